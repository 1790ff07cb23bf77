/* The joint method: as many parts on both sides, each pair one moving contour with its holes. */
#ifndef MT_JOINT_H
#define MT_JOINT_H

#include "morph/morph.h"

/* Joins all matched components of morph->a and morph->b into morph->contours. A component with several partners is divided
 * among them first. Components that hang together by matches, and cannot all be divided and joined, are left to the
 * paper's mapping: their matches go to `rest`. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_joint(mt_morph *morph, const mt_params *params, mt_arena *arena, mt_links *rest);

#endif
