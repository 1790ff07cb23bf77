/* Registration of two glyphs: what they as wholes differ in (width, height, slant, weight, place), so that what is left to compare is
 * how they are drawn. */
#pragma once

#include "morph/model/morph.h"
#include "morph/model/settings.h"

/* Finds one affine map, with a thickening along each axis, by which the boundary of one glyph comes to lie on that of the other, and sets
 * the frames of both sides: one is carried by the map, the other stays; which of them does not depend on which is A. Where no map
 * explains enough, or the glyphs are too large to be aligned, both frames are those of the boxes. Neither side may be empty.
 * MT_NO_MEMORY. */
mt_status mt_register(mt_side *a, mt_side *b, const mt_settings *settings, mt_arena *arena);
