/* What a mesh may have: beyond it is MT_TOO_LARGE, before memory is asked for. */
#pragma once

#define MT_MESH_TRIANGLES_MAX 200000
#define MT_MESH_POINTS_MAX (3 * MT_MESH_TRIANGLES_MAX) /* of a file, where no two triangles share one */
#define MT_MESH_CORNERS_MAX 4096                       /* of a polygon */
#define MT_MESH_SHELLS_MAX 4096
#define MT_MESH_COORDINATE_MAX 1e9
#define MT_MESH_SIDE_MIN 1e-9 /* of the longest side: what is smaller is one point */
#define MT_MESH_BYTES_MAX ((size_t)256 << 20)
