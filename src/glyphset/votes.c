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
    mt_votes larger = *votes;
    larger.room = votes->room ? 2 * votes->room : ROOM;
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
        *place = (mt_vote){(uint16_t)a, b, 0, origin};
        votes->count++;
    }
    if (place->count <= UINT32_MAX / 2) place->count += weight;
}

/* ---- texts --------------------------------------------------------------------------------------------- */

/* A text as both fonts shape it, and the place of it at hand. */
typedef struct mt_shaped_pair {
    const uint32_t *codes;
    mt_shaped_text a, b;
    mt_run in_a, in_b;
} mt_shaped_pair;

static unsigned cluster_at(const mt_shaped_text *shaped, unsigned i) {
    return i < shaped->count ? shaped->glyphs[i].cluster : UINT32_MAX;
}

static void skip_cluster(const mt_shaped_text *shaped, mt_run *run) {
    unsigned cluster = cluster_at(shaped, run->end);
    while (run->end < shaped->count && shaped->glyphs[run->end].cluster == cluster) run->end++;
}

/* Extends both runs to the next place of the text where both shaped texts have a border. */
static void extend(mt_shaped_pair *text) {
    skip_cluster(&text->a, &text->in_a);
    skip_cluster(&text->b, &text->in_b);
    for (;;) {
        unsigned next_a = cluster_at(&text->a, text->in_a.end), next_b = cluster_at(&text->b, text->in_b.end);
        if (next_a == next_b) return;
        if (next_a < next_b)
            skip_cluster(&text->a, &text->in_a);
        else
            skip_cluster(&text->b, &text->in_b);
    }
}

static bool is_at_end(const mt_shaped_pair *text) {
    return text->in_a.end >= text->a.count || text->in_b.end >= text->b.count;
}

static unsigned length_of(mt_run run) {
    return run.end - run.start;
}

/* ---- ink ----------------------------------------------------------------------------------------------- */

static unsigned count_inked(mt_inks *inks, const mt_shaped_text *shaped, mt_run run) {
    unsigned count = 0;
    for (unsigned i = run.start; i < run.end; i++) count += !mt_inks_blank(inks, shaped->glyphs[i].codepoint);
    return count;
}

/* Whether one font draws something in the run and the other nothing. */
static bool differ(const mt_votes *votes, const mt_shaped_pair *text, mt_run in_a, mt_run in_b) {
    return (count_inked(votes->ink_a, &text->a, in_a) > 0) != (count_inked(votes->ink_b, &text->b, in_b) > 0);
}

/* The next place: of a text with several it takes in what follows as long as one font has no ink for what the other has, and
 * where nothing follows, it is not told. */
static bool next_place(const mt_votes *votes, mt_shaped_pair *text) {
    text->in_a.start = text->in_a.end;
    text->in_b.start = text->in_b.end;
    extend(text);
    bool alone = text->in_a.start == 0 && is_at_end(text);
    mt_run last_a = text->in_a, last_b = text->in_b;
    while (!alone && differ(votes, text, last_a, last_b)) {
        if (is_at_end(text)) return false;
        last_a.start = text->in_a.end;
        last_b.start = text->in_b.end;
        extend(text);
        last_a.end = text->in_a.end;
        last_b.end = text->in_b.end;
    }
    return true;
}

/* Whether both runs have as many glyphs, and the i-th ones are both blank or both inked, for all of them. */
static bool same_inks(const mt_votes *votes, const mt_shaped_pair *text) {
    unsigned length = length_of(text->in_a);
    if (length != length_of(text->in_b)) return false;
    for (unsigned i = 0; i < length && length > 1; i++) {
        bool blank_a = mt_inks_blank(votes->ink_a, text->a.glyphs[text->in_a.start + i].codepoint);
        bool blank_b = mt_inks_blank(votes->ink_b, text->b.glyphs[text->in_b.start + i].codepoint);
        if (blank_a != blank_b) return false;
    }
    return true;
}

/* ---- votes --------------------------------------------------------------------------------------------- */

static void vote_each(mt_votes *votes, const mt_shaped_pair *text) {
    unsigned length = length_of(text->in_a);
    for (unsigned i = 0; i < length; i++) {
        const hb_glyph_info_t *a = &text->a.glyphs[text->in_a.start + i];
        const hb_glyph_info_t *b = &text->b.glyphs[text->in_b.start + i];
        if (mt_shaper_same_class(votes->a, a->codepoint, votes->b, b->codepoint))
            vote(votes, a->codepoint, b->codepoint, length == 1 ? ALONE : 1, text->codes[a->cluster]);
    }
}

/* For what all of B's glyphs draw, or for a blank, in the room that B has at the glyph's place; in the room of all of them where A
 * has one glyph. */
static void vote_drawing(mt_votes *votes, const mt_shaped_pair *text, unsigned i) {
    const hb_glyph_info_t *a = &text->a.glyphs[text->in_a.start + i];
    unsigned place = text->in_b.start + i;
    uint32_t number;
    mt_status status;
    if (mt_inks_blank(votes->ink_a, a->codepoint))
        status = mt_runs_add_blank(votes->runs, &text->b, place, &number);
    else if (length_of(text->in_a) == 1)
        status = mt_runs_add(votes->runs, &text->b, text->in_b, MT_RUN_WHOLE, &number);
    else
        status = mt_runs_add(votes->runs, &text->b, text->in_b, (int)place, &number);
    votes->failed |= status != MT_OK;
    if (status == MT_OK && number != MT_NO_DRAWING)
        vote(votes, a->codepoint, number, length_of(text->in_a) == 1 ? ALONE : 1, text->codes[a->cluster]);
}

/* Whether A's run may stand for what B's draws: it has one inked glyph, and is one glyph or as many as B has; marks stand for
 * marks. */
static bool is_for_drawing(const mt_votes *votes, const mt_shaped_pair *text) {
    unsigned length = length_of(text->in_a);
    if (length != 1 && length != length_of(text->in_b)) return false;
    if (count_inked(votes->ink_a, &text->a, text->in_a) != 1) return false;
    return !votes->a->has_classes || !votes->b->has_classes ||
           mt_run_is_mark(votes->a, &text->a, text->in_a) == mt_run_is_mark(votes->b, &text->b, text->in_b);
}

static void vote_place(mt_votes *votes, const mt_shaped_pair *text) {
    if (same_inks(votes, text))
        vote_each(votes, text);
    else if (is_for_drawing(votes, text))
        for (unsigned i = 0; i < length_of(text->in_a); i++) vote_drawing(votes, text, i);
}

static bool has_notdef(const mt_shaped_text *shaped) {
    for (unsigned i = 0; i < shaped->count; i++)
        if (shaped->glyphs[i].codepoint == 0 || shaped->glyphs[i].codepoint > UINT16_MAX) return true;
    return shaped->count == 0;
}

void mt_votes_add(mt_votes *votes, const uint32_t *codes, int count) {
    mt_shaped_pair text = {.codes = codes, .a = mt_shaper_shape(votes->a, codes, count)};
    if (has_notdef(&text.a)) return;
    text.b = mt_shaper_shape(votes->b, codes, count);
    if (has_notdef(&text.b)) return;
    while (!is_at_end(&text))
        if (next_place(votes, &text)) vote_place(votes, &text);
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
