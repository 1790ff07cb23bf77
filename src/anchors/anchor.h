/* Anchors of fonts blended: marks to bases, ligatures and marks, and cursive attachment (GPOS lookup types 3
 * to 6).
 *
 * The lookups are the first font's, A's. A pair of mark and base that another font, B, anchors too is attached
 * between A's way and B's; one that B does not anchor as in A, each anchor moved with its glyph's outline
 * (anchor_move.h).
 *
 * A mark has one anchor in a subtable, and some engines (Uniscribe) stop at a base that has no anchor for a
 * mark's class. So each subtable here has one class of marks, and only the bases with an anchor for it: for
 * each class of A's in each class of B's one with anchors of both, and after these one with the anchors that
 * only A has. A third font divides each of these subtables in the same way, and so on. */
#pragma once

#include "anchors/read.h"
#include "glyphset/places.h"
#include "layout/lookup_builder.h"
#include "layout/systems.h"

/* One of the fonts, as its anchors are read. */
typedef struct mt_anchor_source {
    mt_font *font;
    const mt_layout *layout; /* of GPOS */
    const mt_gdef_deltas *variations;
} mt_anchor_source;

/* Where an anchor is in each font, in units of the new font, not rounded. */
typedef struct mt_anchor {
    mt_anchor_point *in_fonts;
} mt_anchor;

/* A mark, or a base's component, with its anchor. */
typedef struct mt_anchored {
    uint16_t glyph, component, component_count; /* component 0 of 1 for what is no ligature */
    mt_anchor at;
} mt_anchored;

/* A subtable: marks of one class, ascending; bases ascending by glyph, then component. */
typedef struct mt_attachment {
    int mark_count, base_count;
    mt_anchored *marks, *bases;
} mt_attachment;

/* A glyph where a line enters and leaves. */
typedef struct mt_cursive_glyph {
    uint16_t glyph;
    bool has[2];
    mt_anchor at[2];
} mt_cursive_glyph;

typedef struct mt_cursive {
    int count;
    mt_cursive_glyph *glyphs; /* ascending */
} mt_cursive;

typedef struct mt_anchor_lookup {
    mt_lookup_builder head; /* without subtables */
    int attachment_count, attachment_room;
    mt_attachment *attachments; /* types 4 to 6, in the order in which they are tried */
    int cursive_count, cursive_room;
    mt_cursive *cursives; /* type 3 */
} mt_anchor_lookup;

typedef struct mt_anchors {
    int count;
    mt_anchor_lookup *lookups; /* in A's order; none is empty */
} mt_anchors;
