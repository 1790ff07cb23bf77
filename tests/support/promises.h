/* What a triangulation and a decomposition promise, checked by brute force: exact, without tolerance. */
#pragma once

#include "geometry/triangulate.h"
#include "support/check.h"

/* Triangles anticlockwise and with area, areas adding up, half-edges and twins consistent, every diagonal
 * locally Delaunay, and the triangles together the component. For clean components also: as many triangles
 * as Euler's formula says, the edges without twins are the rings' edges; and with at most 60 points: no
 * vertex inside a triangle's circumcircle is in sight of its barycentre. */
void mt_check_mesh(const mt_component *component, const mt_half_edges *mesh, const mt_subject *subject);

/* Pieces convex, over the component's vertices, areas adding up, together the component. For clean
 * components also: every vertex used, no two pieces that could be merged, and with r reflex vertices and h
 * holes from ⌈r/2⌉ + 1 - h to 2r + 1 - h pieces. (Cutting with d diagonals gives d + 1 - h pieces; each
 * reflex vertex needs one diagonal and keeps at most two.) */
void mt_check_pieces(const mt_component *component, const mt_pieces *pieces, const mt_subject *subject);
