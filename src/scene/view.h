/* From where a scene is seen: in parallel rays, so that equal lengths look equal. */
#pragma once

#include "morphotype.h"

/* Directions of length 1, each upright on the others: to the right and upwards on the picture, and towards the eye. */
typedef struct mt_eye {
    mt_vector3 right, up, towards;
} mt_eye;

/* The eye stands `turn` degrees to the right of +z, and `tilt` degrees above the ground; y is up. */
mt_eye mt_eye_at(double turn, double tilt);

/* (to the right, upwards, towards the eye), in the scene's own units. */
mt_vector3 mt_eye_sees(const mt_eye *eye, mt_vector3 place);

/* The box around what is seen of a mesh. */
typedef struct mt_seen_box {
    mt_vector3 low, high;
} mt_seen_box;
mt_seen_box mt_eye_box(const mt_eye *eye, const mt_mesh *mesh);
