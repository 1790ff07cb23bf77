/* Pair adjustment at one T as subtables of a lookup. */
#ifndef MT_PAIR_WRITE_H
#define MT_PAIR_WRITE_H

#include "layout/made.h"
#include "layout/pair_mix.h"

/* PairPosFormat1 for the listed pairs, then PairPosFormat2 for the matrix: as many of each as 16-bit offsets ask for.
 * No left glyph is in two of them of the same format. No subtables where every value is 0. In the arena. MT_NO_MEMORY,
 * MT_TOO_LARGE. */
mt_status mt_pairs_write(const mt_mixed_pairs *mixed, mt_arena *arena, mt_bytes **subtables, int *count);

/* What the writers of the two formats share: subtables as they are made. */
typedef struct mt_pair_writer {
    const mt_mixed_pairs *mixed;
    mt_arena *arena;
    mt_bytes *subtables;
    int count, room;
} mt_pair_writer;

/* Takes a subtable, and frees the table. MT_NO_MEMORY. */
mt_status mt_pair_writer_add(mt_pair_writer *writer, mt_table *table);
/* A bit for each part of `count` values in a row that is not 0 in all of them. */
unsigned mt_pair_format(const mt_mixed_pairs *mixed, const int *values, int count);
void mt_pair_write_header(mt_table *table, int format, size_t coverage, unsigned value_format);
void mt_pair_write_values(mt_table *table, const mt_mixed_pairs *mixed, unsigned format, const int *values);

/* pair_write_list.c, pair_write_matrix.c */
mt_status mt_pair_write_list(mt_pair_writer *writer);
mt_status mt_pair_write_matrix(mt_pair_writer *writer);

/* Where a 16-bit offset may lead at most. */
enum { MT_OFFSET_MAX = UINT16_MAX };

#endif
