#include "mesh/draft.h"

#include <inttypes.h>
#include <math.h>

#include "base/memory.h"
#include "mesh/limits.h"

static bool in_range(double coordinate) {
    return fabs(coordinate) <= MT_MESH_COORDINATE_MAX; /* false for what is no number */
}

mt_status mt_draft_point(mt_draft *draft, double x, double y, double z) {
    if (draft->n_points == MT_MESH_POINTS_MAX)
        return mt_mesh_say(draft->fault, MT_TOO_LARGE, "over %d points", MT_MESH_POINTS_MAX);
    if (!in_range(x) || !in_range(y) || !in_range(z))
        return mt_mesh_say(draft->fault, MT_BAD_MESH, "point %d has a coordinate that is no number up to %g",
                           draft->n_points + 1, MT_MESH_COORDINATE_MAX);
    mt_vector3 *points =
        mt_grow_list(draft->points, draft->n_points, &draft->room_points, sizeof *draft->points);
    if (!points) return MT_NO_MEMORY;
    draft->points = points;
    points[draft->n_points++] = (mt_vector3){x, y, z};
    return MT_OK;
}

static mt_status add_corner(mt_draft *draft, int point) {
    int *corners = mt_grow_list(draft->corners, draft->n_corners, &draft->room_corners, sizeof *corners);
    if (!corners) return MT_NO_MEMORY;
    draft->corners = corners;
    corners[draft->n_corners++] = point;
    return MT_OK;
}

mt_status mt_draft_expect(const mt_draft *draft, int64_t triangles) {
    if (triangles <= MT_MESH_TRIANGLES_MAX) return MT_OK;
    return mt_mesh_say(draft->fault, MT_TOO_LARGE, "%" PRId64 " triangles; %d are the most", triangles,
                       MT_MESH_TRIANGLES_MAX);
}

mt_status mt_draft_polygon(mt_draft *draft, const int *points, int count) {
    if (count < 3 || count > MT_MESH_CORNERS_MAX)
        return mt_mesh_say(draft->fault, MT_BAD_MESH, "polygon %d has %d corners; from 3 to %d go",
                           draft->n_polygons + 1, count, MT_MESH_CORNERS_MAX);
    if (draft->n_corners - 2 * draft->n_polygons + count - 2 > MT_MESH_TRIANGLES_MAX)
        return mt_mesh_say(draft->fault, MT_TOO_LARGE, "over %d triangles", MT_MESH_TRIANGLES_MAX);
    int *ends = mt_grow_list(draft->ends, draft->n_polygons, &draft->room_polygons, sizeof *ends);
    if (!ends) return MT_NO_MEMORY;
    draft->ends = ends;
    for (int i = 0; i < count; i++) {
        mt_status status = add_corner(draft, points[i]);
        if (status != MT_OK) return status;
    }
    ends[draft->n_polygons++] = draft->n_corners;
    return MT_OK;
}

mt_status mt_draft_end(const mt_draft *draft) {
    for (int i = 0, corner = 0; i < draft->n_polygons; i++)
        for (; corner < draft->ends[i]; corner++) {
            int point = draft->corners[corner];
            if (point < 0 || point >= draft->n_points)
                return mt_mesh_say(draft->fault, MT_BAD_MESH, "polygon %d has a corner at no point", i + 1);
        }
    return MT_OK;
}

void mt_draft_free(mt_draft *draft) {
    mt_free(draft->points);
    mt_free(draft->corners);
    mt_free(draft->ends);
    *draft = (mt_draft){.fault = draft->fault};
}
