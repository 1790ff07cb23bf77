/* The views of many samples column by column, so that one sample is costed against all of them at once. */
#ifndef MT_MORPH_ALIGN_COLUMNS_H
#define MT_MORPH_ALIGN_COLUMNS_H

#include "morph/align/align.h"

typedef struct mt_columns {
    float *x, *y, *in_x, *in_y, *out_x, *out_y, *turn_x, *turn_y;
} mt_columns;

/* In the arena. MT_NO_MEMORY. */
mt_status mt_columns_of(const mt_sample_view *views, int count, mt_arena *arena, mt_columns *columns);

/* mt_step_cost of one sample with each of those from `first` up to `end`, into the same places of `costs`. */
void mt_step_costs(const mt_cost_weights *weights, const mt_sample_view *view, const mt_columns *columns,
                   int first, int end, float *costs);

#endif
