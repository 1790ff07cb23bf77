#include "mesh/grid.h"

#include <stdlib.h>

int mt_grid_side(mt_grid_point a, mt_grid_point b, mt_grid_point c, mt_grid_point d) {
    double ax = a.x - d.x, ay = a.y - d.y, az = a.z - d.z, bx = b.x - d.x, by = b.y - d.y, bz = b.z - d.z,
           cx = c.x - d.x, cy = c.y - d.y, cz = c.z - d.z;
    double sum = ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
    /* Six products under 2^66, each rounded three times by 2^-53 at most: off by less than 2^18. */
    if (sum > 262144 || sum < -262144) return sum > 0 ? 1 : -1;
    mt_grid_normal n = mt_grid_normal_of(d, b, c);
    mt_int128 whole =
        (mt_int128)(a.x - d.x) * n.x + (mt_int128)(a.y - d.y) * n.y + (mt_int128)(a.z - d.z) * n.z;
    return whole > 0 ? 1 : whole < 0 ? -1 : 0;
}

mt_grid_normal mt_grid_normal_of(mt_grid_point a, mt_grid_point b, mt_grid_point c) {
    int64_t bx = b.x - a.x, by = b.y - a.y, bz = b.z - a.z, cx = c.x - a.x, cy = c.y - a.y, cz = c.z - a.z;
    return (mt_grid_normal){by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx};
}

mt_grid_flat mt_grid_drop(mt_grid_point point, mt_grid_normal normal) {
    int64_t x = llabs(normal.x), y = llabs(normal.y), z = llabs(normal.z);
    mt_grid_flat flat = {point.x, point.y};
    bool turned = normal.z < 0;
    if (x >= y && x >= z) {
        flat = (mt_grid_flat){point.y, point.z};
        turned = normal.x < 0;
    } else if (y >= z) {
        flat = (mt_grid_flat){point.z, point.x};
        turned = normal.y < 0;
    }
    return turned ? (mt_grid_flat){flat.y, flat.x} : flat;
}

int mt_grid_turn(mt_grid_flat a, mt_grid_flat b, mt_grid_flat c) {
    int64_t turn = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    return (turn > 0) - (turn < 0);
}
