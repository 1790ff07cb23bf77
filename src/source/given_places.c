#include "source/given_places.h"

#include <stdlib.h>

#include "base/memory.h"

static int by_glyph(const void *p, const void *q) {
    uint32_t x = ((const mt_given_place *)p)->glyph, y = ((const mt_given_place *)q)->glyph;
    return (x > y) - (x < y);
}

static bool is_good(const mt_given_places *places, const mt_font *font) {
    for (int i = 0; i < places->count; i++) {
        if (places->list[i].glyph >= (uint32_t)mt_font_glyph_count(font)) return false;
        if (i > 0 && places->list[i].glyph == places->list[i - 1].glyph) return false;
    }
    return true;
}

mt_status mt_given_places_make(const uint32_t *glyphs, const double *t, const double *up, int count,
                               const mt_font *font, mt_given_places *places) {
    mt_given_places made = {.count = count > 0 ? count : 0};
    made.list = mt_new((size_t)made.count + 1, sizeof *made.list);
    if (!made.list) return MT_NO_MEMORY;
    for (int i = 0; i < made.count; i++)
        made.list[i] = (mt_given_place){glyphs[i], {t[i], up ? up[i] : t[i]}};
    qsort(made.list, (size_t)made.count, sizeof *made.list, by_glyph);
    if (is_good(&made, font)) {
        *places = made;
        return MT_OK;
    }
    mt_given_places_free(&made);
    return MT_BAD_PARAMETER;
}

void mt_given_places_free(mt_given_places *places) {
    mt_free(places->list);
    *places = (mt_given_places){0};
}

mt_at mt_given_place_of(const mt_given_places *places, uint32_t glyph, mt_at otherwise) {
    const mt_given_place wanted = {.glyph = glyph};
    if (places->count == 0) return otherwise;
    const mt_given_place *found =
        bsearch(&wanted, places->list, (size_t)places->count, sizeof wanted, by_glyph);
    return found ? found->at : otherwise;
}
