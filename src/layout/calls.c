/* A context has its calls in records at the end of each rule: a place in the sequence, and a lookup. */
#include "layout/calls.h"

#include "layout/rule.h"

/* Levels of lookups, as HarfBuzz has it (HB_MAX_NESTING_LEVEL). */
enum { NESTING_MAX = 64 };

typedef struct mt_calls_reader {
    bool *called; /* by the lookup at hand, one for each lookup */
    int lookup_count, left;
} mt_calls_reader;

/* ---- one lookup ---------------------------------------------------------------------------------------- */

/* An mt_rule_seen: as many records as lie within the table. */
static void read_rule(mt_bytes table, bool chained, size_t from, const mt_rule_layout *rule, void *user) {
    mt_calls_reader *reader = user;
    int fit = mt_ot_fit(table, rule->calls_at, (unsigned)rule->call_count, 4);
    (void)chained, (void)from;
    reader->left -= fit;
    for (int i = 0; i < fit && reader->left >= 0; i++) {
        unsigned lookup = mt_ot_u16(table, rule->calls_at + 4 * (size_t)i + 2);
        if (lookup < (unsigned)reader->lookup_count) reader->called[lookup] = true;
    }
}

static void read_lookup(mt_calls_reader *reader, const mt_layout *layout, int index) {
    for (int i = 0; i < reader->lookup_count; i++) reader->called[i] = false;
    mt_each_rule(layout, index, &reader->left, read_rule, reader);
}

/* ---- circles ------------------------------------------------------------------------------------------- */

/* How many levels of lookups hang together from this one on, itself included, where `depth` stand above it; more than
 * NESTING_MAX together with these in a circle. `known` has what is known of each, or 0. */
static int count_levels(const mt_calls *calls, int lookup, int depth, uint8_t *known) {
    int most = 0;
    if (known[lookup] || depth >= NESTING_MAX) return known[lookup] ? known[lookup] : 1;
    for (int i = calls->first[lookup]; i < calls->first[lookup + 1] && depth + most < NESTING_MAX; i++) {
        int levels = count_levels(calls, calls->lookups[i], depth + 1, known);
        if (levels > most) most = levels;
    }
    known[lookup] = (uint8_t)(most + 1);
    return most + 1;
}

static mt_status check_circles(const mt_calls *calls, int count) {
    uint8_t *known = mt_new((size_t)count, sizeof *known);
    if (!known) return MT_NO_MEMORY;
    bool ends = true;
    for (int i = 0; i < count && ends; i++) ends = count_levels(calls, i, 0, known) <= NESTING_MAX;
    mt_free(known);
    return ends ? MT_OK : MT_ENDLESS_LOOKUPS;
}

/* ---- the whole ----------------------------------------------------------------------------------------- */

static mt_status read_all(mt_calls_reader *reader, const mt_layout *layout, mt_arena *arena,
                          mt_calls *calls) {
    int all = 0, room = 0;
    for (int i = 0; i < reader->lookup_count; i++) {
        calls->first[i] = all;
        read_lookup(reader, layout, i);
        for (int k = 0; k < reader->lookup_count; k++) {
            if (!reader->called[k]) continue;
            uint16_t *grown = mt_arena_grow_list(arena, calls->lookups, all, &room, sizeof *grown);
            if (!grown) return MT_NO_MEMORY;
            calls->lookups = grown;
            calls->lookups[all++] = (uint16_t)k;
        }
    }
    calls->first[reader->lookup_count] = all;
    return MT_OK;
}

mt_status mt_calls_read(const mt_layout *layout, mt_arena *arena, mt_calls *calls) {
    int count = layout->lookup_count;
    mt_calls made = {0};
    *calls = made;
    if (count == 0) return MT_OK;
    mt_calls_reader reader = {mt_new((size_t)count, sizeof(bool)), count, MT_RULE_NUMBERS_MAX};
    made.first = mt_arena_new(arena, (size_t)count + 1, sizeof *made.first);
    mt_status status = reader.called && made.first ? read_all(&reader, layout, arena, &made) : MT_NO_MEMORY;
    if (status == MT_OK) status = check_circles(&made, count);
    mt_free(reader.called);
    if (status == MT_OK) *calls = made;
    return status;
}

/* Each lookup is entered once, and NESTING_MAX levels deep at most. */
void mt_calls_mark(const mt_calls *calls, int lookup, bool *marked) {
    for (int i = calls->first[lookup]; i < calls->first[lookup + 1]; i++) {
        int called = calls->lookups[i];
        if (marked[called]) continue;
        marked[called] = true;
        mt_calls_mark(calls, called, marked);
    }
}
