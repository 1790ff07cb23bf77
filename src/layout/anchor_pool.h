/* Anchors at one T as they are written: whole units, those that fall together only once. */
#ifndef MT_ANCHOR_POOL_H
#define MT_ANCHOR_POOL_H

#include "layout/anchor.h"

enum { MT_ANCHOR_SIZE = 6 }; /* bytes of an Anchor table, format 1 */

typedef struct mt_anchor_value {
    int16_t x, y;
} mt_anchor_value;

typedef struct mt_anchor_pool {
    double t;
    int count;
    mt_anchor_value *values; /* ascending by x, then y */
} mt_anchor_pool;

/* An empty pool with room for that many. MT_NO_MEMORY. */
mt_status mt_anchor_pool_open(double t, int room, mt_arena *arena, mt_anchor_pool *pool);
void mt_anchor_pool_add(mt_anchor_pool *pool, const mt_anchor *anchor);
/* Sorts the values, when all are added. */
void mt_anchor_pool_close(mt_anchor_pool *pool);

/* Where an anchor that was added lies, in bytes from the start of the pool. */
int mt_anchor_pool_find(const mt_anchor_pool *pool, const mt_anchor *anchor);
void mt_anchor_pool_write(const mt_anchor_pool *pool, mt_table *table);

#endif
