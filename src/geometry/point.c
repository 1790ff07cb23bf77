#include "point.h"

/* In-circle determinant of the points relative to d:
 *
 *     | ax  ay  ax² + ay² |
 *     | bx  by  bx² + by² |   > 0  when d is inside the circle through a, b, c (anticlockwise)
 *     | cx  cy  cx² + cy² |
 *
 * With differences under 2^27 the 2×2 minors and the squares stay under 2^55, each product under 2^110, and
 * the sum under 2^112: exact in 128 bits. */
int mt_in_circle(mt_point a, mt_point b, mt_point c, mt_point d) {
    mt_wide ab = mt_cross(d, a, d, b), bc = mt_cross(d, b, d, c), ca = mt_cross(d, c, d, a);
    mt_wide determinant = bc * mt_distance2(d, a) + ca * mt_distance2(d, b) + ab * mt_distance2(d, c);
    return (determinant > 0) - (determinant < 0);
}
