/* Wanted characters are paired first, then all others, sequences, texts, MATH, names and forms, since a glyph of A has one partner: the
 * first that it gets. */
#include "glyphset/font_pair.h"

#include "layout/open.h"

#include <stdlib.h>

#include "math/table/open.h"

enum { FRACTION_SLASH = 0x2044 };

/* ---- sequences ------------------------------------------------------------------------------------------ */

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
        const mt_variation_sequence *other =
            mt_variation_sequences_find(&in_b, variant->selector, variant->code_point);
        if (!other && set != MT_GLYPHS_FIRST) continue;
        if (mt_codes_find(codes, variant->code_point))
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

/* What a person has paired, whether a character leads there or not. */
static void pair_given(const mt_charset_request *request, const mt_codes *wanted, const mt_codes *all,
                       mt_glyph_match *match) {
    for (int k = 0; k < 2; k++) {
        const mt_codes *codes = k ? all : wanted;
        for (int i = 0; i < codes->count; i++) {
            uint32_t given = mt_given_partner(request->pairs, codes->list[i].a, request->other);
            if (given) mt_match_pair(match, codes->list[i].a, given, codes->list[i].code_point);
        }
    }
    for (int a = 1; a < match->count_a; a++) {
        uint32_t given = mt_given_partner(request->pairs, (uint32_t)a, request->other);
        if (given) mt_match_pair(match, (uint32_t)a, given, 0);
    }
}

/* Pairs by characters, by sequences, and by texts of the `spoken` characters. The rest of the characters comes behind the wanted
 * ones: a feature may lead to their glyphs. */
static mt_status pair_by_text(mt_text_pairs *pairs, mt_codes *wanted, const mt_codes *all, mt_codes *spoken,
                              const mt_sequences *sequences, const mt_gsub *gsub_a, const mt_gsub *gsub_b,
                              mt_arena *arena, mt_glyph_match *match) {
    uint32_t *chars = mt_arena_new(arena, (size_t)spoken->count + 1, sizeof *chars);
    int count = 0;
    if (!chars) return MT_NO_MEMORY;
    for (int i = 0; i < spoken->count; i++)
        if (spoken->list[i].b && mt_font_glyph(match->b, spoken->list[i].code_point) == spoken->list[i].b)
            chars[count++] = spoken->list[i].code_point;
    mt_status status = mt_text_pairs_find(pairs, match, gsub_a, gsub_b, chars, count, arena);
    if (status == MT_OK) status = mt_text_pairs_settle(pairs, match, wanted->list, wanted->count);
    if (status == MT_OK && spoken != wanted)
        status = mt_text_pairs_settle(pairs, match, spoken->list, spoken->count);
    if (status != MT_OK) return status;
    pair_codes(wanted, match);
    pair_codes(all, match);
    pair_sequences(sequences, match);
    return mt_text_pairs_apply(pairs, match);
}

/* Adds what A's substitutions and its MATH lead to: all of it, or what nobody has to ask for. */
static mt_status reach(const mt_gsub *gsub, const mt_math_table *math, bool asked_for, bool fractions,
                       bool *kept) {
    enum { ROUNDS_MAX = 8 }; /* from substitutions to MATH and back: no font has more than two */
    mt_status status = MT_OK;
    bool more = true;
    for (int i = 0; i < ROUNDS_MAX && more && status == MT_OK; i++) {
        status = asked_for ? mt_match_reach(gsub, kept) : mt_match_reach_automatic(gsub, fractions, kept);
        more = mt_match_math_reach(math, kept);
    }
    return status;
}

/* Characters, sequences and glyphs that are wanted, and .notdef. */
static mt_status list_wanted(const mt_charset_request *request, const mt_font_pair *pair, mt_arena *arena,
                             bool **kept) {
    bool *list = mt_arena_new(arena, (size_t)pair->match.count_a + 1, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    list[0] = true;
    for (int i = 0; i < pair->codes.count; i++) list[pair->codes.list[i].a] = true;
    for (int i = 0; i < pair->sequences.count; i++) list[pair->sequences.list[i].a->glyph] = true;
    for (int i = 0; i < request->glyph_count; i++) list[request->glyphs[i]] = true;
    *kept = list;
    return MT_OK;
}

static bool is_limited(const mt_charset_request *request, const mt_font_pair *pair) {
    return mt_request_is_limited(request) || mt_font_is_without_layout(pair->match.a);
}

/* The glyphs that may be kept of a limited request, before any of them is paired. */
static mt_status find_reached(const mt_charset_request *request, const mt_gsub *gsub,
                              const mt_math_table *math, mt_arena *arena, mt_font_pair *pair) {
    if (!is_limited(request, pair)) return MT_OK;
    mt_status status = list_wanted(request, pair, arena, &pair->match.reached);
    return status == MT_OK ? reach(gsub, math, true, true, pair->match.reached) : status;
}

/* A glyph that is wanted by itself is paired as in a font of all characters: any text may lead to it. */
static mt_status pair_glyphs(mt_font *a, mt_font *b, const mt_charset_request *request, const mt_gsub *gsub_a,
                             const mt_math_table *math_a, mt_arena *arena, mt_font_pair *pair) {
    mt_codes *wanted = &pair->codes;
    mt_glyph_match *match = &pair->match;
    const mt_charset_request any = {.pairs = request->pairs, .other = request->other};
    mt_codes all = {0};
    mt_gsub gsub_b;
    mt_math_table math_b = {0};
    mt_text_pairs pairs = {0};
    mt_status status = mt_glyph_match_new(a, b, arena, match);
    if (status == MT_OK) status = find_reached(request, gsub_a, math_a, arena, pair);
    if (status == MT_OK) status = mt_codes_list(a, b, &any, arena, &all);
    if (status == MT_OK) pair_given(request, wanted, &all, match);
    if (status == MT_OK) status = mt_gsub_open(b, arena, &gsub_b);
    if (status == MT_OK) status = mt_math_table_open(b, arena, &math_b);
    if (status == MT_OK)
        status = pair_by_text(&pairs, wanted, &all, request->glyph_count ? &all : wanted, &pair->sequences,
                              gsub_a, &gsub_b, arena, match);
    mt_text_pairs_close(&pairs);
    if (status == MT_OK) mt_match_math(match, math_a, &math_b);
    if (status == MT_OK) status = mt_match_names(match, a, b, arena);
    if (status == MT_OK) status = mt_match_forms(match, gsub_a, &gsub_b, arena);
    if (status == MT_OK) mt_match_math(match, math_a, &math_b); /* of what names and features have paired */
    if (status == MT_OK && request->varies) mt_match_math_hold(match, math_a, &math_b);
    if (status == MT_OK) status = match->ink_a.status;
    return status == MT_OK ? match->ink_b.status : status;
}

/* What A makes of the glyphs that are kept. Only of wanted characters there are forms that nobody asks for. */
static mt_status keep_forms(const mt_charset_request *request, const mt_gsub *gsub, const mt_math_table *math,
                            mt_arena *arena, mt_font_pair *pair) {
    bool fractions = mt_codes_find(&pair->codes, FRACTION_SLASH) != NULL;
    bool asked_for = !mt_request_is_limited(request) || request->alternates;
    mt_status status = reach(gsub, math, asked_for, fractions, pair->kept);
    if (status != MT_OK || asked_for) return status;
    return mt_match_left_out(gsub, pair->kept, fractions, arena, &pair->left);
}

static mt_status keep_glyphs(const mt_charset_request *request, const mt_gsub *gsub,
                             const mt_math_table *math, mt_arena *arena, mt_font_pair *pair) {
    const mt_glyph_match *match = &pair->match;
    mt_status status = list_wanted(request, pair, arena, &pair->kept);
    if (status != MT_OK) return status;
    bool limited = is_limited(request, pair);
    for (int i = 0; i < match->count_a && !limited; i++)
        pair->kept[i] |= request->set == MT_GLYPHS_FIRST || match->partner[i] != MT_NO_PARTNER;
    return keep_forms(request, gsub, math, arena, pair);
}

/* ---- the pair ------------------------------------------------------------------------------------------ */

mt_status mt_font_pair_make(mt_font *a, mt_font *b, const mt_charset_request *request, mt_arena *arena,
                            mt_font_pair *pair) {
    mt_font_pair made = {0};
    mt_gsub gsub;
    mt_math_table math;
    mt_status status = mt_codes_list(a, b, request, arena, &made.codes);
    if (status != MT_OK) return status;
    if (made.codes.count == 0 && request->glyph_count == 0) return MT_NOTHING_SHARED;
    status = list_sequences(a, b, &made.codes, request->set, arena, &made.sequences);
    if (status == MT_OK) status = mt_gsub_open(a, arena, &gsub);
    if (status == MT_OK) status = mt_math_table_open(a, arena, &math);
    if (status == MT_OK) status = pair_glyphs(a, b, request, &gsub, &math, arena, &made);
    if (status == MT_OK) status = keep_glyphs(request, &gsub, &math, arena, &made);
    if (status == MT_OK) *pair = made;
    return status;
}

static mt_status check_lookups(mt_font *font, mt_arena *arena) {
    mt_font_pair with_itself;
    mt_layout layout;
    mt_bytes gpos;
    mt_status status = mt_font_table(font, MT_TAG('G', 'P', 'O', 'S'), arena, &gpos);
    if (status == MT_OK) status = mt_layout_open(gpos, MT_EXTENSION_GPOS, arena, &layout);
    return status == MT_OK ? mt_font_pair_make(font, font, &(mt_charset_request){0}, arena, &with_itself)
                           : status;
}

bool mt_font_is_endless(mt_font *font) {
    mt_arena arena = {0};
    mt_status status = check_lookups(font, &arena);
    mt_arena_release(&arena);
    return status == MT_ENDLESS_LOOKUPS;
}

const mt_code *mt_font_pair_code(const mt_font_pair *pair, uint32_t code_point) {
    return mt_codes_find(&pair->codes, code_point);
}

static int by_sequence(const void *p, const void *q) {
    const mt_variation_sequence *x = ((const mt_sequence *)p)->a, *y = ((const mt_sequence *)q)->a;
    if (x->selector != y->selector) return x->selector < y->selector ? -1 : 1;
    return (x->code_point > y->code_point) - (x->code_point < y->code_point);
}

const mt_sequence *mt_font_pair_sequence(const mt_font_pair *pair, const mt_sequence *like) {
    return bsearch(like, pair->sequences.list, (size_t)pair->sequences.count, sizeof *like, by_sequence);
}
