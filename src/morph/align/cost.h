/* The cost of pairing two samples: one with one, and one with many at once. */
#pragma once

#include <math.h>

#include "morph/align/view.h"
#include "morph/model/settings.h"

/* The cost of pairing two samples. */
static inline double mt_step_cost(const mt_cost_weights *w, const mt_sample_view *a,
                                  const mt_sample_view *b) {
    double same = a->in_x * b->in_x + a->in_y * b->in_y + a->out_x * b->out_x + a->out_y * b->out_y;
    double alike = a->turn_x * b->turn_x + a->turn_y * b->turn_y;
    double dx = a->x - b->x, dy = a->y - b->y;
    return w->direction * (2 - same) / 4 + w->distance * sqrt(dx * dx + dy * dy) +
           w->corner * (1 - alike) / 2;
}

/* Added to the cost of a step by which one ring advances while the other waits. */
#define MT_WAIT_COST 0.02

/* The views of many samples, one array for each member. */
typedef struct mt_columns {
    float *x, *y, *in_x, *in_y, *out_x, *out_y, *turn_x, *turn_y;
} mt_columns;

/* In the arena. MT_NO_MEMORY. */
mt_status mt_columns_of(const mt_sample_view *views, int count, mt_arena *arena, mt_columns *columns);

/* mt_step_cost of one sample with each of those from `first` up to `end`, into the same places of `costs`. */
void mt_step_costs(const mt_cost_weights *weights, const mt_sample_view *view, const mt_columns *columns,
                   int first, int end, float *costs);
