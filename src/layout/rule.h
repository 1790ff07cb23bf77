/* Where the rules of contexts stand, and the parts of each in its table (OpenType spec, "Sequence context" and "Chained sequence
 * context"). */
#pragma once

#include "layout/layout.h"

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

/* A rule in its table, whose counts begin at `from`. */
typedef void (*mt_rule_seen)(mt_bytes table, bool chained, size_t from, const mt_rule_layout *rule,
                             void *user);

/* Of rules and their records that are read: a table whose parts share bytes can hold more than there is memory. The largest fonts have a
 * hundredth. */
enum { MT_RULE_NUMBERS_MAX = 1 << 22 };

/* All rules of a lookup, none where it is no context: types 5 and 6 of GSUB, 7 and 8 of GPOS. *left falls by 1 for each subtable, set and
 * rule, and by what `seen` takes of it, and ends the reading below 0. */
void mt_each_rule(const mt_layout *layout, int lookup, int *left, mt_rule_seen seen, void *user);
