/* Path data ("SVG 2", 9.3): all commands, relative and absolute. */
#pragma once

#include "drawing/pen.h"

/* Draws path data up to their end, or to the first thing that is wrong in them, as browsers do (9.5.4). */
void mt_path_text_draw(const char *text, mt_pen *pen);
