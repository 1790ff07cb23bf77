/* Which glyphs of a row are built from others: those that all of its fonts build from the same parts; and where the parts
 * are at a place between the fonts. */
#pragma once

#include "blend/row.h"
#include "glyphset/places.h"

/* A glyph of the new font, moved to the right and up. */
typedef struct mt_row_reference {
    uint16_t glyph;
    int (*at)[2]; /* by how much in each font, its own units */
} mt_row_reference;

typedef struct mt_composite {
    int depth; /* 0: the glyph is no composite; otherwise one more than the deepest of its parts */
    int count;
    mt_row_reference *references; /* in the first font's order */
} mt_composite;

/* Finds the composites among the new font's glyphs, one entry a glyph, in the arena: all fonts draw the glyph by references
 * that only move; each of a font's goes with one of the next font's so that all of them are a glyph of the new font; and no
 * hint says how to draw the whole. The first glyph, .notdef, is none; with a rotation none is, for a glyph that was turned
 * by itself is not what its parts are, turned. No depth is over MT_GLYF_DEPTH_MAX. MT_NO_MEMORY. Not for two threads at
 * once. */
mt_status mt_composites_find(const mt_row *row, const mt_font_glyphs *glyphs, mt_arena *arena,
                             mt_composite **composites);

/* Where a reference is between font number `first` and the next, whole units of the new font; false where a font cannot say so. */
bool mt_reference_at(const mt_row *row, const mt_row_reference *reference, int first, mt_at at, int units,
                     int16_t *dx, int16_t *dy);
