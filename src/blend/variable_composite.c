/* The composites of a variable font: glyphs that all of its fonts build from the same parts. */
#include "blend/variable_job.h"

#include <math.h>

/* ---- from font to font --------------------------------------------------------------------------------- */

static mt_composite *composite_at(const mt_course *course, int step, int glyph) {
    return &course->jobs[step].composites[glyph];
}

/* The reference of the step's that goes on where that of the step before it ends. */
static int continuation(const mt_composite *next, const mt_moving_reference *before, const bool *used) {
    for (int i = 0; i < next->count; i++) {
        const mt_moving_reference *r = &next->references[i];
        if (!used[i] && r->glyph == before->glyph && r->a[0] == before->b[0] && r->a[1] == before->b[1])
            return i;
    }
    return -1;
}

/* Puts the references of a step in the order of those of the step before; false where they do not go on from these. */
static mt_status put_in_order(const mt_composite *before, mt_composite *next, mt_arena *arena,
                              bool *goes_on) {
    size_t count = (size_t)before->count;
    bool *used = mt_arena_new(arena, count, sizeof *used);
    mt_moving_reference *ordered = mt_arena_new(arena, count, sizeof *ordered);
    if (!used || !ordered) return MT_NO_MEMORY;
    *goes_on = next->count == before->count;
    for (int i = 0; i < before->count && *goes_on; i++) {
        int found = continuation(next, &before->references[i], used);
        *goes_on = found >= 0;
        if (!*goes_on) break;
        used[found] = true;
        ordered[i] = next->references[found];
    }
    if (*goes_on) next->references = ordered;
    return MT_OK;
}

static mt_status check_composite(const mt_course *course, int glyph, mt_arena *arena) {
    bool goes_on = composite_at(course, 0, glyph)->count > 0;
    for (int step = 1; step < course->step_count && goes_on; step++) {
        mt_status status = put_in_order(composite_at(course, step - 1, glyph),
                                        composite_at(course, step, glyph), arena, &goes_on);
        if (status != MT_OK) return status;
    }
    for (int step = 0; step < course->step_count && !goes_on; step++)
        *composite_at(course, step, glyph) = (mt_composite){0};
    return MT_OK;
}

/* A glyph turned by itself is not what its parts are, turned. */
mt_status mt_course_composites(const mt_course *course, mt_arena *arena) {
    mt_status status = MT_OK;
    bool turned = course->jobs[0].blend->params.rotation != MT_ROTATION_NONE;
    for (int i = 0; i < course->glyph_count && status == MT_OK; i++) {
        if (turned) *composite_at(course, 0, i) = (mt_composite){0};
        status = check_composite(course, i, arena);
    }
    return status;
}

static bool whole_units(double value, int16_t *rounded) {
    double whole = floor(value + 0.5);
    if (!(whole >= INT16_MIN && whole <= INT16_MAX)) return false;
    *rounded = (int16_t)whole;
    return true;
}

mt_status mt_course_reference(const mt_course *course, int glyph, int reference, int stop, mt_move *offset) {
    int step = stop > 0 ? stop - 1 : 0;
    const mt_moving_reference *r = &composite_at(course, step, glyph)->references[reference];
    const mt_blend *blend = course->jobs[step].blend;
    const int *in_font = stop > 0 ? r->b : r->a;
    double scale = (double)course->units / mt_font_units(stop > 0 ? blend->b : blend->a);
    bool fits = whole_units(in_font[0] * scale, &offset->x) && whole_units(in_font[1] * scale, &offset->y);
    return fits ? MT_OK : MT_TOO_LARGE;
}

/* ---- overlaps ------------------------------------------------------------------------------------------ */

/* Where a glyph is at any place: the box around all of them. */
typedef struct mt_sweep {
    bool blank;
    mt_bounds bounds;
} mt_sweep;

static void widen(mt_sweep *sweep, mt_bounds b) {
    mt_bounds *all = &sweep->bounds;
    bool first = sweep->blank;
    sweep->blank = false;
    all->x_min = first || b.x_min < all->x_min ? b.x_min : all->x_min;
    all->y_min = first || b.y_min < all->y_min ? b.y_min : all->y_min;
    all->x_max = first || b.x_max > all->x_max ? b.x_max : all->x_max;
    all->y_max = first || b.y_max > all->y_max ? b.y_max : all->y_max;
}

static mt_sweep sweep_contours(const mt_glyf *glyph, const mt_glyph_moves *moves) {
    mt_sweep sweep = {.blank = true};
    for (int i = 0; i < mt_glyf_point_count(glyph); i++) {
        int x = glyph->points[i].x, y = glyph->points[i].y;
        widen(&sweep, (mt_bounds){x, y, x, y});
        for (int k = 0; k < moves->place_count; k++) {
            mt_move move = moves->moves[k][i];
            widen(&sweep, (mt_bounds){x + move.x, y + move.y, x + move.x, y + move.y});
        }
    }
    return sweep;
}

static mt_sweep sweep_reference(const mt_glyf *glyph, const mt_glyph_moves *moves, int i,
                                const mt_sweep *part) {
    mt_sweep sweep = {.blank = true};
    const mt_glyf_reference *r = &glyph->references[i];
    for (int k = -1; k < moves->place_count && !part->blank; k++) {
        int dx = r->dx + (k < 0 ? 0 : moves->moves[k][i].x), dy = r->dy + (k < 0 ? 0 : moves->moves[k][i].y);
        mt_bounds b = part->bounds;
        widen(&sweep, (mt_bounds){b.x_min + dx, b.y_min + dy, b.x_max + dx, b.y_max + dy});
    }
    return sweep;
}

static bool meet(const mt_sweep *a, const mt_sweep *b) {
    const mt_bounds *p = &a->bounds, *q = &b->bounds;
    return !a->blank && !b->blank && p->x_min <= q->x_max && q->x_min <= p->x_max && p->y_min <= q->y_max &&
           q->y_min <= p->y_max;
}

/* Of a composite, whose parts are swept. */
static mt_status sweep_composite(mt_glyf *glyphs, int glyph, const mt_glyph_moves *moves, mt_sweep *sweeps,
                                 mt_arena *arena) {
    mt_glyf *composite = &glyphs[glyph];
    mt_sweep *parts = mt_arena_new(arena, (size_t)composite->reference_count, sizeof *parts);
    if (!parts) return MT_NO_MEMORY;
    for (int i = 0; i < composite->reference_count; i++) {
        int part = composite->references[i].glyph;
        parts[i] = sweep_reference(composite, moves, i, &sweeps[part]);
        composite->overlaps = composite->overlaps || glyphs[part].overlaps;
        for (int k = 0; k < i; k++) composite->overlaps = composite->overlaps || meet(&parts[i], &parts[k]);
        if (!parts[i].blank) widen(&sweeps[glyph], parts[i].bounds);
    }
    return MT_OK;
}

/* The room in the line stays; its phantom points come first now. */
static void make_blank(mt_glyf *glyph, mt_glyph_moves *moves, mt_move **rows) {
    for (int i = 0; i < moves->place_count; i++) rows[i] = moves->moves[i] + glyph->reference_count;
    moves->moves = rows;
    glyph->reference_count = 0;
}

mt_status mt_course_overlaps(const mt_course *course, mt_glyf *glyphs, mt_glyph_moves *moves,
                             mt_arena *arena) {
    mt_sweep *sweeps = mt_arena_new(arena, (size_t)course->glyph_count, sizeof *sweeps);
    if (!sweeps) return MT_NO_MEMORY;
    for (int turn = 0; turn < course->glyph_count; turn++) {
        int i = course->jobs[0].order[turn];
        sweeps[i] = sweep_contours(&glyphs[i], &moves[i]);
        if (glyphs[i].reference_count == 0) continue;
        mt_status status = sweep_composite(glyphs, i, &moves[i], sweeps, arena);
        if (status != MT_OK) return status;
        if (!sweeps[i].blank) continue;
        mt_move **rows = mt_arena_new(arena, (size_t)moves[i].place_count, sizeof *rows);
        if (!rows) return MT_NO_MEMORY;
        make_blank(&glyphs[i], &moves[i], rows);
    }
    return MT_OK;
}
