/* The subtables of one font's pair adjustment, of GPOS and of the old 'kern' table. */
#pragma once

#include "layout/gdef_deltas.h"
#include "layout/value.h"

/* The parts of a pair's value: those of the left glyph's record, then those of the right glyph's. */
enum { MT_PAIR_PARTS = 2 * MT_VALUE_PARTS };

typedef enum mt_pair_kind {
    MT_PAIRS_LISTED,  /* PairPosFormat1 */
    MT_PAIRS_CLASSED, /* PairPosFormat2 */
    MT_KERN_LISTED,   /* 'kern' format 0 */
    MT_KERN_CLASSED,  /* 'kern' format 2 */
} mt_pair_kind;

typedef struct mt_pair_subtable {
    mt_pair_kind kind;
    int lookup;     /* in a lookup the first subtable that applies is the one; lookups add up */
    mt_bytes table; /* of 'kern': from its header on */
    size_t header;  /* bytes of that */
    unsigned formats[2];
    int class_counts[2];
} mt_pair_subtable;

enum { MT_PAIR_SUBTABLES_MAX = 1024 }; /* of one font; more are left out */

typedef struct mt_pair_source {
    const mt_gdef_deltas *variations;
    double scale;   /* what values are multiplied by */
    unsigned parts; /* that any value has, a bit each */
    int count;
    mt_pair_subtable *subtables;
} mt_pair_source; /* all zero is a font that does not kern */
