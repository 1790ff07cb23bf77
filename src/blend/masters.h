/* The masters of a variable font: at each place that any of its glyphs has, a font that does not vary, with the same contours
 * and points as all others. */
#pragma once

#include "blend/outlines.h"

/* Hands over the masters of `font`, each with its place as the index. MT_NO_MEMORY, and what `ready` gives. */
mt_status mt_masters_make(const mt_making *making, const mt_outlines *outlines, const mt_font_data *font,
                          mt_font_ready ready, void *user);

/* Gives `made` the room in the line that the glyph takes at a place. */
void mt_glyph_room_at(const mt_glyf *glyph, const mt_glyph_path *path, int place, mt_glyf *made);
