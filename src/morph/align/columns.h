/* The views of many stops column by column, so that one stop is priced against all of them at once. */
#ifndef MT_COLUMNS_H
#define MT_COLUMNS_H

#include "morph/align/align.h"

typedef struct mt_columns {
    float *x, *y, *in_x, *in_y, *out_x, *out_y, *turn_x, *turn_y;
} mt_columns;

/* In the arena. MT_NO_MEMORY. */
mt_status mt_columns_of(const mt_view *views, int count, mt_arena *arena, mt_columns *columns);

/* mt_price of one stop with each of those from `first` up to `end`, into the same places of `prices`. */
void mt_price_all(const mt_tariff *tariff, const mt_view *view, const mt_columns *columns, int first, int end,
                  float *prices);

#endif
