/* Cursive attachment as subtables of type 3. */
#include "anchors/pool.h"
#include "anchors/write_cursive.h"

/* Glyphs in a part of what does not fit in one subtable. A glyph takes at most 18 bytes of a subtable, 12 where
 * it has one anchor in it; those of two parts have one each. Where anchors vary, it takes 50 and 28. */
enum { HEADER_SIZE = 6, RECORD_SIZE = 4, PART_MAX = 2700, PART_MAX_VARYING = 1150 };

static int part_max(const mt_places *places) {
    return places->store ? PART_MAX_VARYING : PART_MAX;
}

/* The glyphs of a subtable with what they have in it, ascending. */
typedef struct mt_joined {
    int count;
    mt_cursive_glyph *glyphs;
    mt_anchor_pool pool;
} mt_joined;

static mt_status add_glyph(mt_joined *joined, const mt_cursive_glyph *glyph, bool entry, bool exit) {
    mt_status status = MT_OK;
    mt_cursive_glyph *made = &joined->glyphs[joined->count];
    *made = *glyph;
    made->has[0] = glyph->has[0] && entry;
    made->has[1] = glyph->has[1] && exit;
    for (int side = 0; side < 2 && status == MT_OK; side++)
        if (made->has[side]) status = mt_anchor_pool_add(&joined->pool, made->glyph, made->at[side]);
    joined->count += made->has[0] || made->has[1];
    return status;
}

/* The exits of one part of the glyphs and the entries of another: where a line goes from a glyph of the first
 * to one of the second. */
static mt_status join(const mt_cursive *cursive, int exits, int entries, const mt_places *places,
                      mt_arena *arena, mt_joined *joined) {
    int most = part_max(places);
    *joined = (mt_joined){.glyphs = mt_arena_new(arena, 2 * (size_t)most, sizeof *joined->glyphs)};
    mt_status status = mt_anchor_pool_open(places, 2 * most, arena, &joined->pool);
    if (!joined->glyphs || status != MT_OK) return MT_NO_MEMORY;
    for (int i = 0; i < cursive->count && status == MT_OK; i++) {
        bool exit = i / most == exits, entry = i / most == entries;
        if (exit || entry) status = add_glyph(joined, &cursive->glyphs[i], entry, exit);
    }
    mt_anchor_pool_close(&joined->pool);
    return status;
}

static mt_status write_coverage(const mt_joined *joined, mt_arena *arena, mt_table *table) {
    uint16_t *glyphs = mt_arena_new(arena, (size_t)joined->count, sizeof *glyphs);
    if (!glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < joined->count; i++) glyphs[i] = joined->glyphs[i].glyph;
    mt_table_coverage(table, glyphs, joined->count);
    return MT_OK;
}

static mt_status write_joined(const mt_joined *joined, mt_arena *arena, mt_subtables *subtables) {
    mt_table table = {0};
    int to_pool = HEADER_SIZE + RECORD_SIZE * joined->count;
    mt_table pool = {0};
    mt_status status = mt_anchor_pool_write(&joined->pool, &pool);
    mt_table_16(&table, 1);
    mt_table_16(&table, to_pool + (int)pool.length);
    mt_table_16(&table, joined->count);
    for (int i = 0; i < joined->count; i++) {
        const mt_cursive_glyph *glyph = &joined->glyphs[i];
        for (int side = 0; side < 2; side++)
            mt_table_16(&table, glyph->has[side] ? to_pool + mt_anchor_pool_find(&joined->pool, glyph->glyph,
                                                                                 glyph->at[side])
                                                 : 0);
    }
    mt_table_bytes(&table, pool.bytes, pool.length);
    table.failed |= pool.failed;
    mt_table_free(&pool);
    if (status == MT_OK) status = write_coverage(joined, arena, &table);
    if (status == MT_OK) status = mt_subtables_add(&table, arena, subtables);
    mt_table_free(&table);
    return status;
}

mt_status mt_cursive_write(const mt_cursive *cursive, const mt_places *places, mt_arena *arena,
                           mt_subtables *subtables) {
    int most = part_max(places), parts = (cursive->count + most - 1) / most;
    mt_joined joined;
    mt_status status = MT_OK;
    for (int i = 0; i < parts * parts && status == MT_OK; i++) {
        status = join(cursive, i / parts, i % parts, places, arena, &joined);
        if (status == MT_OK && joined.count > 0) status = write_joined(&joined, arena, subtables);
    }
    return status;
}
