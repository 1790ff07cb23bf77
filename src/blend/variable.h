/* One font that varies through all fonts of a row. */
#pragma once

#include "blend/making.h"

/* Makes the variable font and hands it to `ready`, with index 0. `also`, unless NULL, is a sink that takes every glyph
 * besides. As mt_blend_make. */
mt_status mt_variable_make(mt_variable *variable, const mt_sink *also, mt_font_ready ready, void *user);

/* The same as masters, fonts that do not vary and whose glyphs have the same points: each with its place on the axis
 * (axis.h) as the index, in this order. */
mt_status mt_variable_masters(mt_variable *variable, const mt_sink *also, mt_font_ready ready, void *user);
