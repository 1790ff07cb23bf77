/* The blend's horizontal kerning as classes and pairs, as a UFO has it (groups.plist, kerning.plist). */
#pragma once

#include "gpos/positions.h"

/* Glyphs of the new font, ascending, that kern alike on one side; no glyph is in two groups of a side. */
typedef struct mt_kerning_group {
    int count;
    const uint16_t *glyphs;
} mt_kerning_group;

/* The value, in the new font's units, that is added to the left glyph's advance. Each side is a group's index or, when
 * it says so, a glyph. A pair of glyphs goes before one of a glyph and a group, and that before one of two groups. */
typedef struct mt_kerning_pair {
    bool left_is_glyph, right_is_glyph;
    uint16_t left, right;
    int value;
} mt_kerning_pair;

typedef struct mt_kerning {
    int left_count, right_count;
    const mt_kerning_group *left, *right;
    int pair_count;
    const mt_kerning_pair *pairs;
} mt_kerning;

/* The kerning at a place, as mt_positions_write has it, of the script that text in Latin is set by; empty where no font kerns, or where
 * their classes together are too many (MT_PAIR_CELLS_MAX). It belongs to the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_positions_kerning(const mt_positions *positions, mt_font_at at, mt_arena *arena,
                               mt_kerning *kerning);

/* The same as one of several masters of a varying font: groups and pairs are the same at all places, also where a pair's value is 0 or
 * that of its groups, as programs that mix masters want them. MT_NO_MEMORY. */
mt_status mt_positions_master_kerning(const mt_positions *positions, mt_between at, mt_arena *arena,
                                      mt_kerning *kerning);
