/* Files of glyphs that go together, a line each: for each font a column with a glyph's name or a character.
 *
 *     # From a # at the start of a line, or after a blank, to the line's end is a comment.
 *     home      house       names of glyphs
 *     /home     U+F015      with a slash before it; the glyph of a code point */
#pragma once

#include "options.h"
#include "source/given_pairs.h"

/* Reads the file of --pairs for the options' fonts; no pairs without one. DONE or, said with the file and the line,
 * COULD_NOT. The pairs are to be freed. */
int pairs_file_read(const cli_options *options, mt_font *const *fonts, mt_given_pairs *pairs);
