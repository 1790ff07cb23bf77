/* Solids and what is between two of them: the inside of the library's handles, and their data. */
#pragma once

#include "base/buffer.h"
#include "base/memory.h"
#include "solid/solid_morph.h"

struct mt_solid {
    mt_arena arena;
    mt_mesh mesh;
};

struct mt_solid_blend {
    mt_arena arena;
    mt_solid_params params;
    mt_mesh a, b;
    mt_solid_morph morph;
};

/* The solid at T in the arena: at 0 and 1 the sources themselves, in between all links, meshes that overlap. MT_BAD_PARAMETER,
 * MT_NO_MEMORY. */
mt_status mt_solid_blend_at(const mt_solid_blend *blend, double t, mt_arena *arena, mt_mesh *mesh);

/* As data, with the names of both files; docs/guide.md has the schema. MT_NO_MEMORY. */
mt_status mt_solid_blend_json(const mt_solid_blend *blend, const char *name_a, const char *name_b,
                              mt_buffer *text);

/* GLB with the second solid as a morph target. MT_NO_MEMORY. */
mt_status mt_solid_blend_glb(const mt_solid_blend *blend, double duration, bool yoyo, mt_buffer *file);
