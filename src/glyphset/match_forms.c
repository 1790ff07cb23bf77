/* Forms: the glyphs that features lead to from glyphs that are paired already. The groups of lookups are gone through
 * until none of them pairs any more. */
#include "glyphset/match.h"

#include <stdlib.h>

#include "geometry/limits.h"
#include "glyphset/match_groups.h"

enum { INPUTS_MAX = 64 }; /* of a ligature */

/* A substitution of B's, and its place in its lookup. */
typedef struct mt_sorted_substitution {
    const mt_substitution *substitution;
    int order;
} mt_sorted_substitution;

typedef struct mt_sorted_lookup {
    int count;
    mt_sorted_substitution *list; /* by inputs, then by order */
} mt_sorted_lookup;

typedef struct mt_forms {
    mt_glyph_match *match;
    const mt_gsub *a, *b;
    mt_sorted_lookup *sorted; /* for each lookup of B's */
    mt_groups groups;
    int64_t left; /* of the comparisons that are made: fonts made for it would take very many */
} mt_forms;

/* ---- B's substitutions in order ------------------------------------------------------------------------ */

static int compare_inputs(const uint16_t *x, int count_x, const uint16_t *y, int count_y) {
    if (count_x != count_y) return count_x < count_y ? -1 : 1;
    for (int i = 0; i < count_x; i++)
        if (x[i] != y[i]) return x[i] < y[i] ? -1 : 1;
    return 0;
}

static int by_inputs(const void *p, const void *q) {
    const mt_sorted_substitution *x = p, *y = q;
    int order = compare_inputs(x->substitution->glyphs, x->substitution->inputs, y->substitution->glyphs,
                               y->substitution->inputs);
    return order ? order : x->order - y->order;
}

static mt_status sort_lookup(const mt_gsub_lookup *lookup, mt_arena *arena, mt_sorted_lookup *sorted) {
    int count = 0;
    for (int i = 0; i < lookup->subtable_count; i++) count += lookup->subtables[i].count;
    sorted->list = mt_arena_new(arena, (size_t)count + 1, sizeof *sorted->list);
    if (!sorted->list) return MT_NO_MEMORY;
    for (int i = 0; i < lookup->subtable_count; i++)
        for (int k = 0; k < lookup->subtables[i].count; k++, sorted->count++)
            sorted->list[sorted->count] =
                (mt_sorted_substitution){&lookup->subtables[i].list[k], sorted->count};
    if (count) qsort(sorted->list, (size_t)count, sizeof *sorted->list, by_inputs);
    return MT_OK;
}

/* The first substitution whose inputs are not before these. */
static int find_inputs(const mt_sorted_lookup *sorted, const uint16_t *inputs, int count) {
    int low = 0, high = sorted->count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        const mt_substitution *at = sorted->list[middle].substitution;
        if (compare_inputs(at->glyphs, at->inputs, inputs, count) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* ---- pairing ------------------------------------------------------------------------------------------- */

/* How many glyphs the feature makes of the inputs; of a list of alternates it takes the first. */
static int outputs_of(int type, const mt_substitution *substitution) {
    return type == MT_GSUB_ALTERNATE ? 1 : substitution->outputs;
}

static bool has_free(const mt_glyph_match *match, int type, const mt_substitution *a) {
    for (int i = 0; i < outputs_of(type, a); i++)
        if (match->partner[a->glyphs[a->inputs + i]] == MT_NO_PARTNER) return true;
    return false;
}

/* The partners of the inputs; false when one has none, or a composed one, which B's substitutions do not know. */
static bool translate(const mt_glyph_match *match, const mt_substitution *a, uint16_t *inputs) {
    for (int i = 0; i < a->inputs; i++) {
        uint32_t partner = match->partner[a->glyphs[i]];
        if (partner >= (uint32_t)match->count_b) return false;
        inputs[i] = (uint16_t)partner;
    }
    return true;
}

/* The first `count` outputs; with `free_only`, with glyphs of B's that are no partners yet. */
static bool pair_outputs(mt_glyph_match *match, const mt_substitution *a, const mt_substitution *b, int count,
                         bool free_only) {
    bool paired = false;
    for (int i = 0; i < count; i++) {
        uint32_t in_b = b->glyphs[b->inputs + i];
        if (in_b == 0 || (free_only && match->taken[in_b])) continue;
        paired |= mt_match_form(match, a->glyphs[a->inputs + i], in_b, match->origin[a->glyphs[0]]);
    }
    return paired;
}

/* Pairs the outputs of a substitution of A's with those of B's lookup for the same inputs. */
static bool pair_in_lookup(mt_forms *forms, int type, const mt_substitution *a, const uint16_t *inputs,
                           int lookup, bool free_only) {
    const mt_sorted_lookup *sorted = &forms->sorted[lookup];
    const int type_b = forms->b->lookups[lookup].type, count = outputs_of(type, a);
    bool paired = false;
    forms->left -= 16;
    for (int i = find_inputs(sorted, inputs, a->inputs); i < sorted->count; i++) {
        const mt_substitution *b = sorted->list[i].substitution;
        if (compare_inputs(b->glyphs, b->inputs, inputs, a->inputs) != 0 || forms->left-- < 0) break;
        if (outputs_of(type_b, b) == count) paired |= pair_outputs(forms->match, a, b, count, free_only);
    }
    return paired;
}

static bool pair_substitution(mt_forms *forms, const mt_group *group, int type, const mt_substitution *a) {
    uint16_t inputs[INPUTS_MAX];
    bool paired = false;
    forms->left--;
    if (a->inputs > INPUTS_MAX || !has_free(forms->match, type, a) || !translate(forms->match, a, inputs))
        return false;
    forms->left -= forms->b->layout.lookup_count;
    for (int pass = 0; pass < 2; pass++)
        for (int i = 0; i < forms->b->layout.lookup_count && forms->left >= 0; i++)
            if (group->b[i]) paired |= pair_in_lookup(forms, type, a, inputs, i, pass == 0);
    return paired;
}

static bool pair_group(mt_forms *forms, const mt_group *group) {
    bool paired = false;
    forms->left -= forms->a->layout.lookup_count;
    for (int i = 0; i < forms->a->layout.lookup_count; i++) {
        const mt_gsub_lookup *lookup = &forms->a->lookups[i];
        for (int k = 0; group->a[i] && k < lookup->subtable_count && forms->left >= 0; k++, forms->left--)
            for (int s = 0; s < lookup->subtables[k].count && forms->left >= 0; s++)
                paired |= pair_substitution(forms, group, lookup->type, &lookup->subtables[k].list[s]);
    }
    return paired;
}

/* A later stage is gone to only when the earlier ones pair no more. */
static void pair_groups(mt_forms *forms) {
    for (int stage = 0; stage < MT_GROUP_STAGES && forms->left >= 0; stage++) {
        bool paired = false;
        for (int i = 0; i < forms->groups.count; i++)
            if (forms->groups.list[i].stage == stage) paired |= pair_group(forms, &forms->groups.list[i]);
        if (paired) stage = -1;
    }
}

mt_status mt_match_forms(mt_glyph_match *match, const mt_gsub *a, const mt_gsub *b, mt_arena *arena) {
    int lookups = b->layout.lookup_count;
    if (!lookups || !a->layout.lookup_count) return MT_OK;
    mt_forms forms = {.match = match, .a = a, .b = b, .left = MT_COMPARISONS_MAX};
    forms.sorted = mt_arena_new(arena, (size_t)lookups, sizeof *forms.sorted);
    if (!forms.sorted) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i < lookups && status == MT_OK; i++)
        status = sort_lookup(&b->lookups[i], arena, &forms.sorted[i]);
    if (status == MT_OK) status = mt_match_groups(a, b, arena, &forms.groups);
    if (status == MT_OK) pair_groups(&forms);
    return status;
}
