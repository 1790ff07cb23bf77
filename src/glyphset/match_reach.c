#include "glyphset/match.h"

#include "geometry/limits.h"

typedef struct mt_reach {
    const mt_glyph_match *match;
    bool all; /* of A's glyphs; otherwise those with a partner */
    bool *kept;
} mt_reach;

/* Whether it makes a new glyph of those that are kept. */
static bool follow(const mt_reach *reach, const mt_substitution *substitution) {
    const uint16_t *outputs = substitution->glyphs + substitution->inputs;
    bool found = false;
    for (int i = 0; i < substitution->inputs; i++)
        if (!reach->kept[substitution->glyphs[i]]) return false;
    for (int i = 0; i < substitution->outputs; i++) {
        bool is_in = reach->all || reach->match->partner[outputs[i]] != MT_NO_PARTNER;
        found |= is_in && !reach->kept[outputs[i]];
        reach->kept[outputs[i]] |= is_in;
    }
    return found;
}

static bool follow_lookup(const mt_reach *reach, const mt_gsub_lookup *lookup, int64_t *left) {
    bool found = false;
    for (int i = 0; i < lookup->subtable_count && *left >= 0; i++, --*left)
        for (int k = 0; k < lookup->subtables[i].count && *left >= 0; k++, --*left)
            found |= follow(reach, &lookup->subtables[i].list[k]);
    return found;
}

mt_status mt_match_reach(const mt_glyph_match *match, const mt_gsub *gsub, bool all, mt_arena *arena,
                         bool *kept) {
    const mt_reach reach = {match, all, kept};
    int64_t left = MT_COMPARISONS_MAX;
    bool *applied = mt_arena_new(arena, (size_t)gsub->layout.lookup_count + 1, sizeof *applied);
    if (!applied) return MT_NO_MEMORY;
    for (int i = 0; i < gsub->layout.feature_count; i++) mt_gsub_mark(gsub, i, applied);
    for (bool more = true; more && left >= 0;) {
        more = false;
        left -= gsub->layout.lookup_count;
        for (int i = 0; i < gsub->layout.lookup_count; i++)
            if (applied[i]) more |= follow_lookup(&reach, &gsub->lookups[i], &left);
    }
    return MT_OK;
}
