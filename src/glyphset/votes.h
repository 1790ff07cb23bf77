/* How often the same place of a text leads to a glyph of A's and to one of B's. */
#pragma once

#include "base/memory.h"
#include "glyphset/shaper.h"

typedef struct mt_vote {
    uint16_t a, b;
    uint32_t count;  /* 0: an empty place of the table */
    uint32_t origin; /* the first character at a place of a text that led to both */
} mt_vote;

typedef struct mt_votes {
    int count, room; /* room: a power of two */
    mt_vote *list;   /* from mt_new; open addressing until mt_votes_sort */
    bool failed;     /* there was no memory */
} mt_votes;

void mt_votes_free(mt_votes *votes);

/* Shapes a text with both fonts and compares where they lead, place by place: a place is as short a part of the text as
 * both keep together. Where a place has as many glyphs in both fonts each of A's gets a vote for that of B's, and more weight
 * where it is one. Nothing for a text that leads to .notdef. */
void mt_votes_add(mt_votes *votes, mt_shaper *a, mt_shaper *b, const uint32_t *codes, int count);

/* The votes in a row: by A's glyphs, the most first. Nothing can be added any more. */
void mt_votes_sort(mt_votes *votes);
