#include "write/max_context.h"

#include "sfnt/sfnt.h"

enum { RULES_MAX = 1 << 20 };

typedef struct mt_counter {
    mt_bytes table;
    int most;
    int rules; /* looked at so far */
} mt_counter;

/* 0 beyond the end of the table. */
static unsigned u16(const mt_counter *counter, size_t at) {
    bool inside = at + 2 <= counter->table.length;
    return inside ? mt_read_u16(counter->table.bytes + at) : 0;
}

static void note(mt_counter *counter, unsigned count) {
    if (count <= UINT16_MAX && (int)count > counter->most) counter->most = (int)count;
}

/* ---- rules --------------------------------------------------------------------------------------------- */

typedef void (*mt_rule)(mt_counter *counter, size_t at);

static void note_ligature(mt_counter *counter, size_t at) {
    note(counter, u16(counter, at + 2));
}

static void note_context(mt_counter *counter, size_t at) {
    note(counter, u16(counter, at));
}

/* Backtrack, input without its first glyph, lookahead; a count before each. */
static void note_chain(mt_counter *counter, size_t at) {
    size_t input_at = at + 2 + 2 * (size_t)u16(counter, at);
    unsigned input = u16(counter, input_at);
    if (input > 0) note(counter, input + u16(counter, input_at + 2 * (size_t)input));
}

/* Sets of rules, the count of the sets at `at` in the subtable. */
static void for_rules(mt_counter *counter, size_t subtable, size_t at, mt_rule rule) {
    unsigned sets = u16(counter, subtable + at);
    for (unsigned i = 0; i < sets && counter->rules < RULES_MAX; i++, counter->rules++) {
        size_t offset = u16(counter, subtable + at + 2 + 2 * (size_t)i), set = subtable + offset;
        unsigned count = offset ? u16(counter, set) : 0;
        for (unsigned k = 0; k < count && counter->rules < RULES_MAX; k++, counter->rules++)
            rule(counter, set + u16(counter, set + 2 + 2 * (size_t)k));
    }
}

/* ---- subtables ----------------------------------------------------------------------------------------- */

static void read_context(mt_counter *counter, size_t at) {
    unsigned format = u16(counter, at);
    if (format == 1) for_rules(counter, at, 4, note_context);
    if (format == 2) for_rules(counter, at, 6, note_context);
    if (format == 3) note(counter, u16(counter, at + 2));
}

static void read_chain(mt_counter *counter, size_t at) {
    unsigned format = u16(counter, at);
    if (format == 1) for_rules(counter, at, 4, note_chain);
    if (format == 2) for_rules(counter, at, 10, note_chain);
    if (format != 3) return;
    size_t input_at = at + 4 + 2 * (size_t)u16(counter, at + 2);
    unsigned input = u16(counter, input_at);
    note(counter, input + u16(counter, input_at + 2 + 2 * (size_t)input));
}

static void read_reverse(mt_counter *counter, size_t at) {
    note(counter, 1 + u16(counter, at + 6 + 2 * (size_t)u16(counter, at + 4)));
}

static void read_subtable(mt_counter *counter, bool substitution, unsigned type, size_t at) {
    enum {
        LIGATURE = 4,
        CONTEXT = 5,
        CHAIN = 6,
        REVERSE = 8,
        PAIR = 2,
        POSITION_CONTEXT = 7,
        POSITION_CHAIN = 8
    };
    if (type == 1 || (substitution && type <= 3)) note(counter, 1);
    if (!substitution && type == PAIR) note(counter, 2);
    if (substitution && type == LIGATURE) for_rules(counter, at, 4, note_ligature);
    if (type == (substitution ? CONTEXT : POSITION_CONTEXT)) read_context(counter, at);
    if (type == (substitution ? CHAIN : POSITION_CHAIN)) read_chain(counter, at);
    if (substitution && type == REVERSE) read_reverse(counter, at);
}

/* ---- the table ----------------------------------------------------------------------------------------- */

static void read_lookup(mt_counter *counter, bool substitution, size_t lookup) {
    const unsigned extension = substitution ? 7 : 9;
    unsigned type = u16(counter, lookup), count = u16(counter, lookup + 4);
    for (unsigned i = 0; i < count && counter->rules < RULES_MAX; i++, counter->rules++) {
        size_t at = lookup + u16(counter, lookup + 6 + 2 * (size_t)i);
        unsigned its_type = type;
        if (type == extension) {
            its_type = u16(counter, at + 2);
            at += (size_t)u16(counter, at + 4) << 16 | u16(counter, at + 6);
        }
        read_subtable(counter, substitution, its_type, at);
    }
}

int mt_max_context(mt_bytes table, bool substitution) {
    mt_counter counter = {.table = table};
    size_t list = u16(&counter, 8);
    unsigned count = u16(&counter, list);
    for (unsigned i = 0; i < count; i++)
        read_lookup(&counter, substitution, list + u16(&counter, list + 2 + 2 * (size_t)i));
    return counter.most;
}
