/* Where an anchor of A's goes that B has not: it moves with the outline. What lies within the box of A's
 * glyph keeps its relative place in the box of B's; what lies outside keeps its distance from the nearer
 * side. */
#pragma once

#include "anchors/read.h"
#include "glyphset/places.h"

typedef struct mt_glyph_boxes mt_glyph_boxes;

typedef struct mt_outline_moves {
    mt_font *a, *b;
    const uint32_t *in_a, *in_b; /* the fonts' own glyphs */
    double scale;                /* new units in a grid unit */
    mt_glyph_boxes *boxes;       /* for each glyph, read when they are asked for */
    mt_arena scratch;            /* of one outline; the caller releases it */
} mt_outline_moves;

/* From the first font, `a`, to `b`, which is number `font`. MT_NO_MEMORY. */
mt_status mt_outline_moves_open(mt_font *a, mt_font *b, const mt_font_glyphs *glyphs, int font, int units,
                                mt_arena *arena, mt_outline_moves *moves);

/* The place in B's glyph, both in units of the new font; the same place where either glyph is blank, cannot
 * be read, or is not there. MT_NO_MEMORY. */
mt_status mt_outline_move(mt_outline_moves *moves, int glyph, mt_anchor_point from, mt_anchor_point *to);
