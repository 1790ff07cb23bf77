#include "kerning/prepare.h"

#include <string.h>

#include "kerning/lists.h"
#include "kerning/sides.h"

/* ---- classes of new glyphs ----------------------------------------------------------------------------- */

static mt_status refine(const mt_pair_side *sides, bool right, const mt_pairs *pairs, mt_interned *found,
                        mt_arena *arena, mt_pair_classes *classes) {
    int number;
    size_t fonts = (size_t)pairs->font_count;
    mt_status status = mt_intern_filled(found, 0, &number);
    classes->of = mt_arena_new(arena, (size_t)pairs->glyph_count, sizeof *classes->of);
    if (!classes->of) return MT_NO_MEMORY;
    for (int i = 0; i < pairs->glyph_count && status == MT_OK; i++) {
        int32_t in_fonts[MT_STOPS_MAX];
        for (size_t k = 0; k < fonts; k++) in_fonts[k] = (right ? sides[k].right_of : sides[k].left_of)[i];
        status = mt_intern(found, in_fonts, &number);
        if (number > UINT16_MAX) return MT_TOO_LARGE;
        classes->of[i] = (uint16_t)number;
    }
    if (status != MT_OK) return status;
    classes->in_fonts = mt_arena_new(arena, (size_t)found->count * fonts, sizeof *classes->in_fonts);
    if (!classes->in_fonts) return MT_NO_MEMORY;
    memcpy(classes->in_fonts, mt_interned_row(found, 0),
           (size_t)found->count * fonts * sizeof *classes->in_fonts);
    classes->count = found->count;
    return MT_OK;
}

static mt_status make_classes(const mt_pair_side *sides, bool right, const mt_pairs *pairs, mt_arena *arena,
                              mt_pair_classes *classes) {
    mt_interned found = {.width = pairs->font_count};
    mt_status status = refine(sides, right, pairs, &found, arena, classes);
    mt_interned_free(&found);
    return status;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

static void find_parts(const mt_pair_source *const *sources, mt_pairs *pairs) {
    unsigned parts = 0;
    for (int s = 0; s < pairs->font_count; s++) parts |= sources[s]->parts;
    for (int k = 0; k < MT_PAIR_PARTS; k++)
        if (parts >> k & 1) pairs->parts[pairs->part_count++] = (uint8_t)k;
}

static mt_status prepare(mt_pair_side *sides, int most, mt_arena *arena, mt_pairs *pairs) {
    mt_status status = make_classes(sides, false, pairs, arena, &pairs->left);
    if (status == MT_OK) status = make_classes(sides, true, pairs, arena, &pairs->right);
    int64_t cells = (int64_t)pairs->left.count * pairs->right.count;
    if (status == MT_OK && cells * pairs->font_count > 2 * (int64_t)most) return MT_TOO_LARGE;
    pairs->fonts = mt_arena_new(arena, (size_t)pairs->font_count, sizeof *pairs->fonts);
    if (!pairs->fonts) return MT_NO_MEMORY;
    for (int s = 0; s < pairs->font_count && status == MT_OK; s++)
        status = mt_pair_side_values(&sides[s], pairs, arena, &pairs->fonts[s]);
    return status == MT_OK ? mt_pairs_list(sides, arena, pairs) : status;
}

mt_status mt_pairs_prepare(const mt_pair_source *const *sources, const mt_font_glyphs *glyphs, int most,
                           int64_t *steps, mt_arena *arena, mt_pairs *pairs) {
    mt_arena scratch = {0};
    mt_pair_side sides[MT_STOPS_MAX] = {0};
    mt_pairs made = {.font_count = glyphs->font_count, .glyph_count = glyphs->glyph_count};
    mt_status status = MT_OK;
    find_parts(sources, &made);
    for (int s = 0; s < made.font_count && status == MT_OK; s++)
        status = mt_pair_side_sort(sources[s], glyphs->of[s], made.glyph_count, steps, &scratch, &sides[s]);
    if (status == MT_OK) status = prepare(sides, most, arena, &made);
    for (int s = 0; s < made.font_count; s++) mt_pair_side_free(&sides[s]);
    mt_arena_release(&scratch);
    if (status == MT_OK) *pairs = made;
    return status;
}
