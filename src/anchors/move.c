#include "anchors/move.h"

#include "geometry/limits.h"

/* Chords this near to the curve give its box nearly enough, in 1/1000 em. */
#define BOX_TOLERANCE 0.5

/* Of the two fonts' outlines, grid units. */
struct mt_glyph_boxes {
    bool known, usable; /* usable: both have points */
    mt_box in[2];
};

mt_status mt_outline_moves_open(mt_font *a, mt_font *b, const mt_font_glyphs *glyphs, int font, int units,
                                mt_arena *arena, mt_outline_moves *moves) {
    mt_glyph_boxes *boxes = mt_arena_new(arena, (size_t)glyphs->glyph_count, sizeof *boxes);
    if (!boxes) return MT_NO_MEMORY;
    *moves = (mt_outline_moves){.a = a,
                                .b = b,
                                .in_a = glyphs->of[0],
                                .in_b = glyphs->of[font],
                                .scale = (double)units / MT_EM,
                                .boxes = boxes};
    return MT_OK;
}

/* ---- boxes --------------------------------------------------------------------------------------------- */

static void widen(mt_box *box, mt_box other) {
    if (other.min.x < box->min.x) box->min.x = other.min.x;
    if (other.min.y < box->min.y) box->min.y = other.min.y;
    if (other.max.x > box->max.x) box->max.x = other.max.x;
    if (other.max.y > box->max.y) box->max.y = other.max.y;
}

/* *found is false for a glyph that is blank or cannot be read. */
static mt_status read_box(mt_font *font, uint32_t glyph, mt_arena *scratch, mt_box *box, bool *found) {
    mt_outline outline;
    mt_rings rings = {0};
    double advance;
    mt_arena_reset(scratch);
    mt_status status = mt_font_outline(font, glyph, scratch, &outline, &advance);
    if (status == MT_OK) status = mt_flatten(&outline, mt_grid_units(BOX_TOLERANCE), scratch, &rings);
    *found = status == MT_OK && rings.count > 0;
    if (*found) *box = mt_ring_box(&rings.rings[0]);
    for (int i = 1; *found && i < rings.count; i++) widen(box, mt_ring_box(&rings.rings[i]));
    return status == MT_NO_MEMORY ? status : MT_OK;
}

static mt_status read_boxes(mt_outline_moves *moves, int glyph, mt_glyph_boxes *boxes) {
    uint32_t a = moves->in_a[glyph], b = moves->in_b[glyph];
    bool in_a = false, in_b = false;
    mt_status status = MT_OK;
    if (b != MT_NO_PARTNER) status = read_box(moves->a, a, &moves->scratch, &boxes->in[0], &in_a);
    if (status == MT_OK && in_a) status = read_box(moves->b, b, &moves->scratch, &boxes->in[1], &in_b);
    boxes->usable = in_a && in_b;
    boxes->known = status == MT_OK;
    return status;
}

/* ---- moving -------------------------------------------------------------------------------------------- */

/* One coordinate, from the span low … high of A's box to that of B's. */
static double move(double at, double low_a, double high_a, double low_b, double high_b) {
    if (at <= low_a) return at - low_a + low_b;
    if (at >= high_a) return at - high_a + high_b;
    return low_b + (at - low_a) * (high_b - low_b) / (high_a - low_a);
}

mt_status mt_outline_move(mt_outline_moves *moves, int glyph, mt_anchor_point from, mt_anchor_point *to) {
    mt_glyph_boxes *boxes = &moves->boxes[glyph];
    mt_status status = boxes->known ? MT_OK : read_boxes(moves, glyph, boxes);
    if (status != MT_OK) return status;
    *to = from;
    if (!boxes->usable) return MT_OK;
    const mt_box *a = &boxes->in[0], *b = &boxes->in[1];
    double s = moves->scale;
    to->x = move(from.x, a->min.x * s, a->max.x * s, b->min.x * s, b->max.x * s);
    to->y = move(from.y, a->min.y * s, a->max.y * s, b->min.y * s, b->max.y * s);
    return MT_OK;
}
