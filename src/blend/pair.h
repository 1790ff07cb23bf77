/* One glyph's way from two fonts to a morph, and from the morph to a glyph of the new font. */
#ifndef MT_BLEND_PAIR_H
#define MT_BLEND_PAIR_H

#include "hints/index.h"
#include "morph/model/morph.h"
#include "source/font.h"
#include "write/font_data.h"

typedef struct mt_glyph_pair {
    mt_shape a, b;
    double advance_a, advance_b; /* grid units */
    mt_vertical vertical_a, vertical_b;
    mt_morph morph;
} mt_glyph_pair;

/* Reads a glyph as a shape: outline, flattened within `tolerance` (1/1000 em), resolved into components. As
 * mt_font_outline and mt_union. */
mt_status mt_glyph_shape(mt_font *font, uint32_t glyph, double tolerance, mt_arena *arena, mt_shape *shape,
                         double *advance);

/* Reads the character from both fonts and prepares its morph, by its hints in `hints` (unless NULL), an index
 * for these two fonts; all in the arena. As mt_glyph_shape and mt_morph_prepare; MT_NO_GLYPH when one font
 * lacks it. */
mt_status mt_glyph_pair_prepare(mt_font *a, mt_font *b, uint32_t code_point, const mt_hint_index *hints,
                                const mt_params *params, mt_arena *arena, mt_glyph_pair *pair);

/* An outline as 'glyf' has it, in `units` to the em: outer contours clockwise, points on whole units, those
 * on the curve that lie midway between their neighbours implied. The advance is in grid units. MT_NO_MEMORY,
 * MT_TOO_LARGE. */
mt_status mt_outline_glyf(const mt_outline *outline, double advance, int units, mt_arena *arena,
                          mt_glyf *glyf);

/* Gives the glyph its vertical metrics, from grid units; at the end of the range where they are beyond. */
void mt_glyf_hang(mt_vertical vertical, int units, mt_glyf *glyf);

#endif
