/* Which glyphs of a blend are built from others: those that both fonts build from the same parts. */
#ifndef MT_BLEND_COMPOSITE_H
#define MT_BLEND_COMPOSITE_H

#include "glyphset/charset.h"
#include "hints/index.h"

/* A glyph of the new font, moved to the right and up: by so much in A and so much in B, each in its own font's units. */
typedef struct mt_moving_reference {
    uint16_t glyph;
    int a[2], b[2];
} mt_moving_reference;

typedef struct mt_composite {
    int depth; /* 0: the glyph is no composite; otherwise one more than the deepest of its parts */
    int count;
    mt_moving_reference *references; /* in A's order */
} mt_composite;

/* Finds the composites among the charset's glyphs, one entry a glyph, in the arena: both fonts draw the glyph by
 * references that only move; each of A's goes with one of B's so that the two are a glyph of the charset; and no hint
 * says how to draw the whole. The first glyph, .notdef, is none. No depth is over MT_GLYF_DEPTH_MAX. MT_NO_MEMORY. Not for
 * two threads at once. */
mt_status mt_composites_find(mt_font *a, mt_font *b, const mt_charset *charset, const mt_hint_index *hints,
                             mt_arena *arena, mt_composite **composites);

#endif
