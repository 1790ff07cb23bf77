#include "sfnt/intern.h"

#include <string.h>

#include "base/memory.h"

static size_t row_size(const mt_interned *set) {
    return (size_t)set->width * sizeof *set->rows;
}

const int32_t *mt_interned_row(const mt_interned *set, int number) {
    return set->rows + (size_t)number * (size_t)set->width;
}

/* FNV-1a over the numbers, then mixed once more for its high bits. */
static uint32_t hash(const int32_t *row, int width) {
    uint32_t h = 2166136261u;
    for (int i = 0; i < width; i++) h = (h ^ (uint32_t)row[i]) * 16777619u;
    h ^= h >> 15;
    return h * 2246822519u;
}

/* The slot of a row, or the free one where it belongs. */
static int find_slot(const mt_interned *set, const int32_t *row) {
    uint32_t mask = (uint32_t)set->slot_count - 1, at = hash(row, set->width) & mask;
    while (set->slots[at] >= 0 && memcmp(mt_interned_row(set, set->slots[at]), row, row_size(set)) != 0)
        at = (at + 1) & mask;
    return (int)at;
}

static mt_status grow_slots(mt_interned *set) {
    int wanted = set->slot_count ? 2 * set->slot_count : 64;
    int *slots = mt_new((size_t)wanted, sizeof *slots);
    if (!slots) return MT_NO_MEMORY;
    for (int i = 0; i < wanted; i++) slots[i] = -1;
    mt_free(set->slots);
    set->slots = slots;
    set->slot_count = wanted;
    for (int i = 0; i < set->count; i++) set->slots[find_slot(set, mt_interned_row(set, i))] = i;
    return MT_OK;
}

static mt_status grow_rows(mt_interned *set) {
    int32_t *rows = mt_grow_list(set->rows, set->count, &set->room, row_size(set) ? row_size(set) : 1);
    if (!rows) return MT_NO_MEMORY;
    set->rows = rows;
    return MT_OK;
}

mt_status mt_intern(mt_interned *set, const int32_t *row, int *number) {
    mt_status status = 2 * (set->count + 1) > set->slot_count ? grow_slots(set) : MT_OK;
    if (status == MT_OK) status = grow_rows(set);
    if (status != MT_OK) return status;
    int slot = find_slot(set, row);
    if (set->slots[slot] < 0) {
        if (set->width) memcpy(set->rows + (size_t)set->count * (size_t)set->width, row, row_size(set));
        set->slots[slot] = set->count++;
    }
    *number = set->slots[slot];
    return MT_OK;
}

mt_status mt_intern_filled(mt_interned *set, int32_t value, int *number) {
    int32_t *row = mt_new((size_t)set->width + 1, sizeof *row);
    if (!row) return MT_NO_MEMORY;
    for (int i = 0; i < set->width; i++) row[i] = value;
    mt_status status = mt_intern(set, row, number);
    mt_free(row);
    return status;
}

void mt_interned_free(mt_interned *set) {
    mt_free(set->rows);
    mt_free(set->slots);
    *set = (mt_interned){.width = set->width};
}
