/* Section 2.1 in space, and the attributes of section 2.2.1. Invariant: pieces are numbered as the cells are; components by their first
 * piece. */
#include "solid/half.h"

#include "solid/decompose.h"
#include "space/vector.h"

/* ---- barycentres --------------------------------------------------------------------------------------- */

/* Adds six times the volume of the cone over a triangle from `from`, and its barycentre times that. */
static void add_cone(mt_vector3 a, mt_vector3 b, mt_vector3 c, mt_vector3 from, double *volume6,
                     mt_vector3 *moment) {
    double v = mt_dot3(mt_minus3(a, from), mt_cross3(mt_minus3(b, from), mt_minus3(c, from)));
    mt_vector3 middle = mt_times3(0.25, mt_plus3(mt_plus3(a, b), mt_plus3(c, from)));
    *volume6 += v;
    *moment = mt_plus3(*moment, mt_times3(v, middle));
}

static mt_vector3 piece_centre(const mt_part *part, double *volume) {
    double volume6 = 0;
    mt_vector3 moment = {0, 0, 0}, from = part->places[0];
    for (int t = 0; t < part->n_triangles; t++) {
        const int *at = part->triangles[t].at;
        add_cone(part->places[at[0]], part->places[at[1]], part->places[at[2]], from, &volume6, &moment);
    }
    *volume = volume6 / 6;
    return volume6 > 0 ? mt_times3(1 / volume6, moment) : from;
}

static mt_vector3 hull_centre(const mt_vector3 *points, const mt_polytope *hull) {
    double volume6 = 0;
    mt_vector3 moment = {0, 0, 0}, from = points[hull->facets[0].corners[0]];
    for (int f = 0; f < hull->n_facets; f++) {
        const mt_hull_facet *facet = &hull->facets[f];
        for (int i = 1; i + 1 < facet->n_corners; i++)
            add_cone(points[facet->corners[0]], points[facet->corners[i]], points[facet->corners[i + 1]],
                     from, &volume6, &moment);
    }
    return volume6 > 0 ? mt_times3(1 / volume6, moment) : from;
}

/* ---- boxes --------------------------------------------------------------------------------------------- */

typedef struct mt_box3 {
    mt_vector3 low, high;
} mt_box3;

static mt_box3 box_around(const mt_vector3 *points, int n) {
    mt_box3 box = {points[0], points[0]};
    for (int i = 1; i < n; i++) {
        mt_vector3 p = points[i];
        box.low = (mt_vector3){fmin(box.low.x, p.x), fmin(box.low.y, p.y), fmin(box.low.z, p.z)};
        box.high = (mt_vector3){fmax(box.high.x, p.x), fmax(box.high.y, p.y), fmax(box.high.z, p.z)};
    }
    return box;
}

/* A place in the box, 0 … 1 on each axis; a side is a grid unit at least. */
static mt_vector3 relative(const mt_box3 *box, mt_vector3 p) {
    mt_vector3 sides = mt_minus3(box->high, box->low), to = mt_minus3(p, box->low);
    return (mt_vector3){to.x / fmax(sides.x, 1), to.y / fmax(sides.y, 1), to.z / fmax(sides.z, 1)};
}

/* ---- pieces -------------------------------------------------------------------------------------------- */

static mt_status measure_piece(mt_arena *arena, mt_half *half, int i, const mt_box3 *box) {
    mt_status status = mt_part_of(arena, &half->cells, i, -1, &half->parts[i]);
    if (status != MT_OK) return status;
    half->centres[i] = piece_centre(&half->parts[i], &half->volumes[i]);
    half->places[i] = relative(box, half->centres[i]);
    return MT_OK;
}

static mt_status measure_pieces(mt_arena *arena, mt_half *half, const mt_box3 *box) {
    size_t n = (size_t)half->n_pieces;
    half->parts = mt_arena_new(arena, n, sizeof *half->parts);
    half->places = mt_arena_new(arena, n, sizeof *half->places);
    half->volumes = mt_arena_new(arena, n, sizeof *half->volumes);
    half->meets = mt_arena_new(arena, n * n, sizeof *half->meets);
    half->centres = mt_arena_new(arena, n, sizeof *half->centres);
    if (!half->parts || !half->places || !half->centres || !half->volumes || !half->meets)
        return MT_NO_MEMORY;
    for (size_t i = 0; i < n; i++) half->meets[i * n + i] = true;
    for (int w = 0; w < half->cells.n_walls; w++) {
        const mt_wall *wall = &half->cells.walls[w];
        if (wall->in_front == MT_OUTSIDE) continue;
        half->meets[(size_t)wall->behind * n + (size_t)wall->in_front] = true;
        half->meets[(size_t)wall->in_front * n + (size_t)wall->behind] = true;
    }
    mt_status status = MT_OK;
    for (int i = 0; status == MT_OK && i < half->n_pieces; i++) status = measure_piece(arena, half, i, box);
    return status;
}

mt_status mt_half_make_pieces(mt_arena *arena, mt_half *half) {
    mt_status status = MT_OK;
    half->pieces = mt_arena_new(arena, (size_t)half->n_pieces, sizeof *half->pieces);
    if (!half->pieces) return MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < half->n_pieces; i++)
        status = mt_piece_of(arena, &half->parts[i], &half->pieces[i]);
    return status;
}

/* ---- components ---------------------------------------------------------------------------------------- */

/* Numbers the components: pieces that hang together. */
static mt_status find_components(mt_arena *arena, mt_half *half) {
    int n = half->n_pieces, *stack = mt_arena_new(arena, (size_t)n, sizeof *stack);
    half->component_of = mt_arena_new(arena, (size_t)n, sizeof *half->component_of);
    if (!stack || !half->component_of) return MT_NO_MEMORY;
    for (int i = 0; i < n; i++) half->component_of[i] = -1;
    for (int i = 0; i < n; i++) {
        if (half->component_of[i] >= 0) continue;
        int depth = 0;
        half->component_of[i] = half->n_components;
        stack[depth++] = i;
        while (depth > 0) {
            int here = stack[--depth];
            for (int k = 0; k < n; k++) {
                if (!half->meets[(size_t)here * (size_t)n + (size_t)k] || half->component_of[k] >= 0)
                    continue;
                half->component_of[k] = half->n_components;
                stack[depth++] = k;
            }
        }
        half->n_components++;
    }
    return MT_OK;
}

static mt_status measure_component(mt_arena *arena, const mt_half *half, int component, const mt_box3 *box,
                                   mt_bulk *bulk) {
    int room = 0, n = 0;
    mt_polytope hull;
    for (int i = 0; i < half->n_pieces; i++)
        room += half->component_of[i] == component ? half->parts[i].n_points : 0;
    mt_vector3 *points = mt_arena_new(arena, (size_t)room, sizeof *points);
    if (!points) return MT_NO_MEMORY;
    for (int i = 0; i < half->n_pieces; i++)
        for (int p = 0; half->component_of[i] == component && p < half->parts[i].n_points; p++)
            points[n++] = half->parts[i].places[p];
    mt_status status = mt_polytope_around(arena, points, n, &hull);
    if (status != MT_OK) return status;
    mt_box3 own = box_around(points, n);
    mt_vector3 sides = mt_minus3(box->high, box->low), centre = relative(box, hull_centre(points, &hull)),
               low = relative(box, own.low), high = relative(box, own.high);
    double longest = fmax(sides.x, fmax(sides.y, sides.z));
    *bulk = (mt_bulk){{centre.x, centre.y, centre.z},
                      hull.volume / (longest * longest * longest),
                      {low.x, low.y, low.z},
                      {high.x, high.y, high.z}};
    return MT_OK;
}

static mt_status measure_components(mt_arena *arena, mt_half *half, const mt_box3 *box) {
    half->n_components = 0;
    mt_status status = find_components(arena, half);
    if (status != MT_OK) return status;
    half->components = mt_arena_new(arena, (size_t)half->n_components, sizeof *half->components);
    if (!half->components) return MT_NO_MEMORY;
    for (int k = 0; status == MT_OK && k < half->n_components; k++)
        status = measure_component(arena, half, k, box, &half->components[k]);
    return status;
}

mt_status mt_half_measure(mt_arena *arena, mt_half *half) {
    const mt_cells *cells = &half->cells;
    mt_vector3 *places = mt_arena_new(arena, (size_t)cells->n_points, sizeof *places);
    if (!places) return MT_NO_MEMORY;
    for (int p = 0; p < cells->n_points; p++) places[p] = mt_place_vector(cells->points[p]);
    mt_box3 box = box_around(places, cells->n_points);
    half->n_pieces = cells->n_cells;
    mt_status status = measure_pieces(arena, half, &box);
    return status == MT_OK ? measure_components(arena, half, &box) : status;
}

mt_status mt_half_of(mt_arena *arena, const mt_mesh *mesh, const mt_solid_params *params, mt_half *half) {
    mt_half made = {0};
    mt_status status = mt_cells_of(arena, mesh, &made.cells);
    made.depth = params->method == MT_METHOD_PAPER ? 0 : params->depth * made.cells.diagonal;
    if (status == MT_OK) status = mt_cells_decompose(&made.cells, made.depth);
    if (status == MT_OK) status = mt_half_measure(arena, &made);
    if (status == MT_OK) *half = made;
    return status;
}

static int compare(double x, double y) {
    return (x > y) - (x < y);
}

int mt_half_compare(const mt_half *p, const mt_half *q) {
    int order = compare(q->n_pieces, p->n_pieces);
    for (int i = 0; order == 0 && i < p->n_pieces; i++) {
        order = compare(p->volumes[i], q->volumes[i]);
        if (order == 0) order = compare(p->places[i].x, q->places[i].x);
        if (order == 0) order = compare(p->places[i].y, q->places[i].y);
        if (order == 0) order = compare(p->places[i].z, q->places[i].z);
    }
    return order;
}

/* ---- the similar function ------------------------------------------------------------------------------ */

/* v1: 1 less the squared distance of the barycentres, relative to how far from the corner they lie. */
static double alike_in_place(const mt_bulk *h1, const mt_bulk *h2) {
    double distance2 = 0, far1 = 0, far2 = 0;
    for (int i = 0; i < 3; i++) {
        distance2 += (h1->centre[i] - h2->centre[i]) * (h1->centre[i] - h2->centre[i]);
        far1 += h1->centre[i];
        far2 += h2->centre[i];
    }
    double scale = far1 * far1 + far2 * far2;
    return scale > 0 ? 1 - distance2 / scale : 1;
}

/* v2: 1 less the difference of the volumes relative to the larger. */
static double alike_in_volume(const mt_bulk *h1, const mt_bulk *h2) {
    double larger = fmax(h1->volume, h2->volume);
    return larger > 0 ? 1 - fabs(h1->volume - h2->volume) / larger : 1;
}

/* v3: 1 less the mean of the differences of the six extremes. */
static double alike_in_box(const mt_bulk *h1, const mt_bulk *h2) {
    double sum = 0;
    for (int i = 0; i < 3; i++) sum += fabs(h1->low[i] - h2->low[i]) + fabs(h1->high[i] - h2->high[i]);
    return 1 - sum / 6;
}

double mt_bulk_similarity(const mt_bulk *h1, const mt_bulk *h2, const double weights[3]) {
    return weights[0] * alike_in_place(h1, h2) + weights[1] * alike_in_volume(h1, h2) +
           weights[2] * alike_in_box(h1, h2);
}
