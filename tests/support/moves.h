/* Morphs of contours that move on straight ways, as the last stages of the engine have them, and what these do to them. */
#pragma once

#include "morph/check/mend.h"

/* A square, 100/1000 em wide, whose lower left corner is at x, y thousandths of the em. */
mt_ring mt_test_square(mt_arena *arena, int x, int y);

/* Ring i of A moves to ring i of B, point by point; the ends are their unions. */
mt_morph mt_test_morph_of(mt_arena *arena, mt_ring *in_a, mt_ring *in_b, int count);

mt_topology_error mt_test_topology_error(mt_arena *arena, const mt_morph *morph);

/* Lets a stage mend the morph, and checks that it says how that strays now. */
typedef mt_status (*mt_mend)(mt_mending *m);
mt_topology_error mt_test_mend(mt_arena *arena, mt_mend mend, mt_morph *morph);

/* How far a contour stands aside half-way, 1/1000 em. */
double mt_test_displacement(const mt_morph *morph, int contour);

/* Checks that at T = 0 and 1 the blend has the area and the box of A, and of B. */
void mt_test_ends_stay(mt_arena *arena, const mt_morph *morph);
