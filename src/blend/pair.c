/* The one place where glyphs are read for a morph and where mt_morph_prepare is called, unless a cache has the pair. */
#include "blend/pair.h"

#include <math.h>

#include "blend/slant.h"
#include "cache/cache.h"
#include "geometry/limits.h"
#include "geometry/layers.h"
#include "glyphset/match.h"
#include "morph/prepare.h"

/* ---- one side ------------------------------------------------------------------------------------------ */

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

/* Both glyphs as they are in their fonts. */
typedef struct drawn_pair {
    mt_outline outlines[2];
    mt_status read[2];
} drawn_pair;

/* Reads the outlines and advances, under the row's lock; of A alone where there is no B. */
static mt_status read_outlines(mt_row *row, int step, uint32_t a, uint32_t b, mt_arena *arena,
                               mt_glyph_pair *pair, drawn_pair *drawn) {
    *drawn = (drawn_pair){.read = {MT_OK, MT_OK}};
    pthread_mutex_lock(&row->lock);
    mt_status leans = mt_row_find_leans(row);
    drawn->read[0] = mt_font_outline(row->fonts[step], a, arena, &drawn->outlines[0], &pair->room_a.advance);
    if (b != MT_NO_PARTNER)
        drawn->read[1] =
            mt_font_outline(row->fonts[step + 1], b, arena, &drawn->outlines[1], &pair->room_b.advance);
    pthread_mutex_unlock(&row->lock);
    for (int i = 0; i < 2; i++) drawn->read[i] = mt_arena_verdict(arena, drawn->read[i]);
    return leans;
}

/* A side as a shape; where it is not read, nothing. */
static mt_status make_shape(const drawn_pair *drawn, int side, double tolerance, mt_arena *arena,
                            mt_shape *shape) {
    *shape = (mt_shape){0};
    if (drawn->read[side] != MT_OK) return drawn->read[side];
    return mt_outline_shape(&drawn->outlines[side], tolerance, arena, shape);
}

/* Both sides as shapes, and their morph. */
static void prepare(const drawn_pair *drawn, bool alone, const mt_hints *hints, const mt_params *params,
                    mt_arena *arena, mt_prepared *made) {
    mt_status in_a = make_shape(drawn, 0, params->tolerance, arena, &made->a);
    mt_status in_b = alone ? MT_OK : make_shape(drawn, 1, params->tolerance, arena, &made->b);
    made->at_fault = in_a != MT_OK ? 0 : in_b != MT_OK ? 1 : -1;
    made->status = in_a != MT_OK ? in_a : in_b;
    if (made->status != MT_OK || alone) return;
    made->status = mt_morph_prepare(&made->a, &made->b, hints, params, arena, &made->morph);
    if (made->status == MT_NO_COUNTERPART) made->at_fault = made->a.count > 0;
}

/* The same within an allowance. */
static void prepare_within(const mt_row *row, const drawn_pair *drawn, bool alone, const mt_hints *hints,
                           const mt_params *params, mt_arena *arena, mt_prepared *made) {
    *made = (mt_prepared){0};
    mt_pair_allow(row, arena);
    prepare(drawn, alone, hints, params, arena, made);
    made->status = mt_row_verdict(row, mt_arena_verdict(arena, made->status));
    mt_arena_bound(arena, NULL);
}

/* Taken from the row's cache, or prepared and kept there. */
static mt_status prepare_or_find(mt_row *row, const drawn_pair *drawn, const mt_hints *hints,
                                 const mt_params *params, mt_arena *arena, mt_prepared *made) {
    mt_digest key;
    mt_status status = mt_cache_key(drawn->outlines, hints, params, &key);
    if (status != MT_OK || mt_cache_find(row->cache, &key, arena, made)) return status;
    prepare_within(row, drawn, false, hints, params, arena, made);
    mt_cache_keep(row->cache, &key, made);
    return MT_OK;
}

mt_status mt_pair_prepare_by(mt_row *row, int step, uint32_t a, uint32_t b, const mt_hints *hints,
                             mt_arena *arena, mt_glyph_pair *pair) {
    drawn_pair drawn;
    mt_prepared made;
    bool alone = b == MT_NO_PARTNER;
    mt_pair_allow(row, arena);
    mt_status status = read_outlines(row, step, a, b, arena, pair, &drawn);
    mt_arena_bound(arena, NULL);
    if (status != MT_OK) return mt_row_verdict(row, status);
    mt_params params = row->params;
    params.lean = row->leans[step];
    if (row->cache && !alone && drawn.read[0] == MT_OK && drawn.read[1] == MT_OK)
        status = prepare_or_find(row, &drawn, hints, &params, arena, &made);
    else
        prepare_within(row, &drawn, alone, hints, &params, arena, &made);
    if (status != MT_OK) return mt_row_verdict(row, status);
    pair->a = made.a;
    pair->b = made.b;
    pair->morph = made.morph;
    pair->at_fault = made.at_fault;
    return mt_row_verdict(row, made.status);
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

/* ---- aside --------------------------------------------------------------------------------------------- */

/* On the way from `from` to `to`, the last place with an advance that is not less than none. */
static mt_at with_room(const mt_glyph_pair *pair, mt_at from, mt_at to) {
    double near = mt_room_between(&pair->room_a, &pair->room_b, from).advance,
           far = mt_room_between(&pair->room_a, &pair->room_b, to).advance;
    return far >= 0 ? to : mt_at_between(from, to, near > 0 ? near / (near - far) : 0);
}

mt_status mt_pair_stand(const mt_glyph_pair *pair, mt_reach reach, mt_at asked, const mt_params *params,
                        mt_arena *arena, mt_at *stands) {
    double from = fmin(fmax((asked.x + asked.y) / 2, reach.from), reach.to);
    mt_at found = mt_at_both(from);
    mt_status status = MT_OK;
    if (asked.x != asked.y) status = mt_morph_aside(&pair->morph, from, asked, params, arena, &found);
    if (status == MT_OK) *stands = with_room(pair, mt_at_both(from), found);
    return status;
}
