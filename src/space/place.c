/* Exact predicates in space. Bits: a difference of places 25, a normal's coordinate 51, normal · p 78, its product with a difference
 * 103, a dot product of two normals 104; the square of a height under 2^62 124. All fit mt_wide's 127. */
#include "space/place.h"

#include <math.h>

/* The length of a normal that no three places give. */
#define NORMAL_UNITS 1073741824.0

mt_plane mt_plane_at(int64_t x, int64_t y, int64_t z, mt_place p) {
    return (mt_plane){x, y, z, (mt_wide)x * p.x + (mt_wide)y * p.y + (mt_wide)z * p.z};
}

mt_plane mt_plane_along(mt_vector3 normal, mt_place p) {
    double length = sqrt(normal.x * normal.x + normal.y * normal.y + normal.z * normal.z);
    if (!(length > 0)) return (mt_plane){0};
    double scale = NORMAL_UNITS / length;
    return mt_plane_at(llround(normal.x * scale), llround(normal.y * scale), llround(normal.z * scale), p);
}

mt_plane mt_plane_through(mt_place a, mt_place b, mt_place c) {
    int64_t ux = (int64_t)b.x - a.x, uy = (int64_t)b.y - a.y, uz = (int64_t)b.z - a.z;
    int64_t vx = (int64_t)c.x - a.x, vy = (int64_t)c.y - a.y, vz = (int64_t)c.z - a.z;
    return mt_plane_at(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx, a);
}

mt_wide mt_plane_height(const mt_plane *plane, mt_place p) {
    return (mt_wide)plane->x * p.x + (mt_wide)plane->y * p.y + (mt_wide)plane->z * p.z - plane->offset;
}

static int sign_of(mt_wide value) {
    return (value > 0) - (value < 0);
}

int mt_plane_side(const mt_plane *plane, mt_place p) {
    mt_wide height = mt_plane_height(plane, p), far = (mt_wide)1 << 62;
    if (height >= far || height <= -far) return sign_of(height); /* a normal is shorter than 2^52 */
    mt_wide length2 =
        (mt_wide)plane->x * plane->x + (mt_wide)plane->y * plane->y + (mt_wide)plane->z * plane->z;
    return height * height <= length2 ? 0 : sign_of(height);
}

int mt_plane_alike(const mt_plane *p, const mt_plane *q) {
    return sign_of((mt_wide)p->x * q->x + (mt_wide)p->y * q->y + (mt_wide)p->z * q->z);
}

/* value / by, rounded to the nearest, halves away from 0; by > 0. */
static int32_t rounded(mt_wide value, mt_wide by) {
    return (int32_t)(value >= 0 ? (value + by / 2) / by : -((-value + by / 2) / by));
}

mt_place mt_plane_crossing(const mt_plane *plane, mt_place p, mt_place q) {
    mt_wide above = mt_plane_height(plane, p), below = mt_plane_height(plane, q);
    if (above < 0) return mt_plane_crossing(plane, q, p);
    mt_wide whole = above - below;
    return (mt_place){p.x + rounded(above * ((mt_wide)q.x - p.x), whole),
                      p.y + rounded(above * ((mt_wide)q.y - p.y), whole),
                      p.z + rounded(above * ((mt_wide)q.z - p.z), whole)};
}

int mt_orient3(mt_place a, mt_place b, mt_place c, mt_place d) {
    mt_plane plane = mt_plane_through(a, b, c);
    return sign_of(mt_plane_height(&plane, d));
}

mt_vector3 mt_plane_normal(const mt_plane *plane) {
    double x = (double)plane->x, y = (double)plane->y, z = (double)plane->z;
    double length = sqrt(x * x + y * y + z * z);
    return length > 0 ? (mt_vector3){x / length, y / length, z / length} : (mt_vector3){0, 0, 0};
}

double mt_plane_distance(const mt_plane *plane, mt_place p) {
    double x = (double)plane->x, y = (double)plane->y, z = (double)plane->z;
    return (double)mt_plane_height(plane, p) / sqrt(x * x + y * y + z * z);
}
