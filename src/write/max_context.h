/* OS/2 usMaxContext: how many glyphs the font's layout looks at together, at most. */
#pragma once

#include "sfnt/sfnt.h"
#include "source/font.h"

/* Of a GSUB or GPOS (OpenType spec, "OS/2": usMaxContext): 1 for a glyph by itself, 2 for a pair, the components of a
 * ligature, the input and lookahead of a context. Attachment of marks and cursive letters does not count. What lies beyond
 * the table's end is passed over, and so is what comes after a million rules. */
int mt_max_context(mt_bytes table, bool substitution);
