/* The similarity of every component of A with every one of B, by their hulls, and its relaxation both ways. O(n m) for n and m components. */
#include "morph/paper/components.h"

#include "morph/paper/relax.h"
#include "morph/paper/similarity.h"

static mt_hull *hulls_of(const mt_side *side, mt_arena *arena, mt_status *status) {
    mt_hull *hulls = mt_arena_new(arena, (size_t)side->shape.count, sizeof *hulls);
    *status = hulls ? MT_OK : MT_NO_MEMORY;
    for (int k = 0; *status == MT_OK && k < side->shape.count; k++)
        *status = mt_hull_of(&side->shape.components[k], side->box, arena, &hulls[k]);
    return hulls;
}

mt_status mt_match_sides(mt_morph *morph, const mt_params *params, mt_arena *arena) {
    int rows = morph->a.shape.count, columns = morph->b.shape.count;
    mt_status status;
    mt_hull *in_a = hulls_of(&morph->a, arena, &status);
    if (status != MT_OK) return status;
    mt_hull *in_b = hulls_of(&morph->b, arena, &status);
    if (status != MT_OK) return status;
    double *s = mt_arena_new(arena, (size_t)rows * (size_t)columns, sizeof *s);
    if (!s) return MT_NO_MEMORY;
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            s[(size_t)i * (size_t)columns + (size_t)j] = mt_similarity(&in_a[i], &in_b[j], params->weights);
    return mt_match_components(s, rows, columns, params->rounds, params->threshold, arena, &morph->matches);
}
