#include "morph/divide/boundary_graph.h"

#include <math.h>

#include "geometry/limits.h"

/* ---- stops ----------------------------------------------------------------------------------------------------- */

static int parts_of(mt_point a, mt_point b, double step) {
    return 1 + (int)(sqrt((double)mt_distance2(a, b)) / step);
}

/* The place k parts of the way from a to b: the same from either end, so that the two sides of a slit stay together. */
static mt_point place_between(mt_point a, mt_point b, int k, int parts) {
    if (b.x < a.x || (b.x == a.x && b.y < a.y)) return place_between(b, a, parts - k, parts);
    double s = (double)k / parts;
    return (mt_point){a.x + (int32_t)lround(s * ((double)b.x - a.x)),
                      a.y + (int32_t)lround(s * ((double)b.y - a.y))};
}

/* The ring with its long edges divided; drawn[i] tells the vertices that it had before. */
static mt_status refine(const mt_ring *ring, double step, mt_arena *arena, mt_ring *fine, bool *drawn) {
    int64_t total = 0;
    for (int i = 0; i < ring->count; i++)
        total += parts_of(ring->points[i], ring->points[(i + 1) % ring->count], step);
    if (total > MT_POINTS_MAX) return MT_TOO_LARGE;
    mt_status status = mt_ring_new(arena, (int)total, fine);
    if (status != MT_OK) return status;
    int made = 0;
    for (int i = 0; i < ring->count; i++) {
        mt_point a = ring->points[i], b = ring->points[(i + 1) % ring->count];
        int parts = parts_of(a, b, step);
        for (int k = 0; k < parts; k++, made++) {
            fine->points[made] = place_between(a, b, k, parts);
            fine->marks[made] = k ? ring->marks[i] & MT_EDGE_MARKS : ring->marks[i];
            drawn[made] = k == 0;
        }
    }
    return MT_OK;
}

static int64_t stops_in(const mt_component *component, double step) {
    int64_t total = 0;
    for (int r = 0; r < component->count; r++) {
        const mt_ring *ring = &component->rings[r];
        for (int i = 0; i < ring->count; i++)
            total += parts_of(ring->points[i], ring->points[(i + 1) % ring->count], step);
    }
    return total;
}

static mt_status view_ring(const mt_ring *ring, double chord, int first, mt_arena *arena, mt_border *border) {
    mt_trace trace;
    mt_status status = mt_trace_ring(ring, chord, arena, &trace);
    if (status != MT_OK) return status;
    for (int i = 0; i < ring->count; i++) {
        mt_stop stop = {.x = ring->points[i].x,
                        .y = ring->points[i].y,
                        .in = mt_trace_in(&trace, i),
                        .out = mt_trace_out(&trace, i)};
        border->views[first + i] = mt_view_of(&stop, border->box);
        border->places[first + i] = ring->points[i];
        border->length[first + i] = trace.length[i] / MT_EM;
        border->along[first + i] = i ? border->along[first + i - 1] + border->length[first + i - 1] : 0;
    }
    return MT_OK;
}

static mt_status add_component(const mt_component *component, int c, double chord, double step,
                               mt_arena *arena, mt_border *border) {
    mt_component fine = {component->count, mt_arena_new(arena, (size_t)component->count, sizeof(mt_ring))};
    int first = border->first_stop[c];
    border->drawn[c] = mt_arena_new(arena, (size_t)(border->first_stop[c + 1] - first), sizeof(bool));
    if (!fine.rings || !border->drawn[c]) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int r = 0, at = first; status == MT_OK && r < component->count; r++) {
        status = refine(&component->rings[r], step, arena, &fine.rings[r], border->drawn[c] + (at - first));
        if (status == MT_OK) status = view_ring(&fine.rings[r], chord, at, arena, border);
        at += fine.rings[r].count;
        border->first_of_ring[++border->ring_count] = at;
    }
    return status == MT_OK ? mt_triangulate(&fine, arena, &border->meshes[c]) : status;
}

/* ---- bridges ----------------------------------------------------------------------------------------------------- */

#define EAR 0.02           /* em */
#define EAR_SHARE 2.0      /* of the diagonal's length */
#define BRIDGE_PRICE 1.0   /* for crossing at all … */
#define BRIDGE_EM_PRICE 10 /* … and for each em of the way */

static int edge_end(const mt_mesh *mesh, int e) {
    return mesh->start[mt_mesh_after(e)];
}

static double diagonal_length(const mt_mesh *mesh, int e) {
    return sqrt((double)mt_distance2(mesh->points[mesh->start[e]], mesh->points[edge_end(mesh, e)]));
}

/* How far it is from one stop to another along their ring, the shorter way; INFINITY between rings. */
static double way_round(const mt_border *b, int from, int to) {
    int ring = mt_border_ring(b, from);
    if (to < b->first_of_ring[ring] || to >= b->first_of_ring[ring + 1]) return INFINITY;
    int last = b->first_of_ring[ring + 1] - 1;
    double whole = b->along[last] + b->length[last], way = fabs(b->along[from] - b->along[to]);
    return fmin(way, whole - way);
}

/* Whether a diagonal only cuts a corner off: the border between its ends is hardly longer. */
static bool is_ear(const mt_border *b, int from, int to, double length) {
    return way_round(b, from, to) < EAR_SHARE * length / MT_EM + EAR;
}

/* Counts the bridges of component c, or writes them when there is room for them. */
static void list_bridges(mt_border *border, int c, double reach, int *next) {
    const mt_mesh *mesh = &border->meshes[c];
    for (int e = 0; e < 3 * mesh->triangle_count; e++) {
        double length = diagonal_length(mesh, e);
        if (mesh->twin[e] < 0 || length > reach) continue;
        int from = border->first_stop[c] + mesh->start[e], to = border->first_stop[c] + edge_end(mesh, e);
        if (is_ear(border, from, to, length)) continue;
        if (border->bridges)
            border->bridges[next[from]] = (mt_bridge){to, e, BRIDGE_PRICE + BRIDGE_EM_PRICE * length / MT_EM};
        next[from]++;
    }
}

/* ---- leaps ------------------------------------------------------------------------------------------------------- */

#define LEAP_REACH 0.15  /* em */
#define LEAP_PRICE 1.0   /* for leaping at all … */
#define LEAP_EM_PRICE 10 /* … and for each em of the way */

/* How far a place is from a component's box, em. */
static double outside(const mt_border *b, int c, mt_point place) {
    mt_box box = b->boxes[c];
    double x = fmax(0, fmax((double)box.min.x - place.x, (double)place.x - box.max.x));
    double y = fmax(0, fmax((double)box.min.y - place.y, (double)place.y - box.max.y));
    return sqrt(x * x + y * y) / MT_EM;
}

/* The stop of component c that is nearest to a stop of another one, near enough to leap to; -1 where none is. */
static int nearest_of(const mt_border *b, int c, int stop) {
    mt_point place = b->places[stop];
    if (outside(b, c, place) > LEAP_REACH) return -1;
    int best = b->first_stop[c];
    for (int i = best + 1; i < b->first_stop[c + 1]; i++)
        if (mt_distance2(b->places[i], place) < mt_distance2(b->places[best], place)) best = i;
    return mt_border_distance(b, stop, best) <= LEAP_REACH ? best : -1;
}

/* Counts the leaps between two components, or writes them when there is room: between stops that are nearest to one another. */
static void list_leaps(mt_border *b, int c, int d, int *next) {
    for (int i = b->first_stop[c]; i < b->first_stop[c + 1]; i++) {
        int k = nearest_of(b, d, i);
        if (k < 0 || nearest_of(b, c, k) != i) continue;
        double price = LEAP_PRICE + LEAP_EM_PRICE * mt_border_distance(b, i, k);
        if (b->bridges) b->bridges[next[i]] = (mt_bridge){k, -1, price};
        if (b->bridges) b->bridges[next[k]] = (mt_bridge){i, -1, price};
        next[i]++;
        next[k]++;
    }
}

static void list_all(mt_border *border, double reach, bool leaps, int *next) {
    for (int c = 0; c < border->component_count; c++) {
        list_bridges(border, c, reach, next);
        for (int d = 0; leaps && d < c; d++) list_leaps(border, c, d, next);
    }
}

static mt_status add_bridges(mt_border *border, double reach, bool leaps, mt_arena *arena) {
    int *next = mt_arena_new(arena, (size_t)border->count + 1, sizeof *next);
    border->first_bridge = mt_arena_new(arena, (size_t)border->count + 1, sizeof(int));
    if (!next || !border->first_bridge) return MT_NO_MEMORY;
    list_all(border, reach, leaps, next);
    for (int i = 0; i < border->count; i++) {
        border->first_bridge[i + 1] = border->first_bridge[i] + next[i];
        next[i] = border->first_bridge[i];
    }
    border->bridges = mt_arena_new(arena, (size_t)border->first_bridge[border->count] + 1, sizeof(mt_bridge));
    if (!border->bridges) return MT_NO_MEMORY;
    list_all(border, reach, leaps, next);
    return MT_OK;
}

/* ---- all of it --------------------------------------------------------------------------------------------------- */

/* Which of `count` runs, of which run i begins at first[i], holds `item`. */
static int run_of(const int *first, int count, int item) {
    int low = 0, high = count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (first[middle] <= item)
            low = middle;
        else
            high = middle;
    }
    return low;
}

int mt_border_ring(const mt_border *border, int stop) {
    return run_of(border->first_of_ring, border->ring_count, stop);
}

int mt_bridge_source(const mt_border *border, int bridge) {
    /* of the stops that have none, which begin where the next begins, the last one is found: the one that has it */
    return run_of(border->first_bridge, border->count, bridge);
}

int mt_bridge_back(const mt_border *border, int bridge) {
    int from = mt_bridge_source(border, bridge), to = border->bridges[bridge].to,
        back = border->first_bridge[to];
    while (border->bridges[back].to != from) back++;
    return back;
}

double mt_border_distance(const mt_border *border, int i, int j) {
    return sqrt((double)mt_distance2(border->places[i], border->places[j])) / MT_EM;
}

double mt_bridge_length(const mt_border *border, int bridge) {
    return mt_border_distance(border, mt_bridge_source(border, bridge), border->bridges[bridge].to);
}

static mt_status start_border(const mt_shape *shape, double step, mt_arena *arena, mt_border *made) {
    size_t parts = (size_t)shape->count, rings = 0;
    int64_t stops = 0;
    made->component_count = shape->count;
    made->meshes = mt_arena_new(arena, parts, sizeof *made->meshes);
    made->drawn = mt_arena_new(arena, parts, sizeof *made->drawn);
    made->boxes = mt_arena_new(arena, parts, sizeof *made->boxes);
    made->first_stop = mt_arena_new(arena, parts + 1, sizeof *made->first_stop);
    if (!made->meshes || !made->drawn || !made->boxes || !made->first_stop) return MT_NO_MEMORY;
    for (int c = 0; c < shape->count; c++) {
        made->boxes[c] = mt_ring_box(&shape->components[c].rings[0]);
        rings += (size_t)shape->components[c].count;
        stops += stops_in(&shape->components[c], step);
        if (stops > MT_POINTS_MAX) return MT_TOO_LARGE;
        made->first_stop[c + 1] = (int)stops;
    }
    made->count = (int)stops;
    made->first_of_ring = mt_arena_new(arena, rings + 1, sizeof *made->first_of_ring);
    made->views = mt_arena_new(arena, (size_t)stops, sizeof *made->views);
    made->places = mt_arena_new(arena, (size_t)stops, sizeof *made->places);
    made->length = mt_arena_new(arena, (size_t)stops, sizeof *made->length);
    made->along = mt_arena_new(arena, (size_t)stops, sizeof *made->along);
    return made->first_of_ring && made->views && made->places && made->length && made->along ? MT_OK
                                                                                             : MT_NO_MEMORY;
}

mt_status mt_border_of(const mt_shape *shape, mt_box box, const mt_manner *manner, double reach,
                       mt_arena *arena, mt_border *border) {
    mt_border made = {.box = box};
    double step = mt_grid_units(manner->step);
    mt_status status = start_border(shape, step, arena, &made);
    for (int c = 0; status == MT_OK && c < shape->count; c++)
        status = add_component(&shape->components[c], c, manner->chord, step, arena, &made);
    if (status == MT_OK) status = add_bridges(&made, reach, manner->leaps, arena);
    if (status == MT_OK) *border = made;
    return status;
}
