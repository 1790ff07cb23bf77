#include "blend/composite.h"

#include <math.h>
#include <stdlib.h>

#include "write/extent.h"

typedef struct mt_sorted_pair {
    uint32_t a, b;
    uint16_t glyph;
} mt_sorted_pair;

typedef struct mt_finder {
    mt_font *a, *b;
    const mt_charset *charset;
    mt_sorted_pair *sorted; /* the charset's glyphs */
    mt_composite *composites;
    mt_arena *arena, scratch;
} mt_finder;

/* ---- the glyph of two others --------------------------------------------------------------------------- */

static int by_pair(const void *p, const void *q) {
    const mt_sorted_pair *x = p, *y = q;
    if (x->a != y->a) return x->a < y->a ? -1 : 1;
    return (x->b > y->b) - (x->b < y->b);
}

static mt_status sort_pairs(mt_finder *finder) {
    size_t count = (size_t)finder->charset->glyph_count;
    finder->sorted = mt_arena_new(finder->arena, count, sizeof *finder->sorted);
    if (!finder->sorted) return MT_NO_MEMORY;
    for (size_t i = 0; i < count; i++) {
        const mt_pairing *pairing = &finder->charset->glyphs[i];
        finder->sorted[i] = (mt_sorted_pair){pairing->a, pairing->b, (uint16_t)i};
    }
    qsort(finder->sorted, count, sizeof *finder->sorted, by_pair);
    return MT_OK;
}

/* NULL where the two are not one glyph of the charset. */
static const mt_sorted_pair *find_pair(const mt_finder *finder, uint32_t a, uint32_t b) {
    mt_sorted_pair key = {a, b, 0};
    return bsearch(&key, finder->sorted, (size_t)finder->charset->glyph_count, sizeof key, by_pair);
}

/* ---- one glyph ----------------------------------------------------------------------------------------- */

/* How far apart two references move what they refer to, in em. */
static double distance(const mt_finder *finder, const mt_reference *a, const mt_reference *b) {
    double em_a = mt_font_units(finder->a), em_b = mt_font_units(finder->b);
    return hypot(a->dx / em_a - b->dx / em_b, a->dy / em_a - b->dy / em_b);
}

/* Matches a reference of A with the one of B's, not used yet, that makes a glyph with it; the nearest of several, such as
 * the two dots of a dieresis. */
static bool match(const mt_finder *finder, const mt_reference *a, const mt_references *in_b, bool *used,
                  mt_moving_reference *made) {
    int best = -1;
    for (int k = 0; k < in_b->count; k++) {
        const mt_reference *b = &in_b->list[k];
        const mt_sorted_pair *pair = used[k] ? NULL : find_pair(finder, a->glyph, b->glyph);
        if (!pair || (best >= 0 && distance(finder, a, b) >= distance(finder, a, &in_b->list[best])))
            continue;
        best = k;
        *made = (mt_moving_reference){pair->glyph, {a->dx, a->dy}, {b->dx, b->dy}};
    }
    if (best >= 0) used[best] = true;
    return best >= 0;
}

/* Leaves the composite as it is where one of the references has no counterpart. */
static mt_status match_all(mt_finder *finder, const mt_references *in_a, const mt_references *in_b,
                           mt_composite *composite) {
    size_t count = (size_t)in_a->count;
    bool *used = mt_arena_new(&finder->scratch, count, sizeof *used);
    mt_moving_reference *references = mt_arena_new(finder->arena, count, sizeof *references);
    if (!used || !references) return MT_NO_MEMORY;
    for (size_t i = 0; i < count; i++)
        if (!match(finder, &in_a->list[i], in_b, used, &references[i])) return MT_OK;
    composite->count = in_a->count;
    composite->references = references;
    return MT_OK;
}

static mt_status read_composite(mt_finder *finder, const mt_pairing *pairing, mt_composite *composite) {
    mt_references in_a, in_b;
    mt_status status = mt_font_references(finder->a, pairing->a, &finder->scratch, &in_a);
    if (status != MT_OK || in_a.count == 0) return status;
    status = mt_font_references(finder->b, pairing->b, &finder->scratch, &in_b);
    if (status != MT_OK || in_b.count != in_a.count) return status;
    return match_all(finder, &in_a, &in_b, composite);
}

static mt_status read_all(mt_finder *finder, const mt_hint_index *hints) {
    mt_status status = MT_OK;
    for (int i = 1; i < finder->charset->glyph_count && status == MT_OK; i++) {
        const mt_pairing *pairing = &finder->charset->glyphs[i];
        if (pairing->b == MT_NO_PARTNER || mt_hint_index_find(hints, pairing->a, pairing->b).count) continue;
        status = read_composite(finder, pairing, &finder->composites[i]);
        mt_arena_reset(&finder->scratch);
    }
    return status;
}

/* ---- depths -------------------------------------------------------------------------------------------- */

enum { UNKNOWN = -1 };

/* One more than the deepest part's; UNKNOWN while a part's is not known. */
static int depth_of(const mt_composite *composite, const mt_composite *composites) {
    int depth = 0;
    for (int i = 0; i < composite->count; i++) {
        int part = composites[composite->references[i].glyph].depth;
        if (part == UNKNOWN) return UNKNOWN;
        if (part >= depth) depth = part + 1;
    }
    return depth;
}

/* A round finds all depths that are one more. What is left then is too deep, or part of itself, and no composite. */
static void find_depths(mt_composite *composites, int count) {
    for (int i = 0; i < count; i++) composites[i].depth = composites[i].count ? UNKNOWN : 0;
    for (int round = 0; round < MT_GLYF_DEPTH_MAX; round++)
        for (int i = 0; i < count; i++)
            if (composites[i].depth == UNKNOWN) composites[i].depth = depth_of(&composites[i], composites);
    for (int i = 0; i < count; i++)
        if (composites[i].depth == UNKNOWN || composites[i].depth > MT_GLYF_DEPTH_MAX)
            composites[i] = (mt_composite){0};
}

/* ---- all of them --------------------------------------------------------------------------------------- */

mt_status mt_composites_find(mt_font *a, mt_font *b, const mt_charset *charset, const mt_hint_index *hints,
                             mt_arena *arena, mt_composite **composites) {
    mt_finder finder = {.a = a, .b = b, .charset = charset, .arena = arena};
    finder.composites = mt_arena_new(arena, (size_t)charset->glyph_count, sizeof *finder.composites);
    if (!finder.composites) return MT_NO_MEMORY;
    mt_status status = sort_pairs(&finder);
    if (status == MT_OK) status = read_all(&finder, hints);
    mt_arena_release(&finder.scratch);
    if (status != MT_OK) return status;
    find_depths(finder.composites, charset->glyph_count);
    *composites = finder.composites;
    return MT_OK;
}
