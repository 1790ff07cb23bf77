/* Binary glTF 2.0, written: one mesh, and where it moves a morph target and the animation of its weight. */
#pragma once

#include "base/buffer.h"

typedef struct mt_glb_content {
    int n_points, n_triangles;
    const mt_vector3 *at_a,
        *at_b; /* points at weight 0 and at weight 1; at_b is NULL for a mesh that does not move */
    const mt_triangle *triangles;
    double duration; /* seconds from weight 0 to weight 1 */
    bool yoyo;       /* and back */
    double degrees;  /* by which it has turned at weight 1, anticlockwise; at weight w by w times that */
    mt_vector3 axis; /* of length 1, through … */
    mt_vector3 middle_a, middle_b; /* … (1 - w) · middle_a + w · middle_b */
} mt_glb_content;

/* Has no normals: glTF then has flat ones, which stay right while it moves. The buffer is the caller's. MT_NO_MEMORY. */
mt_status mt_glb_write(const mt_glb_content *content, mt_buffer *file);
