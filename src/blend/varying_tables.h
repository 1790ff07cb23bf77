/* What a variable font has beside outlines: positions, room in the line and figures of the whole font. Each table has what
 * holds at the first stop, and what every other one adds to it. */
#pragma once

#include "blend/outlines.h"

/* Adds the tables, in the making's arena, to the font, which has its glyphs and how they vary. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_varying_tables_add(mt_making *making, const mt_outlines *outlines, const mt_variable *variable,
                                mt_font_data *font);
