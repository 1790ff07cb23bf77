#include "anchors/pool.h"

#include <stdlib.h>
#include <string.h>

enum { STILL_SIZE = 6, VARYING_SIZE = 10 }; /* bytes of an Anchor table, formats 1 and 3 */

int mt_anchor_size_most(const mt_places *places) {
    return places->store ? VARYING_SIZE + 2 * MT_VARIATION_SIZE : STILL_SIZE;
}

/* ---- values -------------------------------------------------------------------------------------------- */

static bool varies(const mt_anchor_value *value) {
    for (int i = 2; i < value->count; i++)
        if (value->coordinates[i] != value->coordinates[i % 2]) return true;
    return false;
}

static int by_place(const void *p, const void *q) {
    const mt_anchor_value *u = p, *v = q;
    if (varies(u) != varies(v)) return varies(u) ? 1 : -1;
    for (int i = 0; i < u->count; i++)
        if (u->coordinates[i] != v->coordinates[i]) return u->coordinates[i] < v->coordinates[i] ? -1 : 1;
    return 0;
}

static void mix(const mt_places *places, int glyph, mt_anchor anchor, int32_t *coordinates) {
    const mt_anchor_point *in = anchor.in_fonts;
    for (int i = 0; i < places->count; i++) {
        mt_between across = mt_between_at_glyph(places, i, glyph, MT_ACROSS),
                   up = mt_between_at_glyph(places, i, glyph, MT_UP);
        coordinates[2 * i] =
            mt_value_rounded(mt_between_mix(across, in[across.first].x, in[across.first + 1].x));
        coordinates[2 * i + 1] = mt_value_rounded(mt_between_mix(up, in[up.first].y, in[up.first + 1].y));
    }
}

/* ---- the pool ------------------------------------------------------------------------------------------ */

mt_status mt_anchor_pool_open(const mt_places *places, int room, mt_arena *arena, mt_anchor_pool *pool) {
    mt_anchor_value *values = mt_arena_new(arena, (size_t)room, sizeof *values);
    if (!values) return MT_NO_MEMORY;
    *pool = (mt_anchor_pool){.places = places, .arena = arena, .values = values};
    return MT_OK;
}

mt_status mt_anchor_pool_add(mt_anchor_pool *pool, int glyph, mt_anchor anchor) {
    int count = 2 * pool->places->count;
    int32_t *coordinates = mt_arena_new(pool->arena, (size_t)count, sizeof *coordinates);
    if (!coordinates) return MT_NO_MEMORY;
    mix(pool->places, glyph, anchor, coordinates);
    pool->values[pool->count++] = (mt_anchor_value){count, coordinates};
    return MT_OK;
}

void mt_anchor_pool_close(mt_anchor_pool *pool) {
    int kept = 0;
    qsort(pool->values, (size_t)pool->count, sizeof *pool->values, by_place);
    for (int i = 0; i < pool->count; i++)
        if (kept == 0 || by_place(&pool->values[kept - 1], &pool->values[i]) != 0)
            pool->values[kept++] = pool->values[i];
    pool->count = kept;
    while (pool->still_count < kept && !varies(&pool->values[pool->still_count])) pool->still_count++;
}

static int place_of(const mt_anchor_pool *pool, int i) {
    int still = i < pool->still_count ? i : pool->still_count;
    return STILL_SIZE * still + VARYING_SIZE * (i - still);
}

int mt_anchor_pool_find(const mt_anchor_pool *pool, int glyph, mt_anchor anchor) {
    int32_t coordinates[2 * MT_STOPS_MAX];
    mt_anchor_value value = {2 * pool->places->count, coordinates};
    mix(pool->places, glyph, anchor, coordinates);
    const mt_anchor_value *found = bsearch(&value, pool->values, (size_t)pool->count, sizeof value, by_place);
    return place_of(pool, (int)(found - pool->values));
}

int mt_anchor_pool_size(const mt_anchor_pool *pool) {
    return place_of(pool, pool->count);
}

/* ---- writing ------------------------------------------------------------------------------------------- */

/* Where the table of how x (0) or y (1) varies lies from the anchor's start; 0 for none. */
static int variation_of(const mt_anchor_pool *pool, int i, int axis, mt_variation_pool *variations) {
    int32_t values[MT_STOPS_MAX];
    for (int k = 0; k < pool->places->count; k++) values[k] = pool->values[i].coordinates[2 * k + axis];
    int at = mt_variation_pool_add(variations, values);
    return at < 0 ? 0 : mt_anchor_pool_size(pool) - place_of(pool, i) + at;
}

mt_status mt_anchor_pool_write(const mt_anchor_pool *pool, mt_table *table) {
    mt_variation_pool variations = mt_variation_pool_make(pool->places->store);
    for (int i = 0; i < pool->count; i++) {
        bool still = i < pool->still_count;
        mt_table_16(table, still ? 1 : 3);
        for (int axis = 0; axis < 2; axis++) mt_table_16(table, pool->values[i].coordinates[axis]);
        for (int axis = 0; axis < 2 && !still; axis++)
            mt_table_16(table, variation_of(pool, i, axis, &variations));
    }
    mt_variation_pool_write(&variations, table);
    mt_variation_pool_free(&variations);
    return variations.status;
}
