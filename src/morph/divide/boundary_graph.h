/* The border of a shape as a graph on which a walker of the other glyph's border may go: along the rings
 * from stop to stop, and across the ink over bridges. */
#ifndef MT_BORDER_H
#define MT_BORDER_H

#include "geometry/triangulate.h"
#include "morph/align/align.h"

/* A place to cross the ink, in one direction: a diagonal of the triangulation. Or a leap over white to another component: a
 * part that is whole on one side may be two on the other. */
typedef struct mt_bridge {
    int to;       /* the stop on the other bank */
    int edge;     /* the half-edge of its component's mesh; -1 for a leap */
    double price; /* INFINITY where it is barred */
} mt_bridge;

typedef struct mt_border {
    mt_box box; /* of the glyph */
    int component_count;
    mt_mesh *meshes; /* of each component, its long edges divided */
    bool **drawn;    /* of each component's mesh, the vertices that its rings had before */
    mt_box *boxes;   /* of each component */
    int *first_stop; /* component_count + 1: vertex v of mesh c is stop first_stop[c] + v */
    int ring_count;
    int *first_of_ring; /* ring_count + 1 */
    int count;          /* of stops */
    mt_view *views;
    mt_point *places;  /* of each stop */
    double *length;    /* from each stop to the next, em */
    double *along;     /* from the start of its ring to each stop, em */
    int *first_bridge; /* count + 1 */
    mt_bridge *bridges;
} mt_border;

/* The border of a shape in its glyph's box, with the manner's stops, the bridges shorter than `reach` grid units, and leaps if the
 * manner has them. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_border_of(const mt_shape *shape, mt_box box, const mt_manner *manner, double reach,
                       mt_arena *arena, mt_border *border);

/* The stop that a bridge leaves, and the bridge back over the same diagonal. */
int mt_bridge_source(const mt_border *border, int bridge);
int mt_bridge_back(const mt_border *border, int bridge);

/* How far two stops are apart, em. */
double mt_border_distance(const mt_border *border, int i, int j);

/* How long a bridge is, em. */
double mt_bridge_length(const mt_border *border, int bridge);

/* The ring that a stop is on. */
int mt_border_ring(const mt_border *border, int stop);

#endif
