/* What HarfBuzz takes as it comes and other readers refuse the table for, put right in place. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* GSUB (OpenType spec, "ScriptList table", "Script table"): records of scripts and of language systems in the order of their tags, each tag
 * once; of several the first stays. Language systems with features that are not there go. */
void mt_tidy_scripts(uint8_t *gsub, size_t length);

/* GDEF (OpenType spec, "Glyph Class Definition"): classes from 1 to 4; glyphs of any other have none. */
void mt_tidy_classes(uint8_t *gdef, size_t length);
