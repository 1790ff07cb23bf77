/* The depth buffer: which triangle of a mesh is seen at each sample of a picture's rows. */
#pragma once

#include "base/memory.h"
#include "scene/view.h"

/* Samples a pixel has on each side. */
enum { MT_SAMPLES = 4 };

/* What is seen of a mesh, in samples: x to the right, y downwards from the picture's upper left corner, z towards the eye. */
typedef struct mt_seen_mesh {
    int n_triangles;
    const mt_triangle *triangles;
    mt_vector3 *points;
    mt_vector3 *normals; /* of each triangle, of length 1, with y upwards; 0 where it has no area */
} mt_seen_mesh;

/* The scene's place `middle` stands in the middle of width × height pixels, and a unit has `scale` pixels. Belongs to the arena.
 * MT_NO_MEMORY. */
mt_status mt_seen_mesh_make(const mt_mesh *mesh, const mt_eye *eye, mt_vector3 middle, double scale,
                            int width, int height, mt_arena *arena, mt_seen_mesh *seen);

/* Rows of samples. */
typedef struct mt_samples {
    int width, top, rows; /* row 0 is the picture's row `top` */
    int *triangle;        /* -1: none */
    double *depth;        /* z */
} mt_samples;

mt_status mt_samples_new(int width, int rows, mt_arena *arena, mt_samples *samples);

/* Finds what is seen from row `top` on. Triangles that face away or have no area are not. */
void mt_samples_take(const mt_seen_mesh *seen, int top, mt_samples *samples);
