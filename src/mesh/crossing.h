/* Whether a surface crosses or touches itself. */
#pragma once

#include "mesh/surface.h"

/* A slip is no crossing: where triangles are neighbours on the surface, and one reaches through another by less than MT_SLIP. Such are
 * left by programs that move points, and quadrangles that are not flat have them whichever way they are divided. MT_NOT_SOLID, said with the places of two triangles; MT_TOO_LARGE where too many lie close together; MT_NO_MEMORY. */
mt_status mt_surface_check_crossings(const mt_surface *surface, mt_arena *arena, mt_mesh_fault *fault);
