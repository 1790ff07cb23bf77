/* A composite at one place between the fonts: references to glyphs that are made already, where these do not touch. */
#pragma once

#include "blend/composite.h"
#include "write/extent.h"

/* Whether any two of the boxes around parts meet: where none do, no parts touch. An empty box meets nothing. */
bool mt_boxes_meet(const mt_bounds *boxes, int count);

/* The font at one place between the first two fonts, as far as it is made. */
typedef struct mt_assembly {
    const mt_row *row;
    mt_at at;
    int units;
    const mt_glyf *glyphs;
    const mt_extent *extents;
} mt_assembly;

/* Gives the glyph, whose metrics are set, the composite's references, in the arena `kept`, and `extent` what they come to.
 * The glyph stays without references where it has to be drawn as a whole: its parts overlap or touch here, are all blank,
 * or come to more than a glyph may have. MT_NO_MEMORY. */
mt_status mt_composite_assemble(const mt_composite *composite, const mt_assembly *font, mt_arena *kept,
                                mt_arena *scratch, mt_glyf *glyph, mt_extent *extent);
