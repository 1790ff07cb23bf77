/* Random polygons that are awkward on purpose. */
#pragma once

#include "geometry/ring.h"
#include "support/random.h"

typedef enum mt_polygon_kind {
    MT_POLYGON_CONVEX,
    MT_POLYGON_STAR,   /* radii at random around a middle */
    MT_POLYGON_COMB,   /* teeth of many lengths, slanted */
    MT_POLYGON_SPIRAL, /* a band wound up */
    MT_POLYGON_TANGLE, /* points anywhere, joined so that nothing crosses: thin and sharp */
    MT_POLYGON_CELLS,  /* squares of a grid: points in line and on circles, rings that touch */
    MT_POLYGON_KINDS,
} mt_polygon_kind;

/* A component of that kind, of about `size` points (3 … 500), within `extent` grid units (64 or more) of
 * the origin on each axis, with up to three holes where they fit. Rings do not cross; those of cells may
 * touch. */
mt_component mt_random_polygon(mt_random *random, mt_arena *arena, mt_polygon_kind kind, int size,
                               int extent);

/* Any kind, some of them with points in line and repeated points put into their edges, and dents of one
 * unit. */
mt_component mt_random_component(mt_random *random, mt_arena *arena, int size, int extent);

/* Up to `most` of them, side by side, not touching. */
mt_shape mt_random_shape(mt_random *random, mt_arena *arena, int most, int size, int extent);

/* A closed line of random points, crossing itself anyhow. */
mt_ring mt_random_scrawl(mt_random *random, mt_arena *arena, int count, int extent);

mt_ring mt_test_ring(mt_arena *arena,
                     int count); /* like mt_ring_new, all corners between lines; never fails */
/* The ring through these points, each coordinate multiplied. */
mt_ring mt_test_ring_of(mt_arena *arena, const int (*points)[2], int count, int factor);
mt_rings mt_test_rings(mt_arena *arena, int count);
mt_shape mt_test_shape_of(mt_arena *arena, const mt_component *component);

/* A copy with each point multiplied, then moved. */
mt_rings mt_test_moved(mt_arena *arena, const mt_rings *rings, int factor, mt_point by);
mt_shape mt_test_shape_moved(mt_arena *arena, const mt_shape *shape, int factor, mt_point by);

/* All rings of a shape in one list. */
mt_rings mt_test_all_rings(mt_arena *arena, const mt_shape *shape);
