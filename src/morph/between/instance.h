/* One place between two shapes, out of a prepared morph (section 2.3 of the paper). */
#pragma once

#include "morph/model/morph.h"

/* The rings whose union the blend at these weights is: links' sums, and contours flattened within the params' tolerance. */
mt_status mt_morph_rings(const mt_morph *morph, mt_weights weights, const mt_params *params, mt_arena *arena,
                         mt_rings *rings);

/* The blend C(r), or C_int(r) with rotation, as polygons: the ink at these weights. May be called for many
 * weights. */
mt_status mt_morph_blend(const mt_morph *morph, mt_weights weights, const mt_params *params, mt_arena *arena,
                         mt_shape *blend);

/* The same as curves: the contours of aligned components as they are, the others' union fitted; where these
 * overlap, or a contour crosses itself, the union of all, fitted. */
mt_status mt_morph_outline(const mt_morph *morph, mt_weights weights, const mt_params *params,
                           mt_arena *arena, mt_outline *outline);

/* The outline of a shape by itself, curves fitted as in a blend. MT_NO_MEMORY. */
mt_status mt_shape_outline(const mt_shape *shape, const mt_params *params, mt_arena *arena,
                           mt_outline *outline);
