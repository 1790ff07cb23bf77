#include "glyphset/charset.h"

#include <stdlib.h>

#include "geometry/limits.h"
#include "source/variation_sequences.h"

/* ---- characters ---------------------------------------------------------------------------------------- */

/* A character and its glyph in each font; 0 where a font has none. */
typedef struct mt_code {
    uint32_t code_point, a, b;
} mt_code;

typedef struct mt_codes {
    int count;
    mt_code *list; /* ascending */
} mt_codes;

static int ascending(const void *p, const void *q) {
    uint32_t x = ((const mt_code *)p)->code_point, y = ((const mt_code *)q)->code_point;
    return (x > y) - (x < y);
}

static mt_code look_up(const mt_font *a, const mt_font *b, uint32_t code_point) {
    return (mt_code){code_point, mt_font_glyph(a, code_point), mt_font_glyph(b, code_point)};
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
        mt_code code = look_up(a, b, c);
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

/* The sequences of characters that are taken in: those of both fonts, or all of A's. */
typedef struct mt_sequence {
    const mt_variation_sequence *a, *b; /* b is NULL where B has none */
} mt_sequence;

typedef struct mt_sequences {
    int count;
    mt_sequence *list;
} mt_sequences;

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

/* Marks the glyphs of A's that are kept. */
static mt_status keep_glyphs(const mt_codes *codes, const mt_sequences *sequences,
                             const mt_charset_request *request, const mt_gsub *gsub,
                             const mt_glyph_match *match, mt_arena *arena, bool *kept) {
    bool first = request->set == MT_GLYPHS_FIRST;
    kept[0] = true;
    for (int i = 0; i < codes->count; i++) kept[codes->list[i].a] = true;
    for (int i = 0; i < sequences->count; i++) kept[sequences->list[i].a->glyph] = true;
    if (request->count) return mt_match_reach(match, gsub, first, arena, kept);
    for (int i = 0; i < match->count_a; i++) kept[i] = first || match->partner[i] != MT_NO_PARTNER;
    return MT_OK;
}

/* ---- glyphs -------------------------------------------------------------------------------------------- */

/* Whether the character leads to the glyph's first pair, rather than to a further one. */
static bool is_primary(const mt_glyph_match *match, mt_code code) {
    return !code.b || match->partner[code.a] == code.b;
}

static void list_primaries(const mt_glyph_match *match, const mt_codes *codes, const bool *kept,
                           uint16_t *numbers, mt_charset *charset) {
    for (int i = 0; i < match->count_a; i++) {
        if (!kept[i]) continue;
        numbers[i] = (uint16_t)charset->glyph_count;
        charset->glyphs[charset->glyph_count++] =
            (mt_pairing){match->origin[i], (uint32_t)i, match->partner[i], false};
        charset->unblended_count += match->partner[i] == MT_NO_PARTNER;
    }
    charset->primary_count = charset->glyph_count;
    for (int i = 0; i < codes->count; i++) {
        mt_pairing *pairing = &charset->glyphs[numbers[codes->list[i].a]];
        if (pairing->mapped || !is_primary(match, codes->list[i])) continue;
        pairing->mapped = true;
        pairing->code_point = codes->list[i].code_point;
    }
}

static int by_glyphs(const void *p, const void *q) {
    const mt_code *x = p, *y = q;
    if (x->a != y->a) return x->a < y->a ? -1 : 1;
    if (x->b != y->b) return x->b < y->b ? -1 : 1;
    return (x->code_point > y->code_point) - (x->code_point < y->code_point);
}

/* Each further pair once, by the first character that leads to it. */
static mt_status list_further(const mt_glyph_match *match, const mt_codes *codes, mt_arena *arena,
                              mt_codes *further) {
    int count = 0, once = 0;
    mt_code *list = mt_arena_new(arena, (size_t)codes->count + 1, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    for (int i = 0; i < codes->count; i++)
        if (!is_primary(match, codes->list[i])) list[count++] = codes->list[i];
    if (count) qsort(list, (size_t)count, sizeof *list, by_glyphs);
    for (int i = 0; i < count; i++)
        if (once == 0 || list[i].a != list[once - 1].a || list[i].b != list[once - 1].b)
            list[once++] = list[i];
    *further = (mt_codes){once, list};
    return MT_OK;
}

typedef struct mt_sorted_glyph {
    uint32_t a, b;
    uint16_t glyph;
} mt_sorted_glyph;

static int by_pair(const void *p, const void *q) {
    const mt_sorted_glyph *x = p, *y = q;
    if (x->a != y->a) return x->a < y->a ? -1 : 1;
    return (x->b > y->b) - (x->b < y->b);
}

/* Adds the further pairs that a font has room for, in the order of their characters, and lists them by glyphs. */
static mt_status add_further(mt_codes *further, mt_arena *arena, mt_charset *charset,
                             mt_sorted_glyph **sorted) {
    int room = MT_GLYPHS_MAX - charset->glyph_count;
    *sorted = mt_arena_new(arena, (size_t)further->count + 1, sizeof **sorted);
    if (!*sorted) return MT_NO_MEMORY;
    if (further->count) qsort(further->list, (size_t)further->count, sizeof *further->list, ascending);
    if (further->count > room) further->count = room;
    for (int i = 0; i < further->count; i++) {
        mt_code code = further->list[i];
        (*sorted)[i] = (mt_sorted_glyph){code.a, code.b, (uint16_t)charset->glyph_count};
        charset->glyphs[charset->glyph_count++] = (mt_pairing){code.code_point, code.a, code.b, true};
    }
    if (further->count) qsort(*sorted, (size_t)further->count, sizeof **sorted, by_pair);
    return MT_OK;
}

static mt_status map_chars(const mt_glyph_match *match, const mt_codes *codes, const uint16_t *numbers,
                           mt_arena *arena, mt_charset *charset) {
    mt_codes further;
    mt_sorted_glyph *sorted;
    charset->chars = mt_arena_new(arena, (size_t)codes->count, sizeof *charset->chars);
    if (!charset->chars) return MT_NO_MEMORY;
    mt_status status = list_further(match, codes, arena, &further);
    if (status == MT_OK) status = add_further(&further, arena, charset, &sorted);
    for (int i = 0; i < codes->count && status == MT_OK; i++) {
        mt_code code = codes->list[i];
        mt_sorted_glyph key = {code.a, code.b, 0};
        const mt_sorted_glyph *found =
            is_primary(match, code) ? NULL
                                    : bsearch(&key, sorted, (size_t)further.count, sizeof key, by_pair);
        charset->chars[i] = (mt_char){code.code_point, found ? found->glyph : numbers[code.a]};
    }
    charset->char_count = codes->count;
    return status;
}

static mt_status list_variants(const mt_sequences *sequences, const uint16_t *numbers, mt_arena *arena,
                               mt_charset *charset) {
    charset->variants = mt_arena_new(arena, (size_t)sequences->count + 1, sizeof *charset->variants);
    if (!charset->variants) return MT_NO_MEMORY;
    for (int i = 0; i < sequences->count; i++) {
        const mt_variation_sequence *a = sequences->list[i].a;
        charset->variants[i] =
            (mt_char_variation){a->selector, a->code_point, numbers[a->glyph], a->by_default};
    }
    charset->variant_count = sequences->count;
    return MT_OK;
}

/* ---- the whole ----------------------------------------------------------------------------------------- */

static mt_status list_glyphs(const mt_glyph_match *match, const mt_codes *codes,
                             const mt_sequences *sequences, const bool *kept, mt_arena *arena,
                             mt_charset *charset) {
    mt_charset made = {0};
    uint16_t *numbers = mt_arena_new(arena, (size_t)match->count_a, sizeof *numbers);
    made.glyphs = mt_arena_new(arena, (size_t)match->count_a + (size_t)codes->count, sizeof *made.glyphs);
    if (!numbers || !made.glyphs) return MT_NO_MEMORY;
    list_primaries(match, codes, kept, numbers, &made);
    mt_status status = map_chars(match, codes, numbers, arena, &made);
    if (status == MT_OK) status = list_variants(sequences, numbers, arena, &made);
    if (status == MT_OK) *charset = made;
    return status;
}

mt_status mt_charset_make(mt_font *a, mt_font *b, const mt_charset_request *request, mt_arena *arena,
                          mt_charset *charset) {
    mt_codes codes = {0};
    mt_sequences sequences;
    mt_gsub gsub;
    mt_glyph_match match;
    mt_status status = request->count ? list_wanted(a, b, request, arena, &codes)
                                      : list_all(a, b, request->set, arena, &codes);
    if (status != MT_OK) return status;
    if (codes.count == 0) return MT_NOTHING_SHARED;
    status = list_sequences(a, b, &codes, request->set, arena, &sequences);
    if (status == MT_OK) status = mt_gsub_open(a, arena, &gsub);
    if (status == MT_OK) status = pair_glyphs(a, b, &codes, &sequences, &gsub, arena, &match);
    bool *kept = status == MT_OK ? mt_arena_new(arena, (size_t)match.count_a + 1, sizeof *kept) : NULL;
    if (status == MT_OK && !kept) status = MT_NO_MEMORY;
    if (status == MT_OK) status = keep_glyphs(&codes, &sequences, request, &gsub, &match, arena, kept);
    return status == MT_OK ? list_glyphs(&match, &codes, &sequences, kept, arena, charset) : status;
}

mt_status mt_charset_twins(const mt_charset *charset, mt_arena *arena, mt_layout_tables *tables) {
    int count = charset->primary_count, twin_count = charset->glyph_count - count;
    mt_twin *twins = mt_arena_new(arena, (size_t)twin_count + 1, sizeof *twins);
    uint16_t *numbers = mt_arena_new(arena, (size_t)MT_GLYPHS_MAX + 1, sizeof *numbers);
    if (!twins || !numbers) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) numbers[charset->glyphs[i].a] = (uint16_t)i;
    for (int i = 0; i < twin_count; i++)
        twins[i] = (mt_twin){(uint16_t)(count + i), numbers[charset->glyphs[count + i].a]};
    return mt_gsub_twins(tables, count, twins, twin_count, arena);
}
