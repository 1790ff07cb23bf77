/* A move has to lead MT_OVERLAP beyond each wall at its point, and out of none of the outer triangles there. It is found by projecting on
 * one condition after the other; the outer ones, which come last, hold. */
#include "solid/overlap.h"

#include "space/vector.h"

/* Three conditions that are not far from square to each other are met in fewer; where they are not, less overlap is made. */
enum { ROUNDS = 8 };

/* Moves `move` to where it keeps a condition: at least, or at most, `far` along the normal. */
static void keep(mt_vector3 *move, mt_vector3 normal, double far, bool at_least) {
    double lacks = far - mt_dot3(*move, normal);
    if (at_least ? lacks > 0 : lacks < 0) *move = mt_plus3(*move, mt_times3(lacks, normal));
}

static void project(const mt_cells *cells, const mt_part *part, bool inner, mt_vector3 *moves,
                    const bool *moved) {
    for (int t = 0; t < part->n_triangles; t++) {
        bool is_inner = cells->walls[part->walls[t]].in_front != MT_OUTSIDE;
        const int *at = part->triangles[t].at;
        if (is_inner != inner || !(moved[at[0]] || moved[at[1]] || moved[at[2]])) continue;
        mt_plane plane = mt_part_plane(cells, part, t);
        for (int i = 0; i < 3; i++)
            if (moved[at[i]]) keep(&moves[at[i]], mt_plane_normal(&plane), inner ? MT_OVERLAP : 0, inner);
    }
}

mt_status mt_part_overlap(mt_arena *arena, const mt_cells *cells, const mt_part *part, mt_vector3 **moves) {
    mt_vector3 *made = mt_arena_new(arena, (size_t)part->n_points, sizeof *made);
    bool *moved = mt_arena_new(arena, (size_t)part->n_points, sizeof *moved);
    if (!made || !moved) return MT_NO_MEMORY;
    for (int t = 0; t < part->n_triangles; t++)
        for (int i = 0; i < 3; i++)
            if (cells->walls[part->walls[t]].in_front != MT_OUTSIDE) moved[part->triangles[t].at[i]] = true;
    for (int round = 0; round < ROUNDS; round++) {
        project(cells, part, true, made, moved);
        project(cells, part, false, made, moved);
    }
    *moves = made;
    return MT_OK;
}
