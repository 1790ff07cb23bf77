/* From two meshes to the morph between them: the stages in their order. All of it starts from the solid that comes first in an order of
 * their own, so that swapping the two swaps the ends of the same morph. */
#include "solid/solid_morph.h"

#include <math.h>

#include "arithmetic/angles.h"
#include "solid/half.h"
#include "solid/limits.h"
#include "solid/links.h"
#include "solid/overlap.h"
#include "solid/share.h"
#include "solid/sum.h"
#include "space/vector.h"

/* ---- formula (5) --------------------------------------------------------------------------------------- */

/* A place turned about an axis of length 1 through a centre (O. Rodrigues' formula). */
static mt_vector3 turned(mt_vector3 p, mt_vector3 centre, mt_vector3 axis, double degrees) {
    double angle = degrees * M_PI / 180;
    mt_vector3 v = mt_minus3(p, centre);
    mt_vector3 along = mt_times3(mt_dot3(axis, v) * (1 - mt_cos(angle)), axis);
    mt_vector3 across = mt_times3(mt_sin(angle), mt_cross3(axis, v));
    return mt_plus3(centre, mt_plus3(mt_times3(mt_cos(angle), v), mt_plus3(across, along)));
}

static mt_vector3 middle_of(const mt_mesh *mesh) {
    if (mesh->n_points <= 0) return (mt_vector3){0, 0, 0};
    mt_vector3 low = mesh->points[0], high = low;
    for (int i = 1; i < mesh->n_points; i++) {
        mt_vector3 p = mesh->points[i];
        low = (mt_vector3){fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z)};
        high = (mt_vector3){fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z)};
    }
    return mt_between3(low, high, 0.5);
}

/* B turned back about the middle of its box. */
static mt_status turn_back(mt_arena *arena, const mt_mesh *b, mt_solid_morph *morph, mt_mesh *made) {
    *made = *b;
    if (morph->degrees == 0 || b->n_points <= 0) return MT_OK;
    made->points = mt_arena_new(arena, (size_t)b->n_points, sizeof *made->points);
    if (!made->points) return MT_NO_MEMORY;
    for (int i = 0; i < b->n_points; i++)
        made->points[i] = turned(b->points[i], morph->middle_b, morph->axis, -morph->degrees);
    return MT_OK;
}

static void take_rotation(const mt_mesh *a, const mt_mesh *b, const mt_solid_params *params,
                          mt_solid_morph *morph) {
    double length = mt_length3(params->axis);
    morph->axis = length > 0 ? mt_times3(1 / length, params->axis) : (mt_vector3){0, 0, 1};
    morph->degrees = length > 0 ? params->degrees : 0;
    morph->middle_a = middle_of(a);
    morph->middle_b = middle_of(b);
}

/* ---- sides --------------------------------------------------------------------------------------------- */

static mt_status take_side(mt_arena *arena, const mt_half *half, mt_solid_side *side) {
    side->n_components = half->n_components;
    side->n_pieces = half->n_pieces;
    side->component_of = half->component_of;
    side->pieces = mt_arena_new(arena, (size_t)half->n_pieces, sizeof *side->pieces);
    if (!side->pieces) return MT_NO_MEMORY;
    for (int i = 0; i < half->n_pieces; i++) {
        const mt_part *part = &half->pieces[i].part;
        mt_vector3 *points = mt_arena_new(arena, (size_t)part->n_points, sizeof *points);
        mt_vector3 *moves;
        mt_status status = mt_part_overlap(arena, &half->cells, part, &moves);
        if (status != MT_OK || !points) return status != MT_OK ? status : MT_NO_MEMORY;
        for (int p = 0; p < part->n_points; p++)
            points[p] =
                mt_plus3(mt_cells_place(&half->cells, part->point[p]), mt_times3(half->cells.unit, moves[p]));
        side->pieces[i] = (mt_mesh){part->n_points, part->n_triangles, points, part->triangles};
    }
    return MT_OK;
}

/* ---- links --------------------------------------------------------------------------------------------- */

static mt_status take_link(mt_arena *arena, const mt_mesh *of_x, const mt_mesh *of_y, const mt_sum *sum,
                           mt_vector3 **at_x, mt_vector3 **at_y) {
    *at_x = mt_arena_new(arena, (size_t)sum->n_points, sizeof **at_x);
    *at_y = mt_arena_new(arena, (size_t)sum->n_points, sizeof **at_y);
    if (!*at_x || !*at_y) return MT_NO_MEMORY;
    for (int i = 0; i < sum->n_points; i++) {
        (*at_x)[i] = of_x->points[sum->of_x[i]];
        (*at_y)[i] = of_y->points[sum->of_y[i]];
    }
    return MT_OK;
}

/* Links two halves, and divides their pieces unless they are the paper's. */
static mt_status link_halves(mt_arena *arena, mt_half *first, mt_half *second, mt_method method,
                             mt_links *links) {
    mt_status status = mt_link_halves(arena, first, second, links);
    if (status == MT_OK && method != MT_METHOD_PAPER) {
        status = mt_links_share(arena, first, second, links);
        if (status == MT_OK) status = mt_links_join(arena, first, second, links);
    }
    if (status == MT_OK) status = mt_half_make_pieces(arena, first);
    return status == MT_OK ? mt_half_make_pieces(arena, second) : status;
}

static mt_status take_links(mt_arena *arena, const mt_half *first, const mt_half *second,
                            const mt_links *links, bool swapped, mt_solid_morph *morph) {
    mt_status status = MT_OK;
    int n_triangles = 0;
    morph->n_links = links->count;
    morph->links = mt_arena_new(arena, (size_t)links->count, sizeof *morph->links);
    if (!morph->links) return MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < links->count; i++) {
        int x = links->links[i].a, y = links->links[i].b;
        mt_solid_link *link = &morph->links[i];
        mt_sum sum;
        status = mt_sum_of(arena, &first->pieces[x], &second->pieces[y], &sum);
        if (status != MT_OK) break;
        *link = (mt_solid_link){swapped ? y : x, swapped ? x : y, sum.n_points, sum.n_triangles, NULL, NULL,
                                sum.triangles};
        status =
            swapped
                ? take_link(arena, &morph->b.pieces[x], &morph->a.pieces[y], &sum, &link->at_b, &link->at_a)
                : take_link(arena, &morph->a.pieces[x], &morph->b.pieces[y], &sum, &link->at_a, &link->at_b);
        n_triangles += sum.n_triangles;
        if (status == MT_OK && n_triangles > MT_SOLID_TRIANGLES_MAX) status = MT_TOO_LARGE;
    }
    return status;
}

mt_status mt_solid_prepare(mt_arena *arena, const mt_mesh *a, const mt_mesh *b, const mt_solid_params *params,
                           mt_solid_morph *morph) {
    mt_solid_morph made = {0};
    mt_mesh back;
    mt_half halves[2];
    mt_links links;
    take_rotation(a, b, params, &made);
    mt_status status = turn_back(arena, b, &made, &back);
    if (status == MT_OK) status = mt_half_of(arena, a, params, &halves[0]);
    if (status == MT_OK) status = mt_half_of(arena, &back, params, &halves[1]);
    if (status != MT_OK) return status;
    bool swapped = mt_half_compare(&halves[0], &halves[1]) > 0;
    status = link_halves(arena, &halves[swapped], &halves[!swapped], params->method, &links);
    if (status == MT_OK) status = take_side(arena, &halves[0], &made.a);
    if (status == MT_OK) status = take_side(arena, &halves[1], &made.b);
    if (status == MT_OK)
        status = take_links(arena, &halves[swapped], &halves[!swapped], &links, swapped, &made);
    if (status == MT_OK) *morph = made;
    return status;
}

/* ---- the solid at r ------------------------------------------------------------------------------------ */

mt_status mt_solid_at(mt_arena *arena, const mt_solid_morph *morph, double r, mt_mesh *mesh) {
    mt_mesh made = {0};
    mt_vector3 centre = mt_between3(morph->middle_b, morph->middle_a, r);
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
        for (int k = 0; k < link->n_points; k++, p++) {
            mt_vector3 at = mt_plus3(mt_times3(r, link->at_a[k]), mt_times3(1 - r, link->at_b[k]));
            made.points[p] =
                morph->degrees == 0 ? at : turned(at, centre, morph->axis, (1 - r) * morph->degrees);
        }
    }
    *mesh = made;
    return MT_OK;
}
