#include "gpos/kerning.h"

#include "gpos/position_data.h"
#include "kerning/mix.h"

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

static int list_pairs(const mt_mixed_pairs *mixed, int part, mt_kerning_pair *pairs) {
    int count = 0;
    for (int r = 1; r < mixed->row_count; r++)
        for (int c = 1; c < mixed->column_count; c++) {
            int value = mt_mixed_cell(mixed, r, c)[part];
            if (!value) continue;
            if (pairs)
                pairs[count] = (mt_kerning_pair){false, false, (uint16_t)(r - 1), (uint16_t)(c - 1), value};
            count++;
        }
    for (int i = 0; i < mixed->listed_count; i++) {
        mt_listed_pair listed = mixed->listed[i];
        int value = mt_mixed_listed(mixed, i)[part];
        if (value == mt_mixed_cell(mixed, mixed->row_of[listed.left], mixed->column_of[listed.right])[part])
            continue;
        if (pairs) pairs[count] = (mt_kerning_pair){true, true, listed.left, listed.right, value};
        count++;
    }
    return count;
}

static mt_status tell(const mt_mixed_pairs *mixed, mt_arena *arena, mt_kerning *kerning) {
    mt_kerning_group *left, *right;
    int part = find_advance(mixed);
    *kerning = (mt_kerning){0};
    if (part < 0) return MT_OK;
    mt_status status = list_groups(mixed->row_of, mixed->glyph_count, mixed->row_count, arena, &left);
    if (status == MT_OK)
        status = list_groups(mixed->column_of, mixed->glyph_count, mixed->column_count, arena, &right);
    if (status != MT_OK) return status;
    int count = list_pairs(mixed, part, NULL);
    mt_kerning_pair *pairs = mt_arena_new(arena, (size_t)count + 1, sizeof *pairs);
    if (!pairs) return MT_NO_MEMORY;
    list_pairs(mixed, part, pairs);
    *kerning = (mt_kerning){mixed->row_count - 1, mixed->column_count - 1, left, right, count, pairs};
    return MT_OK;
}

mt_status mt_positions_kerning(const mt_positions *positions, double t, mt_arena *arena,
                               mt_kerning *kerning) {
    mt_arena scratch = {0};
    mt_places places = {positions->font_count, 1, &t, NULL};
    mt_mixed_pairs mixed;
    mt_kerning made = {0};
    mt_status status = MT_OK;
    if (positions->has_plain_kerning)
        status = mt_pairs_mix(&positions->plain_kerning, &places, &scratch, &mixed);
    if (status == MT_OK && positions->has_plain_kerning) status = tell(&mixed, arena, &made);
    mt_arena_release(&scratch);
    if (status == MT_OK) *kerning = made;
    return status;
}
