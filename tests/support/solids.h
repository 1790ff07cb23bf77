/* Solids for tests. */
#pragma once

#include "base/memory.h"
#include "morphotype.h"
#include "support/random.h"

/* All belong to the arena; without points when out of memory. */
mt_mesh mt_test_box(mt_arena *arena, mt_vector3 low, mt_vector3 high);
/* A square block, 2 × 0.8 × 2, with a square hole along y: 16 points, 32 triangles. */
mt_mesh mt_test_block(mt_arena *arena);
/* An octahedron, divided once, whose points are drawn in or out by up to `rough`: 18 points. */
mt_mesh mt_random_star(mt_random *random, mt_arena *arena, double rough);

/* How often a surface goes around p: 1 within, 0 outside. */
double mt_test_turns(const mt_vector3 *points, const mt_triangle *triangles, int n, mt_vector3 p);
