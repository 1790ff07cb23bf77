/* The masters of a variable font: at each place that any of its glyphs has, a font that does not vary, with the same contours
 * and points as all others. */
#include "blend/variable_job.h"

#include <math.h>
#include <stdio.h>

#include "blend/metadata.h"
#include "sfnt/axis.h"

/* ---- places -------------------------------------------------------------------------------------------- */

/* All of them, ascending. */
static mt_status list_places(const mt_course *course, const mt_glyph_moves *moves, mt_arena *arena,
                             int **places, int *count) {
    bool *used = mt_arena_new(arena, MT_PLACE_ONE + 1, sizeof *used);
    *places = mt_arena_new(arena, MT_PLACE_ONE + 1, sizeof **places);
    if (!used || !*places) return MT_NO_MEMORY;
    for (int i = 0; i <= course->step_count; i++) used[course->stops[i]] = true;
    for (int i = 0; i < course->glyph_count; i++)
        for (int k = 0; k < moves[i].place_count; k++) used[moves[i].places[k]] = true;
    *count = 0;
    for (int i = 0; i <= MT_PLACE_ONE; i++)
        if (used[i]) (*places)[(*count)++] = i;
    return MT_OK;
}

mt_spot mt_course_spot(const mt_course *course, int place) {
    int step = 0;
    while (step + 1 < course->step_count && place > course->stops[step + 1]) step++;
    double length = course->stops[step + 1] - course->stops[step];
    return (mt_spot){step, (place - course->stops[step]) / length};
}

/* ---- glyphs -------------------------------------------------------------------------------------------- */

/* Between which two of a glyph's places a place is: after is the second of them, and `share` of the way lies behind. */
static void find_between(const mt_glyph_moves *moves, int place, int *after, double *share) {
    int i = 0;
    while (i + 1 < moves->place_count && moves->places[i] < place) i++;
    int from = i ? moves->places[i - 1] : 0;
    *after = i;
    *share = (double)(place - from) / (moves->places[i] - from);
}

static int16_t moved(int16_t from, int16_t before, int16_t after, double share) {
    return (int16_t)(from + floor(before + share * (after - before) + 0.5));
}

static mt_move move_at(const mt_glyph_moves *moves, int place, int point) {
    const mt_move none = {0, 0};
    int after;
    double share;
    if (moves->place_count == 0) return none;
    find_between(moves, place, &after, &share);
    mt_move p = after ? moves->moves[after - 1][point] : none, q = moves->moves[after][point];
    return (mt_move){moved(0, p.x, q.x, share), moved(0, p.y, q.y, share)};
}

void mt_glyph_room_at(const mt_glyf *glyph, const mt_glyph_moves *moves, int place, mt_glyf *made) {
    int phantoms = mt_glyf_point_count(glyph) + glyph->reference_count;
    int right = move_at(moves, place, phantoms + 1).x, top = move_at(moves, place, phantoms + 2).y,
        bottom = move_at(moves, place, phantoms + 3).y;
    made->advance = (uint16_t)(glyph->advance + right);
    made->origin = (int16_t)(glyph->origin + top);
    made->height = (uint16_t)(glyph->height + top - bottom);
}

/* The glyph as it is at a place. */
static mt_status glyph_at(const mt_glyf *glyph, const mt_glyph_moves *moves, int place, mt_arena *arena,
                          mt_glyf *made) {
    int points = mt_glyf_point_count(glyph), references = glyph->reference_count;
    *made = *glyph;
    made->points = mt_arena_new(arena, (size_t)points, sizeof *made->points);
    made->references = mt_arena_new(arena, (size_t)references, sizeof *made->references);
    if (!made->points || !made->references) return MT_NO_MEMORY;
    for (int i = 0; i < points; i++) {
        mt_move move = move_at(moves, place, i);
        const mt_glyf_point *p = &glyph->points[i];
        made->points[i] = (mt_glyf_point){(int16_t)(p->x + move.x), (int16_t)(p->y + move.y), p->on};
    }
    for (int i = 0; i < references; i++) {
        mt_move move = move_at(moves, place, i);
        made->references[i] = glyph->references[i];
        made->references[i].dx = (int16_t)(made->references[i].dx + move.x);
        made->references[i].dy = (int16_t)(made->references[i].dy + move.y);
    }
    mt_glyph_room_at(glyph, moves, place, made);
    return MT_OK;
}

static mt_status glyphs_at(const mt_font_data *font, int place, mt_arena *arena, mt_glyf **glyphs) {
    mt_status status = MT_OK;
    *glyphs = mt_arena_new(arena, (size_t)font->glyph_count, sizeof **glyphs);
    if (!*glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < font->glyph_count && status == MT_OK; i++)
        status = glyph_at(&font->glyphs[i], &font->variation->moves[i], place, arena, &(*glyphs)[i]);
    return status;
}

/* ---- masters ------------------------------------------------------------------------------------------- */

static mt_status kern(const mt_positions *positions, mt_spot spot, mt_arena *arena, mt_font_data *master) {
    mt_kerning *kerning = mt_arena_new(arena, 1, sizeof *kerning);
    if (!kerning) return MT_NO_MEMORY;
    master->kerning = kerning;
    return mt_positions_kerning(positions, spot.step + spot.t, arena, kerning);
}

static mt_status name_style(int place, mt_arena *arena, const char **style) {
    enum { NAME_ROOM = 32 };
    char *name = mt_arena_new(arena, NAME_ROOM, 1);
    if (!name) return MT_NO_MEMORY;
    snprintf(name, NAME_ROOM, MT_AXIS_NAME " %.6g", mt_axis_value(place));
    *style = name;
    return MT_OK;
}

/* What all masters say alike. */
static void take_names(const mt_font_data *font, mt_font_data *master) {
    master->unique_id = font->unique_id;
    master->description = font->description;
    master->copyright = font->copyright;
    master->trademark = font->trademark;
    master->designer = font->designer;
    master->license = font->license;
    master->license_url = font->license_url;
}

static mt_status make_master(const mt_course *course, const mt_font_data *font, int place, mt_arena *arena,
                             mt_font_data *master) {
    mt_spot spot = mt_course_spot(course, place);
    const mt_blend *blend = course->jobs[spot.step].blend;
    *master = *font;
    master->variation = NULL;
    master->extra_count = 0;
    mt_status status = mt_metadata_fill(blend->a, blend->b, spot.t, font->family, arena, master);
    take_names(font, master);
    if (status == MT_OK) status = name_style(place, arena, &master->style);
    if (status == MT_OK) status = glyphs_at(font, place, arena, &master->glyphs);
    if (status == MT_OK) status = kern(course->positions, spot, arena, master);
    return status;
}

mt_status mt_course_masters(const mt_course *course, const mt_font_data *font, mt_font_ready ready,
                            void *user) {
    mt_arena arena = {0};
    int count, *places;
    mt_status status = list_places(course, font->variation->moves, &arena, &places, &count);
    for (int i = 0; i < count && status == MT_OK; i++) {
        mt_font_data master;
        mt_arena_place before = mt_arena_mark(&arena);
        status = make_master(course, font, places[i], &arena, &master);
        if (status == MT_OK) status = ready(&master, places[i], user);
        mt_arena_rewind(&arena, before);
    }
    mt_arena_release(&arena);
    return status;
}
