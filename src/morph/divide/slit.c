/* Opening a hole that the partner does not have, by a cut without width to a ring that the partner has.
 *
 *     A ┌─────────┐      B ┌──────┐         A slit  ┌─────────┐
 *       │  ┌───┐  │        │  ┌───┘                 │  ┌───┐──│   slit: a chord from the hole to the outer ring
 *       │  └───┘  │        │  └───┐                 │  └───┘──│   there and back; A has one ring now, like B
 *       └─────────┘        └──────┘                 └─────────┘
 *
 * The shortest chord of each of CANDIDATES runs of the hole is tried; the one that lowers the cost of aligning with the counterpart
 * most is taken, and none where no chord lowers it. O(CANDIDATES) cuts and alignments. */
#include "morph/divide/slit.h"

#include <math.h>

#include "geometry/limits.h"
#include "morph/divide/boundary_graph.h"
#include "morph/divide/cut.h"

#define CANDIDATES 12 /* runs of the hole's samples, one slit for each */

typedef struct mt_slit_candidates {
    int count;
    int chords[CANDIDATES];
} mt_slit_candidates;

/* The shortest chord from each run of the hole's samples to a ring that has a counterpart. */
static mt_slit_candidates shortest(const mt_boundary *b, int hole, const mt_ring **counterpart) {
    mt_slit_candidates candidates = {0};
    int first = b->first_of_ring[hole], count = b->first_of_ring[hole + 1] - first;
    for (int run = 0; run < CANDIDATES; run++) {
        int from = first + run * count / CANDIDATES, to = first + (run + 1) * count / CANDIDATES, best = -1;
        for (int i = b->first_chord[from]; i < b->first_chord[to]; i++) {
            int ring = mt_boundary_ring(b, b->chords[i].to);
            if (ring == hole || !counterpart[ring]) continue;
            if (best < 0 || mt_chord_length(b, i) < mt_chord_length(b, best)) best = i;
        }
        if (best >= 0) candidates.chords[candidates.count++] = best;
    }
    return candidates;
}

/* The component cut along one chord, and the ring that the cut is on. */
static mt_status cut_along(const mt_boundary *b, int chord, mt_arena *arena, mt_component *opened,
                           const mt_ring **ring) {
    const mt_half_edges *mesh = &b->meshes[0];
    bool *cut = mt_arena_new(arena, 3 * (size_t)mesh->triangle_count, sizeof *cut);
    int *part_of = mt_arena_new(arena, (size_t)mesh->triangle_count, sizeof *part_of);
    if (!cut || !part_of) return MT_NO_MEMORY;
    int edge = b->chords[chord].edge;
    cut[edge] = cut[mesh->twin[edge]] = true;
    mt_cut_plan plan = {mesh, b->drawn[0], cut};
    mt_shape parts;
    mt_status status = mt_cut(&plan, arena, &parts, part_of);
    if (status != MT_OK) return status;
    *opened = parts.components[0]; /* a cut between two rings leaves one part */
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
    mt_status status =
        mt_boundary_of(&whole, &slit->frame, settings, mt_grid_units(MT_CHORD_REACH), arena, &boundary);
    if (status != MT_OK) return status;
    mt_slit_candidates candidates = shortest(&boundary, hole, slit->counterpart);
    double least = INFINITY;
    for (int i = 0; status == MT_OK && i < candidates.count; i++) {
        int to = mt_boundary_ring(&boundary, boundary.chords[candidates.chords[i]].to);
        const mt_ring *goal = slit->counterpart[to], *ring;
        mt_component made;
        double before = 0, after = 0;
        status = cut_along(&boundary, candidates.chords[i], arena, &made, &ring);
        if (status == MT_OK)
            status = mt_pair_cost(&slit->component->rings[to], &slit->frame, goal, &slit->other_frame,
                                  settings, arena, &before);
        if (status == MT_OK)
            status = mt_pair_cost(ring, &slit->frame, goal, &slit->other_frame, settings, arena, &after);
        if (status != MT_OK || after >= before || after - before >= least) continue;
        least = after - before;
        *opened = made;
    }
    if (status == MT_OK) *done = least < INFINITY;
    return status;
}
