/* A glyph of a variable font from what it is on each step of the axis. */
#include "blend/variable_job.h"

#include <math.h>

#include "geometry/limits.h"

typedef struct mt_joint_glyph {
    const mt_course *course;
    int glyph;
    mt_arena *arena;
    int span_count;
    const mt_span **spans; /* of all steps, in order */
    mt_glyf glyf;          /* as the font stands */
    int place_count;       /* with 0 at the start */
    int *places;
    int own_points; /* of contours, or references */
    mt_move **at;   /* at each place, where each point is */
} mt_joint_glyph;

/* ---- what there is ------------------------------------------------------------------------------------- */

static const mt_passage *passage_of(const mt_joint_glyph *join, int step) {
    return &join->course->jobs[step].passages[join->glyph];
}

static const mt_composite *composite_of(const mt_joint_glyph *join) {
    return &join->course->jobs[0].composites[join->glyph];
}

static mt_status list_spans(mt_joint_glyph *join) {
    const mt_course *course = join->course;
    size_t room = 0;
    for (int i = 0; i < course->step_count; i++) room += (size_t)passage_of(join, i)->span_count;
    join->spans = mt_arena_new(join->arena, room, sizeof *join->spans);
    if (!join->spans) return MT_NO_MEMORY;
    for (int i = 0; i < course->step_count; i++)
        for (int k = 0; k < passage_of(join, i)->span_count; k++)
            join->spans[join->span_count++] = &passage_of(join, i)->spans[k];
    return MT_OK;
}

/* The places of the spans, which follow one another; of a composite, the stops. */
static mt_status list_places(mt_joint_glyph *join) {
    const mt_course *course = join->course;
    size_t room = (size_t)course->step_count + 1;
    for (int i = 0; i < join->span_count; i++) room += (size_t)join->spans[i]->place_count;
    join->places = mt_arena_new(join->arena, room, sizeof(int));
    if (!join->places) return MT_NO_MEMORY;
    for (int i = 0; i < join->span_count; i++)
        for (int k = 0; k < join->spans[i]->place_count; k++)
            join->places[join->place_count++] = join->spans[i]->places[k];
    for (int i = 0; join->span_count == 0 && i <= course->step_count; i++)
        join->places[join->place_count++] = course->stops[i];
    return MT_OK;
}

/* ---- contours ------------------------------------------------------------------------------------------ */

static mt_status list_contours(mt_joint_glyph *join) {
    size_t contours = 0, points = 0;
    for (int i = 0; i < join->span_count; i++) {
        contours += (size_t)join->spans[i]->contour_count;
        points += (size_t)mt_span_point_count(join->spans[i]);
        join->glyf.overlaps = join->glyf.overlaps || join->spans[i]->overlaps;
    }
    if (contours > MT_GLYF_CONTOURS_MAX || points > MT_GLYF_POINTS_MAX) return MT_TOO_LARGE;
    join->glyf.ends = mt_arena_new(join->arena, contours, sizeof(int));
    join->glyf.points = mt_arena_new(join->arena, points, sizeof(mt_glyf_point));
    if (!join->glyf.ends || !join->glyf.points) return MT_NO_MEMORY;
    for (int i = 0; i < join->span_count; i++) {
        const mt_span *span = join->spans[i];
        for (int k = 0; k < span->contour_count; k++)
            join->glyf.ends[join->glyf.contour_count++] = join->own_points + span->ends[k];
        for (int k = 0; k < mt_span_point_count(span); k++)
            join->glyf.points[join->own_points++].on = span->points[0][k].on;
    }
    return MT_OK;
}

/* Where the contours of all other spans are collapsed to: on the first point of the one at hand, so that the glyph reaches no
 * further than its ink. */
static mt_move collapsed_at(const mt_span *span, int row) {
    if (span->contour_count == 0) return (mt_move){0, 0};
    return (mt_move){span->points[row][0].x, span->points[row][0].y};
}

static void place_contours(mt_joint_glyph *join, int at_hand, int row, mt_move *at) {
    mt_move elsewhere = collapsed_at(join->spans[at_hand], row);
    int point = 0;
    for (int i = 0; i < join->span_count; i++) {
        const mt_glyf_point *points = join->spans[i]->points[i == at_hand ? row : 0];
        for (int k = 0; k < mt_span_point_count(join->spans[i]); k++)
            at[point++] = i == at_hand ? (mt_move){points[k].x, points[k].y} : elsewhere;
    }
}

static void place_all_contours(mt_joint_glyph *join) {
    int place = 0;
    for (int i = 0; i < join->span_count; i++)
        for (int row = 0; row < join->spans[i]->place_count; row++)
            place_contours(join, i, row, join->at[place++]);
    for (int k = 0; k < join->own_points; k++) {
        join->glyf.points[k].x = join->at[0][k].x;
        join->glyf.points[k].y = join->at[0][k].y;
    }
}

/* ---- references ---------------------------------------------------------------------------------------- */

static mt_status list_references(mt_joint_glyph *join) {
    const mt_composite *composite = composite_of(join);
    join->own_points = join->glyf.reference_count = composite->count;
    join->glyf.references = mt_arena_new(join->arena, (size_t)composite->count, sizeof(mt_glyf_reference));
    if (!join->glyf.references) return MT_NO_MEMORY;
    for (int i = 0; i < composite->count; i++)
        join->glyf.references[i].glyph = composite->references[i].glyph;
    return MT_OK;
}

static mt_status place_references(mt_joint_glyph *join) {
    for (int place = 0; place < join->place_count; place++)
        for (int i = 0; i < join->own_points; i++) {
            mt_status status = mt_course_reference(join->course, join->glyph, i, place, &join->at[place][i]);
            if (status != MT_OK) return status;
        }
    for (int i = 0; i < join->own_points; i++) {
        join->glyf.references[i].dx = join->at[0][i].x;
        join->glyf.references[i].dy = join->at[0][i].y;
    }
    return MT_OK;
}

/* ---- room in the line ---------------------------------------------------------------------------------- */

static double mixed(double a, double b, double t) {
    return (1 - t) * a + t * b;
}

static bool in_range(int value, int least, int most) {
    return value >= least && value <= most;
}

/* The phantom points at a place; the glyph's own metrics at the first one. */
static mt_status place_phantoms(mt_joint_glyph *join, int place, mt_move *phantoms) {
    const mt_course *course = join->course;
    int units = course->units;
    bool alone = course->jobs[0].charset->glyphs[join->glyph].b == MT_NO_PARTNER;
    mt_spot spot = mt_course_spot(course, alone ? 0 : join->places[place]);
    const mt_passage *p = passage_of(join, spot.step);
    double t = spot.t;
    mt_vertical vertical = {mixed(p->vertical_a.advance, p->vertical_b.advance, t),
                            mixed(p->vertical_a.origin, p->vertical_b.origin, t)};
    mt_glyf hung = {0};
    int advance = (int)fmin(floor(mixed(p->advance_a, p->advance_b, t) * units / MT_EM + 0.5), INT16_MAX + 1);
    mt_glyf_hang(vertical, units, &hung);
    int bottom = hung.origin - hung.height;
    if (!in_range(advance, 0, INT16_MAX) || !in_range(bottom, INT16_MIN, INT16_MAX)) return MT_TOO_LARGE;
    phantoms[1].x = (int16_t)advance;
    phantoms[2].y = hung.origin;
    phantoms[3].y = (int16_t)bottom;
    if (place > 0) return MT_OK;
    join->glyf.advance = (uint16_t)advance;
    join->glyf.height = hung.height;
    join->glyf.origin = hung.origin;
    return MT_OK;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

static mt_status start_places(mt_joint_glyph *join) {
    size_t points = (size_t)join->own_points + MT_PHANTOM_POINTS;
    join->at = mt_arena_new(join->arena, (size_t)join->place_count, sizeof *join->at);
    if (!join->at) return MT_NO_MEMORY;
    for (int i = 0; i < join->place_count; i++) {
        join->at[i] = mt_arena_new(join->arena, points, sizeof(mt_move));
        if (!join->at[i]) return MT_NO_MEMORY;
    }
    return MT_OK;
}

/* From where each point is at the other places to how far that is from where it is at 0. */
static mt_status take_first_off(mt_joint_glyph *join) {
    for (int i = 1; i < join->place_count; i++)
        for (int k = 0; k < join->own_points + MT_PHANTOM_POINTS; k++) {
            mt_move *move = &join->at[i][k], first = join->at[0][k];
            int x = move->x - first.x, y = move->y - first.y;
            if (!in_range(x, INT16_MIN, INT16_MAX) || !in_range(y, INT16_MIN, INT16_MAX)) return MT_TOO_LARGE;
            *move = (mt_move){(int16_t)x, (int16_t)y};
        }
    return MT_OK;
}

mt_status mt_course_join(const mt_course *course, int glyph, mt_arena *arena, mt_glyf *glyf,
                         mt_glyph_moves *moves) {
    mt_joint_glyph join = {.course = course, .glyph = glyph, .arena = arena};
    bool composite = composite_of(&join)->count > 0;
    mt_status status = list_spans(&join);
    if (status == MT_OK) status = list_places(&join);
    if (status == MT_OK) status = composite ? list_references(&join) : list_contours(&join);
    if (status == MT_OK) status = start_places(&join);
    if (status == MT_OK && composite) status = place_references(&join);
    if (status != MT_OK) return status;
    if (!composite) place_all_contours(&join);
    for (int i = 0; i < join.place_count && status == MT_OK; i++)
        status = place_phantoms(&join, i, join.at[i] + join.own_points);
    if (status == MT_OK) status = take_first_off(&join);
    if (status != MT_OK) return status;
    *glyf = join.glyf;
    *moves = (mt_glyph_moves){join.place_count - 1, join.places + 1, join.at + 1};
    return MT_OK;
}
