#include "layout/rule.h"

mt_rule_layout mt_find_rule(mt_bytes table, bool chained, size_t from, int first) {
    mt_rule_layout rule = {0};
    size_t at = from;
    for (int s = 0; s < MT_SEQUENCES; s++) {
        if (!chained && s != MT_INPUT) continue;
        int missing = s == MT_INPUT ? first : 0;
        rule.counts[s] = (int)mt_ot_u16(table, at);
        at += 2;
        if (!chained) rule.call_count = (int)mt_ot_u16(table, at);
        if (!chained) at += 2;
        rule.at[s] = at;
        at += 2 * (size_t)(rule.counts[s] > missing ? rule.counts[s] - missing : 0);
    }
    if (chained) rule.call_count = (int)mt_ot_u16(table, at);
    rule.calls_at = at + (chained ? 2 : 0);
    rule.whole = rule.counts[MT_INPUT] > 0 &&
                 mt_ot_has(table, from, rule.calls_at - from + 4 * (size_t)rule.call_count);
    return rule;
}

size_t mt_rule_sets_at(unsigned format, bool chained) {
    return format == 1 ? 4 : chained ? 10 : 6;
}

/* ---- all rules of a lookup ------------------------------------------------------------------------------- */

typedef struct mt_rule_reader {
    bool chained;
    int *left;
    mt_rule_seen seen;
    void *user;
} mt_rule_reader;

static void read_rule(const mt_rule_reader *reader, mt_bytes table, size_t from, int first) {
    mt_rule_layout rule = mt_find_rule(table, reader->chained, from, first);
    --*reader->left;
    reader->seen(table, reader->chained, from, &rule, reader->user);
}

static void read_sets(const mt_rule_reader *reader, mt_bytes table) {
    size_t at = mt_rule_sets_at(mt_ot_u16(table, 0), reader->chained);
    int sets = mt_ot_fit(table, at + 2, mt_ot_u16(table, at), 2);
    for (int i = 0; i < sets && *reader->left >= 0; i++) {
        mt_bytes set = mt_ot_follow(table, at + 2 + 2 * (size_t)i);
        int rules = mt_ot_fit(set, 2, mt_ot_u16(set, 0), 2);
        --*reader->left;
        for (int k = 0; k < rules && *reader->left >= 0; k++)
            read_rule(reader, mt_ot_follow(set, 2 + 2 * (size_t)k), 0, 1);
    }
}

void mt_each_rule(const mt_layout *layout, int index, int *left, mt_rule_seen seen, void *user) {
    mt_lookup lookup = mt_layout_lookup(layout, index);
    int plain = layout->extension == MT_EXTENSION_GSUB ? 5 : 7;
    mt_rule_reader reader = {lookup.type == plain + 1, left, seen, user};
    if (lookup.type != plain && !reader.chained) return;
    for (int i = 0; i < lookup.subtable_count && *left >= 0; i++) {
        mt_bytes table = mt_lookup_subtable(&lookup, i);
        --*left;
        switch (mt_ot_u16(table, 0)) {
        case 1:
        case 2: read_sets(&reader, table); break;
        case 3: read_rule(&reader, table, 2, 0); break;
        default: break;
        }
    }
}
