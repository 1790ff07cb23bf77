/* The in-circle predicate of points relative to d, exact:
 *
 *     | ax  ay  ax² + ay² |
 *     | bx  by  bx² + by² |   > 0  when d is inside the circle through a, b, c (anticlockwise)
 *     | cx  cy  cx² + cy² |
 *
 * With differences up to 2^28 the 2×2 minors and the squares stay within 2^57, each product within 2^114, and the sum within 2^116: they
 * fit 128 bits. O(1). */
#include "geometry/point.h"

int mt_in_circle(mt_point a, mt_point b, mt_point c, mt_point d) {
    mt_wide ab = mt_cross(d, a, d, b), bc = mt_cross(d, b, d, c), ca = mt_cross(d, c, d, a);
    mt_wide determinant = bc * mt_distance2(d, a) + ca * mt_distance2(d, b) + ab * mt_distance2(d, c);
    return (determinant > 0) - (determinant < 0);
}
