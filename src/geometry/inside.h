/* The component of a shape that holds a place or is nearest to it; depth in the ink. */
#pragma once

#include "geometry/ring.h"

/* The component whose ink holds a place, or is nearest to it. The shape is not empty. */
int mt_component_at(const mt_shape *shape, mt_point place);

/* Whether a place is in the ink of a shape. */
bool mt_is_in_ink(const mt_shape *shape, mt_point place);
/* Whether it is there at least `depth` grid units from the border. */
bool mt_is_deep_in_ink(const mt_shape *shape, mt_point place, double depth);

/* The place on the border of a shape that is nearest to a place. The shape is not empty. */
mt_vector mt_nearest_on_border(const mt_shape *shape, mt_point place);
