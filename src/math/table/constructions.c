/* Glyphs that grow (OpenType spec, "MATH": MathVariants, MathGlyphConstruction and GlyphAssembly). */
#include "math/table/reader.h"

static mt_status read_assembly(mt_math_reader *reader, mt_bytes table, mt_math_construction *made) {
    enum { FIRST = 6, RECORD = 10 };
    if (!table.length) return MT_OK;
    made->part_count = mt_math_count(reader, table, 4, FIRST, RECORD, MT_MATH_OWN_MAX);
    made->has_assembly = made->part_count > 0;
    made->italics = mt_math_read_value(reader, table, 0);
    made->parts = mt_arena_new(reader->arena, (size_t)made->part_count + 1, sizeof *made->parts);
    if (!made->parts) return MT_NO_MEMORY;
    for (int i = 0; i < made->part_count; i++) {
        size_t at = FIRST + RECORD * (size_t)i;
        made->parts[i] = (mt_math_part){.glyph = mt_math_read_glyph(reader, table, at),
                                        .start = mt_ot_u16(table, at + 2),
                                        .end = mt_ot_u16(table, at + 4),
                                        .full = mt_ot_u16(table, at + 6),
                                        .flags = mt_ot_u16(table, at + 8)};
    }
    return MT_OK;
}

static mt_status read_construction(mt_math_reader *reader, mt_bytes table, mt_math_construction *made) {
    enum { FIRST = 4, RECORD = 4 };
    made->variant_count = mt_math_count(reader, table, 2, FIRST, RECORD, MT_MATH_OWN_MAX);
    made->variants = mt_arena_new(reader->arena, (size_t)made->variant_count + 1, sizeof *made->variants);
    if (!made->variants) return MT_NO_MEMORY;
    for (int i = 0; i < made->variant_count; i++) {
        size_t at = FIRST + RECORD * (size_t)i;
        made->variants[i] =
            (mt_math_variant){mt_math_read_glyph(reader, table, at), mt_ot_u16(table, at + 2)};
    }
    return read_assembly(reader, mt_math_follow(reader, table, 0), made);
}

enum { OFFSETS = 10 }; /* of constructions, from here on: first the vertical ones, then the others */

static mt_status read_direction(mt_math_reader *reader, mt_bytes table, int direction,
                                mt_math_constructions *constructions) {
    mt_covered *covered;
    int count,
        records = mt_math_count(reader, table, 6 + 2 * (size_t)direction, OFFSETS, 2, MT_MATH_GLYPHS_MAX);
    size_t first = OFFSETS + (direction ? 2 * (size_t)mt_ot_u16(table, 6) : 0);
    mt_status status = mt_math_covered(reader, table, 2 + 2 * (size_t)direction, &covered, &count);
    if (status != MT_OK) return status;
    constructions->list = mt_arena_new(reader->arena, (size_t)count + 1, sizeof *constructions->list);
    if (!constructions->list) return MT_NO_MEMORY;
    reader->damaged |= mt_ot_fit(table, first, (unsigned)records, 2) != records;
    for (int i = 0; i < count && status == MT_OK && !reader->damaged; i++) {
        if (covered[i].index >= records) continue;
        mt_bytes own = mt_math_follow(reader, table, first + 2 * (size_t)covered[i].index);
        mt_math_construction *made = &constructions->list[constructions->count++];
        made->glyph = covered[i].glyph;
        status = read_construction(reader, own, made);
    }
    return status;
}

mt_status mt_math_read_variants(mt_math_reader *reader, mt_bytes table, mt_math_table *math) {
    mt_status status = MT_OK;
    if (!table.length) return MT_OK;
    reader->damaged |= table.length < OFFSETS;
    math->least_overlap = mt_ot_u16(table, 0);
    for (int i = 0; i < MT_MATH_DIRECTIONS && status == MT_OK; i++)
        status = read_direction(reader, table, i, &math->constructions[i]);
    return status;
}
