/* The glyphs of one font sorted into the classes that its pair adjustment tells apart. */
#pragma once

#include "kerning/pairs.h"
#include "sfnt/intern.h"

/* One font's part in a blend's pairs, while they are prepared. */
typedef struct mt_pair_side {
    const mt_pair_source *source;
    const uint32_t *glyph_of; /* its glyph for each new one; MT_NO_PARTNER where it has none */
    mt_interned left, right;  /* rows, and columns, of each class: one number a subtable */
    int64_t *steps;           /* that are left */
    int *left_of, *right_of;  /* the class of each new glyph; MT_NO_CLASS without partner */
} mt_pair_side;

/* Takes steps; false when there are not so many left. */
bool mt_pair_spend(int64_t *steps, int64_t count);

/* Class 0 is of glyphs in no matrix. The interned rows are for mt_pair_side_free, whatever is returned.
 * MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_pair_side_sort(const mt_pair_source *source, const uint32_t *glyph_of, int glyph_count,
                            int64_t *steps, mt_arena *arena, mt_pair_side *side);
void mt_pair_side_free(mt_pair_side *side);

/* The values of all classes, for the parts of `pairs`. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_pair_side_values(const mt_pair_side *side, const mt_pairs *pairs, mt_arena *arena,
                              mt_pair_matrix *matrix);
