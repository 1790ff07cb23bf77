/* What the first font of a row has in common with one other: characters, variation sequences, glyphs. */
#pragma once

#include "glyphset/match.h"
#include "source/variation_sequences.h"

/* A sequence of a character that is taken in. */
typedef struct mt_sequence {
    const mt_variation_sequence *a, *b; /* b is NULL where B has none */
} mt_sequence;

typedef struct mt_sequences {
    int count;
    mt_sequence *list; /* by selector, then by character */
} mt_sequences;

typedef struct mt_font_pair {
    mt_codes codes;
    mt_sequences sequences;
    mt_glyph_match match;
    bool *kept; /* of each of A's glyphs: it is in the new font, as far as these two fonts are concerned */
    mt_left_out
        left; /* forms of wanted characters that are not asked for; all zero where all forms are kept */
} mt_font_pair;

/* Pairs the glyphs of both fonts as a person has, then by characters, by variation sequences, by texts, by MATH, by names and by the
 * features that lead to them (match.h). Keeps the pairs and all that A's substitutions and MATH make of them; of limited characters
 * and glyphs these, MATH's for them, and what A's substitutions make of them without being asked, or all with `alternates`.
 * MT_NOTHING_SHARED, MT_ENDLESS_LOOKUPS, MT_NO_MEMORY. */
mt_status mt_font_pair_make(mt_font *a, mt_font *b, const mt_charset_request *request, mt_arena *arena,
                            mt_font_pair *pair);

/* Whether a font's own lookups have no end, of GPOS too: it is to blame where a pair with it has MT_ENDLESS_LOOKUPS. */
bool mt_font_is_endless(mt_font *font);

/* NULL where the pair has not both the character, or the sequence. */
const mt_code *mt_font_pair_code(const mt_font_pair *pair, uint32_t code_point);
const mt_sequence *mt_font_pair_sequence(const mt_font_pair *pair, const mt_sequence *like);
