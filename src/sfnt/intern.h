/* Rows of whole numbers, each kept once and numbered in the order in which they first come. */
#pragma once

#include <stdint.h>

#include "morphotype.h"

typedef struct mt_interned {
    int width; /* numbers in a row; may be 0 */
    int count, room;
    int32_t *rows;
    int *slots; /* a hash table of row numbers, -1 where free */
    int slot_count;
} mt_interned; /* all zero but the width is an empty set */

/* The number of a row, which is added if it is new. MT_NO_MEMORY. */
mt_status mt_intern(mt_interned *set, const int32_t *row, int *number);
/* The same for a row of zeros, or of `value` throughout. */
mt_status mt_intern_filled(mt_interned *set, int32_t value, int *number);
const int32_t *mt_interned_row(const mt_interned *set, int number);
void mt_interned_free(mt_interned *set);
