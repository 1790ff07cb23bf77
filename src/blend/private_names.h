/* Characters for private use that mean other things in other fonts, as icon fonts have them: told by the glyphs' names. */
#pragma once

#include "glyphset/codes.h"

/* Calls with a line for the first of the fonts that has other names than fonts[0] for the glyphs of private characters that are
 * asked for, those aside that a given pair is for. Names that tell a number or a code say nothing. MT_NO_MEMORY. */
mt_status mt_private_names_review(mt_font *const *fonts, int count, const mt_charset_request *request,
                                  mt_warning call, void *user);
