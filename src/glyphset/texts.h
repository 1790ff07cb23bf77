/* Texts that lead to the glyphs of two fonts. */
#pragma once

#include "base/memory.h"
#include "glyphset/votes.h"
#include "gsub/gsub.h"

typedef struct mt_texts {
    mt_votes *votes;
    int count;             /* of the characters that both fonts have */
    const uint32_t *chars; /* ascending */
} mt_texts;

/* texts.c: each character by itself, and what scripts make of several: letters that join, letters with one mark and with two,
 * consonants joined by a virama, syllables of jamo. Of more than a few thousand texts of one kind some are left out, evenly.
 * MT_NO_MEMORY. */
mt_status mt_texts_of_scripts(const mt_texts *texts, const mt_gsub *gsub_a, const mt_gsub *gsub_b,
                              mt_arena *arena);

/* text_rules.c: for each ligature and each context of A's GSUB a text that spells it. MT_NO_MEMORY. */
mt_status mt_texts_of_rules(const mt_texts *texts, const mt_gsub *gsub, mt_arena *arena);
