/* A solid drawn: shaded by its faces' directions, with lines around it and at its creases, on white. */
#pragma once

#include <cairo.h>

#include "scene/view.h"

typedef struct mt_render {
    mt_eye eye;
    mt_vector3 middle; /* of the scene, in the middle of the picture */
    double scale;      /* pixels a unit */
    int width, height; /* pixels */
} mt_render;

/* An image surface that is the caller's. Of overlapping closed meshes their union is seen. MT_NO_MEMORY. */
mt_status mt_render_mesh(const mt_mesh *mesh, const mt_render *render, cairo_surface_t **image);
