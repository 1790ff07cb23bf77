#include "morph/divide/slit.h"

#include <math.h>

#include "geometry/limits.h"
#include "morph/divide/boundary_graph.h"
#include "morph/divide/cut.h"

#define REACH 300.0 /* of a slit, 1/1000 em */
#define TRIES 12    /* stretches of the hole, of each of which the shortest slit is looked at */

typedef struct mt_tries {
    int count;
    int bridges[TRIES];
} mt_tries;

/* The shortest bridge of each stretch of the hole to a ring that has a counterpart. */
static mt_tries shortest(const mt_border *b, int hole, const mt_ring **counterpart) {
    mt_tries tries = {0};
    int first = b->first_of_ring[hole], count = b->first_of_ring[hole + 1] - first;
    for (int stretch = 0; stretch < TRIES; stretch++) {
        int from = first + stretch * count / TRIES, to = first + (stretch + 1) * count / TRIES, best = -1;
        for (int i = b->first_bridge[from]; i < b->first_bridge[to]; i++) {
            int ring = mt_border_ring(b, b->bridges[i].to);
            if (ring == hole || !counterpart[ring]) continue;
            if (best < 0 || mt_bridge_length(b, i) < mt_bridge_length(b, best)) best = i;
        }
        if (best >= 0) tries.bridges[tries.count++] = best;
    }
    return tries;
}

/* The component cut along one bridge, and the ring that the cut is on. */
static mt_status cut_along(const mt_border *b, int bridge, mt_arena *arena, mt_component *opened,
                           const mt_ring **ring) {
    const mt_mesh *mesh = &b->meshes[0];
    bool *cut = mt_arena_new(arena, 3 * (size_t)mesh->triangle_count, sizeof *cut);
    int *share_of = mt_arena_new(arena, (size_t)mesh->triangle_count, sizeof *share_of);
    if (!cut || !share_of) return MT_NO_MEMORY;
    int edge = b->bridges[bridge].edge;
    cut[edge] = cut[mesh->twin[edge]] = true;
    mt_stencil ink = {mesh, b->drawn[0], cut};
    mt_shape shares;
    mt_status status = mt_cut(&ink, arena, &shares, share_of);
    if (status != MT_OK) return status;
    *opened = shares.components[0]; /* between two rings, a cut parts nothing */
    *ring = &opened->rings[0];
    for (int r = 0; r < opened->count; r++)
        for (int i = 0; i < opened->rings[r].count; i++)
            if (mt_point_equal(opened->rings[r].points[i], mesh->points[mesh->start[edge]]))
                *ring = &opened->rings[r];
    return MT_OK;
}

mt_status mt_slit(const mt_slit_case *slit, int hole, const mt_manner *manner, mt_arena *arena,
                  mt_component *opened, bool *done) {
    mt_border border;
    mt_shape whole = {1, (mt_component *)slit->component};
    mt_status status = mt_border_of(&whole, slit->box, manner, mt_grid_units(REACH), arena, &border);
    if (status != MT_OK) return status;
    mt_tries tries = shortest(&border, hole, slit->counterpart);
    double least = INFINITY;
    for (int i = 0; status == MT_OK && i < tries.count; i++) {
        int to = mt_border_ring(&border, border.bridges[tries.bridges[i]].to);
        const mt_ring *goal = slit->counterpart[to], *ring;
        mt_component made;
        double before = 0, after = 0;
        status = cut_along(&border, tries.bridges[i], arena, &made, &ring);
        if (status == MT_OK)
            status = mt_pair_price(&slit->component->rings[to], slit->box, goal, slit->other_box, manner,
                                   arena, &before);
        if (status == MT_OK)
            status = mt_pair_price(ring, slit->box, goal, slit->other_box, manner, arena, &after);
        if (status != MT_OK || after >= before || after - before >= least) continue;
        least = after - before;
        *opened = made;
    }
    if (status == MT_OK) *done = least < INFINITY;
    return status;
}
