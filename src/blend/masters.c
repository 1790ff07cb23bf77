/* A master has at its place what a variable font has there: points on the straight lines between a glyph's own places, figures
 * and kerning mixed of the two fonts around it. */
#include "blend/masters.h"

#include <math.h>
#include <stdio.h>

#include "blend/metadata.h"
#include "gpos/kerning.h"
#include "sfnt/axis.h"
#include "write/extent.h"

/* ---- places -------------------------------------------------------------------------------------------- */

/* All of them, ascending. */
static mt_status list_places(const mt_making *making, const mt_outlines *outlines, const mt_glyph_path *paths,
                             mt_arena *arena, int **places, int *count) {
    enum { ALL = 2 * MT_PLACE_ONE + 1 };
    const mt_stops *stops = &outlines->stops;
    bool *used = mt_arena_new(arena, ALL, sizeof *used);
    *places = mt_arena_new(arena, ALL, sizeof **places);
    if (!used || !*places) return MT_NO_MEMORY;
    for (int i = 0; i < stops->count; i++) used[stops->at[i] + MT_PLACE_ONE] = true;
    for (int i = 0; i < making->glyph_count; i++)
        for (int k = 0; k < paths[i].place_count; k++) used[paths[i].places[k] + MT_PLACE_ONE] = true;
    *count = 0;
    for (int i = 0; i < ALL; i++)
        if (used[i]) (*places)[(*count)++] = i - MT_PLACE_ONE;
    return MT_OK;
}

/* ---- glyphs -------------------------------------------------------------------------------------------- */

static int16_t mixed(int before, int after, double share) {
    return (int16_t)floor(before + share * (after - before) + 0.5);
}

/* Where a point is at a place, which is `own` at 0: on the straight line between the two of its places around it. */
static mt_font_point point_at(const mt_glyph_path *path, int place, int point, mt_font_point own) {
    int next = 0, from = 0, to = 0;
    mt_font_point p = own, q = own;
    while (next < path->place_count && path->places[next] < place) next++;
    if (next > 0 && (place < 0 || path->places[next - 1] > 0))
        from = path->places[next - 1], p = path->at[next - 1][point];
    if (next < path->place_count && (place > 0 || path->places[next] < 0))
        to = path->places[next], q = path->at[next][point];
    if (place == 0 || from == to) return own;
    double share = (double)(place - from) / (to - from);
    return (mt_font_point){mixed(p.x, q.x, share), mixed(p.y, q.y, share)};
}

void mt_glyph_room_at(const mt_glyf *glyph, const mt_glyph_path *path, int place, mt_glyf *made) {
    int phantoms = mt_glyf_point_count(glyph) + glyph->reference_count;
    mt_font_point right = {(int16_t)glyph->advance, 0}, top = {0, glyph->origin},
                  bottom = {0, (int16_t)(glyph->origin - glyph->height)};
    made->advance = (uint16_t)point_at(path, place, phantoms + 1, right).x;
    made->origin = point_at(path, place, phantoms + 2, top).y;
    made->height = (uint16_t)(made->origin - point_at(path, place, phantoms + 3, bottom).y);
}

/* The glyph as it is at a place. */
static mt_status glyph_at(const mt_glyf *glyph, const mt_glyph_path *path, int place, mt_arena *arena,
                          mt_glyf *made) {
    int points = mt_glyf_point_count(glyph), references = glyph->reference_count;
    *made = *glyph;
    made->points = mt_arena_new(arena, (size_t)points, sizeof *made->points);
    made->references = mt_arena_new(arena, (size_t)references, sizeof *made->references);
    if (!made->points || !made->references) return MT_NO_MEMORY;
    for (int i = 0; i < points; i++) {
        const mt_glyf_point *p = &glyph->points[i];
        mt_font_point at = point_at(path, place, i, (mt_font_point){p->x, p->y});
        made->points[i] = (mt_glyf_point){at.x, at.y, p->on};
    }
    for (int i = 0; i < references; i++) {
        const mt_glyf_reference *r = &glyph->references[i];
        mt_font_point at = point_at(path, place, i, (mt_font_point){r->dx, r->dy});
        made->references[i] = (mt_glyf_reference){r->glyph, at.x, at.y, r->same_metrics};
    }
    mt_glyph_room_at(glyph, path, place, made);
    return MT_OK;
}

static mt_status glyphs_at(const mt_font_data *font, int place, mt_arena *arena, mt_glyf **glyphs) {
    mt_status status = MT_OK;
    *glyphs = mt_arena_new(arena, (size_t)font->glyph_count, sizeof **glyphs);
    if (!*glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < font->glyph_count && status == MT_OK; i++)
        status = glyph_at(&font->glyphs[i], &font->variation->paths[i], place, arena, &(*glyphs)[i]);
    return status;
}

/* ---- masters ------------------------------------------------------------------------------------------- */

static mt_status kern(const mt_positions *positions, mt_between between, mt_arena *arena,
                      mt_font_data *master) {
    mt_kerning *kerning = mt_arena_new(arena, 1, sizeof *kerning);
    if (!kerning) return MT_NO_MEMORY;
    master->kerning = kerning;
    return mt_positions_master_kerning(positions, between, arena, kerning);
}

/* What the axis says of a place there: of weight, width or slant, and as the style. */
static mt_status name_place(const mt_axis_data *variation, int place, mt_arena *arena, mt_font_data *master) {
    enum { NAME_ROOM = 48 };
    double value = mt_axis_user(&variation->axis, mt_axis_value_of(&variation->axis, place));
    char *name = mt_arena_new(arena, NAME_ROOM, 1);
    if (!name) return MT_NO_MEMORY;
    snprintf(name, NAME_ROOM, "%s %.6g", variation->name, value);
    master->style = name;
    mt_metadata_axis(&variation->axis, value, master->units, &master->metrics);
    return MT_OK;
}

static mt_status make_master(const mt_making *making, mt_between between, const mt_font_data *font, int place,
                             mt_arena *arena, mt_font_data *master) {
    mt_font *const *fonts = making->row->fonts + between.first;
    *master = *font;
    master->variation = NULL;
    master->layout_place = mt_axis_goes_down(&font->variation->axis) ? -place : place;
    mt_metadata_fill(fonts[0], fonts[1], mt_at_both(between.t), master);
    mt_status status = name_place(font->variation, place, arena, master);
    if (status == MT_OK) status = glyphs_at(font, place, arena, &master->glyphs);
    if (status == MT_OK) status = kern(making->positions, between, arena, master);
    return status;
}

mt_status mt_masters_make(const mt_making *making, const mt_outlines *outlines, const mt_font_data *font,
                          mt_font_ready ready, void *user) {
    mt_arena arena = {0};
    int count, *places;
    mt_status status = list_places(making, outlines, font->variation->paths, &arena, &places, &count);
    for (int i = 0; i < count && status == MT_OK; i++) {
        mt_font_data master;
        mt_arena_place before = mt_arena_mark(&arena);
        mt_between between = mt_outlines_between(outlines, places[i]);
        status = make_master(making, between, font, places[i], &arena, &master);
        if (status == MT_OK) status = ready(&master, places[i], user);
        mt_arena_rewind(&arena, before);
    }
    mt_arena_release(&arena);
    return status;
}
