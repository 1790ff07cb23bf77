/* Which characters and glyphs a blend has. */
#ifndef MT_GLYPHSET_CHARSET_H
#define MT_GLYPHSET_CHARSET_H

#include "glyphset/match.h"
#include "gsub/subset.h"
#include "write/font_data.h"

/* A glyph of the new font: the glyphs of the two sources that it lies between. */
typedef struct mt_pairing {
    uint32_t code_point; /* the first that leads here, or that this is a form of; 0 where there is none */
    uint32_t a, b;       /* b is MT_NO_PARTNER for a glyph of A's that stays as it is */
    bool mapped;         /* the character of code_point leads here */
} mt_pairing;

/* The glyphs up to primary_count are A's, each once, in A's order; glyph 0 is .notdef. Those behind are further pairs of
 * one of them with other glyphs of B's, for characters that A has one glyph for and B has two: they are substituted as that
 * one is, but no substitution leads to them. */
typedef struct mt_charset {
    int glyph_count, primary_count;
    mt_pairing *glyphs;
    int unblended_count; /* of the glyphs without a partner */
    int char_count;
    mt_char *chars; /* ascending */
    int variant_count;
    mt_char_variation *variants; /* variation sequences of these characters; by selector, then by character */
} mt_charset;

typedef struct mt_charset_request {
    const uint32_t *wanted; /* only these code points, in any order, and their forms */
    int count;              /* 0: all */
    mt_glyph_set set;
} mt_charset_request;

/* Pairs the glyphs of both fonts by characters, by variation sequences, by names and by the features that lead to them (font/match.h), and keeps
 * the pairs, or all of A's glyphs. Of limited characters it keeps their glyphs and those that A's substitutions make of
 * them. Where a font cannot hold all further pairs, their characters lead to A's one. MT_NOTHING_SHARED, MT_NO_MEMORY. */
mt_status mt_charset_make(mt_font *a, mt_font *b, const mt_charset_request *request, mt_arena *arena,
                          mt_charset *charset);

/* Adds the further pairs to the first font's tables, which are pruned to the first primary_count glyphs. MT_NO_MEMORY. */
mt_status mt_charset_twins(const mt_charset *charset, mt_arena *arena, mt_layout_tables *tables);

#endif
