/* Which substitutions text has without asking for them. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* Whether shaping turns on the GSUB feature of this tag by itself, in some script, across or down a line: those of HarfBuzz's
 * shapers, and those that the layout of formulas applies. `fractions`: there is U+2044, around which HarfBuzz makes fractions.
 * All other features are for text to ask for: small capitals, stylistic sets, lists of alternates. */
bool mt_feature_is_automatic(uint32_t tag, bool fractions);
