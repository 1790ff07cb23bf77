/* Places on the integer grid of a solid, and the exact predicates on planes that all of its cutting rests on.
 *
 * Coordinates are up to MT_PLACE_MAX in size. A plane through three places has a normal of 51 bits, and a place lies n · p - offset
 * from it in units of the normal's length: 78 bits. Both are exact. */
#pragma once

#include "geometry/limits.h"
#include "geometry/point.h"
#include "morphotype.h"

/* The largest absolute coordinate of a place: the plane's own, so that what lies in a plane can be triangulated there. A solid's box
 * is some 2^24 grid units long. */
#define MT_PLACE_MAX MT_COORD_MAX

typedef struct mt_place {
    int32_t x, y, z;
} mt_place;

typedef struct mt_plane {
    int64_t x, y, z; /* the normal, up to 2^51 */
    mt_wide offset;  /* normal · p of the plane's points */
} mt_plane;

static inline bool mt_place_equal(mt_place p, mt_place q) {
    return p.x == q.x && p.y == q.y && p.z == q.z;
}

static inline mt_vector3 mt_place_vector(mt_place p) {
    return (mt_vector3){p.x, p.y, p.z};
}

/* The plane through a, b and c, whose normal points to where they are anticlockwise; all zero when they are in line. */
mt_plane mt_plane_through(mt_place a, mt_place b, mt_place c);

/* The plane through a place whose normal is as good as along `normal`; all zero when that has no length. */
mt_plane mt_plane_along(mt_vector3 normal, mt_place p);

/* The plane with that normal through a place. */
mt_plane mt_plane_at(int64_t x, int64_t y, int64_t z, mt_place p);

static inline bool mt_plane_is_none(const mt_plane *plane) {
    return plane->x == 0 && plane->y == 0 && plane->z == 0;
}

/* normal · p - offset: > 0 on the side to which the normal points. */
mt_wide mt_plane_height(const mt_plane *plane, mt_place p);

/* On which side p lies: 1, -1, or 0 for no farther from the plane than one grid unit, which is what rounding moves a point of the
 * plane by at most (√3/2). */
int mt_plane_side(const mt_plane *plane, mt_place p);

/* The sign of the dot product of two normals. */
int mt_plane_alike(const mt_plane *p, const mt_plane *q);

/* Where the segment from p to q, whose ends lie on different sides, meets the plane; rounded to the grid. The same for q to p. */
mt_place mt_plane_crossing(const mt_plane *plane, mt_place p, mt_place q);

/* The sign of the volume of the tetrahedron: > 0 when a, b, c are anticlockwise as seen from d. */
int mt_orient3(mt_place a, mt_place b, mt_place c, mt_place d);

/* The distance of p from the plane in grid units, for measures. */
double mt_plane_distance(const mt_plane *plane, mt_place p);

/* The plane's normal, of length 1, for measures. */
mt_vector3 mt_plane_normal(const mt_plane *plane);
