/* What HarfBuzz takes as it comes and other readers refuse the table for, put right in place. */
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "base/memory.h"
#include "layout/ot.h"

/* GSUB (OpenType spec, "ScriptList table", "Script table"): records of scripts and of language systems in the order of their tags, each tag
 * once; of several the first stays. Language systems with features that are not there go, and the script DFLT where it has no default. */
void mt_tidy_scripts(uint8_t *gsub, size_t length);

/* GSUB and GPOS ("Lookup table", "Sequence lookup record"): a lookup whose mark glyph set GDEF has not, has none; a rule calls lookups that
 * there are, at places of its input, and other calls go. `extension` is the type of the table's extension lookups. MT_NO_MEMORY,
 * MT_ENDLESS_LOOKUPS. */
mt_status mt_tidy_lookups(uint8_t *table, size_t length, int extension, mt_bytes gdef, mt_arena *arena);

/* GDEF (OpenType spec, "Glyph Class Definition"): classes from 1 to 4; glyphs of any other have none. */
void mt_tidy_classes(uint8_t *gdef, size_t length);
