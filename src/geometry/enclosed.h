/* The area that rings enclose, however they lie over themselves and one another. */
#pragma once

#include "geometry/ring.h"

/* Of one ring or more, by the nonzero rule, grid units squared; an estimate, good to a few hundredths. For rings whose edges lie on one
 * another, which a union is not sure of. MT_NO_MEMORY. */
mt_status mt_enclosed_area(const mt_rings *rings, mt_arena *arena, double *area);
