/* A morph as a variable outline: compatible masters for all of it, as a variable font stores them. An aligned component has its
 * contours; a link becomes one contour (link_contour.h). The ink is the nonzero union of all contours, at every r. */
#pragma once

#include "morph/model/morph.h"

/* In the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_variable_outline_make(const mt_morph *morph, const mt_params *params, mt_arena *arena,
                                   mt_variable_outline *variable);

/* The contours at these weights, turned back by formula (5). MT_NO_MEMORY. */
mt_status mt_variable_outline_at(const mt_morph *morph, const mt_variable_outline *variable,
                                 mt_weights weights, mt_arena *arena, mt_outline *outline);

/* The number of straight steps of equal length in T with which all points keep within `bound` grid units of their paths by formula
 * (5): 1 without rotation, 2 where a contour is displaced, MT_TURN_STEPS_MAX at most. */
enum { MT_TURN_STEPS_MAX = 64 };
int mt_variable_outline_steps(const mt_morph *morph, const mt_variable_outline *variable, double bound);
