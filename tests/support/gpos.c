#include "support/gpos.h"

#include "font/sfnt.h"
#include "support/check.h"

#include <string.h>

/* ---- GPOS ---------------------------------------------------------------------------------------------- */

static mt_bytes kept(mt_table *table, mt_arena *arena) {
    mt_bytes bytes;
    mt_assert_ok(mt_table_keep(table, arena, &bytes));
    return bytes;
}

static void write_head(int lookups, mt_table *table) {
    static const int script_list[] = {1, 'D' << 8 | 'F', 'L' << 8 | 'T', 8, 4, 0, 0, 0xFFFF, 1, 0};
    static const int feature_list[] = {1, 'm' << 8 | 'a', 'r' << 8 | 'k', 8, 0};
    int features = 10 + 20;
    mt_table_32(table, 0x00010000);
    mt_table_16(table, 10);
    mt_table_16(table, features);
    mt_table_16(table, features + 10 + 2 + 2 * lookups);
    for (int i = 0; i < 10; i++) mt_table_16(table, script_list[i]);
    for (int i = 0; i < 5; i++) mt_table_16(table, feature_list[i]);
    mt_table_16(table, lookups);
    for (int i = 0; i < lookups; i++) mt_table_16(table, i);
}

static int lookup_size(const mt_made_lookup *lookup) {
    return 6 + (2 + 8) * lookup->subtable_count;
}

/* All lookups are extensions; their subtables lie `to_data` bytes after the lookup. */
static void write_lookup(const mt_made_lookup *lookup, size_t to_data, mt_table *table) {
    enum { MARK_SET = 0x10, EXTENSION = 9 };
    int count = lookup->subtable_count;
    mt_table_16(table, EXTENSION);
    mt_table_16(table, lookup->flag & ~MARK_SET);
    mt_table_16(table, count);
    for (int i = 0; i < count; i++) mt_table_16(table, 6 + 2 * count + 8 * i);
    for (int i = 0; i < count; i++) {
        mt_table_16(table, 1);
        mt_table_16(table, lookup->type);
        mt_table_32(table, (uint32_t)(to_data - (size_t)(6 + 2 * count + 8 * i)));
        to_data += lookup->subtables[i].length;
    }
}

mt_bytes mt_test_gpos(const mt_made_lookups *made, mt_arena *arena) {
    mt_table table = {0};
    size_t at = 2 + 2 * (size_t)made->count, data = at;
    write_head(made->count, &table);
    for (int i = 0; i < made->count; i++) data += (size_t)lookup_size(&made->lookups[i]);
    assert_true(data < 65536);
    mt_table_16(&table, made->count);
    for (int i = 0, from = (int)at; i < made->count; i++) {
        mt_table_16(&table, from);
        from += lookup_size(&made->lookups[i]);
    }
    for (int i = 0; i < made->count; i++) {
        write_lookup(&made->lookups[i], data - at, &table);
        at += (size_t)lookup_size(&made->lookups[i]);
        for (int k = 0; k < made->lookups[i].subtable_count; k++)
            data += made->lookups[i].subtables[k].length;
    }
    for (int i = 0; i < made->count; i++)
        for (int k = 0; k < made->lookups[i].subtable_count; k++)
            mt_table_bytes(&table, made->lookups[i].subtables[k].bytes, made->lookups[i].subtables[k].length);
    return kept(&table, arena);
}

/* ---- a font -------------------------------------------------------------------------------------------- */

static mt_bytes write_gdef(const uint16_t *classes, int count, mt_arena *arena) {
    mt_table table = {0};
    mt_glyph_class *glyphs = mt_arena_new(arena, (size_t)count, sizeof *glyphs);
    assert_non_null(glyphs);
    for (int i = 0; i < count; i++) glyphs[i] = (mt_glyph_class){(uint16_t)i, classes[i]};
    mt_table_32(&table, 0x00010000);
    mt_table_16(&table, 12);
    mt_table_zeros(&table, 6);
    mt_table_classes(&table, glyphs, count);
    return kept(&table, arena);
}

mt_bytes mt_test_layout_font(const mt_charset *charset, int units, const uint16_t *advances,
                             const uint16_t *classes, mt_bytes gpos, mt_arena *arena) {
    mt_font_data data = {
        .units = units,
        .glyph_count = charset->glyph_count,
        .char_count = charset->char_count,
        .chars = charset->chars,
        .metrics = {.underline_thickness = 50, .weight_class = 400, .width_class = 5},
        .family = "Layout",
        .style = "Regular",
        .unique_id = "layout",
    };
    data.glyphs = mt_arena_new(arena, (size_t)charset->glyph_count, sizeof *data.glyphs);
    assert_non_null(data.glyphs);
    for (int i = 0; i < charset->glyph_count; i++) data.glyphs[i].advance = advances[i];
    data.extras[data.extra_count++] =
        (mt_extra_table){MT_TAG('G', 'D', 'E', 'F'), write_gdef(classes, charset->glyph_count, arena)};
    if (gpos.length) data.extras[data.extra_count++] = (mt_extra_table){MT_TAG('G', 'P', 'O', 'S'), gpos};
    uint8_t *bytes;
    size_t length;
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    uint8_t *copy = mt_arena_new(arena, length, 1);
    assert_non_null(copy);
    memcpy(copy, bytes, length);
    mt_bytes_free(bytes);
    return (mt_bytes){copy, length};
}
