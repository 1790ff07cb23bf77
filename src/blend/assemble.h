/* A composite at one place between the fonts: references to glyphs that are made already. */
#ifndef MT_BLEND_ASSEMBLE_H
#define MT_BLEND_ASSEMBLE_H

#include "blend/composite.h"
#include "write/extent.h"

/* The font at one T, as far as it is made. */
typedef struct mt_assembly {
    int units;             /* per em */
    double tolerance;      /* flattening error bound, 1/1000 em */
    double unit_a, unit_b; /* what a unit of A, and one of B, adds to an offset here, in the font's units */
    const mt_glyf *glyphs;
    const mt_extent *extents;
} mt_assembly;

/* Gives the glyph, whose metrics are set, the composite's references, in the arena `kept`, and `extent` what they come to.
 * The glyph stays without references where it has to be drawn as a whole: its parts overlap or touch here, are all blank,
 * or come to more than a glyph may have. MT_NO_MEMORY. */
mt_status mt_composite_assemble(const mt_composite *composite, const mt_assembly *font, mt_arena *kept,
                                mt_arena *scratch, mt_glyf *glyph, mt_extent *extent);

/* Whether any two parts of a composite overlap, or touch. As mt_flatten and mt_union. */
mt_status mt_parts_touch(const mt_glyf *composite, const mt_assembly *font, mt_arena *scratch, bool *overlap);

#endif
