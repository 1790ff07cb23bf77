/* Classes of pair adjustment divided, where glyphs of one class lie at places of their own. */
#pragma once

#include "kerning/pairs.h"

/* The pairs with classes whose glyphs all lie at one place each, `left` and `right` of each class. Where no glyph has a place of its own
 * the classes are as they were, and both NULL. In the arena. MT_NO_MEMORY;
 * MT_TOO_LARGE for more than MT_PAIR_CELLS_MAX pairs of classes. */
typedef struct mt_divided_pairs {
    mt_pairs pairs;
    const mt_at *left, *right;
} mt_divided_pairs;

mt_status mt_pairs_divide(const mt_pairs *pairs, const mt_places *places, mt_arena *arena,
                          mt_divided_pairs *divided);
