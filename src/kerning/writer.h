/* What the writers of both formats of pair adjustment share. */
#pragma once

#include "kerning/mix.h"
#include "layout/lookup_builder.h"

/* What the writers of the two formats share: subtables as they are made. */
typedef struct mt_pair_writer {
    const mt_mixed_pairs *mixed;
    mt_var_store *store;
    mt_arena *arena;
    mt_subtables subtables;
} mt_pair_writer;

void mt_pair_write_header(mt_table *table, int format, size_t coverage, mt_value_format values);

/* Where a 16-bit offset may lead at most. */
enum { MT_OFFSET_MAX = UINT16_MAX };
