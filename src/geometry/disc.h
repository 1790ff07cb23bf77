/* Discs within a region that touch its border. */
#pragma once

#include "geometry/ring.h"

/* The way from point i of one of a region's rings to the middle of the largest disc that touches the border there, grid units. At a corner that
 * points out of the region, the disc touches both edges, as far along them as it gets before it touches a third; a tip sharper than a third of a half turn is its own middle. Rings do not cross;
 * `left`: whether the region lies to the left of their edges. 0, 0 where nothing bounds the disc. Linear in the number of points. */
mt_vector mt_way_to_middle(const mt_rings *region, int ring, int i, bool left);

/* The radius of the largest disc in the region to the left of all edges, grid units, if it is over `least`, else `least`. The discs that are looked at touch the
 * border in places at even distances and in corners, so that the result may be a few hundredths small. */
double mt_largest_disc(const mt_rings *region, double least);
