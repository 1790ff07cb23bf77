/* Which lookups a context calls (OpenType spec, "Sequence context" and "Chained sequence context" formats 1, 2 and 3). */
#include "gsub/gsub.h"

/* SequenceLookup records: a place in the sequence, and a lookup. */
static void read_records(mt_gsub_reader *reader, mt_bytes table, size_t at, unsigned count, bool *called) {
    int fit = mt_ot_fit(table, at, count, 4);
    reader->left -= fit + 1;
    for (int i = 0; i < fit && reader->left >= 0; i++) {
        unsigned lookup = mt_ot_u16(table, at + 4 * (size_t)i + 2);
        if (lookup < (unsigned)reader->lookup_count) called[lookup] = true;
    }
}

/* SequenceRule: the first glyph stands in no array. */
static void read_rule(mt_gsub_reader *reader, mt_bytes rule, bool *called) {
    size_t glyphs = mt_ot_u16(rule, 0);
    read_records(reader, rule, 4 + 2 * (glyphs ? glyphs - 1 : 0), mt_ot_u16(rule, 2), called);
}

/* ChainedSequenceRule: glyphs before, the sequence without its first glyph, glyphs after. */
static void read_chained_rule(mt_gsub_reader *reader, mt_bytes rule, bool *called) {
    size_t at = 2 + 2 * (size_t)mt_ot_u16(rule, 0), glyphs = mt_ot_u16(rule, at);
    at += 2 + 2 * (glyphs ? glyphs - 1 : 0);
    at += 2 + 2 * (size_t)mt_ot_u16(rule, at);
    read_records(reader, rule, at + 2, mt_ot_u16(rule, at), called);
}

/* The sets of rules whose offsets stand from `at` on, after their count. */
static void read_sets(mt_gsub_reader *reader, mt_bytes table, size_t at, bool chained, bool *called) {
    int sets = mt_ot_fit(table, at + 2, mt_ot_u16(table, at), 2);
    for (int i = 0; i < sets && reader->left >= 0; i++) {
        mt_bytes set = mt_ot_follow(table, at + 2 + 2 * (size_t)i);
        int rules = mt_ot_fit(set, 2, mt_ot_u16(set, 0), 2);
        reader->left--;
        for (int k = 0; k < rules && reader->left >= 0; k++) {
            mt_bytes rule = mt_ot_follow(set, 2 + 2 * (size_t)k);
            (chained ? read_chained_rule : read_rule)(reader, rule, called);
        }
    }
}

/* Format 3: one rule, with coverages in place of glyphs. */
static void read_coverages(mt_gsub_reader *reader, mt_bytes table, bool chained, bool *called) {
    size_t at = 2;
    if (!chained) {
        read_records(reader, table, 6 + 2 * (size_t)mt_ot_u16(table, 2), mt_ot_u16(table, 4), called);
        return;
    }
    for (int i = 0; i < 3; i++) at += 2 + 2 * (size_t)mt_ot_u16(table, at);
    read_records(reader, table, at + 2, mt_ot_u16(table, at), called);
}

void mt_gsub_called(mt_gsub_reader *reader, int type, mt_bytes table, bool *called) {
    bool chained = type == MT_GSUB_CHAIN;
    switch (mt_ot_u16(table, 0)) {
    case 1: read_sets(reader, table, 4, chained, called); break;
    case 2: read_sets(reader, table, chained ? 10 : 6, chained, called); break;
    case 3: read_coverages(reader, table, chained, called); break;
    default: break;
    }
}
