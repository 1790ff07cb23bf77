#include "kerning/kern_table.h"

/* ---- the table ----------------------------------------------------------------------------------------- */

typedef struct mt_kern_reader {
    mt_bytes rest; /* from the next subtable on */
    uint32_t left; /* subtables */
    bool apple;    /* version 1.0, with 32-bit lengths */
} mt_kern_reader;

static mt_kern_reader start_reading(mt_bytes kern) {
    if (mt_ot_u16(kern, 0) == 0) return (mt_kern_reader){mt_ot_at(kern, 4), mt_ot_u16(kern, 2), false};
    if (mt_ot_u32(kern, 0) == 0x00010000)
        return (mt_kern_reader){mt_ot_at(kern, 8), mt_ot_u32(kern, 4), true};
    return (mt_kern_reader){0};
}

/* OpenType: horizontal, of no minima, not across the line; Apple: not vertical, across the line or varying. */
static bool kerns_along_the_line(unsigned coverage, bool apple) {
    return apple ? (coverage & 0xE000) == 0 : (coverage & 7) == 1;
}

/* The next subtable that can be read; false at the end. */
static bool next_subtable(mt_kern_reader *reader, mt_pair_subtable *subtable) {
    while (reader->left > 0 && reader->rest.length > 0) {
        mt_bytes table = reader->rest;
        size_t header = reader->apple ? 8 : 6;
        size_t length = reader->apple ? mt_ot_u32(table, 0) : mt_ot_u16(table, 2);
        unsigned coverage = mt_ot_u16(table, 4);
        unsigned format = reader->apple ? coverage & 0xFF : coverage >> 8;
        reader->rest = length < header ? (mt_bytes){0} : mt_ot_at(table, length);
        reader->left--;
        if ((format != 0 && format != 2) || !kerns_along_the_line(coverage, reader->apple)) continue;
        *subtable = (mt_pair_subtable){
            .kind = format == 0 ? MT_KERN_LISTED : MT_KERN_CLASSED, .table = table, .header = header};
        return true;
    }
    return false;
}

bool mt_kern_table_kerns(mt_bytes kern) {
    mt_kern_reader reader = start_reading(kern);
    mt_pair_subtable subtable;
    return next_subtable(&reader, &subtable);
}

mt_status mt_pair_source_kern(mt_bytes kern, double scale, mt_arena *arena, mt_pair_source *source) {
    mt_pair_source made = {.scale = scale, .parts = 1u << MT_VALUE_X_ADVANCE};
    mt_kern_reader reader = start_reading(kern), again = reader;
    mt_pair_subtable subtable;
    int room = 0;
    while (room < MT_PAIR_SUBTABLES_MAX && next_subtable(&reader, &subtable)) room++;
    made.subtables = mt_arena_new(arena, (size_t)room + 1, sizeof *made.subtables);
    if (!made.subtables) return MT_NO_MEMORY;
    for (; made.count < room && next_subtable(&again, &subtable); made.count++) {
        subtable.lookup = made.count;
        made.subtables[made.count] = subtable;
    }
    *source = made;
    return MT_OK;
}

/* ---- format 0 ------------------------------------------------------------------------------------------ */

/* The pairs are not bounded by the subtable's length: 16 bits are too few for long lists, which fonts have. */
static int list_length(const mt_pair_subtable *subtable) {
    return mt_ot_fit(subtable->table, subtable->header + 8, mt_ot_u16(subtable->table, subtable->header), 6);
}

static size_t list_place(const mt_pair_subtable *subtable, int i) {
    return subtable->header + 8 + 6 * (size_t)i;
}

/* The first pair that is not before (left, right). */
static int first_from(const mt_pair_subtable *subtable, uint64_t key) {
    int low = 0, high = list_length(subtable);
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (mt_ot_u32(subtable->table, list_place(subtable, middle)) < key)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

int mt_kern_listed_count(const mt_pair_subtable *subtable, uint32_t left) {
    uint64_t key = (uint64_t)left << 16;
    int count = first_from(subtable, key + 0x10000) - first_from(subtable, key);
    return count > 0 ? count : 0;
}

uint32_t mt_kern_listed(const mt_pair_subtable *subtable, uint32_t left, int i) {
    int at = first_from(subtable, (uint64_t)left << 16) + i;
    return mt_ot_u16(subtable->table, list_place(subtable, at) + 2);
}

double mt_kern_listed_value(const mt_pair_subtable *subtable, uint32_t left, uint32_t right) {
    uint64_t key = (uint64_t)left << 16 | right;
    int at = first_from(subtable, key);
    size_t place = list_place(subtable, at);
    bool found = at < list_length(subtable) && mt_ot_u32(subtable->table, place) == key;
    return found ? mt_ot_i16(subtable->table, place + 4) : 0;
}

/* ---- format 2 ------------------------------------------------------------------------------------------ */

/* The value of a glyph in a class table: first glyph, count, values; `outside` where it is not in there. */
static int class_value(mt_bytes classes, uint32_t glyph, int outside) {
    unsigned first = mt_ot_u16(classes, 0);
    int count = mt_ot_fit(classes, 4, mt_ot_u16(classes, 2), 2);
    if (glyph < first || glyph - first >= (unsigned)count) return outside;
    return (int)mt_ot_u16(classes, 4 + 2 * (size_t)(glyph - first));
}

int mt_kern_row(const mt_pair_subtable *subtable, uint32_t left) {
    int row = class_value(mt_ot_follow(subtable->table, subtable->header + 2), left, -1);
    return row < (int)mt_ot_u16(subtable->table, subtable->header + 6) ? -1 : row;
}

int mt_kern_column(const mt_pair_subtable *subtable, uint32_t right) {
    return class_value(mt_ot_follow(subtable->table, subtable->header + 4), right, 0);
}

double mt_kern_classed_value(const mt_pair_subtable *subtable, int row, int column) {
    return mt_ot_i16(subtable->table, (size_t)row + (size_t)column);
}
