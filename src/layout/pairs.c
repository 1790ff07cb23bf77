#include "layout/pairs.h"

#include "layout/pair_lists.h"
#include "layout/pair_sides.h"

/* ---- classes of new glyphs ----------------------------------------------------------------------------- */

static mt_status refine(const int *in_a, const int *in_b, int glyph_count, mt_interned *found,
                        mt_arena *arena, mt_pair_classes *classes) {
    int number;
    mt_status status = mt_intern_filled(found, 0, &number);
    classes->of = mt_arena_new(arena, (size_t)glyph_count, sizeof *classes->of);
    if (!classes->of) return MT_NO_MEMORY;
    for (int i = 0; i < glyph_count && status == MT_OK; i++) {
        int32_t both[] = {in_a[i], in_b[i]};
        status = mt_intern(found, both, &number);
        if (number > UINT16_MAX) return MT_TOO_LARGE;
        classes->of[i] = (uint16_t)number;
    }
    if (status != MT_OK) return status;
    classes->list = mt_arena_new(arena, (size_t)found->count, sizeof *classes->list);
    if (!classes->list) return MT_NO_MEMORY;
    for (int i = 0; i < found->count; i++) {
        const int32_t *both = mt_interned_row(found, i);
        classes->list[i] = (mt_pair_class){both[0], both[1]};
    }
    classes->count = found->count;
    return MT_OK;
}

static mt_status make_classes(const int *in_a, const int *in_b, int glyph_count, mt_arena *arena,
                              mt_pair_classes *classes) {
    mt_interned found = {.width = 2};
    mt_status status = refine(in_a, in_b, glyph_count, &found, arena, classes);
    mt_interned_free(&found);
    return status;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

static void find_parts(const mt_pair_source *a, const mt_pair_source *b, mt_pairs *pairs) {
    for (int k = 0; k < MT_PAIR_PARTS; k++)
        if ((a->parts | b->parts) >> k & 1) pairs->parts[pairs->part_count++] = (uint8_t)k;
}

static mt_status find_glyphs(const mt_charset *charset, mt_arena *scratch, uint32_t *glyph_of[2]) {
    for (int s = 0; s < 2; s++) {
        glyph_of[s] = mt_arena_new(scratch, (size_t)charset->glyph_count, sizeof *glyph_of[s]);
        if (!glyph_of[s]) return MT_NO_MEMORY;
        for (int i = 0; i < charset->glyph_count; i++)
            glyph_of[s][i] = s == 0 ? charset->glyphs[i].a : charset->glyphs[i].b;
    }
    return MT_OK;
}

static mt_status prepare(mt_pair_side sides[2], int most, mt_arena *arena, mt_pairs *pairs) {
    int count = pairs->glyph_count;
    mt_status status = make_classes(sides[0].left_of, sides[1].left_of, count, arena, &pairs->left);
    if (status == MT_OK)
        status = make_classes(sides[0].right_of, sides[1].right_of, count, arena, &pairs->right);
    int64_t cells = (int64_t)pairs->left.count * pairs->right.count;
    if (status == MT_OK && cells > most) return MT_TOO_LARGE;
    for (int s = 0; s < 2 && status == MT_OK; s++)
        status = mt_pair_side_values(&sides[s], pairs, arena, &pairs->ends[s]);
    return status == MT_OK ? mt_pairs_list(sides, arena, pairs) : status;
}

mt_status mt_pairs_prepare(const mt_pair_source *a, const mt_pair_source *b, const mt_charset *charset,
                           int most, int64_t *steps, mt_arena *arena, mt_pairs *pairs) {
    const mt_pair_source *sources[] = {a, b};
    mt_arena scratch = {0};
    mt_pair_side sides[2] = {0};
    mt_pairs made = {.glyph_count = charset->glyph_count};
    uint32_t *glyph_of[2];
    find_parts(a, b, &made);
    mt_status status = find_glyphs(charset, &scratch, glyph_of);
    for (int s = 0; s < 2 && status == MT_OK; s++)
        status = mt_pair_side_sort(sources[s], glyph_of[s], made.glyph_count, steps, &scratch, &sides[s]);
    if (status == MT_OK) status = prepare(sides, most, arena, &made);
    for (int s = 0; s < 2; s++) mt_pair_side_free(&sides[s]);
    mt_arena_release(&scratch);
    if (status == MT_OK) *pairs = made;
    return status;
}
