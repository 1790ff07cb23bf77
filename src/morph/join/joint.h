/* The joint method: matched components are aligned along their boundaries and move as one contour for each pair of rings. */
#ifndef MT_MORPH_JOIN_JOINT_H
#define MT_MORPH_JOIN_JOINT_H

#include "morph/model/join_context.h"
#include "morph/model/morph.h"

/* Aligns the components of both sides: as they are where each has one counterpart and as many holes as it, otherwise cut
 * (reconcile.h), so that the sides' shapes and the matches are those of what they were cut into. Sets the contours, and
 * which components are aligned. What cannot be stays for the links. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_joint(mt_morph *morph, const mt_join_context *context, mt_arena *arena);

#endif
