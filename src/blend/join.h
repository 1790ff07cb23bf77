/* A glyph of a variable font from its tracks on each step of the row. */
#pragma once

#include "blend/outlines.h"

/* The glyph as the font stands without a setting, and its points at all other places that its tracks have, in the making's arena. It has the
 * contours of all tracks, and those of a segment that is not at hand are collapsed to a point; or, of a composite, its
 * references. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_tracks_join(mt_making *making, const mt_outlines *outlines, int glyph, mt_glyf *glyf,
                         mt_glyph_path *path);
