#include "blend/pair.h"

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/prepare.h"

/* Where the drawing's own contours cross, the resolved shape has corners of its own, like any other. */
static void crossings_are_corners(mt_shape *shape) {
    for (int k = 0; k < shape->count; k++)
        for (int i = 0; i < shape->components[k].count; i++) {
            mt_ring *ring = &shape->components[k].rings[i];
            for (int j = 0; j < ring->count; j++)
                if (ring->marks[j] & MT_CROSSING) ring->marks[j] ^= MT_CROSSING | MT_CORNER;
        }
}

/* Contours are looked at finely first, and kept so where they cross (MT_OVERLAP_CARE). */
mt_status mt_glyph_shape(mt_font *font, uint32_t glyph, double tolerance, mt_arena *arena, mt_shape *shape,
                         double *advance) {
    mt_outline outline;
    bool clean, as_coarse;
    double grid = mt_grid_units(tolerance);
    mt_status status = mt_font_outline(font, glyph, arena, &outline, advance);
    if (status == MT_OK) status = mt_outline_resolve(&outline, grid / MT_OVERLAP_CARE, arena, shape, &clean);
    if (status == MT_OK && clean) status = mt_outline_resolve(&outline, grid, arena, shape, &as_coarse);
    if (status == MT_OK) crossings_are_corners(shape);
    return status;
}

mt_status mt_glyph_pair_prepare(mt_font *a, mt_font *b, uint32_t code_point, const mt_hint_index *hints,
                                const mt_params *params, mt_arena *arena, mt_glyph_pair *pair) {
    uint32_t in_a = mt_font_glyph(a, code_point), in_b = mt_font_glyph(b, code_point);
    if (!in_a || !in_b) return MT_NO_GLYPH;
    mt_hints found = mt_hint_index_find(hints, in_a, in_b);
    mt_status status = mt_glyph_shape(a, in_a, params->tolerance, arena, &pair->a, &pair->advance_a);
    if (status == MT_OK)
        status = mt_glyph_shape(b, in_b, params->tolerance, arena, &pair->b, &pair->advance_b);
    if (status == MT_OK) status = mt_morph_prepare(&pair->a, &pair->b, &found, params, arena, &pair->morph);
    return status;
}
