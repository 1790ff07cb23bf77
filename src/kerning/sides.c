#include "kerning/sides.h"

bool mt_pair_spend(int64_t *steps, int64_t count) {
    *steps = *steps > count ? *steps - count : 0;
    return *steps > 0;
}

/* A glyph's rows, or columns, in all subtables; -1 in lists, which make no classes. */
static void find_places(const mt_pair_source *source, uint32_t glyph, bool right, int32_t *places) {
    for (int i = 0; i < source->count; i++) {
        const mt_pair_subtable *subtable = &source->subtables[i];
        if (mt_pair_is_listed(subtable))
            places[i] = -1;
        else
            places[i] = right ? mt_pair_column(subtable, glyph) : mt_pair_row(subtable, glyph);
    }
}

static mt_status sort(const mt_pair_side *side, int glyph_count, bool right, int32_t *places,
                      mt_interned *classes, int *class_of) {
    int none;
    mt_status status = mt_intern_filled(classes, -1, &none);
    for (int i = 0; i < glyph_count && status == MT_OK; i++) {
        class_of[i] = MT_NO_CLASS;
        if (side->glyph_of[i] == MT_NO_PARTNER) continue;
        find_places(side->source, side->glyph_of[i], right, places);
        status = mt_intern(classes, places, &class_of[i]);
    }
    return status;
}

mt_status mt_pair_side_sort(const mt_pair_source *source, const uint32_t *glyph_of, int glyph_count,
                            int64_t *steps, mt_arena *arena, mt_pair_side *side) {
    *side = (mt_pair_side){.source = source,
                           .glyph_of = glyph_of,
                           .steps = steps,
                           .left = {.width = source->count},
                           .right = {.width = source->count}};
    if (!mt_pair_spend(steps, 2 * (int64_t)glyph_count * source->count)) return MT_TOO_LARGE;
    side->left_of = mt_arena_new(arena, (size_t)glyph_count, sizeof *side->left_of);
    side->right_of = mt_arena_new(arena, (size_t)glyph_count, sizeof *side->right_of);
    int32_t *places = mt_arena_new(arena, (size_t)source->count + 1, sizeof *places);
    if (!side->left_of || !side->right_of || !places) return MT_NO_MEMORY;
    mt_status status = sort(side, glyph_count, false, places, &side->left, side->left_of);
    return status == MT_OK ? sort(side, glyph_count, true, places, &side->right, side->right_of) : status;
}

void mt_pair_side_free(mt_pair_side *side) {
    mt_interned_free(&side->left);
    mt_interned_free(&side->right);
}

mt_status mt_pair_side_values(const mt_pair_side *side, const mt_pairs *pairs, mt_arena *arena,
                              mt_pair_matrix *matrix) {
    int rows = side->left.count, columns = side->right.count;
    int64_t cells = (int64_t)rows * columns;
    if (cells > MT_PAIR_CELLS_MAX || !mt_pair_spend(side->steps, cells * side->source->count))
        return MT_TOO_LARGE;
    size_t count = (size_t)pairs->part_count;
    double *values = mt_arena_new(arena, (size_t)cells * count + 1, sizeof *values), *value = values;
    if (!values) return MT_NO_MEMORY;
    for (int r = 0; r < rows; r++)
        for (int c = 0; c < columns; c++, value += count) {
            double parts[MT_PAIR_PARTS];
            mt_pair pair = {mt_interned_row(&side->left, r), mt_interned_row(&side->right, c), 0, 0};
            mt_pair_value(side->source, &pair, parts);
            for (size_t k = 0; k < count; k++) value[k] = parts[pairs->parts[k]];
        }
    *matrix = (mt_pair_matrix){rows, columns, values};
    return MT_OK;
}
