/* A mesh as a file has it: polygons over points, of which several may stand at one place. */
#pragma once

#include "mesh/fault.h"

typedef struct mt_draft {
    mt_mesh_fault *fault;
    int n_points, room_points;
    mt_vector3 *points;
    int n_corners, room_corners;
    int *corners; /* points; those of one polygon after those of the one before */
    int n_polygons, room_polygons;
    int *ends; /* where a polygon's corners end */
} mt_draft;    /* all zero but `fault` is an empty draft */

/* MT_BAD_MESH for what is no number or beyond the limits of limits.h, MT_TOO_LARGE for too many, MT_NO_MEMORY. */
mt_status mt_draft_point(mt_draft *draft, double x, double y, double z);

/* Points may be added later than the polygons that have them. The same statuses. */
mt_status mt_draft_polygon(mt_draft *draft, const int *points, int count);

/* Says how many triangles there are to be, before they are read. MT_TOO_LARGE. */
mt_status mt_draft_expect(const mt_draft *draft, int64_t triangles);

/* Whether all points that polygons have are there. MT_BAD_MESH. */
mt_status mt_draft_end(const mt_draft *draft);

void mt_draft_free(mt_draft *draft);
