/* Which of B's glyphs each of A's is blended with. */
#pragma once

#include "base/memory.h"
#include "glyphset/codes.h"
#include "glyphset/inks.h"
#include "glyphset/runs.h"
#include "glyphset/shaper.h"
#include "glyphset/votes.h"
#include "gsub/gsub.h"
#include "math/table/math_table.h"
#include "source/font.h"

/* B's glyph where B has none. */
#define MT_NO_PARTNER UINT32_MAX

typedef struct mt_glyph_match {
    mt_font *a, *b;
    int count_a, count_b;
    uint32_t *partner; /* of each of A's glyphs: B's glyph, of the font or composed, or MT_NO_PARTNER */
    uint32_t *
        origin; /* of each of A's glyphs: the character that leads here, or whose form it is; 0: none known */
    bool *taken;   /* for each of B's glyphs: it is a partner */
    bool *reached; /* for each of A's glyphs: the new font may have it; NULL: any of them */
    mt_inks ink_a, ink_b;
} mt_glyph_match;

/* No glyph has a partner but .notdef. MT_NO_MEMORY. */
mt_status mt_glyph_match_new(mt_font *a, mt_font *b, mt_arena *arena, mt_glyph_match *match);

/* Pairs two glyphs unless A's has a partner; whether it had none. */
bool mt_match_pair(mt_glyph_match *match, uint32_t a, uint32_t b, uint32_t origin);

/* The same for two glyphs that no character leads to: a blank glyph is not paired with one that has ink. Of those that are not
 * reached this is not asked, since all outlines of a font of 65 535 glyphs take a second to read. */
bool mt_match_form(mt_glyph_match *match, uint32_t a, uint32_t b, uint32_t origin);

/* match_text.c: what both fonts' own shaping makes of the same texts. */
typedef struct mt_text_pairs {
    bool found; /* there is a GSUB: otherwise shaping tells nothing */
    mt_shaper a, b;
    mt_runs runs; /* of B's */
    mt_votes votes;
} mt_text_pairs; /* refers to itself: it stays where it is */

/* Shapes texts of the characters, which both fonts have, in ascending order. MT_NO_MEMORY. */
mt_status mt_text_pairs_find(mt_text_pairs *pairs, mt_glyph_match *match, const mt_gsub *gsub_a,
                             const mt_gsub *gsub_b, const uint32_t *chars, int count, mt_arena *arena);
/* Where a character by itself leads to A's own glyph for it, and in B to another than B's own, that takes its place; to several,
 * what they draw. Not where A's has a partner already. MT_NO_MEMORY. */
mt_status mt_text_pairs_settle(mt_text_pairs *pairs, const mt_glyph_match *match, mt_code *codes, int count);
/* Pairs each glyph of A's with that of B's that most texts lead to, or with what several draw. MT_NO_MEMORY. */
mt_status mt_text_pairs_apply(const mt_text_pairs *pairs, mt_glyph_match *match);
void mt_text_pairs_close(mt_text_pairs *pairs);

/* match_names.c: pairs glyphs of the same name, of those that are in no pair yet. Names that only tell a number do not
 * count. MT_NO_MEMORY. */
mt_status mt_match_names(mt_glyph_match *match, mt_font *a, mt_font *b, mt_arena *arena);

/* match_forms.c: where the same layout feature leads from paired glyphs to a glyph in both fonts, pairs these, and so on
 * from there: for the same script and language where both fonts have them, then for any. MT_NO_MEMORY. */
mt_status mt_match_forms(mt_glyph_match *match, const mt_gsub *a, const mt_gsub *b, mt_arena *arena);

/* match_math.c: pairs what the MATH tables of both fonts have for paired glyphs: larger glyphs by their order, parts of assemblies
 * that are alike by their places. */
void mt_match_math(mt_glyph_match *match, const mt_math_table *a, const mt_math_table *b);
/* Takes the parts of A's assemblies apart from their partners where they would not join in a font that varies, whose lengths of
 * parts do not: unless B has the same assembly, in which no length differs by more than half the least overlap. */
void mt_match_math_hold(mt_glyph_match *match, const mt_math_table *a, const mt_math_table *b);
/* Adds to the glyphs that are `kept` the larger ones and the parts that A's MATH has for them; whether there were any. */
bool mt_match_math_reach(const mt_math_table *math, bool *kept);

/* match_reach.c: adds to the glyphs that are `kept` (one for each of A's) what A's features make of them, all but 'aalt', which
 * only lists alternates. MT_NO_MEMORY. */
mt_status mt_match_reach(const mt_gsub *gsub, bool *kept);
/* The same by the features alone that text has without asking for them (feature_tags.h), or that a language requires. */
mt_status mt_match_reach_automatic(const mt_gsub *gsub, bool fractions, bool *kept);

/* Glyphs that only other features lead to, and these features. */
typedef struct mt_left_out {
    bool *glyphs; /* of each of A's glyphs */
    int tag_count;
    uint32_t *tags; /* in the font's order, each once */
} mt_left_out;

/* Of the glyphs that mt_match_reach would add to those that mt_match_reach_automatic has left; in the arena. MT_NO_MEMORY. */
mt_status mt_match_left_out(const mt_gsub *gsub, const bool *kept, bool fractions, mt_arena *arena,
                            mt_left_out *left);
