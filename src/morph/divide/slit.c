#include "morph/divide/slit.h"

#include <math.h>

#include "geometry/limits.h"
#include "morph/divide/boundary_graph.h"
#include "morph/divide/cut.h"

#define REACH 300.0 /* of a slit, 1/1000 em */
#define TRIES 12    /* stretches of the hole, of each of which the shortest slit is looked at */

typedef struct mt_tries {
    int count;
    int chords[TRIES];
} mt_tries;

/* The shortest chord of each stretch of the hole to a ring that has a counterpart. */
static mt_tries shortest(const mt_boundary *b, int hole, const mt_ring **counterpart) {
    mt_tries tries = {0};
    int first = b->first_of_ring[hole], count = b->first_of_ring[hole + 1] - first;
    for (int stretch = 0; stretch < TRIES; stretch++) {
        int from = first + stretch * count / TRIES, to = first + (stretch + 1) * count / TRIES, best = -1;
        for (int i = b->first_chord[from]; i < b->first_chord[to]; i++) {
            int ring = mt_boundary_ring(b, b->chords[i].to);
            if (ring == hole || !counterpart[ring]) continue;
            if (best < 0 || mt_chord_length(b, i) < mt_chord_length(b, best)) best = i;
        }
        if (best >= 0) tries.chords[tries.count++] = best;
    }
    return tries;
}

/* The component cut along one chord, and the ring that the cut is on. */
static mt_status cut_along(const mt_boundary *b, int chord, mt_arena *arena, mt_component *opened,
                           const mt_ring **ring) {
    const mt_mesh *mesh = &b->meshes[0];
    bool *cut = mt_arena_new(arena, 3 * (size_t)mesh->triangle_count, sizeof *cut);
    int *part_of = mt_arena_new(arena, (size_t)mesh->triangle_count, sizeof *part_of);
    if (!cut || !part_of) return MT_NO_MEMORY;
    int edge = b->chords[chord].edge;
    cut[edge] = cut[mesh->twin[edge]] = true;
    mt_stencil ink = {mesh, b->drawn[0], cut};
    mt_shape parts;
    mt_status status = mt_cut(&ink, arena, &parts, part_of);
    if (status != MT_OK) return status;
    *opened = parts.components[0]; /* between two rings, a cut parts nothing */
    *ring = &opened->rings[0];
    for (int r = 0; r < opened->count; r++)
        for (int i = 0; i < opened->rings[r].count; i++)
            if (mt_point_equal(opened->rings[r].points[i], mesh->points[mesh->start[edge]]))
                *ring = &opened->rings[r];
    return MT_OK;
}

mt_status mt_slit(const mt_slit_case *slit, int hole, const mt_settings *settings, mt_arena *arena,
                  mt_component *opened, bool *done) {
    mt_boundary boundary;
    mt_shape whole = {1, (mt_component *)slit->component};
    mt_status status = mt_boundary_of(&whole, slit->box, settings, mt_grid_units(REACH), arena, &boundary);
    if (status != MT_OK) return status;
    mt_tries tries = shortest(&boundary, hole, slit->counterpart);
    double least = INFINITY;
    for (int i = 0; status == MT_OK && i < tries.count; i++) {
        int to = mt_boundary_ring(&boundary, boundary.chords[tries.chords[i]].to);
        const mt_ring *goal = slit->counterpart[to], *ring;
        mt_component made;
        double before = 0, after = 0;
        status = cut_along(&boundary, tries.chords[i], arena, &made, &ring);
        if (status == MT_OK)
            status = mt_pair_cost(&slit->component->rings[to], slit->box, goal, slit->other_box, settings,
                                  arena, &before);
        if (status == MT_OK)
            status = mt_pair_cost(ring, slit->box, goal, slit->other_box, settings, arena, &after);
        if (status != MT_OK || after >= before || after - before >= least) continue;
        least = after - before;
        *opened = made;
    }
    if (status == MT_OK) *done = least < INFINITY;
    return status;
}
