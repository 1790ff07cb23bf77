#include "layout/tidy.h"

#include <string.h>

#include "layout/layout.h"
#include "layout/open.h"
#include "layout/ot.h"
#include "layout/rule.h"

enum { RECORD = 6, LAST_CLASS = 4 };

/* ---- scripts ------------------------------------------------------------------------------------------- */

static void put_16(uint8_t *at, unsigned value) {
    at[0] = (uint8_t)(value >> 8);
    at[1] = (uint8_t)value;
}

/* Puts a record among the `count` sorted ones before it; false where its tag is there already. */
static bool insert(uint8_t *records, unsigned count, const uint8_t record[RECORD]) {
    uint8_t moved[RECORD];
    unsigned at = count;
    memcpy(moved, record, RECORD);
    while (at > 0 && memcmp(records + RECORD * (at - 1), moved, 4) > 0) at--;
    if (at > 0 && memcmp(records + RECORD * (at - 1), moved, 4) == 0) return false;
    memmove(records + RECORD * (at + 1), records + RECORD * at, RECORD * (size_t)(count - at));
    memcpy(records + RECORD * at, moved, RECORD);
    return true;
}

/* Whether the language system at `at` names features that there are. */
static bool is_system(mt_bytes gsub, size_t at) {
    enum { NONE_REQUIRED = 0xFFFF };
    unsigned features = mt_ot_u16(gsub, mt_ot_u16(gsub, 6)), required = mt_ot_u16(gsub, at + 2),
             count = mt_ot_u16(gsub, at + 4);
    bool valid = mt_ot_has(gsub, at, 6 + 2 * (size_t)count) && count <= features &&
                 (required == NONE_REQUIRED || required < features);
    for (unsigned i = 0; valid && i < count; i++) valid = mt_ot_u16(gsub, at + 6 + 2 * (size_t)i) < features;
    return valid;
}

/* Records of a tag and an offset from `base`, behind their number at `at`; those that lead to no language system go. */
static void sort_records(uint8_t *bytes, size_t length, size_t at, size_t base, bool of_systems) {
    mt_bytes table = {bytes, length};
    unsigned count = mt_ot_u16(table, at), kept = 0;
    if (!mt_ot_has(table, at, 2 + RECORD * (size_t)count)) return;
    uint8_t *records = bytes + at + 2;
    for (unsigned i = 0; i < count; i++) {
        size_t to = base + mt_ot_u16(table, at + 2 + RECORD * (size_t)i + 4);
        if (!of_systems || is_system(table, to)) kept += insert(records, kept, records + RECORD * i);
    }
    put_16(bytes + at, kept);
}

static void tidy_script(uint8_t *gsub, size_t length, size_t script) {
    mt_bytes table = {gsub, length};
    unsigned usual = mt_ot_u16(table, script);
    if (usual && !is_system(table, script + usual)) put_16(gsub + script, 0);
    sort_records(gsub, length, script + 2, script, true);
}

/* DFLT is for text of no script that the font has, by its default system alone. */
static bool is_void(mt_bytes gsub, size_t scripts, size_t record) {
    return mt_ot_u32(gsub, record) == MT_TAG('D', 'F', 'L', 'T') &&
           mt_ot_u16(gsub, scripts + mt_ot_u16(gsub, record + 4)) == 0;
}

void mt_tidy_scripts(uint8_t *gsub, size_t length) {
    mt_bytes table = {gsub, length};
    size_t scripts = mt_ot_u16(table, 4);
    if (scripts == 0) return;
    sort_records(gsub, length, scripts, scripts, false);
    unsigned count = mt_ot_u16(table, scripts);
    for (unsigned i = 0; i < count; i++)
        tidy_script(gsub, length, scripts + mt_ot_u16(table, scripts + 2 + RECORD * (size_t)i + 4));
    unsigned kept = 0;
    for (unsigned i = 0; i < count; i++) {
        size_t record = scripts + 2 + RECORD * (size_t)i;
        if (!is_void(table, scripts, record))
            memmove(gsub + scripts + 2 + RECORD * (size_t)kept++, gsub + record, RECORD);
    }
    put_16(gsub + scripts, kept);
}

/* ---- lookups ------------------------------------------------------------------------------------------- */

/* How many mark glyph sets there are (OpenType spec, "Mark Glyph Sets Table"). */
static unsigned mark_sets_of(mt_bytes gdef) {
    return mt_ot_u16(gdef, 2) >= 2 ? mt_ot_u16(mt_ot_follow(gdef, 12), 2) : 0;
}

static void tidy_mark_set(uint8_t *bytes, size_t length, size_t lookup, unsigned sets) {
    mt_bytes table = {bytes, length};
    unsigned flag = mt_ot_u16(table, lookup + 2), subtables = mt_ot_u16(table, lookup + 4);
    size_t set = lookup + 6 + 2 * (size_t)subtables;
    if (!(flag & MT_LOOKUP_MARK_SET) || !mt_ot_has(table, set, 2) || mt_ot_u16(table, set) < sets) return;
    put_16(bytes + lookup + 2, flag & ~(unsigned)MT_LOOKUP_MARK_SET);
}

static void tidy_mark_sets(uint8_t *bytes, size_t length, unsigned sets) {
    mt_bytes table = {bytes, length};
    size_t lookups = mt_ot_u16(table, 8);
    unsigned count = lookups ? mt_ot_u16(table, lookups) : 0;
    for (unsigned i = 0; i < count; i++)
        tidy_mark_set(bytes, length, lookups + mt_ot_u16(table, lookups + 2 + 2 * (size_t)i), sets);
}

typedef struct mt_calls_tidier {
    uint8_t *table;
    unsigned lookup_count;
} mt_calls_tidier;

/* An mt_rule_seen: keeps the calls of lookups that there are, at places of the input. */
static void tidy_rule(mt_bytes table, bool chained, size_t from, const mt_rule_layout *rule, void *user) {
    const mt_calls_tidier *tidier = user;
    unsigned kept = 0;
    if (!rule->whole) return;
    uint8_t *bytes = tidier->table + (table.bytes - tidier->table), *calls = bytes + rule->calls_at;
    for (int i = 0; i < rule->call_count; i++) {
        unsigned place = mt_ot_u16(table, rule->calls_at + 4 * (size_t)i),
                 lookup = mt_ot_u16(table, rule->calls_at + 4 * (size_t)i + 2);
        if (place >= (unsigned)rule->counts[MT_INPUT] || lookup >= tidier->lookup_count) continue;
        memmove(calls + 4 * (size_t)kept++, calls + 4 * (size_t)i, 4);
    }
    put_16(chained ? calls - 2 : bytes + from + 2, kept);
}

mt_status mt_tidy_lookups(uint8_t *bytes, size_t length, int extension, mt_bytes gdef, mt_arena *arena) {
    mt_layout layout = {0};
    int left = MT_RULE_NUMBERS_MAX;
    tidy_mark_sets(bytes, length, mark_sets_of(gdef));
    mt_status status = mt_layout_open((mt_bytes){bytes, length}, extension, arena, &layout);
    mt_calls_tidier tidier = {bytes, (unsigned)layout.lookup_count};
    for (int i = 0; status == MT_OK && i < layout.lookup_count; i++)
        mt_each_rule(&layout, i, &left, tidy_rule, &tidier);
    return status;
}

/* ---- classes ------------------------------------------------------------------------------------------- */

static void check_class(uint8_t *gdef, size_t length, size_t at) {
    if (mt_ot_u16((mt_bytes){gdef, length}, at) > LAST_CLASS) put_16(gdef + at, 0);
}

void mt_tidy_classes(uint8_t *gdef, size_t length) {
    mt_bytes table = {gdef, length};
    size_t classes = mt_ot_u16(table, 4);
    bool listed = mt_ot_u16(table, classes) == 1;
    size_t first = classes + (listed ? 6 : 4), each = listed ? 2 : 6;
    unsigned count = mt_ot_u16(table, classes + (listed ? 4 : 2));
    if (classes == 0 || !mt_ot_has(table, first, each * count)) return;
    for (unsigned i = 0; i < count; i++) check_class(gdef, length, first + each * i + (listed ? 0 : 4));
}
