/* Sections 2.1 and 2.2.2 for a whole morph: the components that are not joined are decomposed into convex pieces, and the pieces linked, as
 * printed or evenly. Invariant: pieces are numbered through the components of a side; an aligned component has none. O(m · n) for m and n
 * pieces, and the triangulations. */
#include "morph/paper/pieces.h"

#include "geometry/decompose.h"
#include "morph/paper/links.h"

/* Decomposes the components that are not joined. */
static mt_status decompose_all(mt_side *side, mt_arena *arena) {
    mt_pieces *parts = mt_arena_new(arena, (size_t)side->shape.count, sizeof *parts);
    side->first = mt_arena_new(arena, (size_t)side->shape.count + 1, sizeof *side->first);
    if (!parts || !side->first) return MT_NO_MEMORY;
    for (int k = 0; k < side->shape.count; k++) {
        mt_status status = MT_OK;
        if (!side->aligned || !side->aligned[k])
            status = mt_decompose(&side->shape.components[k], arena, &parts[k]);
        if (status != MT_OK) return status;
        side->first[k + 1] = side->first[k] + parts[k].count;
    }
    side->pieces.count = side->first[side->shape.count];
    side->pieces.rings = mt_arena_new(arena, (size_t)side->pieces.count, sizeof(mt_ring));
    if (!side->pieces.rings) return MT_NO_MEMORY;
    for (int k = 0; k < side->shape.count; k++)
        for (int i = 0; i < parts[k].count; i++) side->pieces.rings[side->first[k] + i] = parts[k].rings[i];
    return MT_OK;
}

mt_status mt_map_pieces(mt_morph *morph, const mt_params *params, mt_arena *arena) {
    bool paper = params->method == MT_METHOD_PAPER;
    mt_status status = decompose_all(&morph->a, arena);
    if (status == MT_OK) status = decompose_all(&morph->b, arena);
    if (status != MT_OK) return status;
    return (paper ? mt_link_pieces : mt_link_evenly)(&morph->a, &morph->b, &morph->matches, params->one_scale,
                                                     arena, &morph->links);
}
