/* Kerning of scripts at the corners of glyphs (OpenType spec, "MATH": MathKernInfo and MathKern). */
#include "math/table/reader.h"

enum { VALUE = 4 /* bytes of a MathValueRecord */ };

static mt_status read_kern(mt_math_reader *reader, mt_bytes table, mt_math_kern *kern) {
    if (!table.length) return MT_OK;
    int count = mt_math_count(reader, table, 0, 2 + VALUE, 2 * (size_t)VALUE,
                              MT_MATH_OWN_MAX); /* one kern more than heights */
    kern->present = true;
    kern->count = count;
    kern->heights = mt_arena_new(reader->arena, (size_t)count + 1, sizeof *kern->heights);
    kern->kerns = mt_arena_new(reader->arena, (size_t)count + 1, sizeof *kern->kerns);
    if (!kern->heights || !kern->kerns) return MT_NO_MEMORY;
    reader->damaged |= !mt_ot_has(table, 2, VALUE);
    for (int i = 0; i < count; i++)
        kern->heights[i] = mt_math_read_value(reader, table, 2 + VALUE * (size_t)i);
    for (int i = 0; i <= count; i++)
        kern->kerns[i] = mt_math_read_value(reader, table, 2 + VALUE * (size_t)(count + i));
    return MT_OK;
}

mt_status mt_math_read_kerns(mt_math_reader *reader, mt_bytes info, mt_math_kerns *kerns) {
    enum { FIRST = 4, RECORD = 2 * MT_MATH_CORNERS };
    mt_covered *covered;
    int count, records = mt_math_count(reader, info, 2, FIRST, RECORD, MT_MATH_GLYPHS_MAX);
    mt_status status = mt_math_covered(reader, info, 0, &covered, &count);
    if (status != MT_OK) return status;
    kerns->list = mt_arena_new(reader->arena, (size_t)count + 1, sizeof *kerns->list);
    if (!kerns->list) return MT_NO_MEMORY;
    for (int i = 0; i < count && status == MT_OK; i++) {
        if (covered[i].index >= records) continue;
        size_t at = FIRST + RECORD * (size_t)covered[i].index;
        mt_math_glyph_kerns *own = &kerns->list[kerns->count++];
        own->glyph = covered[i].glyph;
        for (size_t c = 0; c < MT_MATH_CORNERS && status == MT_OK; c++)
            status = read_kern(reader, mt_math_follow(reader, info, at + 2 * c), &own->corners[c]);
    }
    return status;
}
