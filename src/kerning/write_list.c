/* PairPosFormat1 (OpenType spec, "Pair adjustment positioning subtable format 1"). */
#include <limits.h>
#include <string.h>

#include "kerning/write_list.h"

/* The pairs of one left glyph, as listed; equal sets of a subtable share one place in it. */
typedef struct mt_pair_set {
    uint16_t left;
    int first, end;
    size_t start; /* bytes from the first set */
} mt_pair_set;

/* A subtable in the making: its sets one after another, then the tables of what varies. */
typedef struct mt_list_part {
    mt_value_format format;
    size_t record_size, length; /* of the sets */
    int count;
    mt_pair_set *sets;
    mt_variation_pool pool;
} mt_list_part;

/* ---- sets ---------------------------------------------------------------------------------------------- */

static size_t set_size(const mt_list_part *part, int pair_count) {
    return 2 + part->record_size * (size_t)pair_count;
}

static bool are_equal(const mt_mixed_pairs *mixed, const mt_pair_set *one, const mt_pair_set *other) {
    int count = one->end - one->first;
    size_t size = (size_t)mt_value_row_width(&mixed->values) * sizeof(int32_t);
    if (count != other->end - other->first) return false;
    for (int i = 0; i < count; i++)
        if (mixed->listed[one->first + i].right != mixed->listed[other->first + i].right) return false;
    return memcmp(mt_mixed_listed(mixed, one->first), mt_mixed_listed(mixed, other->first),
                  (size_t)count * size) == 0;
}

/* Where an equal set is already; the end of the sets where none is. */
static size_t find_start(const mt_list_part *part, const mt_mixed_pairs *mixed, const mt_pair_set *set) {
    for (int i = 0; i < part->count; i++)
        if (are_equal(mixed, &part->sets[i], set)) return part->sets[i].start;
    return part->length;
}

/* Adds what varies in a set to the pool, so that its size is known. */
static void pool_set(mt_list_part *part, const mt_mixed_pairs *mixed, const mt_pair_set *set) {
    const mt_value_rows *rows = &mixed->values;
    for (int i = set->first; i < set->end && part->format.varying; i++)
        for (int k = 0; k < rows->part_count; k++)
            mt_variation_pool_add(&part->pool, mt_mixed_listed(mixed, i) + k * rows->place_count);
}

static void add_set(mt_list_part *part, const mt_mixed_pairs *mixed, int first, int end) {
    mt_pair_set *set = &part->sets[part->count];
    *set = (mt_pair_set){mixed->listed[first].left, first, end, 0};
    set->start = find_start(part, mixed, set);
    if (set->start == part->length) {
        part->length += set_size(part, end - first);
        pool_set(part, mixed, set);
    }
    part->count++;
}

/* The pool follows the sets, and its offsets count from the start of the set. */
static void write_set(mt_list_part *part, const mt_mixed_pairs *mixed, const mt_pair_set *set,
                      mt_table *table) {
    mt_table_16(table, set->end - set->first);
    for (int i = set->first; i < set->end; i++) {
        mt_table_16(table, mixed->listed[i].right);
        mt_value_write(table, &mixed->values, part->format, mt_mixed_listed(mixed, i), &part->pool,
                       part->length - set->start);
    }
}

/* ---- subtables ----------------------------------------------------------------------------------------- */

enum { HEADER = 10 };

/* Before the sets: header, offsets and the Coverage, at most. */
static size_t head_size(int count) {
    return HEADER + 2 * (size_t)count + 4 + 2 * (size_t)count;
}

/* What is written of the sets, each that is not an earlier one, and of what varies in them. */
static void write_sets(mt_list_part *part, const mt_mixed_pairs *mixed, mt_table *table) {
    size_t start = table->length;
    for (int i = 0; i < part->count; i++)
        if (part->sets[i].start == table->length - start) write_set(part, mixed, &part->sets[i], table);
    mt_variation_pool_write(&part->pool, table);
}

static mt_status write_glyphs(const mt_list_part *part, mt_arena *scratch, mt_table *coverage) {
    uint16_t *glyphs = mt_arena_new(scratch, (size_t)part->count, sizeof *glyphs);
    if (!glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < part->count; i++) glyphs[i] = part->sets[i].left;
    mt_table_coverage(coverage, glyphs, part->count);
    return MT_OK;
}

static mt_status flush(mt_pair_writer *writer, mt_list_part *part, mt_arena *scratch) {
    mt_table table = {0}, coverage = {0};
    size_t offsets_end = HEADER + 2 * (size_t)part->count;
    mt_arena_place place = mt_arena_mark(scratch);
    mt_status status = write_glyphs(part, scratch, &coverage);
    mt_arena_rewind(scratch, place);
    mt_pair_write_header(&table, 1, offsets_end, part->format);
    mt_table_16(&table, part->count);
    for (int i = 0; i < part->count; i++)
        mt_table_16(&table, (int)(offsets_end + coverage.length + part->sets[i].start));
    mt_table_bytes(&table, coverage.bytes, coverage.length);
    table.failed |= coverage.failed;
    mt_table_free(&coverage);
    write_sets(part, writer->mixed, &table);
    if (status == MT_OK) status = part->pool.status;
    mt_variation_pool_free(&part->pool);
    part->pool = mt_variation_pool_make(writer->store);
    part->length = 0;
    part->count = 0;
    if (status == MT_OK) status = mt_subtables_add(&table, writer->arena, &writer->subtables);
    mt_table_free(&table);
    return status;
}

/* Bytes of what may vary in so many pairs, at most. */
static size_t pool_size_most(const mt_list_part *part, int pair_count) {
    return MT_VARIATION_SIZE * (size_t)__builtin_popcount(part->format.varying) * (size_t)pair_count;
}

/* Whether the subtable is complete before a set of so many pairs: 16-bit offsets lead to the start of each set and, where
 * values vary, from there to what follows all sets. */
static bool is_full(const mt_list_part *part, int pair_count) {
    size_t length = head_size(part->count + 1) + part->length;
    if (part->format.varying)
        length += set_size(part, pair_count) + mt_variation_pool_size(&part->pool) +
                  pool_size_most(part, pair_count);
    return length > MT_OFFSET_MAX;
}

/* The pairs that one set may have. */
static int pairs_most(const mt_list_part *part) {
    size_t rest = MT_OFFSET_MAX - head_size(1) - set_size(part, 0);
    return part->format.varying ? (int)(rest / (part->record_size + pool_size_most(part, 1))) : INT_MAX;
}

/* A left glyph with too many pairs goes on in another subtable. */
static int end_of_set(const mt_mixed_pairs *mixed, int i, int most) {
    int end = i + 1;
    while (end < mixed->listed_count && end - i < most && mixed->listed[end].left == mixed->listed[i].left)
        end++;
    return end;
}

static bool goes_on(const mt_list_part *part, uint16_t left) {
    return part->count && part->sets[part->count - 1].left == left;
}

static mt_status write_parts(mt_pair_writer *writer, mt_list_part *part, mt_arena *scratch) {
    const mt_mixed_pairs *mixed = writer->mixed;
    mt_status status = MT_OK;
    for (int i = 0, end; i < mixed->listed_count && status == MT_OK; i = end) {
        end = end_of_set(mixed, i, pairs_most(part));
        bool complete = goes_on(part, mixed->listed[i].left) || is_full(part, end - i);
        if (part->count && complete) status = flush(writer, part, scratch);
        add_set(part, mixed, i, end);
    }
    return status == MT_OK && part->count ? flush(writer, part, scratch) : status;
}

mt_status mt_pair_write_list(mt_pair_writer *writer) {
    const mt_mixed_pairs *mixed = writer->mixed;
    mt_arena scratch = {0};
    mt_list_part part = {.pool = mt_variation_pool_make(writer->store)};
    part.format = mt_value_format_of(&mixed->values, mixed->listed_values, mixed->listed_count);
    if (!part.format.plain && !part.format.varying && mixed->values.part_count)
        part.format.plain = 1u << mixed->values.parts[0]; /* all of them take the classes' values back */
    part.record_size = 2 + mt_value_format_size(part.format);
    part.sets = mt_arena_new(&scratch, (size_t)mixed->glyph_count, sizeof *part.sets);
    mt_status status = part.sets ? write_parts(writer, &part, &scratch) : MT_NO_MEMORY;
    mt_variation_pool_free(&part.pool);
    mt_arena_release(&scratch);
    return status;
}
