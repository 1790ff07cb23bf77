/* Drawings as shapes: one outline, or several layers of ink over one another. */
#pragma once

#include "geometry/union.h"

/* An outline that is filled by itself. */
typedef struct mt_layer {
    mt_outline outline;
    mt_rule rule;
} mt_layer;

typedef struct mt_layers {
    int count;
    mt_layer *list;
} mt_layers;

/* An outline as a shape: flattened within `tolerance` (1/1000 em), resolved into components. As mt_outline_resolve. */
mt_status mt_outline_shape(const mt_outline *outline, double tolerance, mt_arena *arena, mt_shape *shape);

/* The same of layers, ink where any of them has ink. MT_TOO_LARGE for more than MT_POINTS_MAX points, or more than
 * MT_LAYER_CROSSINGS_MAX crossings; and as mt_flatten and mt_union. */
#define MT_LAYER_CROSSINGS_MAX 10000
mt_status mt_layers_shape(const mt_layers *layers, double tolerance, mt_arena *arena, mt_shape *shape);
