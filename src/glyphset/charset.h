/* Which characters and glyphs a blend has. */
#pragma once

#include "glyphset/font_pair.h"
#include "gsub/subset.h"
#include "sfnt/var_store.h"
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
    int left_count;      /* of the first font's glyphs that only features lead to which are not asked for */
    int left_tag_count;  /* of these features */
    const uint32_t *left_tags;
    int char_count;
    mt_char *chars; /* ascending */
    int variant_count;
    mt_char_variation *variants; /* variation sequences of these characters; by selector, then by character */
} mt_charset;

/* The glyphs of the new font, as each font has them. */
typedef struct mt_font_glyphs {
    int font_count, glyph_count;
    const uint32_t *of[MT_STOPS_MAX]; /* MT_NO_PARTNER where a font has none; the first has all */
} mt_font_glyphs;

/* The glyph set of a row: its characters, and the first font's glyphs with those of the second; and the glyphs of every font.
 * A glyph that some font has not stays as it is in the first: no other font has it here. */
typedef struct mt_row_glyphs {
    mt_charset charset;
    mt_font_glyphs fonts;
} mt_row_glyphs;

/* Pairs the glyphs of the first font with those of each other one (font_pair.h), and keeps those that have a partner in all
 * of them, or all of the first font's. Where a font cannot hold all further tuples, their characters lead to the first font's
 * glyph. MT_NOTHING_SHARED, MT_NO_MEMORY. */
mt_status mt_row_glyphs_make(mt_font *const *fonts, int count, const mt_charset_request *request,
                             mt_arena *arena, mt_row_glyphs *glyphs);
/* What goes with glyphs of the first font in a new font of all characters: partners[k][i] is font number k's glyph for glyphs[i], or
 * MT_NO_PARTNER, in the arena. `partners` has one for each font; pairs may be NULL. As mt_row_glyphs_make. */
mt_status mt_row_partners(mt_font *const *fonts, int count, const mt_given_pairs *pairs,
                          const uint32_t *glyphs, int glyph_count, mt_arena *arena, uint32_t **partners);
/* Of a row of two. */
mt_status mt_charset_make(mt_font *a, mt_font *b, const mt_charset_request *request, mt_arena *arena,
                          mt_charset *charset);

/* Adds the further pairs to the first font's tables, which are pruned to the first primary_count glyphs. MT_NO_MEMORY. */
mt_status mt_charset_twins(const mt_charset *charset, mt_arena *arena, mt_layout_tables *tables);
