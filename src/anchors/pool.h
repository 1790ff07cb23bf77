/* Anchors as they are written: whole units, those that are the same at all places only once; behind them what varies in
 * them (OpenType spec, "GPOS": Anchor table formats 1 and 3). */
#pragma once

#include "anchors/anchor.h"
#include "layout/value_write.h"

/* An anchor's coordinates: x and y at each place in turn. */
typedef struct mt_anchor_value {
    int count; /* of coordinates */
    const int32_t *coordinates;
} mt_anchor_value;

typedef struct mt_anchor_pool {
    const mt_places *places;
    mt_arena *arena;
    int count, still_count;  /* the still ones come first */
    mt_anchor_value *values; /* ascending by x, then y, at the first place, and so on */
} mt_anchor_pool;

/* The most bytes that an anchor takes with what varies in it. */
int mt_anchor_size_most(const mt_places *places);

/* An empty pool with room for that many. MT_NO_MEMORY. */
mt_status mt_anchor_pool_open(const mt_places *places, int room, mt_arena *arena, mt_anchor_pool *pool);
mt_status mt_anchor_pool_add(mt_anchor_pool *pool, int glyph, mt_anchor anchor); /* MT_NO_MEMORY */
/* Sorts the values, when all are added. */
void mt_anchor_pool_close(mt_anchor_pool *pool);

/* Where a glyph's anchor that was added lies, in bytes from the start of the pool; and how many bytes all anchors take. */
int mt_anchor_pool_find(const mt_anchor_pool *pool, int glyph, mt_anchor anchor);
int mt_anchor_pool_size(const mt_anchor_pool *pool);
/* MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_anchor_pool_write(const mt_anchor_pool *pool, mt_table *table);
