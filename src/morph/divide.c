#include "morph/divide.h"

#include <math.h>

#include "geometry/limits.h"
#include "geometry/triangulate.h"
#include "geometry/union.h"

/* What a cut costs per unit of its length, beside a unit of area that is a unit away from its partner: 1/1000 em. */
#define CUT_PRICE 60.0
#define ROUNDS 30

typedef struct mt_division {
    mt_mesh mesh;
    int count;     /* of partners */
    double *price; /* of each triangle with each partner */
    int *label;    /* the partner of each triangle */
    int *island;   /* scratch: the connected part of equal label that each triangle is in */
    int *stack;
} mt_division;

/* ---- how far ink is ------------------------------------------------------------------------------------ */

typedef struct mt_spot {
    double x, y; /* 1/1000 em */
} mt_spot;

static double to_segment(mt_spot p, mt_spot a, mt_spot b) {
    double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    double t = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
    t = fmin(1, fmax(0, t));
    return hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/* The distance from a spot to a component's ink; 0 inside. */
static double to_ink(mt_spot p, const mt_component *component) {
    double least = INFINITY;
    bool inside = false;
    for (int i = 0; i < component->count; i++) {
        const mt_ring *ring = &component->rings[i];
        for (int k = 0; k < ring->count; k++) {
            mt_point u = ring->points[k], v = ring->points[(k + 1) % ring->count];
            mt_spot a = {u.x * 1000.0 / MT_EM, u.y * 1000.0 / MT_EM},
                    b = {v.x * 1000.0 / MT_EM, v.y * 1000.0 / MT_EM};
            least = fmin(least, to_segment(p, a, b));
            if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
    }
    return inside ? 0 : least;
}

/* A place of one glyph at the same place in another's box, 1/1000 em. */
static mt_spot moved(double x, double y, mt_box from, mt_box to) {
    double s = (x - from.min.x) / mt_box_width(from), t = (y - from.min.y) / mt_box_height(from);
    return (mt_spot){(to.min.x + s * mt_box_width(to)) * 1000 / MT_EM,
                     (to.min.y + t * mt_box_height(to)) * 1000 / MT_EM};
}

static mt_point corner(const mt_mesh *mesh, int e) {
    return mesh->points[mesh->start[e]];
}

static void price_triangle(mt_division *d, int t, const mt_side *from, const mt_side *to,
                           const int *partners) {
    mt_point a = corner(&d->mesh, 3 * t), b = corner(&d->mesh, 3 * t + 1), c = corner(&d->mesh, 3 * t + 2);
    double area = (double)mt_orient(a, b, c) / 2 * (1000.0 / MT_EM) * (1000.0 / MT_EM);
    mt_spot centre = moved(((double)a.x + b.x + c.x) / 3, ((double)a.y + b.y + c.y) / 3, from->box, to->box);
    for (int l = 0; l < d->count; l++)
        d->price[t * d->count + l] = area * to_ink(centre, &to->shape.components[partners[l]]);
}

/* ---- labels -------------------------------------------------------------------------------------------- */

static double edge_length(const mt_mesh *mesh, int e) {
    int after = e % 3 == 2 ? e - 2 : e + 1;
    return sqrt((double)mt_distance2(corner(mesh, e), corner(mesh, after))) * 1000 / MT_EM;
}

/* The price of triangle t with label l: its own, and that of its cuts against the neighbours' present labels. */
static double label_price(const mt_division *d, int t, int l) {
    double price = d->price[t * d->count + l];
    for (int e = 3 * t; e < 3 * t + 3; e++) {
        int twin = d->mesh.twin[e];
        if (twin >= 0 && d->label[twin / 3] != l) price += CUT_PRICE * edge_length(&d->mesh, e);
    }
    return price;
}

static int cheapest(const mt_division *d, int t, bool with_cuts) {
    int best = 0;
    double least = INFINITY;
    for (int l = 0; l < d->count; l++) {
        double price = with_cuts ? label_price(d, t, l) : d->price[t * d->count + l];
        if (price >= least) continue;
        least = price;
        best = l;
    }
    return best;
}

/* Iterated conditional modes (J. Besag, "On the statistical analysis of dirty pictures", 1986). */
static void choose_labels(mt_division *d) {
    for (int t = 0; t < d->mesh.triangle_count; t++) d->label[t] = cheapest(d, t, false);
    bool changed = true;
    for (int round = 0; round < ROUNDS && changed; round++) {
        changed = false;
        for (int t = 0; t < d->mesh.triangle_count; t++) {
            int label = cheapest(d, t, true);
            changed |= label != d->label[t];
            d->label[t] = label;
        }
    }
}

/* ---- islands ------------------------------------------------------------------------------------------- */

static double triangle_area(const mt_mesh *mesh, int t) {
    return (double)mt_orient(corner(mesh, 3 * t), corner(mesh, 3 * t + 1), corner(mesh, 3 * t + 2));
}

/* Numbers the island around triangle t; returns its area. */
static double flood(mt_division *d, int t, int number) {
    double area = 0;
    int count = 0;
    d->stack[count++] = t;
    d->island[t] = number;
    while (count > 0) {
        int u = d->stack[--count];
        area += triangle_area(&d->mesh, u);
        for (int e = 3 * u; e < 3 * u + 3; e++) {
            int v = d->mesh.twin[e] >= 0 ? d->mesh.twin[e] / 3 : -1;
            if (v < 0 || d->island[v] >= 0 || d->label[v] != d->label[u]) continue;
            d->island[v] = number;
            d->stack[count++] = v;
        }
    }
    return area;
}

/* Numbers all islands; main[l] becomes the largest of label l, or -1 when there is none. */
static void find_islands(mt_division *d, int *main_island, double *main_area) {
    int number = 0;
    for (int t = 0; t < d->mesh.triangle_count; t++) d->island[t] = -1;
    for (int l = 0; l < d->count; l++) main_island[l] = -1, main_area[l] = 0;
    for (int t = 0; t < d->mesh.triangle_count; t++) {
        if (d->island[t] >= 0) continue;
        int l = d->label[t];
        double area = flood(d, t, number);
        if (area > main_area[l]) main_island[l] = number, main_area[l] = area;
        number++;
    }
}

/* Gives each triangle that is cut off from its label's largest island to a neighbour that is not. Whether any changed hands. */
static bool absorb_strays(mt_division *d, const int *main_island) {
    bool changed = false;
    for (int t = 0; t < d->mesh.triangle_count; t++) {
        if (d->island[t] == main_island[d->label[t]]) continue;
        double longest = 0;
        for (int e = 3 * t; e < 3 * t + 3; e++) {
            int v = d->mesh.twin[e] >= 0 ? d->mesh.twin[e] / 3 : -1;
            bool settled = v >= 0 && d->island[v] == main_island[d->label[v]];
            if (!settled || edge_length(&d->mesh, e) <= longest) continue;
            longest = edge_length(&d->mesh, e);
            d->label[t] = d->label[v];
            d->island[t] = d->island[v];
            changed = true;
        }
    }
    return changed;
}

static mt_status settle_islands(mt_division *d, mt_arena *arena) {
    int *main_island = mt_arena_new(arena, (size_t)d->count, sizeof *main_island);
    double *main_area = mt_arena_new(arena, (size_t)d->count, sizeof *main_area);
    if (!main_island || !main_area) return MT_NO_MEMORY;
    find_islands(d, main_island, main_area);
    while (absorb_strays(d, main_island)) {
    }
    return MT_OK;
}

/* ---- shares -------------------------------------------------------------------------------------------- */

/* The union of the triangles of label l. *whole: it is one component. */
static mt_status take_share(const mt_division *d, int l, mt_arena *arena, mt_component *share, bool *whole) {
    mt_rings triangles = {0, mt_arena_new(arena, (size_t)d->mesh.triangle_count, sizeof(mt_ring))};
    if (!triangles.rings) return MT_NO_MEMORY;
    for (int t = 0; t < d->mesh.triangle_count; t++) {
        if (d->label[t] != l) continue;
        mt_ring *ring = &triangles.rings[triangles.count++];
        mt_status status = mt_ring_new(arena, 3, ring);
        if (status != MT_OK) return status;
        for (int i = 0; i < 3; i++) {
            ring->points[i] = corner(&d->mesh, 3 * t + i);
            ring->marks[i] = d->mesh.marks[3 * t + i];
        }
    }
    mt_shape shape;
    mt_status status = mt_union(&triangles, arena, &shape);
    if (status != MT_OK) return status;
    *whole = shape.count == 1;
    if (*whole) *share = shape.components[0];
    return MT_OK;
}

static mt_status start_division(const mt_component *component, int count, mt_arena *arena, mt_division *d) {
    mt_status status = mt_triangulate(component, arena, &d->mesh);
    if (status != MT_OK) return status;
    size_t triangles = (size_t)d->mesh.triangle_count;
    d->count = count;
    d->price = mt_arena_new(arena, triangles * (size_t)count, sizeof(double));
    d->label = mt_arena_new(arena, triangles, sizeof(int));
    d->island = mt_arena_new(arena, triangles, sizeof(int));
    d->stack = mt_arena_new(arena, triangles, sizeof(int));
    return d->price && d->label && d->island && d->stack ? MT_OK : MT_NO_MEMORY;
}

mt_status mt_divide(const mt_side *from, int k, const mt_side *to, const int *partners, int count,
                    mt_arena *arena, mt_component *shares, bool *divided) {
    mt_division d;
    mt_status status = start_division(&from->shape.components[k], count, arena, &d);
    if (status != MT_OK) return status;
    for (int t = 0; t < d.mesh.triangle_count; t++) price_triangle(&d, t, from, to, partners);
    choose_labels(&d);
    status = settle_islands(&d, arena);
    *divided = true;
    for (int l = 0; status == MT_OK && l < count && *divided; l++)
        status = take_share(&d, l, arena, &shares[l], divided);
    return status;
}
