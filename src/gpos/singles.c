#include "gpos/singles.h"

#include <string.h>

#include "layout/value_write.h"

/* ---- reading ------------------------------------------------------------------------------------------- */

enum { STEPS_MAX = 1 << 25 }; /* glyphs looked up in subtables */

static bool subtable_value(mt_bytes subtable, const mt_gdef_deltas *variations, uint32_t glyph,
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

static bool is_there(const mt_font_glyphs *glyphs, int font, int glyph) {
    return glyphs->of[font][glyph] != MT_NO_PARTNER;
}

/* What all fonts have for a new glyph; false where none adjusts it. */
static bool find_single(const mt_single_source *sources, const mt_font_glyphs *glyphs, int glyph,
                        double (*in_fonts)[MT_VALUE_PARTS]) {
    bool has = glyph_value(&sources[0], glyphs->of[0][glyph], in_fonts[0]);
    for (int s = 1; s < glyphs->font_count; s++) {
        bool there = sources[s].count && is_there(glyphs, s, glyph);
        has |= there && glyph_value(&sources[s], glyphs->of[s][glyph], in_fonts[s]);
        if (!there) memcpy(in_fonts[s], in_fonts[0], sizeof in_fonts[0]);
    }
    return has;
}

/* The same of what the caller's contexts call; false where it does not adjust the glyph. */
static bool find_called(const mt_single_source *sources, int caller, const mt_font_glyphs *glyphs, int glyph,
                        double (*in_fonts)[MT_VALUE_PARTS]) {
    const double *own = in_fonts[caller];
    if (!is_there(glyphs, caller, glyph)) return false;
    if (!glyph_value(&sources[caller], glyphs->of[caller][glyph], in_fonts[caller])) return false;
    for (int s = 0; s < glyphs->font_count; s++) {
        bool there = is_there(glyphs, s, glyph);
        if (s != caller && there) glyph_value(&sources[s], glyphs->of[s][glyph], in_fonts[s]);
        if (!there) memcpy(in_fonts[s], own, sizeof in_fonts[0]);
    }
    return true;
}

mt_status mt_singles_prepare(const mt_single_source *sources, int caller, const mt_font_glyphs *glyphs,
                             mt_arena *arena, mt_singles *singles) {
    size_t fonts = (size_t)glyphs->font_count;
    int64_t subtables = 0;
    for (size_t s = 0; s < fonts; s++) subtables += count_subtables(&sources[s]);
    if (subtables * glyphs->glyph_count > STEPS_MAX) return MT_TOO_LARGE;
    mt_singles made = {0};
    made.list = mt_arena_new(arena, (size_t)glyphs->glyph_count, sizeof *made.list);
    if (!made.list) return MT_NO_MEMORY;
    for (int i = 0; i < glyphs->glyph_count; i++) {
        double in_fonts[MT_STOPS_MAX][MT_VALUE_PARTS];
        bool has = caller == MT_NO_CALLER ? find_single(sources, glyphs, i, in_fonts)
                                          : find_called(sources, caller, glyphs, i, in_fonts);
        if (!has) continue;
        mt_single *single = &made.list[made.count++];
        single->glyph = (uint16_t)i;
        single->in_fonts = mt_arena_new(arena, fonts, sizeof *single->in_fonts);
        if (!single->in_fonts) return MT_NO_MEMORY;
        memcpy(single->in_fonts, in_fonts, fonts * sizeof *in_fonts);
    }
    *singles = made;
    return MT_OK;
}

/* ---- writing ------------------------------------------------------------------------------------------- */

/* The values at the places: `value_of` is the number of each single's. */
typedef struct mt_mixed_singles {
    mt_value_rows shape;
    mt_var_store *store;
    mt_interned values;
    int *value_of, *uses; /* uses of each value */
} mt_mixed_singles;

static void mix_single(const mt_single *single, const mt_places *places, int32_t *value) {
    for (int i = 0; i < places->count; i++) {
        for (int k = 0; k < MT_VALUE_PARTS; k++) {
            mt_between between = mt_between_at_glyph(places, i, single->glyph, mt_value_direction(k));
            double first = single->in_fonts[between.first][k],
                   second = single->in_fonts[between.first + 1][k];
            value[k * places->count + i] = mt_value_rounded(mt_between_mix(between, first, second));
        }
    }
}

static mt_status mix(const mt_singles *singles, const mt_places *places, mt_arena *scratch,
                     mt_mixed_singles *mixed) {
    int number;
    mt_status status = mt_intern_filled(&mixed->values, 0, &number); /* 0 is no adjustment */
    mixed->value_of = mt_arena_new(scratch, (size_t)singles->count + 1, sizeof *mixed->value_of);
    mixed->uses = mt_arena_new(scratch, (size_t)singles->count + 1, sizeof *mixed->uses);
    if (!mixed->value_of || !mixed->uses) return MT_NO_MEMORY;
    for (int i = 0; i < singles->count && status == MT_OK; i++) {
        int32_t value[MT_VALUE_PARTS * MT_STOPS_MAX];
        mix_single(&singles->list[i], places, value);
        status = mt_intern(&mixed->values, value, &mixed->value_of[i]);
        if (status == MT_OK) mixed->uses[mixed->value_of[i]]++;
    }
    return status;
}

static mt_value_format format_of(const mt_mixed_singles *mixed, int value) {
    return mt_value_format_of(&mixed->shape, mt_interned_row(&mixed->values, value), 1);
}

/* Glyphs that make a subtable, with the number of each one's value. */
typedef struct mt_single_part {
    int count;
    uint16_t *glyphs;
    int *values;
} mt_single_part;

/* One value for all glyphs, or `each` its own; behind the values is what varies in them, and then the Coverage. There
 * are not more than 16-bit offsets can pass over. */
static mt_status write_part(const mt_mixed_singles *mixed, const mt_single_part *part, bool each,
                            mt_table *table) {
    mt_table values = {0};
    mt_variation_pool pool = mt_variation_pool_make(mixed->store);
    int count = each ? part->count : 1;
    size_t header = each ? 8 : 6;
    mt_value_format format = {0, 0};
    for (int i = 0; i < count; i++) format = mt_value_format_join(format, format_of(mixed, part->values[i]));
    size_t to_pool = header + mt_value_format_size(format) * (size_t)count;
    for (int i = 0; i < count; i++)
        mt_value_write(&values, &mixed->shape, format, mt_interned_row(&mixed->values, part->values[i]),
                       &pool, to_pool);
    mt_variation_pool_write(&pool, &values);
    mt_table_16(table, each ? 2 : 1);
    mt_table_16(table, (int)(header + values.length));
    mt_table_16(table, mt_value_format_field(format, 0));
    if (each) mt_table_16(table, count);
    mt_table_bytes(table, values.bytes, values.length);
    mt_table_coverage(table, part->glyphs, part->count);
    table->failed |= values.failed;
    mt_table_free(&values);
    mt_variation_pool_free(&pool);
    return pool.status;
}

/* Values that many glyphs share are a subtable each. Of others a subtable has some thousand: 8 bytes a glyph at most or,
 * where they vary, 40. */
enum { MANY = 16, TOGETHER_MAX = 8000, TOGETHER_MAX_VARYING = 1600 };

static int together_max(const mt_mixed_singles *mixed) {
    return mixed->store ? TOGETHER_MAX_VARYING : TOGETHER_MAX;
}

static bool is_shared(const mt_mixed_singles *mixed, int value) {
    return mixed->uses[value] >= MANY;
}

/* The next subtable: of `value` where that is not 0, else of values that are not shared, from single *next on. */
static mt_status write_next(const mt_singles *singles, const mt_mixed_singles *mixed, int value, int *next,
                            mt_arena *scratch, mt_table *table) {
    mt_single_part part = {.glyphs = mt_arena_new(scratch, (size_t)singles->count + 1, sizeof *part.glyphs),
                           .values = mt_arena_new(scratch, (size_t)singles->count + 1, sizeof *part.values)};
    if (!part.glyphs || !part.values) return MT_NO_MEMORY;
    int i = *next;
    for (; i < singles->count && (value || part.count < together_max(mixed)); i++) {
        int own = mixed->value_of[i];
        if (value ? own != value : own == 0 || is_shared(mixed, own)) continue;
        part.glyphs[part.count] = singles->list[i].glyph;
        part.values[part.count++] = own;
    }
    *next = i;
    return part.count ? write_part(mixed, &part, !value, table) : MT_OK;
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
        mt_table_free(&table);
        if (status != MT_OK) return status;
    }
    *count = made;
    return MT_OK;
}

mt_status mt_singles_write(const mt_singles *singles, const mt_places *places, mt_arena *arena,
                           mt_bytes **subtables, int *count) {
    static const uint8_t parts[MT_VALUE_PARTS] = {0, 1, 2, 3};
    mt_arena scratch = {0};
    mt_mixed_singles mixed = {.shape = {MT_VALUE_PARTS, places->count, parts},
                              .store = places->store,
                              .values = {.width = MT_VALUE_PARTS * places->count}};
    size_t room = (size_t)(singles->count / MANY + singles->count / together_max(&mixed)) + 2;
    mt_bytes *made = mt_arena_new(arena, room, sizeof *made);
    mt_status status = made ? mix(singles, places, &scratch, &mixed) : MT_NO_MEMORY;
    if (status == MT_OK) status = write_all(singles, &mixed, &scratch, arena, made, count);
    mt_interned_free(&mixed.values);
    mt_arena_release(&scratch);
    if (status == MT_OK) *subtables = made;
    return status;
}
