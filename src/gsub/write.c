/* Subtables of substitutions, written (OpenType spec, "GSUB": Lookup types 1 to 4 and 8). */
#include "gsub/gsub.h"

#include <string.h>

#include "layout/lookup_builder.h"

mt_status mt_gsub_add_part(mt_gsub_parts *parts, size_t at, bool is_old) {
    mt_gsub_part *list =
        mt_arena_grow_list(parts->arena, parts->list, parts->count, &parts->room, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    parts->list = list;
    parts->list[parts->count++] = (mt_gsub_part){at, is_old};
    return MT_OK;
}

/* ---- what stands behind one input glyph ---------------------------------------------------------------- */

/* The end of the substitutions from `i` on that have one first glyph: the ligatures of a set, otherwise a single one. */
static int group_end(const mt_substitution *list, int count, int i) {
    int end = i + 1;
    while (end < count && list[end].glyphs[0] == list[i].glyphs[0]) end++;
    return end;
}

static void write_ligatures(mt_table *table, const mt_substitution *list, int count) {
    size_t at = 2 + 2 * (size_t)count;
    mt_table_16(table, count);
    for (int i = 0; i < count; i++) {
        mt_table_16(table, (int)at);
        at += 4 + 2 * (size_t)(list[i].inputs - 1);
    }
    for (int i = 0; i < count; i++) {
        mt_table_16(table, list[i].glyphs[list[i].inputs]);
        mt_table_16(table, list[i].inputs);
        for (int k = 1; k < list[i].inputs; k++) mt_table_16(table, list[i].glyphs[k]);
    }
}

/* A Sequence, an AlternateSet or a LigatureSet. */
static void write_set(mt_table *table, int type, const mt_substitution *list, int count) {
    if (type == MT_GSUB_LIGATURE) {
        write_ligatures(table, list, count);
        return;
    }
    mt_table_16(table, list[0].outputs);
    for (int i = 0; i < list[0].outputs; i++) mt_table_16(table, list[0].glyphs[1 + i]);
}

static size_t set_length(int type, const mt_substitution *list, int count) {
    size_t length = 2;
    if (type != MT_GSUB_LIGATURE) return 2 + 2 * (size_t)list[0].outputs;
    for (int i = 0; i < count; i++) length += 6 + 2 * (size_t)(list[i].inputs - 1);
    return length;
}

/* ---- subtables ----------------------------------------------------------------------------------------- */

static mt_status write_coverage(mt_table *table, const mt_substitution *list, int count) {
    uint16_t *glyphs = mt_new((size_t)count, sizeof *glyphs);
    int groups = 0;
    if (!glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < count; i = group_end(list, count, i)) glyphs[groups++] = list[i].glyphs[0];
    mt_table_coverage(table, glyphs, groups);
    mt_free(glyphs);
    return MT_OK;
}

static mt_status write_single(mt_table *table, const mt_substitution *list, int count) {
    mt_table_16(table, 2);
    mt_table_16(table, 6 + 2 * count);
    mt_table_16(table, count);
    for (int i = 0; i < count; i++) mt_table_16(table, list[i].glyphs[1]);
    return write_coverage(table, list, count);
}

static mt_status write_sets(mt_table *table, int type, const mt_substitution *list, int count) {
    int groups = 0;
    size_t at = 6;
    for (int i = 0, end; i < count; i = end, groups++, at += 2) {
        end = group_end(list, count, i);
        at += set_length(type, list + i, end - i);
    }
    mt_table_16(table, 1);
    mt_table_16(table, (int)at);
    mt_table_16(table, groups);
    at = 6 + 2 * (size_t)groups;
    for (int i = 0, end; i < count; i = end) {
        end = group_end(list, count, i);
        mt_table_16(table, (int)at);
        at += set_length(type, list + i, end - i);
    }
    for (int i = 0, end; i < count; i = end) {
        end = group_end(list, count, i);
        write_set(table, type, list + i, end - i);
    }
    return write_coverage(table, list, count);
}

/* A Coverage table as it stands; what is past the end of the bytes is left out. */
static void copy_coverage(mt_table *table, mt_bytes coverage) {
    size_t size = mt_ot_u16(coverage, 0) == 2 ? 6 : 2;
    int count = mt_ot_fit(coverage, 4, mt_ot_u16(coverage, 2), size);
    mt_table_16(table, (int)mt_ot_u16(coverage, 0));
    mt_table_16(table, count);
    if (count) mt_table_bytes(table, coverage.bytes + 4, size * (size_t)count);
}

/* Copies the coverages whose count and offsets stand at `at` in `old`: the offsets into the table, the coverages into
 * `behind`, which comes `from` bytes after the subtable's start. Gives the place past the offsets. */
static size_t copy_coverages(mt_table *table, mt_bytes old, size_t at, mt_table *behind, size_t from) {
    unsigned count = mt_ot_u16(old, at);
    mt_table_16(table, (int)count);
    for (unsigned i = 0; i < count && from + behind->length <= UINT16_MAX && !behind->failed; i++) {
        mt_table_16(table, (int)(from + behind->length));
        copy_coverage(behind, mt_ot_follow(old, at + 2 + 2 * (size_t)i));
    }
    return at + 2 + 2 * (size_t)count;
}

/* Left empty where the coverages of the context do not fit. */
static mt_status write_reverse(mt_table *table, mt_bytes old, const mt_substitution *list, int count) {
    mt_table behind = {0}, made = {0};
    size_t before = mt_ot_u16(old, 4), after = mt_ot_u16(old, 6 + 2 * before);
    size_t length = 10 + 2 * (before + after + (size_t)count);
    mt_table_16(&made, 1);
    mt_table_16(&made, (int)length);
    mt_status status = write_coverage(&behind, list, count);
    size_t at = copy_coverages(&made, old, 4, &behind, length);
    copy_coverages(&made, old, at, &behind, length);
    mt_table_16(&made, count);
    for (int i = 0; i < count; i++) mt_table_16(&made, list[i].glyphs[1]);
    mt_table_bytes(&made, behind.bytes, behind.length);
    if (made.length <= UINT16_MAX) mt_table_bytes(table, made.bytes, made.length);
    table->failed |= made.failed || behind.failed;
    mt_table_free(&made);
    mt_table_free(&behind);
    return status;
}

/* ---- as many subtables as it takes --------------------------------------------------------------------- */

/* A subtable is full when one more set would take it past this: then all its offsets, and those of its coverage, do. */
enum { SUBTABLE_BYTES = 30000 };

/* How many of the substitutions go into one subtable; the first set always does, and is passed over by the caller when
 * it is too long. */
static int fill(int type, const mt_substitution *list, int count, size_t *length) {
    int end = 0;
    *length = 0;
    while (end < count) {
        int next = group_end(list, count, end);
        size_t more = 2 + set_length(type, list + end, next - end);
        if (end > 0 && *length + more > SUBTABLE_BYTES) break;
        *length += more;
        end = next;
    }
    return end;
}

mt_status mt_gsub_write(mt_gsub_parts *parts, int type, mt_bytes old, const mt_substitution *list,
                        int count) {
    mt_status status = MT_OK;
    for (int i = 0, taken; i < count && status == MT_OK; i += taken) {
        size_t length, start = parts->bytes.length;
        taken = fill(type, list + i, count - i, &length);
        if (length > UINT16_MAX - 6) continue; /* one set of more ligatures than a subtable can hold */
        if (type == MT_GSUB_SINGLE)
            status = write_single(&parts->bytes, list + i, taken);
        else if (type == MT_GSUB_REVERSE)
            status = write_reverse(&parts->bytes, old, list + i, taken);
        else
            status = write_sets(&parts->bytes, type, list + i, taken);
        bool wrote = parts->bytes.length > start;
        if (status == MT_OK && wrote) status = mt_gsub_add_part(parts, start, false);
    }
    return status;
}
