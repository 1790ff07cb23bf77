/* Cursive attachment as subtables of type 3. */
#include "layout/anchor_pool.h"
#include "layout/anchor_write.h"

/* Glyphs in a part of what does not fit in one subtable. A glyph takes at most 18 bytes of a subtable, 12 where
 * it has one anchor in it; those of two parts have one each. */
enum { HEADER_SIZE = 6, RECORD_SIZE = 4, PART_MAX = 2700 };

/* The glyphs of a subtable with what they have in it, ascending. */
typedef struct mt_joined {
    int count;
    mt_cursive_glyph *glyphs;
    mt_anchor_pool pool;
} mt_joined;

static void add_glyph(mt_joined *joined, const mt_cursive_glyph *glyph, bool entry, bool exit) {
    mt_cursive_glyph *made = &joined->glyphs[joined->count];
    *made = *glyph;
    made->has[0] = glyph->has[0] && entry;
    made->has[1] = glyph->has[1] && exit;
    for (int side = 0; side < 2; side++)
        if (made->has[side]) mt_anchor_pool_add(&joined->pool, &made->at[side]);
    joined->count += made->has[0] || made->has[1];
}

/* The exits of one part of the glyphs and the entries of another: where a line goes from a glyph of the first
 * to one of the second. */
static mt_status join(const mt_cursive *cursive, int exits, int entries, double t, mt_arena *arena,
                      mt_joined *joined) {
    *joined = (mt_joined){.glyphs = mt_arena_new(arena, 2 * PART_MAX, sizeof *joined->glyphs)};
    mt_status status = mt_anchor_pool_open(t, 2 * PART_MAX, arena, &joined->pool);
    if (!joined->glyphs || status != MT_OK) return MT_NO_MEMORY;
    for (int i = 0; i < cursive->count; i++) {
        bool exit = i / PART_MAX == exits, entry = i / PART_MAX == entries;
        if (exit || entry) add_glyph(joined, &cursive->glyphs[i], entry, exit);
    }
    mt_anchor_pool_close(&joined->pool);
    return MT_OK;
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
    mt_table_16(&table, 1);
    mt_table_16(&table, to_pool + MT_ANCHOR_SIZE * joined->pool.count);
    mt_table_16(&table, joined->count);
    for (int i = 0; i < joined->count; i++) {
        const mt_cursive_glyph *glyph = &joined->glyphs[i];
        for (int side = 0; side < 2; side++)
            mt_table_16(&table, glyph->has[side]
                                    ? to_pool + mt_anchor_pool_find(&joined->pool, &glyph->at[side])
                                    : 0);
    }
    mt_anchor_pool_write(&joined->pool, &table);
    mt_status status = write_coverage(joined, arena, &table);
    if (status == MT_OK) status = mt_subtables_add(&table, arena, subtables);
    mt_table_free(&table);
    return status;
}

mt_status mt_cursive_write(const mt_cursive *cursive, double t, mt_arena *arena, mt_subtables *subtables) {
    int parts = (cursive->count + PART_MAX - 1) / PART_MAX;
    mt_joined joined;
    mt_status status = MT_OK;
    for (int i = 0; i < parts * parts && status == MT_OK; i++) {
        status = join(cursive, i / parts, i % parts, t, arena, &joined);
        if (status == MT_OK && joined.count > 0) status = write_joined(&joined, arena, subtables);
    }
    return status;
}
