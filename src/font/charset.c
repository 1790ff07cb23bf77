#include "font/charset.h"

#include <stdlib.h>

#include "geometry/limits.h"

static int ascending(const void *p, const void *q) {
    uint32_t a = *(const uint32_t *)p, b = *(const uint32_t *)q;
    return (a > b) - (a < b);
}

static bool is_shared(const mt_font *a, const mt_font *b, uint32_t c) {
    return mt_font_glyph(a, c) && mt_font_glyph(b, c);
}

/* Keeps the shared ones of the wanted code points, ascending, each once. */
static int filter_wanted(const mt_font *a, const mt_font *b, const uint32_t *wanted, int count,
                         uint32_t *kept) {
    for (int i = 0; i < count; i++) kept[i] = wanted[i];
    qsort(kept, (size_t)count, sizeof *kept, ascending);
    int shared = 0;
    for (int i = 0; i < count; i++)
        if ((shared == 0 || kept[shared - 1] != kept[i]) && is_shared(a, b, kept[i]))
            kept[shared++] = kept[i];
    return shared;
}

/* All shared code points, ascending; counts them only where `kept` is NULL. */
static int list_shared(const mt_font *a, const mt_font *b, uint32_t *kept) {
    int shared = 0;
    uint32_t c = 0;
    for (bool more = mt_font_next_char(a, 0, &c); more; more = mt_font_next_char(a, c + 1, &c)) {
        if (!is_shared(a, b, c)) continue;
        if (kept) kept[shared] = c;
        shared++;
    }
    return shared;
}

/* ---- glyphs -------------------------------------------------------------------------------------------- */

static int by_glyphs(const void *p, const void *q) {
    const mt_pairing *x = p, *y = q;
    if (x->a != y->a) return x->a < y->a ? -1 : 1;
    if (x->b != y->b) return x->b < y->b ? -1 : 1;
    return (x->code_point > y->code_point) - (x->code_point < y->code_point);
}

static int by_code_point(const void *p, const void *q) {
    return ascending(&((const mt_pairing *)p)->code_point, &((const mt_pairing *)q)->code_point);
}

/* The pairs of glyphs, each once, in the order of their first code points; .notdef before all. */
static mt_status pair_glyphs(const mt_font *a, const mt_font *b, const uint32_t *chars, int count,
                             mt_arena *arena, mt_charset *charset) {
    mt_pairing *pairs = mt_arena_new(arena, (size_t)count + 1, sizeof *pairs);
    if (!pairs) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++)
        pairs[i + 1] = (mt_pairing){chars[i], mt_font_glyph(a, chars[i]), mt_font_glyph(b, chars[i])};
    qsort(pairs + 1, (size_t)count, sizeof *pairs, by_glyphs);
    int kept = 1;
    for (int i = 1; i <= count; i++)
        if (kept == 1 || pairs[i].a != pairs[kept - 1].a || pairs[i].b != pairs[kept - 1].b)
            pairs[kept++] = pairs[i];
    if (kept > MT_GLYPHS_MAX) return MT_TOO_LARGE;
    qsort(pairs + 1, (size_t)kept - 1, sizeof *pairs, by_code_point);
    charset->glyph_count = kept;
    charset->glyphs = pairs;
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

static mt_status map_chars(const mt_font *a, const mt_font *b, const uint32_t *chars, int count,
                           mt_arena *arena, mt_charset *charset) {
    size_t glyphs = (size_t)charset->glyph_count - 1;
    mt_sorted_glyph *sorted = mt_arena_new(arena, glyphs, sizeof *sorted);
    charset->chars = mt_arena_new(arena, (size_t)count, sizeof(mt_char));
    if (!sorted || !charset->chars) return MT_NO_MEMORY;
    for (size_t i = 0; i < glyphs; i++)
        sorted[i] = (mt_sorted_glyph){charset->glyphs[i + 1].a, charset->glyphs[i + 1].b, (uint16_t)(i + 1)};
    qsort(sorted, glyphs, sizeof *sorted, by_pair);
    for (int i = 0; i < count; i++) {
        mt_sorted_glyph key = {mt_font_glyph(a, chars[i]), mt_font_glyph(b, chars[i]), 0};
        const mt_sorted_glyph *found = bsearch(&key, sorted, glyphs, sizeof *sorted, by_pair);
        charset->chars[i] = (mt_char){chars[i], found->glyph};
    }
    charset->char_count = count;
    return MT_OK;
}

mt_status mt_charset_make(const mt_font *a, const mt_font *b, const uint32_t *wanted, int count,
                          mt_arena *arena, mt_charset *charset) {
    int most = count ? count : list_shared(a, b, NULL);
    uint32_t *chars = mt_arena_new(arena, (size_t)most, sizeof *chars);
    if (!chars) return MT_NO_MEMORY;
    int shared = count ? filter_wanted(a, b, wanted, count, chars) : list_shared(a, b, chars);
    if (shared == 0) return MT_NOTHING_SHARED;
    mt_charset made = {0};
    mt_status status = pair_glyphs(a, b, chars, shared, arena, &made);
    if (status == MT_OK) status = map_chars(a, b, chars, shared, arena, &made);
    if (status == MT_OK) *charset = made;
    return status;
}
