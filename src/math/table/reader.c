#include "math/table/reader.h"

mt_bytes mt_math_follow(mt_math_reader *reader, mt_bytes table, size_t at) {
    mt_bytes found = mt_ot_follow(table, at);
    reader->damaged |= mt_ot_u16(table, at) != 0 && !found.length;
    return found;
}

int mt_math_count(mt_math_reader *reader, mt_bytes table, size_t at, size_t first, size_t size, int most) {
    unsigned said = mt_ot_u16(table, at);
    int count = mt_ot_fit(table, first, said, size);
    bool said_there = !table.length || mt_ot_has(table, at, 2);
    bool all = said_there && count == (int)said && count <= most && count <= reader->left;
    reader->damaged |= !all;
    if (!all) return 0;
    reader->left -= count;
    return count;
}

double mt_math_read_value(mt_math_reader *reader, mt_bytes table, size_t at) {
    return mt_ot_i16(table, at) + mt_gdef_delta(&reader->deltas, mt_math_follow(reader, table, at + 2));
}

uint16_t mt_math_read_glyph(mt_math_reader *reader, mt_bytes table, size_t at) {
    unsigned glyph = mt_ot_u16(table, at);
    bool there = glyph < (unsigned)reader->glyph_count;
    reader->damaged |= !there;
    return (uint16_t)(there ? glyph : 0);
}

/* A Coverage table of a known format, whole. */
static bool is_coverage(mt_bytes coverage) {
    unsigned format = mt_ot_u16(coverage, 0), count = mt_ot_u16(coverage, 2);
    if ((format != 1 && format != 2) || !mt_ot_has(coverage, 2, 2)) return false;
    return mt_ot_fit(coverage, 4, count, format == 1 ? 2 : 6) == (int)count;
}

mt_status mt_math_covered(mt_math_reader *reader, mt_bytes table, size_t at, mt_covered **list, int *count) {
    mt_bytes coverage = mt_math_follow(reader, table, at);
    *list = NULL;
    *count = 0;
    if (!coverage.length) return MT_OK;
    reader->damaged |= !is_coverage(coverage);
    if (reader->damaged) return MT_OK;
    mt_status status = mt_coverage_list(coverage, reader->arena, list, count);
    while (status == MT_OK && *count > 0 && (*list)[*count - 1].glyph >= reader->glyph_count) --*count;
    return status;
}
