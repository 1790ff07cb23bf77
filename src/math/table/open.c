#include "math/table/open.h"

#include "math/table/reader.h"

/* ---- constants ----------------------------------------------------------------------------------------- */

static void read_constants(mt_math_reader *reader, mt_bytes table, mt_math_table *math) {
    enum { WORD = 2, RECORD = 4, LENGTH = 214 };
    size_t at = 0;
    if (!table.length) return;
    reader->damaged |= table.length < LENGTH;
    math->has_constants = true;
    for (int i = 0; i < MT_MATH_CONSTANTS; i++) {
        bool plain = i < MT_MATH_FIRST_VALUE || i == MT_MATH_LAST_PERCENT;
        bool height = i >= MT_MATH_PERCENTS && i < MT_MATH_FIRST_VALUE;
        if (plain)
            math->constants[i] = height ? (int)mt_ot_u16(table, at) : mt_ot_i16(table, at);
        else
            math->constants[i] = mt_math_read_value(reader, table, at);
        at += plain ? WORD : RECORD;
    }
}

/* ---- values of glyphs ---------------------------------------------------------------------------------- */

/* MathItalicsCorrectionInfo and MathTopAccentAttachment: a Coverage table, and a value for each of its glyphs. */
static mt_status read_values(mt_math_reader *reader, mt_bytes table, mt_math_values *values) {
    enum { FIRST = 4, RECORD = 4 };
    mt_covered *covered;
    int count, records = mt_math_count(reader, table, 2, FIRST, RECORD, MT_MATH_GLYPHS_MAX);
    mt_status status = mt_math_covered(reader, table, 0, &covered, &count);
    if (status != MT_OK) return status;
    values->present = table.length > 0;
    values->list = mt_arena_new(reader->arena, (size_t)count + 1, sizeof *values->list);
    if (!values->list) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        if (covered[i].index >= records) continue;
        double value = mt_math_read_value(reader, table, FIRST + RECORD * (size_t)covered[i].index);
        values->list[values->count++] = (mt_math_value){covered[i].glyph, value};
    }
    return MT_OK;
}

static mt_status read_extended(mt_math_reader *reader, mt_bytes info, mt_math_values *extended) {
    mt_covered *covered;
    int count;
    mt_status status = mt_math_covered(reader, info, 4, &covered, &count);
    if (status != MT_OK) return status;
    extended->list = mt_arena_new(reader->arena, (size_t)count + 1, sizeof *extended->list);
    if (!extended->list) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) extended->list[i].glyph = covered[i].glyph;
    extended->count = count;
    return MT_OK;
}

/* MathGlyphInfo. */
static mt_status read_info(mt_math_reader *reader, mt_bytes info, mt_math_table *math) {
    enum { LENGTH = 8 };
    if (!info.length) return MT_OK;
    reader->damaged |= info.length < LENGTH;
    mt_status status = read_values(reader, mt_math_follow(reader, info, 0), &math->italics);
    if (status == MT_OK) status = read_values(reader, mt_math_follow(reader, info, 2), &math->accents);
    if (status == MT_OK) status = read_extended(reader, info, &math->extended);
    if (status == MT_OK) status = mt_math_read_kerns(reader, mt_math_follow(reader, info, 6), &math->kerns);
    return status;
}

/* ---- the table ----------------------------------------------------------------------------------------- */

static mt_status open_reader(const mt_font *font, mt_arena *arena, mt_math_reader *reader) {
    const int32_t *place;
    int axes = mt_font_place(font, &place);
    mt_bytes gdef;
    *reader = (mt_math_reader){
        .glyph_count = mt_font_glyph_count(font), .arena = arena, .left = MT_MATH_RECORDS_MAX};
    mt_status status = mt_font_table(font, MT_TAG('G', 'D', 'E', 'F'), arena, &gdef);
    return status == MT_OK ? mt_gdef_deltas_open(gdef, place, axes, arena, &reader->deltas) : status;
}

mt_status mt_math_table_open(const mt_font *font, mt_arena *arena, mt_math_table *math) {
    enum { HEADER = 10 };
    mt_bytes table;
    mt_math_reader reader;
    mt_math_table made = {.state = MT_MATH_WHOLE};
    mt_status status = mt_font_table(font, MT_TAG('M', 'A', 'T', 'H'), arena, &table);
    if (status == MT_OK) status = open_reader(font, arena, &reader);
    if (status != MT_OK) return status;
    if (mt_font_is_without_layout(font)) table = (mt_bytes){0};
    *math = (mt_math_table){.state = table.length ? MT_MATH_DAMAGED : MT_MATH_NONE};
    if (table.length < HEADER || mt_ot_u16(table, 0) != 1) return MT_OK;
    read_constants(&reader, mt_math_follow(&reader, table, 4), &made);
    status = read_info(&reader, mt_math_follow(&reader, table, 6), &made);
    if (status == MT_OK) status = mt_math_read_variants(&reader, mt_math_follow(&reader, table, 8), &made);
    if (status == MT_OK && !reader.damaged) *math = made;
    return status;
}
