/* Where the parts of a context's rule stand in its table (OpenType spec, "Sequence context" and "Chained sequence context"). */
#pragma once

#include "layout/ot.h"

/* The three sequences of a rule: glyphs before, from the nearest on; those that it is for; glyphs after. */
enum { MT_BEFORE, MT_INPUT, MT_AFTER, MT_SEQUENCES };

/* A rule in its table: the sequences without their counts, and the records of calls: a place in the input and a lookup each. */
typedef struct mt_rule_layout {
    int counts[MT_SEQUENCES];
    size_t at[MT_SEQUENCES]; /* of the numbers that stand there: a glyph, a class or an offset each */
    int call_count;
    size_t calls_at;
    bool whole; /* it has an input, and all of it lies within the table */
} mt_rule_layout;

/* `from` is where the counts begin, and `first` is 1 where the input's first place is told elsewhere, as in formats 1 and 2; in format 3,
 * 0. */
mt_rule_layout mt_find_rule(mt_bytes table, bool chained, size_t from, int first);

/* Where the count of the rules' sets stands in a table of format 1 or 2; their offsets follow. */
size_t mt_rule_sets_at(unsigned format, bool chained);
