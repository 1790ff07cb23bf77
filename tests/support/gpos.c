#include "support/gpos.h"

#include "sfnt/sfnt.h"
#include "support/check.h"
#include "write/write.h"

#include <string.h>

static mt_bytes kept(mt_table *table, mt_arena *arena) {
    mt_bytes bytes;
    mt_assert_ok(mt_table_keep(table, arena, &bytes));
    return bytes;
}

mt_bytes mt_test_gdef(const uint16_t *classes, int count, mt_arena *arena) {
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

static void add_extra(mt_font_data *data, uint32_t tag, mt_bytes table) {
    if (table.length) data->extras[data->extra_count++] = (mt_extra_table){tag, table};
}

mt_bytes mt_test_layout_font(const mt_charset *charset, int units, const uint16_t *advances, mt_bytes gdef,
                             mt_bytes gpos, mt_test_varying varying, mt_arena *arena) {
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
    add_extra(&data, MT_TAG('G', 'D', 'E', 'F'), gdef);
    add_extra(&data, MT_TAG('G', 'P', 'O', 'S'), gpos);
    add_extra(&data, MT_TAG('f', 'v', 'a', 'r'), varying.fvar);
    add_extra(&data, MT_TAG('H', 'V', 'A', 'R'), varying.hvar);
    uint8_t *bytes;
    size_t length;
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    uint8_t *copy = mt_arena_new(arena, length, 1);
    assert_non_null(copy);
    memcpy(copy, bytes, length);
    mt_bytes_free(bytes);
    return (mt_bytes){copy, length};
}
