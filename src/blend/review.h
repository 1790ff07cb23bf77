/* What a user should know of the sources before a font made of them goes out. */
#pragma once

#include "source/font.h"

/* Calls with a line of English for each: what the embedding bits and the licence of a source restrict; a name that a
 * source keeps for itself in `family` (unless NULL); metrics
 * beside a source that cannot be read; tables of which a blend has none: colour,
 * bitmap and math (where the first font has none, or it is damaged), Graphite's, Apple's layout.
 * MT_NO_MEMORY. */
mt_status mt_review(mt_font *const *fonts, int count, const char *family, mt_warning call, void *user);
