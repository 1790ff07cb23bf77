/* Which of B's glyphs each of A's is blended with. */
#pragma once

#include "base/memory.h"
#include "gsub/gsub.h"
#include "source/font.h"

/* B's glyph where B has none. */
#define MT_NO_PARTNER UINT32_MAX

typedef struct mt_glyph_match {
    int count_a, count_b;
    uint32_t *partner; /* of each of A's glyphs: B's glyph or MT_NO_PARTNER */
    uint32_t *
        origin; /* of each of A's glyphs: the character that leads here, or whose form it is; 0: none known */
    bool *taken; /* for each of B's glyphs: it is a partner */
} mt_glyph_match;

/* No glyph has a partner but .notdef. MT_NO_MEMORY. */
mt_status mt_glyph_match_new(const mt_font *a, const mt_font *b, mt_arena *arena, mt_glyph_match *match);

/* Pairs two glyphs unless A's has a partner; whether it had none. */
bool mt_match_pair(mt_glyph_match *match, uint32_t a, uint32_t b, uint32_t origin);

/* match_names.c: pairs glyphs of the same name, of those that are in no pair yet. Names that only tell a number do not
 * count. MT_NO_MEMORY. */
mt_status mt_match_names(mt_glyph_match *match, mt_font *a, mt_font *b, mt_arena *arena);

/* match_forms.c: where the same layout feature leads from paired glyphs to a glyph in both fonts, pairs these, and so on
 * from there: for the same script and language where both fonts have them, then for any. MT_NO_MEMORY. */
mt_status mt_match_forms(mt_glyph_match *match, const mt_gsub *a, const mt_gsub *b, mt_arena *arena);

/* match_reach.c: adds to the glyphs that are `kept` (one for each of A's) what A's features make of them: those that have
 * a partner, or with `all` any. What stands around a glyph in the text is not looked at. MT_NO_MEMORY. */
mt_status mt_match_reach(const mt_glyph_match *match, const mt_gsub *gsub, bool all, mt_arena *arena,
                         bool *kept);
