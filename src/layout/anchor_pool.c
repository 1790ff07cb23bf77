#include "layout/anchor_pool.h"

#include <math.h>
#include <stdlib.h>

static int16_t whole(double value) {
    return (int16_t)fmin(fmax(floor(value + 0.5), INT16_MIN), INT16_MAX);
}

static mt_anchor_value value_at(const mt_anchor *anchor, double t) {
    const mt_anchor_point *a = &anchor->ends[0], *b = &anchor->ends[1];
    return (mt_anchor_value){whole((1 - t) * a->x + t * b->x), whole((1 - t) * a->y + t * b->y)};
}

static int by_place(const void *p, const void *q) {
    const mt_anchor_value *u = p, *v = q;
    return u->x != v->x ? u->x - v->x : u->y - v->y;
}

mt_status mt_anchor_pool_open(double t, int room, mt_arena *arena, mt_anchor_pool *pool) {
    mt_anchor_value *values = mt_arena_new(arena, (size_t)room, sizeof *values);
    if (!values) return MT_NO_MEMORY;
    *pool = (mt_anchor_pool){.t = t, .values = values};
    return MT_OK;
}

void mt_anchor_pool_add(mt_anchor_pool *pool, const mt_anchor *anchor) {
    pool->values[pool->count++] = value_at(anchor, pool->t);
}

void mt_anchor_pool_close(mt_anchor_pool *pool) {
    int kept = 0;
    qsort(pool->values, (size_t)pool->count, sizeof *pool->values, by_place);
    for (int i = 0; i < pool->count; i++)
        if (kept == 0 || by_place(&pool->values[kept - 1], &pool->values[i]) != 0)
            pool->values[kept++] = pool->values[i];
    pool->count = kept;
}

int mt_anchor_pool_find(const mt_anchor_pool *pool, const mt_anchor *anchor) {
    mt_anchor_value value = value_at(anchor, pool->t);
    const mt_anchor_value *found = bsearch(&value, pool->values, (size_t)pool->count, sizeof value, by_place);
    return MT_ANCHOR_SIZE * (int)(found - pool->values);
}

void mt_anchor_pool_write(const mt_anchor_pool *pool, mt_table *table) {
    for (int i = 0; i < pool->count; i++) {
        mt_table_16(table, 1);
        mt_table_16(table, pool->values[i].x);
        mt_table_16(table, pool->values[i].y);
    }
}
