#include "glyphset/match.h"

#include <math.h>

/* ---- pairs --------------------------------------------------------------------------------------------- */

/* Glyphs without a character that A's MATH has for another glyph: the larger ones by their order, the glyph itself left out. */
static void pair_variants(mt_glyph_match *match, const mt_math_construction *a,
                          const mt_math_construction *b) {
    int in_b = 0;
    for (int i = 0; i < a->variant_count; i++) {
        if (a->variants[i].glyph == a->glyph) continue;
        while (in_b < b->variant_count && b->variants[in_b].glyph == b->glyph) in_b++;
        if (in_b == b->variant_count) return;
        mt_match_form(match, a->variants[i].glyph, b->variants[in_b++].glyph, match->origin[a->glyph]);
    }
}

static void pair_parts(mt_glyph_match *match, const mt_math_construction *a, const mt_math_construction *b) {
    if (!mt_math_same_assembly(a, b)) return;
    for (int i = 0; i < a->part_count; i++)
        mt_match_form(match, a->parts[i].glyph, b->parts[i].glyph, match->origin[a->glyph]);
}

/* What B has for the partner of the glyph that A has it for; NULL where there is none. */
static const mt_math_construction *
find_counterpart(const mt_glyph_match *match, const mt_math_construction *a, const mt_math_constructions *b) {
    uint32_t partner = match->partner[a->glyph];
    return partner == MT_NO_PARTNER ? NULL : mt_math_construction_find(b, partner);
}

void mt_match_math(mt_glyph_match *match, const mt_math_table *a, const mt_math_table *b) {
    for (int k = 0; k < MT_MATH_DIRECTIONS; k++) {
        for (int i = 0; i < a->constructions[k].count; i++) {
            const mt_math_construction *in_a = &a->constructions[k].list[i];
            const mt_math_construction *in_b = find_counterpart(match, in_a, &b->constructions[k]);
            if (!in_b) continue;
            pair_variants(match, in_a, in_b);
            pair_parts(match, in_a, in_b);
        }
    }
}

/* ---- assemblies in a font that varies ------------------------------------------------------------------ */

/* Whether the lengths, in shares of the em, are so alike that parts of either font join as the others. */
static bool joins_alike(const mt_glyph_match *match, const mt_math_table *table,
                        const mt_math_construction *a, const mt_math_construction *b) {
    double em_a = mt_font_units_per_em(match->a), em_b = mt_font_units_per_em(match->b);
    if (!mt_math_same_assembly(a, b)) return false;
    for (int i = 0; i < a->part_count; i++)
        if (fabs(a->parts[i].full / em_a - b->parts[i].full / em_b) > table->least_overlap / em_a / 2)
            return false;
    return true;
}

static bool is_paired_alike(const mt_glyph_match *match, const mt_math_table *table,
                            const mt_math_construction *a, const mt_math_construction *b) {
    if (!b || !joins_alike(match, table, a, b)) return false;
    for (int i = 0; i < a->part_count; i++)
        if (match->partner[a->parts[i].glyph] != b->parts[i].glyph) return false;
    return true;
}

/* Whether any of its parts had a partner. */
static bool hold_parts(mt_glyph_match *match, const mt_math_construction *a) {
    bool held = false;
    for (int i = 0; i < a->part_count; i++) {
        uint32_t *partner = &match->partner[a->parts[i].glyph];
        held |= *partner != MT_NO_PARTNER;
        *partner = MT_NO_PARTNER;
    }
    return held;
}

static bool hold_once(mt_glyph_match *match, const mt_math_table *a, const mt_math_table *b) {
    bool held = false;
    for (int k = 0; k < MT_MATH_DIRECTIONS; k++) {
        for (int i = 0; i < a->constructions[k].count; i++) {
            const mt_math_construction *in_a = &a->constructions[k].list[i];
            const mt_math_construction *in_b = find_counterpart(match, in_a, &b->constructions[k]);
            if (!is_paired_alike(match, a, in_a, in_b)) held |= hold_parts(match, in_a);
        }
    }
    return held;
}

void mt_match_math_hold(mt_glyph_match *match, const mt_math_table *a, const mt_math_table *b) {
    enum { PASSES_MAX = 16 }; /* assemblies share parts: those of a font are through in two or three */
    for (int i = 0; i < PASSES_MAX && hold_once(match, a, b); i++) continue;
}

/* ---- what it leads to ---------------------------------------------------------------------------------- */

static bool keep(bool *kept, uint32_t glyph) {
    bool is_new = !kept[glyph];
    kept[glyph] = true;
    return is_new;
}

bool mt_match_math_reach(const mt_math_table *math, bool *kept) {
    bool more = false;
    for (int k = 0; k < MT_MATH_DIRECTIONS; k++) {
        for (int i = 0; i < math->constructions[k].count; i++) {
            const mt_math_construction *own = &math->constructions[k].list[i];
            if (!kept[own->glyph]) continue;
            for (int v = 0; v < own->variant_count; v++) more |= keep(kept, own->variants[v].glyph);
            for (int p = 0; p < own->part_count; p++) more |= keep(kept, own->parts[p].glyph);
        }
    }
    return more;
}
