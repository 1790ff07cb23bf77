/* PairPosFormat1 (OpenType spec, "Pair adjustment positioning subtable format 1"). */
#include <string.h>

#include "layout/pair_write.h"

/* A subtable in the making: pair sets one after another; left glyphs with equal sets share one. */
typedef struct mt_list_part {
    mt_table sets;
    int count;
    uint16_t *glyphs;
    size_t *starts; /* of each glyph's set in `sets` */
} mt_list_part;

static int end_of_left(const mt_mixed_pairs *mixed, int i) {
    int end = i + 1;
    while (end < mixed->listed_count && mixed->listed[end].left == mixed->listed[i].left) end++;
    return end;
}

/* Where bytes equal to those from `start` on lie as an earlier set; `start` itself when nowhere. */
static size_t find_equal(const mt_list_part *part, size_t start) {
    size_t length = part->sets.length - start;
    const uint8_t *set = part->sets.bytes + start;
    for (int i = 0; i < part->count; i++)
        if (start - part->starts[i] >= length && memcmp(part->sets.bytes + part->starts[i], set, length) == 0)
            return part->starts[i];
    return start;
}

static void add_set(mt_list_part *part, const mt_mixed_pairs *mixed, unsigned format, int i, int end) {
    size_t start = part->sets.length;
    mt_table_16(&part->sets, end - i);
    for (int k = i; k < end; k++) {
        mt_table_16(&part->sets, mixed->listed[k].right);
        mt_pair_write_values(&part->sets, mixed, format, mixed->listed_values + k * mixed->part_count);
    }
    if (part->sets.failed) return;
    part->glyphs[part->count] = mixed->listed[i].left;
    part->starts[part->count] = find_equal(part, start);
    if (part->starts[part->count] != start) part->sets.length = start;
    part->count++;
}

enum { HEADER = 10 };

/* Before the sets: header, offsets and the Coverage, at most. */
static size_t head_size(int count) {
    return HEADER + 2 * (size_t)count + 4 + 2 * (size_t)count;
}

static mt_status flush(mt_pair_writer *writer, mt_list_part *part, unsigned format) {
    mt_table table = {0}, coverage = {0};
    size_t offsets_end = HEADER + 2 * (size_t)part->count;
    mt_table_coverage(&coverage, part->glyphs, part->count);
    mt_pair_write_header(&table, 1, offsets_end, format);
    mt_table_16(&table, part->count);
    for (int i = 0; i < part->count; i++)
        mt_table_16(&table, (int)(offsets_end + coverage.length + part->starts[i]));
    mt_table_bytes(&table, coverage.bytes, coverage.length);
    mt_table_bytes(&table, part->sets.bytes, part->sets.length);
    table.failed |= coverage.failed || part->sets.failed;
    mt_table_free(&coverage);
    part->sets.length = 0;
    part->count = 0;
    return mt_pair_writer_add(writer, &table);
}

static mt_status write_parts(mt_pair_writer *writer, mt_list_part *part) {
    const mt_mixed_pairs *mixed = writer->mixed;
    unsigned format = mt_pair_format(mixed, mixed->listed_values, mixed->listed_count);
    if (!format) format = 1u << mixed->parts[0]; /* all of them take the classes' values back */
    mt_status status = MT_OK;
    for (int i = 0, end; i < mixed->listed_count && status == MT_OK; i = end) {
        end = end_of_left(mixed, i);
        add_set(part, mixed, format, i, end);
        bool full = head_size(part->count + 1) + part->sets.length > MT_OFFSET_MAX;
        if (full || end == mixed->listed_count || part->sets.failed) status = flush(writer, part, format);
    }
    return status;
}

mt_status mt_pair_write_list(mt_pair_writer *writer) {
    const mt_mixed_pairs *mixed = writer->mixed;
    mt_arena scratch = {0};
    mt_list_part part = {0};
    part.glyphs = mt_arena_new(&scratch, (size_t)mixed->glyph_count, sizeof *part.glyphs);
    part.starts = mt_arena_new(&scratch, (size_t)mixed->glyph_count, sizeof *part.starts);
    mt_status status = part.glyphs && part.starts ? write_parts(writer, &part) : MT_NO_MEMORY;
    mt_table_free(&part.sets);
    mt_arena_release(&scratch);
    return status;
}
