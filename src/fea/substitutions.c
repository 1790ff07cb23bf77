/* Substitutions of one, several and alternates, ligatures, and single ones from the end of the text in a context. What an earlier
 * rule of the lookup takes hides a later one, which is left out: compilers sort. */
#include <string.h>

#include "fea/writer.h"
#include "gsub/gsub.h"

static void put_row(mt_fea_writer *writer, const uint16_t *glyphs, int count) {
    for (int i = 0; i < count; i++) {
        if (i) mt_fea_put(writer, &writer->lookups, " ");
        mt_fea_glyph(writer, &writer->lookups, glyphs[i]);
    }
}

static void put_rule(mt_fea_writer *writer, int type, const mt_substitution *rule) {
    mt_buffer *to = &writer->lookups;
    mt_fea_put(writer, to, "  sub ");
    put_row(writer, rule->glyphs, rule->inputs);
    mt_fea_put(writer, to, type == MT_GSUB_ALTERNATE ? " from [" : " by ");
    if (rule->outputs == 0) mt_fea_put(writer, to, "NULL");
    put_row(writer, rule->glyphs + rule->inputs, rule->outputs);
    mt_fea_put(writer, to, type == MT_GSUB_ALTERNATE ? "];\n" : ";\n");
}

/* ---- what is hidden ------------------------------------------------------------------------------------ */

/* Rules that are written, by their first glyph. */
typedef struct mt_kept_rule {
    const mt_substitution *rule;
    int next; /* with the same first glyph, in the list; -1: none */
} mt_kept_rule;

typedef struct mt_kept_rules {
    int *first; /* for each glyph, one more than its first in the list */
    int count, room;
    mt_kept_rule *list;
} mt_kept_rules;

static bool hides(const mt_substitution *rule, const mt_substitution *other) {
    return rule->inputs <= other->inputs &&
           memcmp(rule->glyphs, other->glyphs, rule->inputs * sizeof *rule->glyphs) == 0;
}

static bool is_hidden(mt_fea_writer *writer, const mt_kept_rules *kept, const mt_substitution *rule) {
    for (int i = kept->first[rule->glyphs[0]] - 1; i >= 0; i = kept->list[i].next)
        if (!mt_fea_spend(writer, 1) || hides(kept->list[i].rule, rule)) return true;
    return false;
}

static void keep(mt_fea_writer *writer, mt_kept_rules *kept, const mt_substitution *rule) {
    mt_kept_rule *grown =
        mt_arena_grow_list(writer->arena, kept->list, kept->count, &kept->room, sizeof *grown);
    if (!grown) {
        writer->status = MT_NO_MEMORY;
        return;
    }
    kept->list = grown;
    kept->list[kept->count] = (mt_kept_rule){rule, kept->first[rule->glyphs[0]] - 1};
    kept->first[rule->glyphs[0]] = ++kept->count;
}

/* ---- in a context -------------------------------------------------------------------------------------- */

/* The coverages whose offsets stand from `at` on; those before the glyph are told from the nearest on. */
static void put_coverages(mt_fea_writer *writer, mt_bytes table, size_t at, bool backwards) {
    int count = mt_ot_fit(table, at + 2, mt_ot_u16(table, at), 2);
    for (int i = 0; i < count; i++) {
        uint16_t *glyphs;
        int length, turn = backwards ? count - 1 - i : i;
        mt_bytes coverage = mt_ot_follow(table, at + 2 + 2 * (size_t)turn);
        if (!mt_fea_coverage_list(writer, coverage, &glyphs, &length) || length == 0) continue;
        mt_fea_put(writer, &writer->lookups, backwards ? "" : " ");
        mt_fea_class(writer, &writer->lookups, glyphs, length);
        mt_fea_put(writer, &writer->lookups, backwards ? " " : "");
    }
}

static void put_reverse(mt_fea_writer *writer, mt_bytes table, const mt_substitution *rule) {
    mt_buffer *to = &writer->lookups;
    mt_fea_put(writer, to, "  rsub ");
    put_coverages(writer, table, 4, true);
    put_row(writer, rule->glyphs, 1);
    mt_fea_put(writer, to, "'");
    put_coverages(writer, table, 6 + 2 * (size_t)mt_ot_u16(table, 4), false);
    mt_fea_put(writer, to, " by ");
    put_row(writer, rule->glyphs + 1, 1);
    mt_fea_put(writer, to, ";\n");
}

/* ---- all ----------------------------------------------------------------------------------------------- */

static void put_subtable(mt_fea_writer *writer, int type, const mt_gsub_subtable *subtable,
                         mt_kept_rules *kept) {
    for (int i = 0; i < subtable->count && writer->status == MT_OK; i++) {
        const mt_substitution *rule = &subtable->list[i];
        if (type == MT_GSUB_REVERSE) {
            put_reverse(writer, subtable->table, rule);
            continue;
        }
        if (rule->glyphs[0] >= writer->source->glyph_count || is_hidden(writer, kept, rule)) continue;
        put_rule(writer, type, rule);
        keep(writer, kept, rule);
    }
}

void mt_fea_substitutions(mt_fea_writer *writer, const mt_layout *layout, int lookup) {
    mt_lookup from = mt_layout_lookup(layout, lookup);
    mt_gsub_reader reader = {writer->arena, writer->source->glyph_count, writer->left};
    mt_kept_rules kept = {.first =
                              mt_fea_new(writer, (size_t)writer->source->glyph_count, sizeof *kept.first)};
    for (int i = 0; i < from.subtable_count && writer->status == MT_OK; i++) {
        mt_gsub_subtable subtable = {.table = mt_lookup_subtable(&from, i)};
        writer->status = mt_gsub_read(&reader, from.type, subtable.table, &subtable);
        if (writer->status == MT_OK) put_subtable(writer, from.type, &subtable, &kept);
    }
}
