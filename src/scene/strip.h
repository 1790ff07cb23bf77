/* A strip of solids: a mesh at several places side by side, all on one scale. */
#pragma once

#include "base/memory.h"
#include "scene/view.h"

/* The largest size that a step may have, pixels. */
#define MT_SCENE_SIZE_MAX 4096.0
#define MT_SCENE_SIZE_MIN 16.0

/* Makes the mesh of a step, in the arena. */
typedef mt_status (*mt_step_mesh)(int step, mt_arena *arena, mt_mesh *mesh, void *user);

typedef struct mt_solid_strip {
    const double *at; /* T of each step, as many as step_count */
    int step_count;
    double size;       /* pixels that the longest side of what is seen of any step has */
    double turn, tilt; /* from where it is seen, degrees: mt_eye_at */
    bool labels;       /* T under each step */
    mt_step_mesh mesh;
    void *user;
} mt_solid_strip;

/* Written whole or not at all in the format of the extension, .png, .svg or .pdf; in the last two, solids are images. MT_UNKNOWN_FORMAT,
 * MT_BAD_PARAMETER, MT_TOO_LARGE for a picture over the sides that picture/canvas.h gives, MT_CANNOT_WRITE, MT_NO_MEMORY. */
mt_status mt_solid_strip_save(const mt_solid_strip *strip, const char *path);
