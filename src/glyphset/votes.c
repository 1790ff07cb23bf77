#include "glyphset/votes.h"

#include <stdlib.h>

enum { ROOM = 4096, ALONE = 4 /* the weight of a place with one glyph */ };

void mt_votes_free(mt_votes *votes) {
    mt_free(votes->list);
    *votes = (mt_votes){0};
}

/* ---- the table ----------------------------------------------------------------------------------------- */

/* The place of the two glyphs in the table, or the empty one where they belong. */
static mt_vote *find(const mt_votes *votes, uint32_t a, uint32_t b) {
    uint32_t mask = (uint32_t)votes->room - 1, at = ((a << 16 | b) * 2654435769u >> 7) & mask;
    while (votes->list[at].count && (votes->list[at].a != a || votes->list[at].b != b)) at = (at + 1) & mask;
    return &votes->list[at];
}

/* Three quarters of the places are used at most. */
static bool make_room(mt_votes *votes) {
    if (4 * (votes->count + 1) <= 3 * votes->room) return true;
    mt_votes larger = {.count = votes->count, .room = votes->room ? 2 * votes->room : ROOM};
    larger.list = mt_new((size_t)larger.room, sizeof *larger.list);
    if (!larger.list) return false;
    for (int i = 0; i < votes->room; i++)
        if (votes->list[i].count) *find(&larger, votes->list[i].a, votes->list[i].b) = votes->list[i];
    mt_free(votes->list);
    *votes = larger;
    return true;
}

static void vote(mt_votes *votes, uint32_t a, uint32_t b, uint32_t weight, uint32_t origin) {
    if (!make_room(votes)) {
        votes->failed = true;
        return;
    }
    mt_vote *place = find(votes, a, b);
    if (!place->count) {
        *place = (mt_vote){(uint16_t)a, (uint16_t)b, 0, origin};
        votes->count++;
    }
    if (place->count <= UINT32_MAX / 2) place->count += weight;
}

/* ---- texts --------------------------------------------------------------------------------------------- */

/* A part of a shaped text: the glyphs from `start` up to `end`. */
typedef struct mt_cluster_run {
    unsigned start, end;
} mt_cluster_run;

static unsigned cluster_at(const mt_shaped_text *shaped, unsigned i) {
    return i < shaped->count ? shaped->glyphs[i].cluster : UINT32_MAX;
}

static void skip_cluster(const mt_shaped_text *shaped, mt_cluster_run *part) {
    unsigned cluster = cluster_at(shaped, part->end);
    while (part->end < shaped->count && shaped->glyphs[part->end].cluster == cluster) part->end++;
}

/* Extends both parts to the next place of the text where both shaped texts have a border. */
static void next_place(const mt_shaped_text *a, mt_cluster_run *in_a, const mt_shaped_text *b,
                       mt_cluster_run *in_b) {
    in_a->start = in_a->end;
    in_b->start = in_b->end;
    skip_cluster(a, in_a);
    skip_cluster(b, in_b);
    for (;;) {
        unsigned next_a = cluster_at(a, in_a->end), next_b = cluster_at(b, in_b->end);
        if (next_a == next_b) return;
        if (next_a < next_b)
            skip_cluster(a, in_a);
        else
            skip_cluster(b, in_b);
    }
}

static bool has_notdef(const mt_shaped_text *shaped) {
    for (unsigned i = 0; i < shaped->count; i++)
        if (shaped->glyphs[i].codepoint == 0 || shaped->glyphs[i].codepoint > UINT16_MAX) return true;
    return shaped->count == 0;
}

void mt_votes_add(mt_votes *votes, mt_shaper *a, mt_shaper *b, const uint32_t *codes, int count) {
    mt_shaped_text in_a = mt_shaper_shape(a, codes, count);
    if (has_notdef(&in_a)) return;
    mt_shaped_text in_b = mt_shaper_shape(b, codes, count);
    if (has_notdef(&in_b)) return;
    mt_cluster_run part_a = {0, 0}, part_b = {0, 0};
    while (part_a.end < in_a.count && part_b.end < in_b.count) {
        next_place(&in_a, &part_a, &in_b, &part_b);
        unsigned length = part_a.end - part_a.start;
        if (length != part_b.end - part_b.start) continue;
        for (unsigned i = 0; i < length; i++) {
            uint32_t glyph_a = in_a.glyphs[part_a.start + i].codepoint;
            uint32_t glyph_b = in_b.glyphs[part_b.start + i].codepoint;
            if (mt_shaper_same_class(a, glyph_a, b, glyph_b))
                vote(votes, glyph_a, glyph_b, length == 1 ? ALONE : 1,
                     codes[in_a.glyphs[part_a.start + i].cluster]);
        }
    }
}

/* ---- the result ---------------------------------------------------------------------------------------- */

static int by_count(const void *p, const void *q) {
    const mt_vote *x = p, *y = q;
    if (x->a != y->a) return x->a < y->a ? -1 : 1;
    if (x->count != y->count) return x->count > y->count ? -1 : 1;
    return (x->b > y->b) - (x->b < y->b);
}

void mt_votes_sort(mt_votes *votes) {
    int count = 0;
    for (int i = 0; i < votes->room; i++)
        if (votes->list[i].count) votes->list[count++] = votes->list[i];
    if (count) qsort(votes->list, (size_t)count, sizeof *votes->list, by_count);
}
