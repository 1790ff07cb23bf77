/* An outline's own union, and whether the outline was that already: where area is covered twice, or rings cancel, the areas or the counts
 * of rings differ. Both are exact. O(n log n) in practice for n chords. */
#include "geometry/union.h"

mt_status mt_outline_resolve(const mt_outline *outline, double tolerance, mt_arena *arena, mt_shape *shape,
                             bool *clean) {
    mt_rings drawn, resolved;
    mt_status status = mt_flatten(outline, tolerance, arena, &drawn);
    if (status == MT_OK) status = mt_union(&drawn, MT_NONZERO, arena, shape);
    if (status == MT_OK) status = mt_shape_rings(shape, arena, &resolved);
    if (status != MT_OK) return status;
    int64_t area2 = mt_component_area2(&drawn);
    *clean = resolved.count == drawn.count && (area2 < 0 ? -area2 : area2) == mt_shape_area2(shape);
    return MT_OK;
}
