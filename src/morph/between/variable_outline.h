/* A morph as moving contours: compatible masters for all of it, which is what a variable font stores.
 *
 * An aligned component moves by its contours as it is. Of a link, the Minkowski sum rA ⊕ (1 - r)B has the same corners for all
 * 0 < r < 1, each r·a + (1 - r)·b for the same vertices a and b: so a link is one contour too. Its vertices are a's in the one
 * master and b's in the other, and the same lines and quadratics are fitted to both. The ink is the nonzero union of all
 * contours, at every r. */
#ifndef MT_MORPH_BETWEEN_VARIABLE_OUTLINE_H
#define MT_MORPH_BETWEEN_VARIABLE_OUTLINE_H

#include "morph/model/morph.h"

/* In the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_variable_outline_make(const mt_morph *morph, const mt_params *params, mt_arena *arena,
                                   mt_variable_outline *moving);

/* The contours at these weights, turned back by formula (5). MT_NO_MEMORY. */
mt_status mt_variable_outline_at(const mt_morph *morph, const mt_variable_outline *moving, mt_weights weights,
                                 mt_arena *arena, mt_outline *outline);

/* In how many straight steps, each as long in T, all points keep within `bound` grid units of the way that formula (5) takes
 * them: 1 without rotation, 2 where a contour stands aside half-way, MT_TURN_STEPS_MAX at most. */
enum { MT_TURN_STEPS_MAX = 64 };
int mt_variable_outline_steps(const mt_morph *morph, const mt_variable_outline *moving, double bound);

#endif
