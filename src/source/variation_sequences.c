#include "source/variation_sequences.h"

#include <stdlib.h>
#include <string.h>

#include "geometry/limits.h"
#include "source/handle.h"

typedef struct mt_sequence_reading {
    mt_arena *arena;
    mt_variation_sequences variants;
    int room;
} mt_sequence_reading;

static int in_order(const void *p, const void *q) {
    const mt_variation_sequence *x = p, *y = q;
    if (x->selector != y->selector) return x->selector < y->selector ? -1 : 1;
    return (x->code_point > y->code_point) - (x->code_point < y->code_point);
}

static mt_status add(mt_sequence_reading *reading, mt_variation_sequence variant) {
    mt_variation_sequences *variants = &reading->variants;
    mt_variation_sequence *list =
        mt_arena_grow_list(reading->arena, variants->list, variants->count, &reading->room, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    variants->list = list;
    variants->list[variants->count++] = variant;
    return MT_OK;
}

/* FreeType's lists end with 0; a list holds until the next is asked for. */
static mt_status read_selector(mt_font *font, uint32_t selector, mt_sequence_reading *reading) {
    const FT_UInt32 *chars = FT_Face_GetCharsOfVariant(font->face, selector);
    mt_status status = MT_OK;
    for (; chars && *chars && status == MT_OK && reading->variants.count < MT_VARIATION_SEQUENCES_MAX;
         chars++) {
        FT_UInt glyph = FT_Face_GetCharVariantIndex(font->face, *chars, selector);
        bool by_default = FT_Face_GetCharVariantIsDefault(font->face, *chars, selector) == 1;
        if (by_default) glyph = mt_font_mapped_glyph(font, (uint32_t)*chars);
        if (glyph && glyph < (FT_UInt)mt_font_glyph_count(font))
            status = add(reading, (mt_variation_sequence){selector, (uint32_t)*chars, glyph, by_default});
    }
    return status;
}

static mt_status read_all(mt_font *font, void *user) {
    mt_sequence_reading *reading = user;
    const FT_UInt32 *selectors = FT_Face_GetVariantSelectors(font->face);
    int count = 0;
    while (selectors && selectors[count]) count++;
    uint32_t *copy = mt_arena_new(reading->arena, (size_t)count + 1, sizeof *copy);
    if (!copy) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) copy[i] = (uint32_t)selectors[i];
    mt_status status = MT_OK;
    for (int i = 0; i < count && status == MT_OK; i++) status = read_selector(font, copy[i], reading);
    return status;
}

mt_status mt_font_variation_sequences(mt_font *font, mt_arena *arena, mt_variation_sequences *variants) {
    mt_sequence_reading reading = {.arena = arena};
    if (!font->face) return MT_NO_MEMORY;
    mt_status status = mt_font_guard(font, read_all, &reading);
    if (status != MT_OK) return status;
    if (reading.variants.count)
        qsort(reading.variants.list, (size_t)reading.variants.count, sizeof *reading.variants.list, in_order);
    *variants = reading.variants;
    return MT_OK;
}

const mt_variation_sequence *mt_variation_sequences_find(const mt_variation_sequences *variants,
                                                         uint32_t selector, uint32_t code_point) {
    mt_variation_sequence key = {.selector = selector, .code_point = code_point};
    if (variants->count == 0) return NULL;
    return bsearch(&key, variants->list, (size_t)variants->count, sizeof key, in_order);
}
