#include "layout/ot.h"

#include "base/memory.h"
#include "sfnt/sfnt.h"

bool mt_ot_has(mt_bytes table, size_t at, size_t length) {
    return at <= table.length && length <= table.length - at;
}

unsigned mt_ot_u16(mt_bytes table, size_t at) {
    return mt_ot_has(table, at, 2) ? mt_read_u16(table.bytes + at) : 0;
}

int mt_ot_i16(mt_bytes table, size_t at) {
    return (int16_t)mt_ot_u16(table, at);
}

uint32_t mt_ot_u32(mt_bytes table, size_t at) {
    return mt_ot_has(table, at, 4) ? mt_read_u32(table.bytes + at) : 0;
}

mt_bytes mt_ot_at(mt_bytes table, size_t offset) {
    if (offset == 0 || offset >= table.length) return (mt_bytes){0};
    return (mt_bytes){table.bytes + offset, table.length - offset};
}

mt_bytes mt_ot_follow(mt_bytes table, size_t at) {
    return mt_ot_at(table, mt_ot_u16(table, at));
}

mt_bytes mt_ot_follow32(mt_bytes table, size_t at) {
    return mt_ot_at(table, mt_ot_u32(table, at));
}

int mt_ot_fit(mt_bytes table, size_t at, unsigned count, size_t size) {
    size_t most = at <= table.length ? (table.length - at) / size : 0;
    return (int)(count < most ? count : most);
}

/* ---- sets and classes of glyphs ------------------------------------------------------------------------ */

/* Format 2 of both tables: the record (first glyph, last glyph, value) that holds the glyph; -1 when none does. */
static int find_range(mt_bytes table, uint32_t glyph) {
    int low = 0, high = mt_ot_fit(table, 4, mt_ot_u16(table, 2), 6);
    while (low < high) {
        int middle = low + (high - low) / 2;
        size_t at = 4 + 6 * (size_t)middle;
        if (glyph < mt_ot_u16(table, at))
            high = middle;
        else if (glyph > mt_ot_u16(table, at + 2))
            low = middle + 1;
        else
            return middle;
    }
    return -1;
}

static int find_glyph(mt_bytes coverage, uint32_t glyph) {
    int low = 0, high = mt_ot_fit(coverage, 4, mt_ot_u16(coverage, 2), 2);
    while (low < high) {
        int middle = low + (high - low) / 2;
        unsigned found = mt_ot_u16(coverage, 4 + 2 * (size_t)middle);
        if (found == glyph) return middle;
        if (glyph < found)
            high = middle;
        else
            low = middle + 1;
    }
    return -1;
}

int mt_coverage_find(mt_bytes coverage, uint32_t glyph) {
    unsigned format = mt_ot_u16(coverage, 0);
    if (format == 1) return find_glyph(coverage, glyph);
    int range = format == 2 ? find_range(coverage, glyph) : -1;
    if (range < 0) return -1;
    size_t at = 4 + 6 * (size_t)range;
    return (int)(mt_ot_u16(coverage, at + 4) + (glyph - mt_ot_u16(coverage, at)));
}

unsigned mt_class_find(mt_bytes class_def, uint32_t glyph) {
    unsigned format = mt_ot_u16(class_def, 0);
    if (format == 1) {
        unsigned first = mt_ot_u16(class_def, 2);
        int count = mt_ot_fit(class_def, 6, mt_ot_u16(class_def, 4), 2);
        return glyph >= first && glyph - first < (unsigned)count
                   ? mt_ot_u16(class_def, 6 + 2 * (size_t)(glyph - first))
                   : 0;
    }
    int range = format == 2 ? find_range(class_def, glyph) : -1;
    return range < 0 ? 0 : mt_ot_u16(class_def, 8 + 6 * (size_t)range);
}

/* Counts only where `list` is NULL. */
static int list_glyphs(mt_bytes coverage, mt_covered *list) {
    int all = mt_ot_fit(coverage, 4, mt_ot_u16(coverage, 2), 2), count = 0;
    int64_t last = -1;
    for (int i = 0; i < all; i++) {
        unsigned glyph = mt_ot_u16(coverage, 4 + 2 * (size_t)i);
        if (glyph <= last) continue;
        if (list) list[count] = (mt_covered){(uint16_t)glyph, (uint16_t)i};
        count++;
        last = glyph;
    }
    return count;
}

static int list_ranges(mt_bytes coverage, mt_covered *list) {
    int all = mt_ot_fit(coverage, 4, mt_ot_u16(coverage, 2), 6), count = 0;
    int64_t last = -1;
    for (int i = 0; i < all; i++) {
        size_t at = 4 + 6 * (size_t)i;
        unsigned start = mt_ot_u16(coverage, at), end = mt_ot_u16(coverage, at + 2);
        if (start <= last || end < start) continue;
        for (unsigned glyph = start; glyph <= end; glyph++, count++)
            if (list)
                list[count] =
                    (mt_covered){(uint16_t)glyph, (uint16_t)(mt_ot_u16(coverage, at + 4) + glyph - start)};
        last = end;
    }
    return count;
}

mt_status mt_coverage_list(mt_bytes coverage, mt_arena *arena, mt_covered **list, int *count) {
    unsigned format = mt_ot_u16(coverage, 0);
    int (*fill)(mt_bytes, mt_covered *) = format == 1 ? list_glyphs : format == 2 ? list_ranges : NULL;
    int all = fill ? fill(coverage, NULL) : 0;
    mt_covered *made = mt_arena_new(arena, (size_t)all + 1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    if (fill) fill(coverage, made);
    *list = made;
    *count = all;
    return MT_OK;
}
