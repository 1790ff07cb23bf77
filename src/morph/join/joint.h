/* The joint method: matched components are aligned along their boundaries and become one contour pair for each pair of rings. */
#pragma once

#include "morph/model/join_context.h"
#include "morph/model/morph.h"

/* Joins the components of both sides: as they are where each has one counterpart with as many holes, otherwise cut (reconcile.h), so
 * that the sides' shapes and the matches become those of the parts. Sets the contours, and which components are aligned; the others
 * are left to the links. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_joint(mt_morph *morph, const mt_join_context *context, mt_arena *arena);
