/* From two meshes to the morph between them: the stages in their order. */
#include "solid/solid_morph.h"

#include <math.h>

#include "solid/cells.h"
#include "solid/piece.h"
#include "solid/sum.h"
#include "space/vector.h"

/* One solid on the way to its pieces. */
typedef struct mt_solid_work {
    mt_cells cells;
    mt_piece *pieces;
} mt_solid_work;

static mt_status side_of(mt_arena *arena, const mt_mesh *mesh, mt_solid_work *work, mt_solid_side *side) {
    mt_status status = mt_cells_of(arena, mesh, &work->cells);
    if (status != MT_OK) return status;
    int n = work->cells.n_cells;
    side->n_components = n;
    side->n_pieces = n;
    work->pieces = mt_arena_new(arena, (size_t)n, sizeof *work->pieces);
    side->pieces = mt_arena_new(arena, (size_t)n, sizeof *side->pieces);
    side->component_of = mt_arena_new(arena, (size_t)n, sizeof *side->component_of);
    if (!work->pieces || !side->pieces || !side->component_of) return MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < n; i++) {
        mt_part part;
        side->component_of[i] = i;
        status = mt_part_of(arena, &work->cells, i, &part);
        if (status == MT_OK) status = mt_piece_of(arena, &part, &work->pieces[i]);
        if (status != MT_OK) break;
        mt_mesh *made = &side->pieces[i];
        *made = (mt_mesh){part.n_points, part.n_triangles,
                          mt_arena_new(arena, (size_t)part.n_points, sizeof(mt_vector3)), part.triangles};
        if (!made->points) return MT_NO_MEMORY;
        for (int p = 0; p < part.n_points; p++) made->points[p] = mt_cells_place(&work->cells, part.point[p]);
    }
    return status;
}

static mt_status link_of(mt_arena *arena, const mt_solid_work *a, const mt_solid_work *b,
                         mt_solid_morph *morph, mt_solid_link *link) {
    mt_sum sum;
    mt_status status = mt_sum_of(arena, &a->pieces[link->piece_a], &b->pieces[link->piece_b], &sum);
    if (status != MT_OK) return status;
    link->n_points = sum.n_points;
    link->n_triangles = sum.n_triangles;
    link->triangles = sum.triangles;
    link->at_a = mt_arena_new(arena, (size_t)sum.n_points, sizeof *link->at_a);
    link->at_b = mt_arena_new(arena, (size_t)sum.n_points, sizeof *link->at_b);
    if (!link->at_a || !link->at_b) return MT_NO_MEMORY;
    for (int i = 0; i < sum.n_points; i++) {
        link->at_a[i] = morph->a.pieces[link->piece_a].points[sum.of_x[i]];
        link->at_b[i] = morph->b.pieces[link->piece_b].points[sum.of_y[i]];
    }
    return MT_OK;
}

mt_status mt_solid_prepare(mt_arena *arena, const mt_mesh *a, const mt_mesh *b, const mt_solid_params *params,
                           mt_solid_morph *morph) {
    mt_solid_morph made = {.axis = {0, 0, 1}};
    mt_solid_work work_a = {0}, work_b = {0};
    (void)params;
    mt_status status = side_of(arena, a, &work_a, &made.a);
    if (status == MT_OK) status = side_of(arena, b, &work_b, &made.b);
    if (status != MT_OK) return status;
    made.n_links = made.a.n_pieces > made.b.n_pieces ? made.a.n_pieces : made.b.n_pieces;
    made.links = mt_arena_new(arena, (size_t)made.n_links, sizeof *made.links);
    if (!made.links) return MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < made.n_links; i++) {
        made.links[i].piece_a = i % made.a.n_pieces;
        made.links[i].piece_b = i % made.b.n_pieces;
        status = link_of(arena, &work_a, &work_b, &made, &made.links[i]);
    }
    if (status == MT_OK) *morph = made;
    return status;
}

mt_status mt_solid_at(mt_arena *arena, const mt_solid_morph *morph, double r, mt_mesh *mesh) {
    mt_mesh made = {0};
    for (int i = 0; i < morph->n_links; i++) {
        made.n_points += morph->links[i].n_points;
        made.n_triangles += morph->links[i].n_triangles;
    }
    made.points = mt_arena_new(arena, (size_t)made.n_points, sizeof *made.points);
    made.triangles = mt_arena_new(arena, (size_t)made.n_triangles, sizeof *made.triangles);
    if (!made.points || !made.triangles) return MT_NO_MEMORY;
    int p = 0, t = 0;
    for (int i = 0; i < morph->n_links; i++) {
        const mt_solid_link *link = &morph->links[i];
        for (int k = 0; k < link->n_triangles; k++, t++)
            for (int c = 0; c < 3; c++) made.triangles[t].at[c] = p + link->triangles[k].at[c];
        for (int k = 0; k < link->n_points; k++, p++)
            made.points[p] = mt_plus3(mt_times3(r, link->at_a[k]), mt_times3(1 - r, link->at_b[k]));
    }
    *mesh = made;
    return MT_OK;
}
