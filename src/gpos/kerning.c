#include "gpos/kerning.h"

#include "gpos/position_data.h"
#include "kerning/mix.h"

#include <string.h>

/* ---- groups -------------------------------------------------------------------------------------------- */

/* The glyphs of each row (or column) but 0; group i is of row i + 1. */
static mt_status list_groups(const uint16_t *of, int glyph_count, int count, mt_arena *arena,
                             mt_kerning_group **groups) {
    mt_kerning_group *made = mt_arena_new(arena, (size_t)count, sizeof *made);
    int *filled = mt_arena_new(arena, (size_t)count, sizeof *filled);
    uint16_t *glyphs = mt_arena_new(arena, (size_t)glyph_count, sizeof *glyphs);
    if (!made || !filled || !glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < glyph_count; i++)
        if (of[i]) made[of[i] - 1].count++;
    for (int g = 0, at = 0; g < count - 1; g++) {
        made[g].glyphs = glyphs + at;
        filled[g] = at;
        at += made[g].count;
    }
    for (int i = 0; i < glyph_count; i++)
        if (of[i]) glyphs[filled[of[i] - 1]++] = (uint16_t)i;
    *groups = made;
    return MT_OK;
}

/* ---- pairs --------------------------------------------------------------------------------------------- */

/* The place of the horizontal advance among the parts; -1 when there is none. */
static int find_advance(const mt_mixed_pairs *mixed) {
    for (int k = 0; k < mixed->values.part_count; k++)
        if (mixed->values.parts[k] == MT_VALUE_X_ADVANCE) return k;
    return -1;
}

/* Where the kerning is told of: all places that are mixed, and the one whose values count. */
typedef struct mt_told {
    const mt_mixed_pairs *mixed;
    int part;
    mt_between at; /* among the mixed places */
} mt_told;

static int value_of(const mt_told *told, const int32_t *row) {
    const int32_t *values = row + told->part * told->mixed->values.place_count;
    double first = values[told->at.first];
    return told->at.t == 0 ? (int)first
                           : mt_value_rounded(mt_between_mix(told->at, first, values[told->at.first + 1]));
}

static bool are_equal(const mt_told *told, const int32_t *row, const int32_t *other) {
    int places = told->mixed->values.place_count, first = told->part * places;
    return memcmp(row + first, other + first, (size_t)places * sizeof *row) == 0;
}

/* All that are not nothing at each of the places, so that they are the same pairs for each of these. */
static int list_pairs(const mt_told *told, mt_kerning_pair *pairs) {
    const mt_mixed_pairs *mixed = told->mixed;
    const int32_t *nothing = mt_mixed_cell(mixed, 0, 0);
    int count = 0;
    for (int r = 1; r < mixed->row_count; r++)
        for (int c = 1; c < mixed->column_count; c++) {
            const int32_t *cell = mt_mixed_cell(mixed, r, c);
            if (are_equal(told, cell, nothing)) continue;
            if (pairs)
                pairs[count] = (mt_kerning_pair){false, false, (uint16_t)(r - 1), (uint16_t)(c - 1),
                                                 value_of(told, cell)};
            count++;
        }
    for (int i = 0; i < mixed->listed_count; i++) {
        mt_listed_pair listed = mixed->listed[i];
        const int32_t *value = mt_mixed_listed(mixed, i);
        if (are_equal(told, value,
                      mt_mixed_cell(mixed, mixed->row_of[listed.left], mixed->column_of[listed.right])))
            continue;
        if (pairs)
            pairs[count] = (mt_kerning_pair){true, true, listed.left, listed.right, value_of(told, value)};
        count++;
    }
    return count;
}

static mt_status tell(const mt_mixed_pairs *mixed, mt_between at, mt_arena *arena, mt_kerning *kerning) {
    mt_kerning_group *left, *right;
    mt_told told = {mixed, find_advance(mixed), at};
    *kerning = (mt_kerning){0};
    if (told.part < 0) return MT_OK;
    mt_status status = list_groups(mixed->row_of, mixed->glyph_count, mixed->row_count, arena, &left);
    if (status == MT_OK)
        status = list_groups(mixed->column_of, mixed->glyph_count, mixed->column_count, arena, &right);
    if (status != MT_OK) return status;
    int count = list_pairs(&told, NULL);
    mt_kerning_pair *pairs = mt_arena_new(arena, (size_t)count + 1, sizeof *pairs);
    if (!pairs) return MT_NO_MEMORY;
    list_pairs(&told, pairs);
    *kerning = (mt_kerning){mixed->row_count - 1, mixed->column_count - 1, left, right, count, pairs};
    return MT_OK;
}

/* The kerning that is the same for all places, with the values at one of them or between two. */
static mt_status kern(const mt_positions *positions, const mt_places *places, mt_between at, mt_arena *arena,
                      mt_kerning *kerning) {
    mt_arena scratch = {0};
    mt_mixed_pairs mixed;
    mt_kerning made = {0};
    mt_status status = MT_OK;
    if (positions->has_plain_kerning)
        status = mt_pairs_mix(&positions->plain_kerning, places, &scratch, &mixed);
    if (status == MT_OK && positions->has_plain_kerning) status = tell(&mixed, at, arena, &made);
    mt_arena_release(&scratch);
    if (status == MT_OK) *kerning = made;
    return status;
}

mt_status mt_positions_kerning(const mt_positions *positions, mt_font_at at, mt_arena *arena,
                               mt_kerning *kerning) {
    mt_places place = mt_places_of_one(&at, positions->font_count);
    return kern(positions, &place, (mt_between){0, 0}, arena, kerning);
}

mt_status mt_positions_master_kerning(const mt_positions *positions, mt_between at, mt_arena *arena,
                                      mt_kerning *kerning) {
    mt_at fonts[MT_STOPS_MAX];
    for (int i = 0; i < positions->font_count; i++) fonts[i] = mt_at_both(i);
    mt_places places = {positions->font_count, positions->font_count, fonts, NULL, NULL};
    return kern(positions, &places, at, arena, kerning);
}
