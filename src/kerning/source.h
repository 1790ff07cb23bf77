/* Pair adjustment of one font: subtables of GPOS and of the old 'kern' table, read in one way.
 *
 * A subtable is a list of pairs, or a matrix of classes. What it has for a left glyph is a row, for a right glyph of a
 * matrix a column: numbers without further meaning, the same for glyphs that it does not tell apart, and -1 where it has
 * nothing. */
#ifndef MT_KERNING_SOURCE_H
#define MT_KERNING_SOURCE_H

#include "layout/layout.h"
#include "layout/value.h"
#include "sfnt/sfnt.h"

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

/* The pair adjustment of these lookups of GPOS, in their order. MT_NO_MEMORY. */
mt_status mt_pair_source_gpos(const mt_layout *layout, const int *lookups, int count,
                              const mt_gdef_deltas *variations, double scale, mt_arena *arena,
                              mt_pair_source *source);
/* That of a 'kern' table: formats 0 and 2, horizontal, neither of minima nor across the line. MT_NO_MEMORY. */
mt_status mt_pair_source_kern(mt_bytes kern, double scale, mt_arena *arena, mt_pair_source *source);
/* Whether a 'kern' table has any such subtable. */
bool mt_kern_table_kerns(mt_bytes kern);

bool mt_pair_is_listed(const mt_pair_subtable *subtable);
int mt_pair_row(const mt_pair_subtable *subtable, uint32_t left);
int mt_pair_column(const mt_pair_subtable *subtable, uint32_t right); /* -1 for a list */

/* The right glyphs that a list has for a row (of the glyph `left`), numbered from 0. */
int mt_pair_listed_count(const mt_pair_subtable *subtable, int row, uint32_t left);
uint32_t mt_pair_listed(const mt_pair_subtable *subtable, int row, uint32_t left, int i);

/* A pair as subtables see it: a row and a column in each, and the glyphs for the lists. */
typedef struct mt_pair {
    const int32_t *rows, *columns;
    uint32_t left, right;
} mt_pair;

/* The value of a pair; with rows of -1 in all lists, what the classes alone give. */
void mt_pair_value(const mt_pair_source *source, const mt_pair *pair, double values[MT_PAIR_PARTS]);

#endif
