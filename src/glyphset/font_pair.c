/* Wanted characters are paired first, then all others, sequences, names and forms, since a glyph of A has one partner: the
 * first that it gets. */
#include "glyphset/font_pair.h"

#include <stdlib.h>

/* ---- characters ---------------------------------------------------------------------------------------- */

static int ascending(const void *p, const void *q) {
    uint32_t x = ((const mt_code *)p)->code_point, y = ((const mt_code *)q)->code_point;
    return (x > y) - (x < y);
}

static mt_code look_up(const mt_font *a, const mt_font *b, uint32_t code_point) {
    return (mt_code){code_point, mt_font_glyph(a, code_point), mt_font_glyph(b, code_point)};
}

/* Without what a symbol font has for other codes than it maps: whichever font comes first, the characters are the same. */
static mt_code look_up_mapped(const mt_font *a, const mt_font *b, uint32_t code_point) {
    return (mt_code){code_point, mt_font_mapped_glyph(a, code_point), mt_font_mapped_glyph(b, code_point)};
}

static bool is_in(mt_code code, mt_glyph_set set) {
    return code.a && (code.b || set == MT_GLYPHS_FIRST);
}

/* The wanted ones that the set takes in, each once. */
static mt_status list_wanted(const mt_font *a, const mt_font *b, const mt_charset_request *request,
                             mt_arena *arena, mt_codes *codes) {
    codes->list = mt_arena_new(arena, (size_t)request->count, sizeof *codes->list);
    if (!codes->list) return MT_NO_MEMORY;
    for (int i = 0; i < request->count; i++) codes->list[i].code_point = request->wanted[i];
    qsort(codes->list, (size_t)request->count, sizeof *codes->list, ascending);
    for (int i = 0; i < request->count; i++) {
        mt_code code = look_up(a, b, codes->list[i].code_point);
        bool again = codes->count && codes->list[codes->count - 1].code_point == code.code_point;
        if (!again && is_in(code, request->set)) codes->list[codes->count++] = code;
    }
    return MT_OK;
}

/* All of A's that the set takes in; counts them only where `list` is NULL. */
static int fill_all(const mt_font *a, const mt_font *b, mt_glyph_set set, mt_code *list) {
    int count = 0;
    uint32_t c = 0;
    for (bool more = mt_font_next_char(a, 0, &c); more; more = mt_font_next_char(a, c + 1, &c)) {
        mt_code code = look_up_mapped(a, b, c);
        if (!is_in(code, set)) continue;
        if (list) list[count] = code;
        count++;
    }
    return count;
}

static mt_status list_all(const mt_font *a, const mt_font *b, mt_glyph_set set, mt_arena *arena,
                          mt_codes *codes) {
    codes->list = mt_arena_new(arena, (size_t)fill_all(a, b, set, NULL) + 1, sizeof *codes->list);
    if (!codes->list) return MT_NO_MEMORY;
    codes->count = fill_all(a, b, set, codes->list);
    return MT_OK;
}

/* Those of both fonts, or all of A's, of characters that are taken in. */
static mt_status list_sequences(mt_font *a, mt_font *b, const mt_codes *codes, mt_glyph_set set,
                                mt_arena *arena, mt_sequences *sequences) {
    mt_variation_sequences in_a, in_b;
    mt_status status = mt_font_variation_sequences(a, arena, &in_a);
    if (status == MT_OK) status = mt_font_variation_sequences(b, arena, &in_b);
    if (status != MT_OK) return status;
    mt_sequence *list = mt_arena_new(arena, (size_t)in_a.count + 1, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    *sequences = (mt_sequences){0, list};
    for (int i = 0; i < in_a.count; i++) {
        const mt_variation_sequence *variant = &in_a.list[i];
        mt_code key = {variant->code_point, 0, 0};
        const mt_variation_sequence *other =
            mt_variation_sequences_find(&in_b, variant->selector, variant->code_point);
        if (!other && set != MT_GLYPHS_FIRST) continue;
        if (bsearch(&key, codes->list, (size_t)codes->count, sizeof key, ascending))
            list[sequences->count++] = (mt_sequence){variant, other};
    }
    return MT_OK;
}

/* ---- pairs --------------------------------------------------------------------------------------------- */

static void pair_codes(const mt_codes *codes, mt_glyph_match *match) {
    for (int i = 0; i < codes->count; i++)
        if (codes->list[i].b)
            mt_match_pair(match, codes->list[i].a, codes->list[i].b, codes->list[i].code_point);
}

static void pair_sequences(const mt_sequences *sequences, mt_glyph_match *match) {
    for (int i = 0; i < sequences->count; i++) {
        const mt_sequence *s = &sequences->list[i];
        if (s->b) mt_match_pair(match, s->a->glyph, s->b->glyph, s->a->code_point);
    }
}

/* What is wanted is paired first; the rest follows, since forms of what is wanted may come from it. */
static mt_status pair_glyphs(mt_font *a, mt_font *b, const mt_codes *wanted, const mt_sequences *sequences,
                             const mt_gsub *gsub_a, mt_arena *arena, mt_glyph_match *match) {
    mt_codes all = {0};
    mt_gsub gsub_b;
    mt_status status = mt_glyph_match_new(a, b, arena, match);
    if (status == MT_OK) status = list_all(a, b, MT_GLYPHS_BOTH, arena, &all);
    if (status == MT_OK) {
        pair_codes(wanted, match);
        pair_codes(&all, match);
        pair_sequences(sequences, match);
        status = mt_match_names(match, a, b, arena);
    }
    if (status == MT_OK) status = mt_gsub_open(b, arena, &gsub_b);
    return status == MT_OK ? mt_match_forms(match, gsub_a, &gsub_b, arena) : status;
}

static mt_status keep_glyphs(const mt_charset_request *request, const mt_gsub *gsub, mt_arena *arena,
                             mt_font_pair *pair) {
    const mt_glyph_match *match = &pair->match;
    bool first = request->set == MT_GLYPHS_FIRST;
    bool *kept = pair->kept = mt_arena_new(arena, (size_t)match->count_a + 1, sizeof *kept);
    if (!kept) return MT_NO_MEMORY;
    kept[0] = true;
    for (int i = 0; i < pair->codes.count; i++) kept[pair->codes.list[i].a] = true;
    for (int i = 0; i < pair->sequences.count; i++) kept[pair->sequences.list[i].a->glyph] = true;
    if (request->count) return mt_match_reach(match, gsub, first, arena, kept);
    for (int i = 0; i < match->count_a; i++) kept[i] = first || match->partner[i] != MT_NO_PARTNER;
    return MT_OK;
}

/* ---- the pair ------------------------------------------------------------------------------------------ */

mt_status mt_font_pair_make(mt_font *a, mt_font *b, const mt_charset_request *request, mt_arena *arena,
                            mt_font_pair *pair) {
    mt_font_pair made = {0};
    mt_gsub gsub;
    mt_status status = request->count ? list_wanted(a, b, request, arena, &made.codes)
                                      : list_all(a, b, request->set, arena, &made.codes);
    if (status != MT_OK) return status;
    if (made.codes.count == 0) return MT_NOTHING_SHARED;
    status = list_sequences(a, b, &made.codes, request->set, arena, &made.sequences);
    if (status == MT_OK) status = mt_gsub_open(a, arena, &gsub);
    if (status == MT_OK) status = pair_glyphs(a, b, &made.codes, &made.sequences, &gsub, arena, &made.match);
    if (status == MT_OK) status = keep_glyphs(request, &gsub, arena, &made);
    if (status == MT_OK) *pair = made;
    return status;
}

const mt_code *mt_font_pair_code(const mt_font_pair *pair, uint32_t code_point) {
    mt_code key = {code_point, 0, 0};
    return bsearch(&key, pair->codes.list, (size_t)pair->codes.count, sizeof key, ascending);
}

static int by_sequence(const void *p, const void *q) {
    const mt_variation_sequence *x = ((const mt_sequence *)p)->a, *y = ((const mt_sequence *)q)->a;
    if (x->selector != y->selector) return x->selector < y->selector ? -1 : 1;
    return (x->code_point > y->code_point) - (x->code_point < y->code_point);
}

const mt_sequence *mt_font_pair_sequence(const mt_font_pair *pair, const mt_sequence *like) {
    return bsearch(like, pair->sequences.list, (size_t)pair->sequences.count, sizeof *like, by_sequence);
}
