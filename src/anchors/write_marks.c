/* Marks of one class and their bases as subtables of types 4 to 6. */
#include "anchors/pool.h"
#include "anchors/write_marks.h"

/* A subtable has a header, both coverages, the marks and the bases, in this order. With so many marks, of 10 bytes
 * each, and bases that take up to 64 KB, 8 bytes at least each, the bases start under 64 KB; where anchors vary, a mark
 * takes up to 26 bytes, and bases are counted as 24 at least. */
enum { HEADER_SIZE = 12, MARKS_MAX = 4000, MARKS_MAX_VARYING = 2000, BASES_SIZE_MAX = 65535 };

/* A part of an attachment that makes one subtable. */
typedef struct mt_mark_part {
    int type;
    const mt_places *places;
    const mt_anchored *marks, *bases;
    int mark_count, base_count, glyph_count; /* glyphs: a base's components are one */
} mt_mark_part;

static int glyph_end(const mt_anchored *anchored, int count, int start) {
    int end = start + 1;
    while (end < count && anchored[end].glyph == anchored[start].glyph) end++;
    return end;
}

/* ---- arrays of anchors --------------------------------------------------------------------------------- */

static mt_status write_coverage(const mt_anchored *anchored, int count, mt_arena *arena, mt_table *table) {
    uint16_t *glyphs = mt_arena_new(arena, (size_t)count, sizeof *glyphs);
    int glyph_count = 0;
    if (!glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < count; i = glyph_end(anchored, count, i)) glyphs[glyph_count++] = anchored[i].glyph;
    mt_table_coverage(table, glyphs, glyph_count);
    return MT_OK;
}

static mt_status pool_of(const mt_anchored *anchored, int count, const mt_places *places, mt_arena *arena,
                         mt_anchor_pool *pool) {
    mt_status status = mt_anchor_pool_open(places, count, arena, pool);
    for (int i = 0; i < count && status == MT_OK; i++)
        status = mt_anchor_pool_add(pool, anchored[i].glyph, anchored[i].at);
    if (status == MT_OK) mt_anchor_pool_close(pool);
    return status;
}

static mt_status write_marks(const mt_mark_part *part, mt_arena *arena, mt_table *table) {
    mt_anchor_pool pool;
    mt_status status = pool_of(part->marks, part->mark_count, part->places, arena, &pool);
    if (status != MT_OK) return status;
    mt_table_16(table, part->mark_count);
    for (int i = 0; i < part->mark_count; i++) {
        mt_table_16(table, 0);
        mt_table_16(table, 2 + 4 * part->mark_count +
                               mt_anchor_pool_find(&pool, part->marks[i].glyph, part->marks[i].at));
    }
    return mt_anchor_pool_write(&pool, table);
}

/* One ligature's components; the pool starts `to_pool` bytes from here. */
static void write_ligature(const mt_anchored *bases, int count, int to_pool, const mt_anchor_pool *pool,
                           mt_table *table) {
    mt_table_16(table, bases->component_count);
    for (int c = 0, i = 0; c < bases->component_count; c++) {
        bool has = i < count && bases[i].component == c;
        mt_table_16(table, has ? to_pool + mt_anchor_pool_find(pool, bases[i].glyph, bases[i].at) : 0);
        i += has;
    }
}

static int ligature_size(const mt_anchored *base) {
    return 2 + 2 * base->component_count;
}

static void write_ligatures(const mt_mark_part *part, const mt_anchor_pool *pool, mt_table *table) {
    const mt_anchored *bases = part->bases;
    int count = part->base_count, at = 2 + 2 * part->glyph_count;
    for (int i = 0; i < count; i = glyph_end(bases, count, i)) {
        mt_table_16(table, at);
        at += ligature_size(&bases[i]);
    }
    int to_pool = at - 2 - 2 * part->glyph_count;
    for (int i = 0, end; i < count; i = end) {
        end = glyph_end(bases, count, i);
        write_ligature(bases + i, end - i, to_pool, pool, table);
        to_pool -= ligature_size(&bases[i]);
    }
}

static mt_status write_bases(const mt_mark_part *part, mt_arena *arena, mt_table *table) {
    mt_anchor_pool pool;
    mt_status status = pool_of(part->bases, part->base_count, part->places, arena, &pool);
    if (status != MT_OK) return status;
    mt_table_16(table, part->glyph_count);
    if (part->type == MT_MARK_TO_LIGATURE)
        write_ligatures(part, &pool, table);
    else
        for (int i = 0; i < part->base_count; i++)
            mt_table_16(table, 2 + 2 * part->base_count +
                                   mt_anchor_pool_find(&pool, part->bases[i].glyph, part->bases[i].at));
    return mt_anchor_pool_write(&pool, table);
}

/* ---- subtables ----------------------------------------------------------------------------------------- */

/* The four parts after the header, and where each starts; a failed table is noticed when it is kept. */
static mt_status write_parts(const mt_mark_part *part, mt_arena *arena, mt_table *table, size_t starts[4]) {
    starts[0] = HEADER_SIZE;
    mt_status status = write_coverage(part->marks, part->mark_count, arena, table);
    starts[1] = HEADER_SIZE + table->length;
    if (status == MT_OK) status = write_coverage(part->bases, part->base_count, arena, table);
    starts[2] = HEADER_SIZE + table->length;
    if (status == MT_OK) status = write_marks(part, arena, table);
    starts[3] = HEADER_SIZE + table->length;
    if (status == MT_OK) status = write_bases(part, arena, table);
    return status;
}

static mt_status write_part(const mt_mark_part *part, mt_arena *arena, mt_subtables *subtables) {
    mt_table parts = {0}, table = {0};
    size_t starts[4];
    mt_status status = write_parts(part, arena, &parts, starts);
    if (status == MT_OK) {
        mt_table_16(&table, 1);
        mt_table_16(&table, (int)starts[0]);
        mt_table_16(&table, (int)starts[1]);
        mt_table_16(&table, 1); /* one class */
        mt_table_16(&table, (int)starts[2]);
        mt_table_16(&table, (int)starts[3]);
        mt_table_bytes(&table, parts.bytes, parts.length);
        table.failed |= parts.failed;
        status = mt_subtables_add(&table, arena, subtables);
    }
    mt_table_free(&parts);
    mt_table_free(&table);
    return status;
}

/* What the components start … end of one base take at most. */
static int base_size(const mt_mark_part *part, int start, int end) {
    int anchors = mt_anchor_size_most(part->places) * (end - start);
    return part->type == MT_MARK_TO_LIGATURE ? 2 + ligature_size(&part->bases[start]) + anchors : 2 + anchors;
}

/* The bases from `start` on that go into one subtable; none for a base that fits in none. */
static int fitting_bases(const mt_mark_part *all, int start, int *glyph_count) {
    int size = 2, at = start;
    *glyph_count = 0;
    while (at < all->base_count) {
        int end = glyph_end(all->bases, all->base_count, at);
        size += base_size(all, at, end);
        if (size > BASES_SIZE_MAX) break;
        at = end;
        ++*glyph_count;
    }
    return at - start;
}

mt_status mt_attachment_write(const mt_attachment *attachment, int type, const mt_places *places,
                              mt_arena *arena, mt_subtables *subtables) {
    mt_mark_part all = {
        .type = type, .places = places, .bases = attachment->bases, .base_count = attachment->base_count};
    int most = places->store ? MARKS_MAX_VARYING : MARKS_MAX;
    mt_status status = MT_OK;
    for (int b = 0, count, glyphs; b < all.base_count && status == MT_OK; b += count) {
        count = fitting_bases(&all, b, &glyphs);
        for (int m = 0; m < attachment->mark_count && glyphs && status == MT_OK; m += most) {
            int marks = attachment->mark_count - m < most ? attachment->mark_count - m : most;
            mt_mark_part part = {type, places, attachment->marks + m, all.bases + b, marks, count, glyphs};
            status = write_part(&part, arena, subtables);
        }
        if (!glyphs) count = glyph_end(all.bases, all.base_count, b) - b;
    }
    return status;
}
