/* GSUB tables for tests, in the making, and small fonts that have one. */
#pragma once

#include "base/memory.h"
#include "write/font_data.h"

/* One lookup of one subtable, as text: a feature, a language of the script latn (NULL: the default one), and what is
 * substituted. A feature of four spaces applies nothing: contexts may call the lookup.
 *     "1 2"       glyph 1 becomes glyph 2 (type 1)
 *     "1 2 3"     1 becomes the row 2 3 (2), or one of them (3); "1 2" is the ligature of 1 and 2, "3" (4: the last)
 *     several of them, split by commas; for type 6, "1 2 3 4": before 1, glyph 2, after 3, lookup 4 is called; for type 8,
 *     "1 2 3 4": before 1, glyph 2 becomes 4, after 3 */
typedef struct mt_test_lookup {
    const char *feature, *language;
    int type;
    const char *what;
} mt_test_lookup;

/* The table's bytes, in the arena. With `extended`, all lookups are extensions. */
mt_bytes mt_test_gsub(const mt_test_lookup *lookups, int count, bool extended, mt_arena *arena);

/* A font of `glyph_count` glyphs, which are squares of different sizes, with these characters: chars[i] has glyph i + 1.
 * `names` may be NULL. Saved as `path` and opened. */
mt_font *mt_test_gsub_font(const char *path, int glyph_count, const char *chars, const char **names,
                           mt_bytes gsub, mt_arena *arena);
