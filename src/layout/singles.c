#include "layout/singles.h"

#include <string.h>

#include "layout/intern.h"

/* ---- reading ------------------------------------------------------------------------------------------- */

enum { STEPS_MAX = 1 << 25 }; /* glyphs looked up in subtables */

static bool subtable_value(mt_bytes subtable, const mt_variations *variations, uint32_t glyph,
                           double values[MT_VALUE_PARTS]) {
    int index = mt_coverage_find(mt_ot_follow(subtable, 2), glyph);
    unsigned form = mt_ot_u16(subtable, 0), format = mt_ot_u16(subtable, 4);
    size_t size = mt_value_size(format);
    if (index < 0 || (form != 1 && form != 2)) return false;
    if (form == 2 && index >= (int)mt_ot_u16(subtable, 6)) return false;
    size_t at = form == 1 ? 6 : 8 + size * (size_t)index;
    if (!mt_ot_has(subtable, at, size)) return false;
    mt_value_read(subtable, at, format, variations, values);
    return true;
}

/* The sum over the lookups of the first value in each. */
static bool glyph_value(const mt_single_source *source, uint32_t glyph, double values[MT_VALUE_PARTS]) {
    bool found = false;
    for (int k = 0; k < MT_VALUE_PARTS; k++) values[k] = 0;
    for (int i = 0; i < source->count; i++) {
        mt_lookup lookup = mt_layout_lookup(source->layout, source->lookups[i]);
        double value[MT_VALUE_PARTS];
        int s = 0;
        while (s < lookup.subtable_count &&
               !subtable_value(mt_lookup_subtable(&lookup, s), source->variations, glyph, value))
            s++;
        if (s == lookup.subtable_count) continue;
        for (int k = 0; k < MT_VALUE_PARTS; k++) values[k] += source->scale * value[k];
        found = true;
    }
    return found;
}

static int64_t count_subtables(const mt_single_source *source) {
    int64_t count = 0;
    for (int i = 0; i < source->count; i++)
        count += mt_layout_lookup(source->layout, source->lookups[i]).subtable_count;
    return count;
}

mt_status mt_singles_prepare(const mt_single_source *a, const mt_single_source *b, const mt_charset *charset,
                             mt_arena *arena, mt_singles *singles) {
    int64_t steps = (count_subtables(a) + count_subtables(b)) * charset->glyph_count;
    if (steps > STEPS_MAX) return MT_TOO_LARGE;
    mt_singles made = {0};
    made.list = mt_arena_new(arena, (size_t)charset->glyph_count, sizeof *made.list);
    if (!made.list) return MT_NO_MEMORY;
    for (int i = 0; i < charset->glyph_count; i++) {
        mt_single *single = &made.list[made.count];
        single->glyph = (uint16_t)i;
        bool has = glyph_value(a, charset->glyphs[i].a, single->ends[0]);
        if (b->count && charset->glyphs[i].b != MT_NO_PARTNER)
            has |= glyph_value(b, charset->glyphs[i].b, single->ends[1]);
        else
            memcpy(single->ends[1], single->ends[0], sizeof single->ends[1]);
        made.count += has;
    }
    *singles = made;
    return MT_OK;
}

/* ---- writing ------------------------------------------------------------------------------------------- */

/* The values at one T: `value_of` is the number of each single's. */
typedef struct mt_mixed_singles {
    mt_interned values;
    int *value_of, *uses; /* uses of each value */
} mt_mixed_singles;

static mt_status mix(const mt_singles *singles, double t, mt_arena *scratch, mt_mixed_singles *mixed) {
    int number;
    mt_status status = mt_intern_filled(&mixed->values, 0, &number); /* 0 is no adjustment */
    mixed->value_of = mt_arena_new(scratch, (size_t)singles->count + 1, sizeof *mixed->value_of);
    mixed->uses = mt_arena_new(scratch, (size_t)singles->count + 1, sizeof *mixed->uses);
    if (!mixed->value_of || !mixed->uses) return MT_NO_MEMORY;
    for (int i = 0; i < singles->count && status == MT_OK; i++) {
        int32_t value[MT_VALUE_PARTS];
        for (int k = 0; k < MT_VALUE_PARTS; k++)
            value[k] =
                mt_value_rounded((1 - t) * singles->list[i].ends[0][k] + t * singles->list[i].ends[1][k]);
        status = mt_intern(&mixed->values, value, &mixed->value_of[i]);
        if (status == MT_OK) mixed->uses[mixed->value_of[i]]++;
    }
    return status;
}

static unsigned format_of(const mt_mixed_singles *mixed, int value) {
    unsigned format = 0;
    for (int k = 0; k < MT_VALUE_PARTS; k++)
        if (mt_interned_row(&mixed->values, value)[k]) format |= 1u << k;
    return format;
}

static void write_value(const mt_mixed_singles *mixed, int value, unsigned format, mt_table *table) {
    for (int k = 0; k < MT_VALUE_PARTS; k++)
        if (format >> k & 1) mt_table_16(table, mt_interned_row(&mixed->values, value)[k]);
}

static void write_head(mt_table *table, int form, size_t coverage, unsigned format) {
    mt_table_16(table, form);
    mt_table_16(table, (int)coverage);
    mt_table_16(table, (int)format);
}

/* One value for some glyphs. */
static void write_shared(const mt_mixed_singles *mixed, int value, const uint16_t *glyphs, int count,
                         mt_table *table) {
    unsigned format = format_of(mixed, value);
    write_head(table, 1, 6 + mt_value_size(format), format);
    write_value(mixed, value, format, table);
    mt_table_coverage(table, glyphs, count);
}

/* A value for each glyph; there are not more than a 16-bit offset can pass over. */
static void write_single(const mt_mixed_singles *mixed, const int *values, const uint16_t *glyphs, int count,
                         mt_table *table) {
    unsigned format = 0;
    for (int i = 0; i < count; i++) format |= format_of(mixed, values[i]);
    write_head(table, 2, 8 + mt_value_size(format) * (size_t)count, format);
    mt_table_16(table, count);
    for (int i = 0; i < count; i++) write_value(mixed, values[i], format, table);
    mt_table_coverage(table, glyphs, count);
}

enum { MANY = 16, TOGETHER_MAX = 8000 };

static bool is_shared(const mt_mixed_singles *mixed, int value) {
    return mixed->uses[value] >= MANY;
}

/* The next subtable: of `value` where that is not 0, else of values that are not shared, from single *next on. */
static mt_status write_next(const mt_singles *singles, const mt_mixed_singles *mixed, int value, int *next,
                            mt_arena *scratch, mt_table *table) {
    uint16_t *glyphs = mt_arena_new(scratch, (size_t)singles->count + 1, sizeof *glyphs);
    int *values = mt_arena_new(scratch, (size_t)singles->count + 1, sizeof *values);
    if (!glyphs || !values) return MT_NO_MEMORY;
    int count = 0, i = *next;
    for (; i < singles->count && (value || count < TOGETHER_MAX); i++) {
        int own = mixed->value_of[i];
        if (value ? own != value : own == 0 || is_shared(mixed, own)) continue;
        glyphs[count] = singles->list[i].glyph;
        values[count++] = own;
    }
    *next = i;
    if (count && value) write_shared(mixed, value, glyphs, count, table);
    if (count && !value) write_single(mixed, values, glyphs, count, table);
    return MT_OK;
}

static mt_status write_all(const mt_singles *singles, const mt_mixed_singles *mixed, mt_arena *scratch,
                           mt_arena *arena, mt_bytes *subtables, int *count) {
    int made = 0, next = 0;
    for (int value = 1; value < mixed->values.count || next < singles->count; value++) {
        bool rest = value >= mixed->values.count;
        int from = 0;
        if (!rest && !is_shared(mixed, value)) continue;
        mt_table table = {0};
        mt_arena_place place = mt_arena_mark(scratch);
        mt_status status =
            write_next(singles, mixed, rest ? 0 : value, rest ? &next : &from, scratch, &table);
        mt_arena_rewind(scratch, place);
        bool empty = status == MT_OK && table.length == 0 && !table.failed;
        if (status == MT_OK && !empty) status = mt_table_keep(&table, arena, &subtables[made++]);
        if (status != MT_OK) return status;
    }
    *count = made;
    return MT_OK;
}

mt_status mt_singles_write(const mt_singles *singles, double t, mt_arena *arena, mt_bytes **subtables,
                           int *count) {
    mt_arena scratch = {0};
    mt_mixed_singles mixed = {.values = {.width = MT_VALUE_PARTS}};
    mt_bytes *made = mt_arena_new(arena, (size_t)(singles->count / MANY + singles->count / TOGETHER_MAX) + 2,
                                  sizeof *made);
    mt_status status = made ? mix(singles, t, &scratch, &mixed) : MT_NO_MEMORY;
    if (status == MT_OK) status = write_all(singles, &mixed, &scratch, arena, made, count);
    mt_interned_free(&mixed.values);
    mt_arena_release(&scratch);
    if (status == MT_OK) *subtables = made;
    return status;
}
