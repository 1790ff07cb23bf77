#include "kerning/source.h"

#include "kerning/kern_table.h"

bool mt_pair_is_listed(const mt_pair_subtable *subtable) {
    return subtable->kind == MT_PAIRS_LISTED || subtable->kind == MT_KERN_LISTED;
}

/* ---- subtables of GPOS --------------------------------------------------------------------------------- */

/* False for a subtable that is malformed. */
static bool read_subtable(mt_bytes table, int lookup, mt_pair_subtable *subtable) {
    unsigned format = mt_ot_u16(table, 0);
    *subtable = (mt_pair_subtable){.kind = format == 1 ? MT_PAIRS_LISTED : MT_PAIRS_CLASSED,
                                   .lookup = lookup,
                                   .table = table,
                                   .formats = {mt_ot_u16(table, 4), mt_ot_u16(table, 6)}};
    if (format == 1) return true;
    subtable->class_counts[0] = (int)mt_ot_u16(table, 12);
    subtable->class_counts[1] = (int)mt_ot_u16(table, 14);
    size_t cells = (size_t)subtable->class_counts[0] * (size_t)subtable->class_counts[1];
    size_t size = mt_value_size(subtable->formats[0]) + mt_value_size(subtable->formats[1]);
    return format == 2 && mt_ot_has(table, 16, cells * size);
}

static int count_subtables(const mt_layout *layout, const int *lookups, int count) {
    int all = 0;
    for (int i = 0; i < count && all < MT_PAIR_SUBTABLES_MAX; i++)
        all += mt_layout_lookup(layout, lookups[i]).subtable_count;
    return all < MT_PAIR_SUBTABLES_MAX ? all : MT_PAIR_SUBTABLES_MAX;
}

mt_status mt_pair_source_gpos(const mt_layout *layout, const int *lookups, int count,
                              const mt_gdef_deltas *variations, double scale, mt_arena *arena,
                              mt_pair_source *source) {
    mt_pair_source made = {.variations = variations, .scale = scale};
    int room = count_subtables(layout, lookups, count);
    made.subtables = mt_arena_new(arena, (size_t)room + 1, sizeof *made.subtables);
    if (!made.subtables) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        mt_lookup lookup = mt_layout_lookup(layout, lookups[i]);
        for (int k = 0; k < lookup.subtable_count && made.count < room; k++) {
            mt_pair_subtable *subtable = &made.subtables[made.count];
            if (!read_subtable(mt_lookup_subtable(&lookup, k), i, subtable)) continue;
            made.parts |= mt_value_parts(subtable->formats[0]) | mt_value_parts(subtable->formats[1])
                                                                     << MT_VALUE_PARTS;
            made.count++;
        }
    }
    *source = made;
    return MT_OK;
}

/* Every glyph has a class on the right, if only class 0: where the left glyph is covered, the subtable applies. */
static int class_column(const mt_pair_subtable *subtable, uint32_t right) {
    unsigned class = mt_class_find(mt_ot_follow(subtable->table, 10), right);
    return (int)class < subtable->class_counts[1] ? (int)class : -1;
}

static int class_row(const mt_pair_subtable *subtable, uint32_t left) {
    if (mt_coverage_find(mt_ot_follow(subtable->table, 2), left) < 0) return -1;
    unsigned class = mt_class_find(mt_ot_follow(subtable->table, 8), left);
    return (int)class < subtable->class_counts[0] ? (int)class : -1;
}

static int set_row(const mt_pair_subtable *subtable, uint32_t left) {
    int index = mt_coverage_find(mt_ot_follow(subtable->table, 2), left);
    return index < mt_ot_fit(subtable->table, 10, mt_ot_u16(subtable->table, 8), 2) ? index : -1;
}

static void class_value(const mt_pair_source *source, const mt_pair_subtable *subtable, int row, int column,
                        double values[MT_PAIR_PARTS]) {
    size_t first = mt_value_size(subtable->formats[0]), size = first + mt_value_size(subtable->formats[1]);
    size_t cell = (size_t)row * (size_t)subtable->class_counts[1] + (size_t)column, at = 16 + cell * size;
    mt_value_read(subtable->table, at, subtable->formats[0], source->variations, values);
    mt_value_read(subtable->table, at + first, subtable->formats[1], source->variations,
                  values + MT_VALUE_PARTS);
}

/* ---- a list's sets of pairs ---------------------------------------------------------------------------- */

static mt_bytes pair_set(const mt_pair_subtable *subtable, int row) {
    return mt_ot_follow(subtable->table, 10 + 2 * (size_t)row);
}

static size_t pair_size(const mt_pair_subtable *subtable) {
    return 2 + mt_value_size(subtable->formats[0]) + mt_value_size(subtable->formats[1]);
}

static int set_count(const mt_pair_subtable *subtable, int row) {
    mt_bytes set = pair_set(subtable, row);
    return mt_ot_fit(set, 2, mt_ot_u16(set, 0), pair_size(subtable));
}

static uint32_t set_glyph(const mt_pair_subtable *subtable, int row, int i) {
    return mt_ot_u16(pair_set(subtable, row), 2 + (size_t)i * pair_size(subtable));
}

/* The place of a right glyph in the set of a row; -1 when it is not there. */
static int find_in_set(const mt_pair_subtable *subtable, int row, uint32_t right) {
    int low = 0, high = set_count(subtable, row);
    while (low < high) {
        int middle = low + (high - low) / 2;
        uint32_t glyph = set_glyph(subtable, row, middle);
        if (glyph == right) return middle;
        if (right < glyph)
            high = middle;
        else
            low = middle + 1;
    }
    return -1;
}

static void set_value(const mt_pair_source *source, const mt_pair_subtable *subtable, int row, int i,
                      double values[MT_PAIR_PARTS]) {
    mt_bytes set = pair_set(subtable, row);
    size_t at = 4 + (size_t)i * pair_size(subtable), first = mt_value_size(subtable->formats[0]);
    mt_value_read(set, at, subtable->formats[0], source->variations, values);
    mt_value_read(set, at + first, subtable->formats[1], source->variations, values + MT_VALUE_PARTS);
}

/* ---- any subtable -------------------------------------------------------------------------------------- */

int mt_pair_row(const mt_pair_subtable *subtable, uint32_t left) {
    switch (subtable->kind) {
    case MT_PAIRS_LISTED: return set_row(subtable, left);
    case MT_PAIRS_CLASSED: return class_row(subtable, left);
    case MT_KERN_LISTED: return 0;
    case MT_KERN_CLASSED: return mt_kern_row(subtable, left);
    }
    return -1;
}

int mt_pair_column(const mt_pair_subtable *subtable, uint32_t right) {
    if (subtable->kind == MT_PAIRS_CLASSED) return class_column(subtable, right);
    return subtable->kind == MT_KERN_CLASSED ? mt_kern_column(subtable, right) : -1;
}

int mt_pair_listed_count(const mt_pair_subtable *subtable, int row, uint32_t left) {
    return subtable->kind == MT_KERN_LISTED ? mt_kern_listed_count(subtable, left) : set_count(subtable, row);
}

uint32_t mt_pair_listed(const mt_pair_subtable *subtable, int row, uint32_t left, int i) {
    return subtable->kind == MT_KERN_LISTED ? mt_kern_listed(subtable, left, i) : set_glyph(subtable, row, i);
}

/* Whether the subtable applies to the pair; if so, its value in the font's own units. */
static bool apply(const mt_pair_source *source, int i, const mt_pair *pair, double values[MT_PAIR_PARTS]) {
    const mt_pair_subtable *subtable = &source->subtables[i];
    int row = pair->rows[i], column = pair->columns[i], found;
    if (row < 0) return false;
    switch (subtable->kind) {
    case MT_PAIRS_LISTED:
        found = find_in_set(subtable, row, pair->right);
        if (found >= 0) set_value(source, subtable, row, found, values);
        return found >= 0;
    case MT_PAIRS_CLASSED:
        if (column >= 0) class_value(source, subtable, row, column, values);
        return column >= 0;
    case MT_KERN_LISTED:
        values[MT_VALUE_X_ADVANCE] = mt_kern_listed_value(subtable, pair->left, pair->right);
        return true;
    case MT_KERN_CLASSED:
        values[MT_VALUE_X_ADVANCE] = mt_kern_classed_value(subtable, row, column);
        return true;
    }
    return false;
}

void mt_pair_value(const mt_pair_source *source, const mt_pair *pair, double values[MT_PAIR_PARTS]) {
    int done = -1; /* the lookup that has applied */
    for (int k = 0; k < MT_PAIR_PARTS; k++) values[k] = 0;
    for (int i = 0; i < source->count; i++) {
        double value[MT_PAIR_PARTS] = {0};
        if (source->subtables[i].lookup == done || !apply(source, i, pair, value)) continue;
        for (int k = 0; k < MT_PAIR_PARTS; k++) values[k] += source->scale * value[k];
        done = source->subtables[i].lookup;
    }
}
