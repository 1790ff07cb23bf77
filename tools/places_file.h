/* Files of glyphs that lie at places of their own, a line each:
 *
 *     # From a # at the start of a line, or after a blank, to the line's end is a comment.
 *     a é 0.4            characters, code points, ranges and glyphs as in characters_file.h, and after a blank T
 *     /a.sc 0.4,y=0.6    T across, and T upwards */
#pragma once

#include "options.h"

/* Gives the blend of the options' fonts the places of the file of --places; none without one. DONE or, said with the file and the line,
 * COULD_NOT. */
int places_file_set(const cli_options *options, mt_font *font, mt_blend *blend);
