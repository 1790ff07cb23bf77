/* HarfBuzz takes characters apart before it looks for glyphs, and puts others together, as far as the font has them (Unicode's
 * canonical mappings, and those of its shapers for Thai, Lao and Khmer): a font without the parts shapes otherwise. */
#include "glyphset/codes.h"

#include <hb.h>
#include <stdlib.h>

static int ascending(const void *p, const void *q) {
    uint32_t x = ((const mt_code *)p)->code_point, y = ((const mt_code *)q)->code_point;
    return (x > y) - (x < y);
}

void mt_codes_sort(mt_code *list, int count) {
    if (count) qsort(list, (size_t)count, sizeof *list, ascending);
}

const mt_code *mt_codes_find(const mt_codes *codes, uint32_t code_point) {
    mt_code key = {code_point, 0, 0};
    return codes->count ? bsearch(&key, codes->list, (size_t)codes->count, sizeof key, ascending) : NULL;
}

/* Both fonts, and what is asked of them. */
typedef struct mt_code_source {
    const mt_font *a, *b;
    const mt_charset_request *request;
} mt_code_source;

/* With the glyph of B's that is given for A's. */
static mt_code as_given(const mt_code_source *source, mt_code code) {
    uint32_t given = mt_given_partner(source->request->pairs, code.a, source->request->other);
    if (given) code.b = given;
    return code;
}

static mt_code look_up(const mt_code_source *source, uint32_t code_point) {
    return as_given(source, (mt_code){code_point, mt_font_glyph(source->a, code_point),
                                      mt_font_glyph(source->b, code_point)});
}

/* Without what a symbol font has for other codes than it maps: whichever font comes first, the characters are the same. */
static mt_code look_up_mapped(const mt_code_source *source, uint32_t code_point) {
    return as_given(source, (mt_code){code_point, mt_font_mapped_glyph(source->a, code_point),
                                      mt_font_mapped_glyph(source->b, code_point)});
}

static bool is_in(const mt_code_source *source, mt_code code) {
    return code.a && (code.b || source->request->set == MT_GLYPHS_FIRST);
}

/* Sorts, and leaves each character once. */
static void settle(mt_codes *codes) {
    int once = 0;
    mt_codes_sort(codes->list, codes->count);
    for (int i = 0; i < codes->count; i++)
        if (once == 0 || codes->list[i].code_point != codes->list[once - 1].code_point)
            codes->list[once++] = codes->list[i];
    codes->count = once;
}

/* ---- what is asked for --------------------------------------------------------------------------------- */

static mt_status append(mt_codes *codes, int *room, mt_code code, mt_arena *arena) {
    mt_code *list = mt_arena_grow_list(arena, codes->list, codes->count, room, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    codes->list = list;
    codes->list[codes->count++] = code;
    return MT_OK;
}

/* Adds the characters that lead to wanted glyphs. */
static mt_status add_characters_of_glyphs(const mt_code_source *source, mt_codes *codes, int *room,
                                          mt_arena *arena) {
    const mt_charset_request *request = source->request;
    const mt_font *a = source->a;
    bool *wanted = mt_arena_new(arena, (size_t)mt_font_glyph_count(a) + 1, sizeof *wanted);
    if (!wanted) return MT_NO_MEMORY;
    for (int i = 0; i < request->glyph_count; i++) wanted[request->glyphs[i]] = true;
    uint32_t c = 0;
    for (bool more = mt_font_next_char(a, 0, &c); more; more = mt_font_next_char(a, c + 1, &c)) {
        mt_code code = look_up_mapped(source, c);
        if (!wanted[code.a] || !is_in(source, code)) continue;
        if (append(codes, room, code, arena) != MT_OK) return MT_NO_MEMORY;
    }
    return MT_OK;
}

static mt_status list_wanted(const mt_code_source *source, mt_arena *arena, mt_codes *codes) {
    const mt_charset_request *request = source->request;
    int room = request->count;
    codes->list = mt_arena_new(arena, (size_t)room + 1, sizeof *codes->list);
    if (!codes->list) return MT_NO_MEMORY;
    for (int i = 0; i < request->count; i++) {
        mt_code code = look_up(source, request->wanted[i]);
        if (is_in(source, code)) codes->list[codes->count++] = code;
    }
    mt_status status = request->glyph_count ? add_characters_of_glyphs(source, codes, &room, arena) : MT_OK;
    settle(codes);
    return status;
}

/* All of A's that the set takes in; counts them only where `list` is NULL. */
static int fill_all(const mt_code_source *source, mt_code *list) {
    const mt_font *a = source->a;
    int count = 0;
    uint32_t c = 0;
    for (bool more = mt_font_next_char(a, 0, &c); more; more = mt_font_next_char(a, c + 1, &c)) {
        mt_code code = look_up_mapped(source, c);
        if (!is_in(source, code)) continue;
        if (list) list[count] = code;
        count++;
    }
    return count;
}

static mt_status list_all(const mt_code_source *source, mt_arena *arena, mt_codes *codes) {
    codes->list = mt_arena_new(arena, (size_t)fill_all(source, NULL) + 1, sizeof *codes->list);
    if (!codes->list) return MT_NO_MEMORY;
    codes->count = fill_all(source, codes->list);
    return MT_OK;
}

/* ---- what goes with it --------------------------------------------------------------------------------- */

/* The two characters that HarfBuzz takes one apart into and does not put together again: vowels of two parts, whose first is a mark,
 * and those of its shapers for Thai, Lao and Khmer. The second may be 0. Accented letters stay whole where the font has them. */
static bool take_apart(uint32_t code, uint32_t parts[2]) {
    hb_unicode_funcs_t *unicode = hb_unicode_funcs_get_default();
    switch (code) {
    case 0x0E33: return parts[0] = 0x0E4D, parts[1] = 0x0E32, true; /* Thai and Lao am */
    case 0x0EB3: return parts[0] = 0x0ECD, parts[1] = 0x0EB2, true;
    case 0x17BE: /* Khmer vowels that stand on both sides */
    case 0x17BF:
    case 0x17C0:
    case 0x17C4:
    case 0x17C5: return parts[0] = 0x17C1, parts[1] = code, true;
    default: break;
    }
    if (!hb_unicode_decompose(unicode, code, &parts[0], &parts[1])) return false;
    hb_unicode_general_category_t first = hb_unicode_general_category(unicode, parts[0]);
    return first == HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK ||
           first == HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK;
}

/* Adds the parts of each character, and theirs. */
static mt_status add_parts(const mt_code_source *source, mt_codes *codes, mt_arena *arena) {
    const mt_codes known = *codes;
    int room = codes->count;
    for (int i = 0; i < codes->count; i++) {
        uint32_t parts[2];
        if (!take_apart(codes->list[i].code_point, parts)) continue;
        for (int k = 0; k < 2; k++) {
            mt_code part = look_up(source, parts[k]);
            if (!parts[k] || !part.a || mt_codes_find(&known, parts[k])) continue;
            if (append(codes, &room, part, arena) != MT_OK) return MT_NO_MEMORY;
        }
    }
    settle(codes);
    return MT_OK;
}

/* Adds the characters of the set that two of the list make. */
static mt_status add_wholes(const mt_code_source *source, mt_codes *codes, mt_arena *arena) {
    const mt_font *a = source->a;
    const mt_codes known = *codes;
    int room = codes->count;
    uint32_t c = 0;
    for (bool more = mt_font_next_char(a, 0, &c); more; more = mt_font_next_char(a, c + 1, &c)) {
        uint32_t parts[2];
        if (!hb_unicode_decompose(hb_unicode_funcs_get_default(), c, &parts[0], &parts[1])) continue;
        mt_code code = look_up_mapped(source, c);
        bool whole = parts[1] && mt_codes_find(&known, parts[0]) && mt_codes_find(&known, parts[1]);
        if (!whole || !is_in(source, code) || mt_codes_find(&known, c)) continue;
        if (append(codes, &room, code, arena) != MT_OK) return MT_NO_MEMORY;
    }
    settle(codes);
    return MT_OK;
}

mt_status mt_codes_list(const mt_font *a, const mt_font *b, const mt_charset_request *request,
                        mt_arena *arena, mt_codes *codes) {
    enum { ROUNDS = 3 }; /* what is put together of parts that are put together: Greek, Vietnamese, Hangul */
    mt_codes made = {0};
    const mt_code_source source = {a, b, request};
    bool limited = mt_request_is_limited(request);
    mt_status status = limited ? list_wanted(&source, arena, &made) : list_all(&source, arena, &made);
    for (int i = 0, before = -1; i < ROUNDS && limited && status == MT_OK && made.count != before; i++) {
        before = made.count;
        status = add_wholes(&source, &made, arena);
    }
    if (status == MT_OK && made.count) status = add_parts(&source, &made, arena);
    if (status == MT_OK) *codes = made;
    return status;
}
