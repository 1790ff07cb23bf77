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
