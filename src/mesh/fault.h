/* What is wrong with a mesh, in words that name the place. */
#pragma once

#include "morphotype.h"

/* Says it, cut where it does not fit, and gives `status`. */
__attribute__((format(printf, 3, 4))) mt_status mt_mesh_say(mt_mesh_fault *fault, mt_status status,
                                                            const char *format, ...);

/* "(0.5, 1, -2)". */
enum { MT_PLACE_ROOM = 64 };
void mt_place_write(mt_vector3 place, char text[MT_PLACE_ROOM]);
