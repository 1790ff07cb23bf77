/* Rings, components and shapes: what the geometry works on.
 *
 * A ring is a closed polygon without its first point repeated. A component (the paper's connected weight) is
 * a connected region of ink: rings[0] is its outer boundary, anticlockwise, the others are its holes,
 * clockwise; the ink lies to the left of every edge. A piece (the paper's convex subset) is a convex
 * anticlockwise ring. A shape is the ink of one glyph.
 *
 * Each point carries a mark that remembers where it came from, so that curves can be told from corners again
 * when the result is fitted. Geometry itself decides nothing by marks. */
#pragma once

#include "base/memory.h"
#include "geometry/point.h"
#include "morphotype.h"

/* Of a point, and of the edge that starts at it. Without the first two, the drawing is smooth here: on a
 * curve, or where one runs on into a line or another curve. Without the last two, nothing is known of the
 * edge. */
typedef enum mt_mark {
    MT_CORNER = 1,   /* the drawing has a corner here */
    MT_CROSSING = 2, /* no vertex of any drawing: two edges of a union cross here */
    MT_LINE = 4,     /* the edge was drawn as a straight line */
    MT_CHORD = 8,    /* the edge stands for a part of a curve */
    MT_POINT_MARKS = MT_CORNER | MT_CROSSING,
    MT_EDGE_MARKS = MT_LINE | MT_CHORD,
} mt_mark;

typedef struct mt_ring {
    int count;
    mt_point *points;
    uint8_t *marks; /* mt_marks for each point */
} mt_ring;

typedef struct mt_rings {
    int count;
    mt_ring *rings;
} mt_rings;

typedef mt_rings mt_component; /* outer ring first, then holes */
typedef mt_rings mt_pieces;    /* convex, anticlockwise */

typedef struct mt_shape {
    int count;
    mt_component *components;
} mt_shape;

/* A ring of `count` points, all zero, in the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_ring_new(mt_arena *arena, int count, mt_ring *ring);

/* Twice the signed area, grid units squared: > 0 for an anticlockwise ring. Exact. */
int64_t mt_ring_area2(const mt_ring *ring);
int64_t mt_component_area2(const mt_component *component); /* the holes taken off; of any rings, their sum */
int64_t mt_shape_area2(const mt_shape *shape);

/* The number of their points. */
int64_t mt_rings_corners(const mt_rings *rings);

/* The number of a shape's rings. */
int mt_shape_ring_count(const mt_shape *shape);

/* All rings of a shape in one list; the points are shared, not copied. MT_NO_MEMORY. */
mt_status mt_shape_rings(const mt_shape *shape, mt_arena *arena, mt_rings *rings);

double mt_ring_length(const mt_ring *ring); /* grid units */
double mt_rings_length(const mt_rings *rings);

/* The smallest upright rectangle around; the box of nothing is (0, 0) to (0, 0). */
mt_box mt_ring_box(const mt_ring *ring);
mt_box mt_shape_box(const mt_shape *shape);
mt_box mt_box_around(mt_box p, mt_box q); /* both */

/* The sides of a box, grid units; at least 1, so that places can be relative to a box without width or height. */
double mt_box_width(mt_box box);
double mt_box_height(mt_box box);

/* The barycentre of the area, grid units. A ring without area gives the middle of its box. */
void mt_ring_centre(const mt_ring *ring, double *x, double *y);

/* The distance of a place from an edge, grid units, and the vector to the edge's nearest place. */
double mt_way_to_edge(mt_point from, mt_point a, mt_point b, double way[2]);

/* The least distance between the borders of two rings that do not cross, grid units, and the vector from p to q where they are nearest,
 * rounded. */
double mt_ring_gap(const mt_ring *p, const mt_ring *q, mt_point *way);

/* At least three points, every turn to the left or straight on, once around; no area is not convex. */
bool mt_ring_is_convex(const mt_ring *ring);

/* The convex hull of n points (Andrew's monotone chain), anticlockwise, without points in line; `hull` has
 * room for n + 1. Returns how many. `points` is sorted on return. */
int mt_convex_hull(mt_point *points, int n, mt_point *hull);

/* Whether the struct keeps its invariants, in linear time, asserted where it is made. A ring: points within four times
 * MT_COORD_MAX, as sums and displacements reach, and known marks. A component: rings of three points or more, the outer
 * one's area positive, the holes' negative. A shape: its components' invariants. Pieces: convex rings. */
bool mt_ring_is_valid(const mt_ring *ring);
bool mt_component_is_valid(const mt_component *component);
bool mt_shape_is_valid(const mt_shape *shape);
bool mt_pieces_is_valid(const mt_pieces *pieces);
