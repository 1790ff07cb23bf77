/* The shells of a surface, in one part each: outer ones face outwards, those of hollows inwards. */
#pragma once

#include "mesh/surface.h"

/* Turns over shells that face the wrong way, if what they stand in does so too. The surface neither crosses nor touches itself. MT_NOT_SOLID
 * for a shell inside another one that faces as that does; MT_TOO_LARGE for too many; MT_NO_MEMORY. */
mt_status mt_surface_turn_shells(mt_surface *surface, mt_arena *arena, mt_mesh_fault *fault);
