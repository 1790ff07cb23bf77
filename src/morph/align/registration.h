/* Registration of two glyphs: what they as wholes differ in (width, height, slant, weight, place), so that what is left to compare is
 * how they are drawn. */
#pragma once

#include "morph/model/morph.h"
#include "morph/model/settings.h"

/* The frames of both sides for each placing; where one does not apply, nothing is gained by it. */
typedef struct mt_registered {
    bool applies[MT_PLACINGS];
    mt_frame a[MT_PLACINGS], b[MT_PLACINGS];
} mt_registered;

/* Finds one affine map, with a thickening along each axis, by which the boundary of one glyph comes to lie on that of the other: one is
 * carried, the other stays; which of them does not depend on which is A. Where no map explains enough, or the glyphs are too large to be
 * aligned, MT_REGISTERED has the boxes' frames. `lean`: by how many degrees B's font leans to the right of A's. Neither side may
 * be empty. MT_NO_MEMORY. */
mt_status mt_register(const mt_side *a, const mt_side *b, double lean, const mt_settings *settings,
                      mt_arena *arena, mt_registered *registered);
