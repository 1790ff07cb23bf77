/* Greedy: a cell that is not near enough to convex is cut by the plane that leaves the least between its parts and their hulls; then
 * neighbours are merged as long as they are near enough together. Each cut makes cells with fewer reflex edges or less depth; there are
 * at most MT_SOLID_PIECES_MAX of them. */
#include "solid/decompose.h"

#include <stdlib.h>

#include "solid/cut.h"
#include "solid/depth.h"
#include "solid/limits.h"
#include "solid/planes.h"
#include "solid/trial.h"

/* What one part more is worth, as a share of the volume: of two cuts that leave as much, the one into fewer parts. */
#define PART_COST 0.002
/* And a handle: a part that has one has to be cut again. */
#define HANDLE_COST 0.3
/* And what it is worth that all reflex edges lie in the plane, where they need no other cut. */
#define RESOLVED_WORTH 0.05

/* ---- one cell ------------------------------------------------------------------------------------------ */

mt_status mt_part_is_done(mt_arena *arena, const mt_cells *cells, const mt_part *part, double depth,
                          bool *done, mt_depth *found) {
    mt_polytope hull;
    bool ball = false;
    mt_status status = mt_part_is_ball(arena, part, &ball);
    *done = ball && mt_part_is_convex(cells, part);
    if (status != MT_OK || *done) return status;
    status = mt_polytope_around(arena, part->places, part->n_points, &hull);
    if (status == MT_OK) status = mt_part_depth(arena, part, &hull, depth, found);
    *done = status == MT_OK && ball && depth > 0 && found->distance <= depth;
    return status;
}

typedef struct mt_ranked {
    mt_plane plane;
    double cost;
    int number;
} mt_ranked;

static int by_cost(const void *p, const void *q) {
    const mt_ranked *x = p, *y = q;
    return x->cost != y->cost ? (x->cost > y->cost) - (x->cost < y->cost)
                              : (x->number > y->number) - (x->number < y->number);
}

/* Cuts by the best plane that the cell can be cut by. */
static mt_status cut_best(mt_arena *arena, mt_cells *cells, int cell, const mt_part *part,
                          const mt_depth *found) {
    mt_planes planes;
    mt_status status = mt_planes_for(arena, cells, part, found, &planes);
    if (status != MT_OK) return status;
    mt_ranked *ranked = mt_arena_new(arena, (size_t)planes.count, sizeof *ranked);
    double volume = mt_part_volume(part);
    int n = 0;
    if (!ranked) return MT_NO_MEMORY;
    for (int i = 0; i < planes.count; i++) {
        mt_trial trial;
        status = mt_trial_of(part, &planes.planes[i], &trial);
        if (status != MT_OK) return status;
        if (trial.n_parts > 1)
            ranked[n++] = (mt_ranked){planes.planes[i],
                                      trial.excess / volume + PART_COST * trial.n_parts +
                                          HANDLE_COST * trial.n_handles - RESOLVED_WORTH * planes.resolved[i],
                                      i};
    }
    qsort(ranked, (size_t)n, sizeof *ranked, by_cost);
    status = MT_BAD_GEOMETRY;
    for (int i = 0; status == MT_BAD_GEOMETRY && i < n; i++)
        status = mt_cells_cut(cells, cell, ranked[i].plane);
    return status;
}

static mt_status refine(mt_arena *arena, mt_cells *cells, int cell, double depth, bool *done) {
    mt_part part;
    mt_depth found;
    mt_status status = mt_part_of(arena, cells, cell, -1, &part);
    if (status == MT_OK) status = mt_part_is_done(arena, cells, &part, depth, done, &found);
    if (status == MT_OK && !*done) status = cut_best(arena, cells, cell, &part, &found);
    return status;
}

static mt_status refine_all(mt_cells *cells, double depth) {
    mt_arena scratch = {0};
    mt_status status = MT_OK;
    for (int cell = 0; status == MT_OK && cell < cells->n_cells;) {
        bool done = false;
        status =
            cells->n_cells > MT_SOLID_PIECES_MAX ? MT_TOO_LARGE : refine(&scratch, cells, cell, depth, &done);
        if (done) cell++;
        mt_arena_reset(&scratch);
    }
    mt_arena_release(&scratch);
    return status;
}

/* ---- merging ------------------------------------------------------------------------------------------- */

typedef struct mt_neighbours {
    int p, q;    /* p < q */
    double area; /* of the walls between them */
} mt_neighbours;

static int by_cells(const void *p, const void *q) {
    const mt_neighbours *x = p, *y = q;
    return x->p != y->p ? (x->p > y->p) - (x->p < y->p) : (x->q > y->q) - (x->q < y->q);
}

static int by_area(const void *p, const void *q) {
    const mt_neighbours *x = p, *y = q;
    return x->area != y->area ? (x->area < y->area) - (x->area > y->area) : by_cells(p, q);
}

static mt_status find_neighbours(mt_arena *arena, const mt_cells *cells, mt_neighbours **found, int *n) {
    mt_neighbours *all = *found = mt_arena_new(arena, (size_t)cells->n_walls, sizeof *all);
    int count = 0;
    *n = 0;
    if (!all) return MT_NO_MEMORY;
    for (int w = 0; w < cells->n_walls; w++) {
        const mt_wall *wall = &cells->walls[w];
        if (wall->in_front == MT_OUTSIDE) continue;
        int p = wall->behind, q = wall->in_front;
        mt_plane plane = mt_plane_through(cells->points[wall->at[0]], cells->points[wall->at[1]],
                                          cells->points[wall->at[2]]);
        double x = (double)plane.x, y = (double)plane.y, z = (double)plane.z;
        all[count++] = (mt_neighbours){p < q ? p : q, p < q ? q : p, x * x + y * y + z * z};
    }
    qsort(all, (size_t)count, sizeof *all, by_cells);
    for (int i = 0; i < count; i++) {
        if (*n > 0 && by_cells(&all[*n - 1], &all[i]) == 0)
            all[*n - 1].area += all[i].area;
        else
            all[(*n)++] = all[i];
    }
    qsort(all, (size_t)*n, sizeof *all, by_area);
    return MT_OK;
}

/* One round over all neighbours, those with the most wall between them first; a cell takes part in one merge a round. */
static mt_status merge_round(mt_cells *cells, double depth, bool *any) {
    mt_arena pairs = {0}, scratch = {0};
    mt_neighbours *neighbours;
    int n;
    bool *merged = mt_arena_new(&pairs, (size_t)cells->n_cells, sizeof *merged);
    mt_status status = merged ? find_neighbours(&pairs, cells, &neighbours, &n) : MT_NO_MEMORY;
    *any = false;
    for (int i = 0; status == MT_OK && i < n; i++) {
        mt_part part;
        mt_depth found;
        bool done = false;
        int p = neighbours[i].p, q = neighbours[i].q;
        if (merged[p] || merged[q]) continue;
        status = mt_part_of(&scratch, cells, p, q, &part);
        if (status == MT_OK) status = mt_part_is_done(&scratch, cells, &part, depth, &done, &found);
        if (status == MT_BAD_GEOMETRY) status = MT_OK; /* not a part together */
        if (status == MT_OK && done) {
            mt_cells_merge(cells, p, q);
            *any = merged[p] = merged[q] = true;
        }
        mt_arena_reset(&scratch);
    }
    mt_arena_release(&pairs);
    mt_arena_release(&scratch);
    return status;
}

/* Numbers the cells that are left from 0, in their order. */
static mt_status renumber(mt_cells *cells) {
    int *number = mt_arena_new(cells->arena, (size_t)cells->n_cells, sizeof *number);
    if (!number) return MT_NO_MEMORY;
    for (int w = 0; w < cells->n_walls; w++) {
        number[cells->walls[w].behind] = 1;
        if (cells->walls[w].in_front != MT_OUTSIDE) number[cells->walls[w].in_front] = 1;
    }
    int n = 0;
    for (int i = 0; i < cells->n_cells; i++) number[i] = number[i] ? n++ : -1;
    for (int w = 0; w < cells->n_walls; w++) {
        cells->walls[w].behind = number[cells->walls[w].behind];
        if (cells->walls[w].in_front != MT_OUTSIDE)
            cells->walls[w].in_front = number[cells->walls[w].in_front];
    }
    cells->n_cells = n;
    return MT_OK;
}

mt_status mt_cells_decompose(mt_cells *cells, double depth) {
    mt_status status = refine_all(cells, depth);
    bool any = true;
    for (int round = 0; status == MT_OK && any && round < MT_MERGE_ROUNDS; round++)
        status = merge_round(cells, depth, &any);
    return status == MT_OK ? renumber(cells) : status;
}
