/* The one place where glyphs are read for a morph and where mt_morph_prepare is called. */
#include "blend/pair.h"

#include <math.h>

#include "blend/slant.h"
#include "geometry/limits.h"
#include "geometry/layers.h"
#include "glyphset/match.h"
#include "morph/prepare.h"

/* ---- one side ------------------------------------------------------------------------------------------ */

mt_status mt_glyph_shape(mt_font *font, uint32_t glyph, double tolerance, mt_arena *arena, mt_shape *shape,
                         double *advance) {
    mt_outline outline;
    mt_status status = mt_font_outline(font, glyph, arena, &outline, advance);
    return status == MT_OK ? mt_outline_shape(&outline, tolerance, arena, shape) : status;
}

static mt_status read_room(mt_font *font, uint32_t glyph, mt_glyph_room *room) {
    mt_status across = mt_font_advance(font, glyph, &room->advance);
    mt_status down = mt_font_vertical(font, glyph, &room->vertical);
    return across == MT_NO_MEMORY || down == MT_NO_MEMORY ? MT_NO_MEMORY : MT_OK;
}

/* ---- both ---------------------------------------------------------------------------------------------- */

mt_status mt_pair_read_rooms(mt_row *row, int step, uint32_t a, uint32_t b, mt_glyph_pair *pair) {
    pthread_mutex_lock(&row->lock);
    mt_status status = read_room(row->fonts[step], a, &pair->room_a);
    if (b == MT_NO_PARTNER)
        pair->room_b = pair->room_a;
    else if (status == MT_OK)
        status = read_room(row->fonts[step + 1], b, &pair->room_b);
    pthread_mutex_unlock(&row->lock);
    return status;
}

mt_status mt_row_find_leans(mt_row *row) {
    mt_status status = MT_OK;
    bool wanted = !row->leans_known && row->params.method == MT_METHOD_JOINT;
    for (int i = 0; status == MT_OK && wanted && i + 1 < row->font_count; i++)
        if (row->params.slant == MT_SLANT_GIVEN)
            row->leans[i] = row->params.lean;
        else
            status = mt_slant_between(row->fonts[i], row->fonts[i + 1], &row->leans[i]);
    row->leans_known = status == MT_OK;
    return status;
}

void mt_pair_allow(const mt_row *row, mt_arena *arena) {
    double effort = row->params.effort;
    mt_allowance allowance = {(int64_t)(effort * (double)MT_GLYPH_STEPS),
                              (size_t)(effort * (double)MT_GLYPH_BYTES), &row->stop};
    mt_arena_bound(arena, &allowance);
}

/* As mt_pair_prepare_by, within the arena's allowance. */
static mt_status prepare(mt_row *row, int step, uint32_t a, uint32_t b, const mt_hints *hints,
                         mt_arena *arena, mt_glyph_pair *pair) {
    double tolerance = row->params.tolerance;
    bool alone = b == MT_NO_PARTNER;
    mt_status in_b = MT_OK;
    pthread_mutex_lock(&row->lock);
    mt_status leans = mt_row_find_leans(row);
    mt_status in_a = mt_glyph_shape(row->fonts[step], a, tolerance, arena, &pair->a, &pair->room_a.advance);
    if (!alone)
        in_b = mt_glyph_shape(row->fonts[step + 1], b, tolerance, arena, &pair->b, &pair->room_b.advance);
    pthread_mutex_unlock(&row->lock);
    pair->at_fault = in_a != MT_OK ? 0 : in_b != MT_OK ? 1 : -1;
    if (in_a != MT_OK || in_b != MT_OK || alone) return in_a != MT_OK ? in_a : in_b;
    if (leans != MT_OK) return leans;
    mt_params params = row->params;
    params.lean = row->leans[step];
    mt_status status = mt_morph_prepare(&pair->a, &pair->b, hints, &params, arena, &pair->morph);
    if (status == MT_NO_COUNTERPART) pair->at_fault = pair->a.count > 0;
    return status;
}

mt_status mt_pair_prepare_by(mt_row *row, int step, uint32_t a, uint32_t b, const mt_hints *hints,
                             mt_arena *arena, mt_glyph_pair *pair) {
    mt_pair_allow(row, arena);
    mt_status status = mt_arena_verdict(arena, prepare(row, step, a, b, hints, arena, pair));
    mt_arena_bound(arena, NULL);
    return mt_row_verdict(row, status);
}

mt_status mt_pair_prepare(mt_row *row, int step, uint32_t a, uint32_t b, mt_arena *arena,
                          mt_glyph_pair *pair) {
    mt_hints hints = mt_hint_index_find(b == MT_NO_PARTNER ? NULL : row->hints[step], a, b);
    return mt_pair_prepare_by(row, step, a, b, &hints, arena, pair);
}

mt_status mt_pair_prepare_char(mt_row *row, uint32_t code_point, mt_arena *arena, mt_glyph_pair *pair) {
    *pair = (mt_glyph_pair){0};
    pthread_mutex_lock(&row->lock);
    uint32_t a = mt_font_glyph(row->fonts[0], code_point);
    uint32_t b = row->font_count > 1 ? mt_given_glyph(&row->pairs, row->fonts, 1, code_point) : MT_NO_PARTNER;
    pthread_mutex_unlock(&row->lock);
    return a && b ? mt_pair_prepare(row, 0, a, b, arena, pair) : MT_NO_GLYPH;
}

/* ---- past the ends ------------------------------------------------------------------------------------- */

mt_status mt_pair_reach(const mt_glyph_pair *pair, mt_reach wanted, const mt_params *params, mt_arena *arena,
                        mt_reach *reach) {
    double a = pair->room_a.advance, b = pair->room_b.advance;
    mt_status status = mt_morph_reach(&pair->morph, wanted, params, arena, reach);
    if (status != MT_OK) return status;
    if (b < a) reach->to = fmin(reach->to, fmax(1, a / (a - b)));
    if (a < b) reach->from = fmax(reach->from, fmin(0, a / (a - b)));
    return MT_OK;
}
