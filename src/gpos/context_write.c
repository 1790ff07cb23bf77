/* Contexts written: rules of classes in format 2, rules of lists of glyphs in format 3. */
#include "gpos/context.h"

/* The numbers that lookups are called by. */
typedef struct mt_called_numbers {
    int most;
    bool *there; /* of each up to the largest, whether a lookup has it */
} mt_called_numbers;

/* A lookup in the making. */
typedef struct mt_context_writer {
    bool chained;
    const mt_called_numbers *called;
    mt_arena *arena;
    mt_subtables subtables;
    int call_count, call_room;
    mt_lookup_call *calls;
} mt_context_writer;

static bool is_there(const mt_context_writer *writer, int called_as) {
    return called_as <= writer->called->most && writer->called->there[called_as];
}

static mt_status add_call(mt_context_writer *writer, size_t at, int called_as) {
    mt_lookup_call *grown = mt_arena_grow_list(writer->arena, writer->calls, writer->call_count,
                                               &writer->call_room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    writer->calls = grown;
    writer->calls[writer->call_count++] = (mt_lookup_call){writer->subtables.count, at, called_as};
    return MT_OK;
}

/* The records of a rule; `from` is where the table will stand in its subtable. */
static mt_status write_calls(mt_context_writer *writer, const mt_context_rule *rule, size_t from,
                             mt_table *table) {
    mt_status status = MT_OK;
    for (int i = 0; i < rule->call_count && status == MT_OK; i++) {
        if (!is_there(writer, rule->calls[i].called_as)) continue;
        mt_table_16(table, rule->calls[i].at);
        status = add_call(writer, from + table->length, rule->calls[i].called_as);
        mt_table_16(table, 0);
    }
    return status;
}

static int count_calls(const mt_context_writer *writer, const mt_context_rule *rule) {
    int count = 0;
    for (int i = 0; i < rule->call_count; i++) count += is_there(writer, rule->calls[i].called_as);
    return count;
}

/* ---- rules of classes ---------------------------------------------------------------------------------- */

static size_t rule_length(const mt_context_writer *writer, const mt_context_rule *rule) {
    size_t numbers = writer->chained ? 4 : 2;
    for (int s = 0; s < MT_SEQUENCES; s++) numbers += (size_t)rule->counts[s];
    return 2 * (numbers - 1) + 4 * (size_t)count_calls(writer, rule);
}

static size_t set_length(const mt_context_writer *writer, const mt_context_set *set) {
    size_t length = set->count ? 2 + 2 * (size_t)set->count : 0;
    for (int i = 0; i < set->count; i++) length += rule_length(writer, &set->rules[i]);
    return length;
}

static mt_status write_rule(mt_context_writer *writer, const mt_context_rule *rule, size_t from,
                            mt_table *table) {
    for (int s = 0; s < MT_SEQUENCES; s++) {
        if (!writer->chained && s != MT_INPUT) continue;
        mt_table_16(table, rule->counts[s]);
        if (!writer->chained) mt_table_16(table, count_calls(writer, rule));
        for (int i = s == MT_INPUT; i < rule->counts[s]; i++) mt_table_16(table, rule->classes[s][i]);
    }
    if (writer->chained) mt_table_16(table, count_calls(writer, rule));
    return write_calls(writer, rule, from, table);
}

static mt_status write_set(mt_context_writer *writer, const mt_context_set *set, size_t from,
                           mt_table *table) {
    size_t at = 2 + 2 * (size_t)set->count;
    mt_status status = MT_OK;
    mt_table_16(table, set->count);
    for (int i = 0; i < set->count; i++) {
        mt_table_16(table, (int)at);
        at += rule_length(writer, &set->rules[i]);
    }
    for (int i = 0; i < set->count && status == MT_OK; i++)
        status = write_rule(writer, &set->rules[i], from, table);
    return status;
}

/* The glyphs that a rule of the sets from `low` to before `high` may begin with. */
static mt_status write_first(const mt_context_subtable *subtable, int low, int high, mt_arena *arena,
                             mt_table *table) {
    const mt_glyph_class *classes = subtable->classes[MT_INPUT];
    uint16_t *glyphs = mt_arena_new(arena, (size_t)subtable->first.count + 1, sizeof *glyphs);
    int count = 0, k = 0;
    if (!glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < subtable->first.count; i++) {
        int glyph = subtable->first.glyphs[i];
        while (k < subtable->class_counts[MT_INPUT] && classes[k].glyph < glyph) k++;
        bool listed = k < subtable->class_counts[MT_INPUT] && classes[k].glyph == glyph;
        int class = listed ? classes[k].class : 0;
        if (class >= low && class < high) glyphs[count++] = (uint16_t)glyph;
    }
    mt_table_coverage(table, glyphs, count);
    return MT_OK;
}

/* The tables behind the sets' offsets: the coverage and the classes, then the sets. `tables` takes where they are. */
static mt_status write_behind(mt_context_writer *writer, const mt_context_subtable *subtable, int low,
                              int high, size_t from, size_t starts[1 + MT_SEQUENCES], mt_table *table) {
    starts[0] = from;
    mt_status status = write_first(subtable, low, high, writer->arena, table);
    for (int s = 0; s < MT_SEQUENCES; s++) {
        if (!writer->chained && s != MT_INPUT) continue;
        starts[1 + s] = from + table->length;
        mt_table_classes(table, subtable->classes[s], subtable->class_counts[s]);
    }
    for (int i = low; i < high && status == MT_OK; i++)
        if (subtable->sets[i].count) status = write_set(writer, &subtable->sets[i], from, table);
    return status;
}

/* The header and the offsets of the sets; those below `low` are empty. */
static void write_head(const mt_context_writer *writer, const mt_context_subtable *subtable, int low,
                       int high, const size_t starts[1 + MT_SEQUENCES], size_t end, mt_table *table) {
    size_t at = end;
    for (int i = low; i < high; i++) at -= set_length(writer, &subtable->sets[i]);
    mt_table_16(table, 2);
    mt_table_16(table, (int)starts[0]);
    for (int s = 0; s < MT_SEQUENCES; s++)
        if (writer->chained || s == MT_INPUT) mt_table_16(table, (int)starts[1 + s]);
    mt_table_16(table, high);
    for (int i = 0; i < high; i++) {
        size_t length = i < low ? 0 : set_length(writer, &subtable->sets[i]);
        mt_table_16(table, length ? (int)at : 0);
        at += length;
    }
}

/* The sets from `low` to before `high`, in two subtables where 16-bit offsets do not reach; a set alone that is too long is
 * left out. */
static mt_status write_sets(mt_context_writer *writer, const mt_context_subtable *subtable, int low,
                            int high) {
    mt_table table = {0}, behind = {0};
    size_t starts[1 + MT_SEQUENCES] = {0}, head = (writer->chained ? 12u : 8u) + 2 * (size_t)high;
    int calls = writer->call_count;
    bool any = false;
    for (int i = low; i < high; i++) any |= subtable->sets[i].count > 0;
    if (!any) return MT_OK;
    mt_status status = write_behind(writer, subtable, low, high, head, starts, &behind);
    bool fits = head + behind.length <= UINT16_MAX;
    if (status == MT_OK && fits) {
        write_head(writer, subtable, low, high, starts, head + behind.length, &table);
        mt_table_bytes(&table, behind.bytes, behind.length);
        table.failed |= behind.failed;
        status = mt_subtables_add(&table, writer->arena, &writer->subtables);
    }
    mt_table_free(&behind);
    mt_table_free(&table);
    if (status != MT_OK || fits) return status;
    writer->call_count = calls;
    if (high - low == 1) return MT_OK;
    int middle = low + (high - low) / 2;
    status = write_sets(writer, subtable, low, middle);
    return status == MT_OK ? write_sets(writer, subtable, middle, high) : status;
}

/* ---- rules of lists ------------------------------------------------------------------------------------ */

static mt_status write_lists(mt_context_writer *writer, const mt_context_subtable *subtable) {
    const mt_context_rule *rule = &subtable->sets[0].rules[0];
    mt_table table = {0}, behind = {0};
    size_t places = 0;
    for (int s = 0; s < MT_SEQUENCES; s++) places += (size_t)rule->counts[s];
    size_t head = (writer->chained ? 10 : 6) + 2 * places + 4 * (size_t)count_calls(writer, rule);
    int calls = writer->call_count;
    mt_table_16(&table, 3);
    for (int s = 0; s < MT_SEQUENCES; s++) {
        if (!writer->chained && s != MT_INPUT) continue;
        mt_table_16(&table, rule->counts[s]);
        if (!writer->chained) mt_table_16(&table, count_calls(writer, rule));
        for (int i = 0; i < rule->counts[s]; i++) {
            mt_table_16(&table, (int)(head + behind.length));
            mt_table_coverage(&behind, rule->lists[s][i].glyphs, rule->lists[s][i].count);
        }
    }
    if (writer->chained) mt_table_16(&table, count_calls(writer, rule));
    mt_status status = write_calls(writer, rule, 0, &table);
    bool fits = head + behind.length <= UINT16_MAX;
    mt_table_bytes(&table, behind.bytes, behind.length);
    table.failed |= behind.failed;
    if (status == MT_OK && fits) status = mt_subtables_add(&table, writer->arena, &writer->subtables);
    if (!fits) writer->call_count = calls;
    mt_table_free(&behind);
    mt_table_free(&table);
    return status;
}

/* ---- lookups ------------------------------------------------------------------------------------------- */

static mt_status write_lookup(const mt_context_lookup *lookup, const mt_called_numbers *called,
                              mt_arena *arena, mt_lookup_builders *made) {
    mt_context_writer writer = {
        .chained = lookup->head.type == MT_CHAINED_CONTEXT, .called = called, .arena = arena};
    mt_status status = MT_OK;
    for (int i = 0; i < lookup->count && status == MT_OK; i++) {
        const mt_context_subtable *subtable = &lookup->subtables[i];
        status = subtable->by_lists ? write_lists(&writer, subtable)
                                    : write_sets(&writer, subtable, 0, subtable->set_count);
    }
    mt_lookup_builder head = lookup->head;
    head.subtable_count = writer.subtables.count;
    head.subtables = writer.subtables.list;
    head.call_count = writer.call_count;
    head.calls = writer.calls;
    return status == MT_OK ? mt_lookup_builders_add(made, &head, arena) : status;
}

/* Marks the numbers that the lookups are called by; counts them only where `there` is NULL. */
static int list_called(const mt_contexts *contexts, const mt_lookup_builders *made, bool *there) {
    int most = 0;
    for (int i = 0; i < made->count; i++) {
        int called_as = made->lookups[i].subtable_count ? made->lookups[i].called_as : 0;
        if (there) there[called_as] = called_as > 0;
        if (called_as > most) most = called_as;
    }
    for (int i = 0; i < contexts->count; i++) {
        int called_as = contexts->list[i].head.called_as;
        if (there) there[called_as] = called_as > 0;
        if (called_as > most) most = called_as;
    }
    return most;
}

mt_status mt_contexts_write(const mt_contexts *contexts, mt_arena *arena, mt_lookup_builders *made) {
    mt_status status = MT_OK;
    if (contexts->count == 0) return MT_OK;
    mt_called_numbers called = {list_called(contexts, made, NULL), NULL};
    called.there = mt_arena_new(arena, (size_t)called.most + 1, sizeof *called.there);
    if (!called.there) return MT_NO_MEMORY;
    list_called(contexts, made, called.there);
    for (int i = 0; i < contexts->count && status == MT_OK; i++)
        status = write_lookup(&contexts->list[i], &called, arena, made);
    return status;
}
