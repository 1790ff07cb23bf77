/* Contexts, of GSUB (types 5 and 6) and of GPOS (7 and 8): each rule of each format, in the order in which they are tried, with the
 * lookups that it calls; a rule that calls none lets nothing behind it be tried ("ignore"). */
#include "fea/writer.h"
#include "layout/rule.h"

typedef struct mt_glyph_run {
    uint16_t *glyphs;
    int count; /* -1: not listed yet */
} mt_glyph_run;

/* A subtable. */
typedef struct mt_context_at {
    mt_bytes table;
    unsigned format;
    bool chained;
    mt_bytes class_defs[MT_SEQUENCES]; /* format 2 */
    mt_glyph_run *runs[MT_SEQUENCES];  /* of classes, once they are listed */
    int run_count;                     /* classes of each that are kept */
    mt_glyph_run first;                /* what a rule begins with; empty for format 3 */
} mt_context_at;

enum { RUNS_MAX = 4096 };

static mt_glyph_run run_of_class(mt_fea_writer *writer, mt_context_at *context, int sequence,
                                 unsigned number) {
    mt_glyph_run none = {0}, *run = number < RUNS_MAX ? &context->runs[sequence][number] : &none;
    if (run->glyphs) return *run;
    if (!mt_fea_class_list(writer, context->class_defs[sequence], number, &run->glyphs, &run->count))
        run->count = 0;
    return *run;
}

/* The glyphs for a number that stands in a rule. */
static mt_glyph_run run_of(mt_fea_writer *writer, mt_context_at *context, int sequence, unsigned number) {
    mt_glyph_run run = {0};
    if (context->format == 2) return run_of_class(writer, context, sequence, number);
    if (context->format == 3) {
        mt_fea_coverage_list(writer, mt_ot_at(context->table, number), &run.glyphs, &run.count);
    } else if ((int)number < writer->source->glyph_count) {
        run.glyphs = mt_fea_new(writer, 1, sizeof *run.glyphs);
        if (run.glyphs) run.glyphs[0] = (uint16_t)number, run.count = 1;
    }
    return run;
}

/* ---- a rule -------------------------------------------------------------------------------------------- */

/* A rule as it is read: places before, from the farthest on, those that it is for, and those after. */
typedef struct mt_rule_at {
    int counts[MT_SEQUENCES];
    mt_glyph_run *runs[MT_SEQUENCES];
    mt_bytes calls; /* its records, from there on */
    int call_count;
} mt_rule_at;

/* False where a place has no glyph, so that the rule is never met. */
static bool read_sequence(mt_fea_writer *writer, mt_context_at *context, mt_bytes at,
                          const mt_rule_layout *layout, int sequence, mt_rule_at *rule) {
    int first = sequence == MT_INPUT && context->format != 3, count = layout->counts[sequence] - first;
    mt_glyph_run *runs = mt_fea_new(writer, (size_t)(count + first), sizeof *runs);
    if (!runs || !mt_fea_spend(writer, count + 1)) return false;
    if (first) runs[0] = context->first;
    for (int i = 0; i < count; i++) {
        int to = sequence == MT_BEFORE ? count - 1 - i : i + first;
        runs[to] = run_of(writer, context, sequence, mt_ot_u16(at, layout->at[sequence] + 2 * (size_t)i));
    }
    rule->runs[sequence] = runs;
    rule->counts[sequence] = count + first;
    for (int i = 0; i < count + first; i++)
        if (runs[i].count <= 0) return false;
    return true;
}

static bool read_rule(mt_fea_writer *writer, mt_context_at *context, mt_bytes at, size_t from,
                      mt_rule_at *rule) {
    mt_rule_layout layout = mt_find_rule(at, context->chained, from, context->format != 3);
    *rule = (mt_rule_at){.calls = mt_ot_at(at, layout.calls_at)};
    if (!layout.whole) return false;
    rule->call_count = mt_ot_fit(rule->calls, 0, (unsigned)layout.call_count, 4);
    for (int s = 0; s < MT_SEQUENCES; s++)
        if (!read_sequence(writer, context, at, &layout, s, rule)) return false;
    return true;
}

static int call_at(const mt_rule_at *rule, int i) {
    return (int)mt_ot_u16(rule->calls, 4 * (size_t)i);
}

static int called_by(const mt_rule_at *rule, int i) {
    return (int)mt_ot_u16(rule->calls, 4 * (size_t)i + 2);
}

/* Text calls from the first place to the last: others that change how many glyphs there are cannot be told. */
static bool can_be_told(const mt_fea_table *table, const mt_rule_at *rule) {
    bool sub = table->layout.extension == MT_EXTENSION_GSUB;
    for (int i = 1; i < rule->call_count && sub; i++)
        if (call_at(rule, i) < call_at(rule, i - 1)) return false;
    return true;
}

static bool calls_any(const mt_fea_table *table, const mt_rule_at *rule) {
    for (int i = 0; i < rule->call_count; i++) {
        int lookup = called_by(rule, i);
        bool inside = lookup < table->layout.lookup_count && call_at(rule, i) < rule->counts[MT_INPUT];
        if (inside && table->parts[lookup] > 0) return true;
    }
    return false;
}

static void put_calls(mt_fea_writer *writer, const mt_fea_table *table, const mt_rule_at *rule, int place) {
    for (int i = 0; i < rule->call_count; i++)
        if (call_at(rule, i) == place && called_by(rule, i) < table->layout.lookup_count)
            mt_fea_call(writer, &writer->lookups, table, called_by(rule, i));
}

static void put_rule(mt_fea_writer *writer, const mt_fea_table *table, const mt_rule_at *rule) {
    mt_buffer *to = &writer->lookups;
    mt_fea_print(writer, to, "  %s%s", calls_any(table, rule) ? "" : "ignore ", table->verb);
    for (int s = 0; s < MT_SEQUENCES; s++)
        for (int i = 0; i < rule->counts[s]; i++) {
            mt_fea_put(writer, to, " ");
            mt_fea_class(writer, to, rule->runs[s][i].glyphs, rule->runs[s][i].count);
            if (s != MT_INPUT) continue;
            mt_fea_put(writer, to, "'");
            put_calls(writer, table, rule, i);
        }
    mt_fea_put(writer, to, ";\n");
}

static void tell_rule(mt_fea_writer *writer, const mt_fea_table *table, mt_context_at *context, mt_bytes at,
                      size_t from) {
    mt_rule_at rule;
    if (!read_rule(writer, context, at, from, &rule)) return;
    if (can_be_told(table, &rule))
        put_rule(writer, table, &rule);
    else
        writer->fea->unsaid++;
}

/* ---- subtables ----------------------------------------------------------------------------------------- */

/* The glyphs of the coverage that begin the rules of a set: one, or those of a class. */
static void find_first(mt_fea_writer *writer, mt_context_at *context, const mt_glyph_run *covered, int set) {
    mt_glyph_run first = {mt_fea_new(writer, (size_t)covered->count, sizeof *first.glyphs), 0};
    for (int i = 0; i < covered->count && first.glyphs; i++) {
        uint16_t glyph = covered->glyphs[i];
        unsigned number = context->format == 2
                              ? mt_class_find(context->class_defs[MT_INPUT], glyph)
                              : (unsigned)mt_coverage_find(mt_ot_follow(context->table, 2), glyph);
        if (number == (unsigned)set) first.glyphs[first.count++] = glyph;
    }
    context->first = first;
}

static void put_sets(mt_fea_writer *writer, const mt_fea_table *table, mt_context_at *context) {
    mt_glyph_run covered = {0};
    size_t at = mt_rule_sets_at(context->format, context->chained);
    int sets = mt_ot_fit(context->table, at + 2, mt_ot_u16(context->table, at), 2);
    if (!mt_fea_coverage_list(writer, mt_ot_follow(context->table, 2), &covered.glyphs, &covered.count))
        return;
    for (int i = 0; i < sets && writer->status == MT_OK; i++) {
        mt_bytes set = mt_ot_follow(context->table, at + 2 + 2 * (size_t)i);
        int rules = mt_ot_fit(set, 2, mt_ot_u16(set, 0), 2);
        if (rules == 0 || !mt_fea_spend(writer, covered.count)) continue;
        find_first(writer, context, &covered, i);
        for (int k = 0; k < rules && writer->status == MT_OK && mt_fea_spend(writer, 1); k++)
            tell_rule(writer, table, context, mt_ot_follow(set, 2 + 2 * (size_t)k), 0);
    }
}

static bool list_classes(mt_fea_writer *writer, mt_context_at *context) {
    if (context->format != 2) return true;
    for (int s = 0; s < MT_SEQUENCES; s++) {
        size_t at = context->chained ? 4 + 2 * (size_t)s : 4;
        context->class_defs[s] = mt_ot_follow(context->table, at);
        context->runs[s] = mt_fea_new(writer, RUNS_MAX, sizeof *context->runs[s]);
        if (!context->runs[s]) return false;
    }
    return true;
}

void mt_fea_contexts(mt_fea_writer *writer, const mt_fea_table *table, int lookup) {
    mt_lookup from = mt_layout_lookup(&table->layout, lookup);
    bool chained = from.type == (table->layout.extension == MT_EXTENSION_GSUB ? 6 : 8);
    for (int i = 0; i < from.subtable_count && writer->status == MT_OK; i++) {
        mt_arena_place before = mt_arena_mark(writer->arena);
        mt_context_at context = {.table = mt_lookup_subtable(&from, i), .chained = chained};
        context.format = mt_ot_u16(context.table, 0);
        if (context.format == 3)
            tell_rule(writer, table, &context, context.table, 2);
        else if ((context.format == 1 || context.format == 2) && list_classes(writer, &context))
            put_sets(writer, table, &context);
        mt_arena_rewind(writer->arena, before);
    }
}
