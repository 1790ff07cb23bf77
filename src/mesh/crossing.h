/* Whether a surface crosses or touches itself. */
#pragma once

#include "mesh/surface.h"

/* MT_NOT_SOLID, said with the places of two triangles; MT_TOO_LARGE where too many lie close together; MT_NO_MEMORY. */
mt_status mt_surface_check_crossings(const mt_surface *surface, mt_arena *arena, mt_mesh_fault *fault);
