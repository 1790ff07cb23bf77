#include "kerning/lists.h"

#include <stdlib.h>
#include <string.h>

/* ---- from a font's glyphs to new ones ------------------------------------------------------------------ */

/* The new glyphs of each glyph of a font: those of glyph g are at first[g] … first[g + 1]. */
typedef struct mt_new_glyphs {
    int *first;
    uint16_t *list;
} mt_new_glyphs;

enum { GLYPH_IDS = 0x10000 };

static mt_status find_new_glyphs(const mt_pair_side *side, int glyph_count, mt_arena *arena,
                                 mt_new_glyphs *made) {
    int *first = mt_arena_new(arena, GLYPH_IDS + 2, sizeof *first);
    uint16_t *list = mt_arena_new(arena, (size_t)glyph_count, sizeof *list);
    if (!first || !list) return MT_NO_MEMORY;
    for (int i = 0; i < glyph_count; i++)
        if (side->glyph_of[i] < GLYPH_IDS) first[side->glyph_of[i] + 2]++;
    for (int g = 2; g < GLYPH_IDS + 2; g++) first[g] += first[g - 1];
    for (int i = 0; i < glyph_count; i++)
        if (side->glyph_of[i] < GLYPH_IDS) list[first[side->glyph_of[i] + 1]++] = (uint16_t)i;
    *made = (mt_new_glyphs){first, list};
    return MT_OK;
}

/* ---- pairs that are in a list -------------------------------------------------------------------------- */

typedef struct mt_pair_keys {
    uint32_t *keys; /* left << 16 | right */
    size_t count, room;
} mt_pair_keys;

static mt_status add_key(mt_pair_keys *keys, uint32_t key) {
    if (keys->count == MT_PAIRS_LISTED_MAX) return MT_TOO_LARGE;
    if (keys->count == keys->room) {
        size_t room = keys->room ? 2 * keys->room : 1024;
        uint32_t *grown = mt_grow(keys->keys, room, sizeof *grown);
        if (!grown) return MT_NO_MEMORY;
        keys->keys = grown;
        keys->room = room;
    }
    keys->keys[keys->count++] = key;
    return MT_OK;
}

static mt_status add_left(const mt_pair_side *side, const mt_new_glyphs *glyphs, int left,
                          mt_pair_keys *keys) {
    uint32_t glyph = side->glyph_of[left];
    mt_status status = MT_OK;
    for (int i = 0; i < side->source->count; i++) {
        const mt_pair_subtable *subtable = &side->source->subtables[i];
        int row = mt_pair_is_listed(subtable) ? mt_pair_row(subtable, glyph) : -1;
        int count = row < 0 ? 0 : mt_pair_listed_count(subtable, row, glyph);
        if (!mt_pair_spend(side->steps, count)) return MT_TOO_LARGE;
        for (int k = 0; k < count; k++) {
            uint32_t right = mt_pair_listed(subtable, row, glyph, k);
            for (int n = glyphs->first[right]; n < glyphs->first[right + 1] && status == MT_OK; n++)
                status = add_key(keys, (uint32_t)left << 16 | glyphs->list[n]);
        }
    }
    return status;
}

static int ascending(const void *p, const void *q) {
    uint32_t a = *(const uint32_t *)p, b = *(const uint32_t *)q;
    return (a > b) - (a < b);
}

static void sort_keys(mt_pair_keys *keys) {
    size_t kept = 0;
    if (keys->count) qsort(keys->keys, keys->count, sizeof *keys->keys, ascending);
    for (size_t i = 0; i < keys->count; i++)
        if (kept == 0 || keys->keys[kept - 1] != keys->keys[i]) keys->keys[kept++] = keys->keys[i];
    keys->count = kept;
}

static mt_status collect_keys(const mt_pair_side *sides, const mt_pairs *pairs, mt_arena *scratch,
                              mt_pair_keys *keys) {
    mt_status status = MT_OK;
    for (int s = 0; s < pairs->font_count && status == MT_OK; s++) {
        mt_new_glyphs glyphs;
        status = find_new_glyphs(&sides[s], pairs->glyph_count, scratch, &glyphs);
        for (int i = 0; i < pairs->glyph_count && status == MT_OK; i++)
            if (sides[s].glyph_of[i] != MT_NO_PARTNER) status = add_left(&sides[s], &glyphs, i, keys);
    }
    sort_keys(keys);
    return status;
}

/* ---- their values -------------------------------------------------------------------------------------- */

/* The rows of a left glyph in all subtables, lists too. */
static void find_rows(const mt_pair_side *side, int left, int32_t *rows) {
    for (int i = 0; i < side->source->count; i++)
        rows[i] = mt_pair_row(&side->source->subtables[i], side->glyph_of[left]);
}

/* A pair's value in one font, from lists and classes; false where that is what the classes alone give. */
static bool find_value(const mt_pair_side *side, const mt_pair_matrix *matrix, const mt_pairs *pairs,
                       const int32_t *rows, mt_listed_pair listed, double *value) {
    int left = side->left_of[listed.left], right = side->right_of[listed.right];
    mt_pair pair = {rows, mt_interned_row(&side->right, right), side->glyph_of[listed.left],
                    side->glyph_of[listed.right]};
    double parts[MT_PAIR_PARTS];
    mt_pair_value(side->source, &pair, parts);
    size_t count = (size_t)pairs->part_count;
    const double *class_value =
        matrix->values + ((size_t)left * (size_t)matrix->columns + (size_t)right) * count;
    bool differs = false;
    for (size_t k = 0; k < count; k++) {
        value[k] = parts[pairs->parts[k]];
        differs |= value[k] != class_value[k];
    }
    return differs;
}

/* All fonts' values; the first's where one has not both glyphs. */
static bool find_values(const mt_pair_side *sides, const mt_pairs *pairs, int32_t *const *rows,
                        mt_listed_pair listed, double *values) {
    size_t count = (size_t)pairs->part_count;
    bool differs = false;
    for (int s = 0; s < pairs->font_count; s++) {
        double *value = values + (size_t)s * count;
        if (sides[s].left_of[listed.left] >= 0 && sides[s].right_of[listed.right] >= 0)
            differs |= find_value(&sides[s], &pairs->fonts[s], pairs, rows[s], listed, value);
        else
            memcpy(value, values, count * sizeof *value);
    }
    return differs;
}

static mt_status keep_pairs(const mt_pair_side *sides, const mt_pair_keys *keys, mt_arena *scratch,
                            mt_arena *arena, mt_pairs *pairs) {
    int32_t *rows[MT_STOPS_MAX];
    size_t step = (size_t)pairs->font_count * (size_t)pairs->part_count;
    for (int s = 0; s < pairs->font_count; s++) {
        rows[s] = mt_arena_new(scratch, (size_t)sides[s].source->count + 1, sizeof *rows[s]);
        if (!rows[s]) return MT_NO_MEMORY;
    }
    pairs->listed = mt_arena_new(arena, keys->count + 1, sizeof *pairs->listed);
    pairs->listed_values = mt_arena_new(arena, keys->count * step + step, sizeof *pairs->listed_values);
    if (!pairs->listed || !pairs->listed_values) return MT_NO_MEMORY;
    int count = 0, last = -1;
    for (size_t i = 0; i < keys->count; i++) {
        mt_listed_pair pair = {(uint16_t)(keys->keys[i] >> 16), (uint16_t)keys->keys[i]};
        for (int s = 0; s < pairs->font_count && pair.left != last; s++)
            if (sides[s].left_of[pair.left] >= 0) find_rows(&sides[s], pair.left, rows[s]);
        last = pair.left;
        if (!find_values(sides, pairs, rows, pair, pairs->listed_values + (size_t)count * step)) continue;
        pairs->listed[count++] = pair;
    }
    pairs->listed_count = count;
    return MT_OK;
}

mt_status mt_pairs_list(const mt_pair_side *sides, mt_arena *arena, mt_pairs *pairs) {
    mt_arena scratch = {0};
    mt_pair_keys keys = {0};
    mt_status status = collect_keys(sides, pairs, &scratch, &keys);
    int64_t subtables = 0;
    for (int s = 0; s < pairs->font_count; s++) subtables += sides[s].source->count;
    if (status == MT_OK && !mt_pair_spend(sides[0].steps, (int64_t)keys.count * subtables))
        status = MT_TOO_LARGE;
    if (status == MT_OK) status = keep_pairs(sides, &keys, &scratch, arena, pairs);
    mt_free(keys.keys);
    mt_arena_release(&scratch);
    return status;
}
