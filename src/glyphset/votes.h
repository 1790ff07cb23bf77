/* How often the same place of a text leads to a glyph of A's and to one of B's, or to what several of B's draw. */
#pragma once

#include "base/memory.h"
#include "glyphset/runs.h"
#include "glyphset/shaper.h"

typedef struct mt_vote {
    uint16_t a;
    uint32_t b;      /* a glyph, or the number of a drawing (runs.h) */
    uint32_t count;  /* 0: an empty place of the table */
    uint32_t origin; /* the first character at a place of a text that led to both */
} mt_vote;

typedef struct mt_votes {
    mt_shaper *a, *b;
    mt_inks *ink_a, *ink_b;
    mt_runs *runs;   /* of B's */
    int count, room; /* room: a power of two */
    mt_vote *list;   /* from mt_new; open addressing until mt_votes_sort */
    bool failed;     /* there was no memory */
} mt_votes;

void mt_votes_free(mt_votes *votes); /* all zero is fine */

/* Shapes a text with both fonts and compares where they lead, place by place: a place is as short a part of the text as
 * both keep together, and longer where one font has a blank for what the other draws: the ink comes before or behind. Where a place
 * has as many glyphs in both fonts, blank ones and others in the same order, each of A's gets a vote for that of B's, and more
 * weight where it is one. Where A has one glyph with ink it gets a vote for what B's glyphs draw together. Nothing for a text
 * that leads to .notdef. */
void mt_votes_add(mt_votes *votes, const uint32_t *codes, int count);

/* The votes in a row: by A's glyphs, the most first. Nothing can be added any more. */
void mt_votes_sort(mt_votes *votes);
