/* Each kind is drawn in floating point or on a small grid, rounded, and checked by brute force to be free
 * of crossings; what fails is drawn again. */
#include "support/polygons.h"

#include "support/check.h"
#include "support/oracle.h"

#include <math.h>
#include <string.h>

enum { POINTS_MAX = 1600, CELLS_SIDE_MAX = 16, TRIES = 60 };

typedef struct sketch {
    int count;
    mt_point points[POINTS_MAX];
} sketch;

static void add(sketch *s, double x, double y) {
    assert_true(s->count < POINTS_MAX);
    s->points[s->count++] = (mt_point){(int32_t)lround(x), (int32_t)lround(y)};
}

/* ---- rings, copies ------------------------------------------------------------------------------------- */

mt_ring mt_test_ring(mt_arena *arena, int count) {
    mt_ring ring;
    mt_assert_ok(mt_ring_new(arena, count, &ring));
    memset(ring.marks, MT_CORNER | MT_LINE, (size_t)count);
    return ring;
}

mt_ring mt_test_ring_of(mt_arena *arena, const int (*points)[2], int count, int factor) {
    mt_ring ring = mt_test_ring(arena, count);
    for (int i = 0; i < count; i++) ring.points[i] = (mt_point){points[i][0] * factor, points[i][1] * factor};
    return ring;
}

mt_rings mt_test_rings(mt_arena *arena, int count) {
    mt_rings rings = {count, mt_arena_new(arena, (size_t)count, sizeof(mt_ring))};
    assert_non_null(rings.rings);
    return rings;
}

mt_shape mt_test_shape_of(mt_arena *arena, const mt_component *component) {
    mt_shape shape = {1, mt_arena_new(arena, 1, sizeof(mt_component))};
    assert_non_null(shape.components);
    shape.components[0] = *component;
    return shape;
}

static mt_ring moved(mt_arena *arena, const mt_ring *ring, int factor, mt_point by) {
    mt_ring copy = mt_test_ring(arena, ring->count);
    for (int i = 0; i < ring->count; i++) {
        copy.points[i] = (mt_point){ring->points[i].x * factor + by.x, ring->points[i].y * factor + by.y};
        copy.marks[i] = ring->marks[i];
    }
    return copy;
}

mt_rings mt_test_moved(mt_arena *arena, const mt_rings *rings, int factor, mt_point by) {
    mt_rings copy = mt_test_rings(arena, rings->count);
    for (int i = 0; i < rings->count; i++) copy.rings[i] = moved(arena, &rings->rings[i], factor, by);
    return copy;
}

mt_shape mt_test_shape_moved(mt_arena *arena, const mt_shape *shape, int factor, mt_point by) {
    mt_shape copy = {shape->count, mt_arena_new(arena, (size_t)shape->count, sizeof(mt_component))};
    assert_non_null(copy.components);
    for (int i = 0; i < shape->count; i++)
        copy.components[i] = mt_test_moved(arena, &shape->components[i], factor, by);
    return copy;
}

mt_rings mt_test_all_rings(mt_arena *arena, const mt_shape *shape) {
    int count = 0;
    for (int i = 0; i < shape->count; i++) count += shape->components[i].count;
    mt_rings all = mt_test_rings(arena, count);
    all.count = 0;
    for (int i = 0; i < shape->count; i++)
        for (int k = 0; k < shape->components[i].count; k++)
            all.rings[all.count++] = shape->components[i].rings[k];
    return all;
}

static mt_ring ring_of(mt_arena *arena, const sketch *s, bool backwards) {
    mt_ring ring = mt_test_ring(arena, s->count);
    for (int i = 0; i < s->count; i++) ring.points[i] = s->points[backwards ? s->count - 1 - i : i];
    return ring;
}

/* ---- kinds --------------------------------------------------------------------------------------------- */

static void draw_convex(mt_random *random, sketch *s, int size, double extent) {
    mt_spot spots[POINTS_MAX], hull[POINTS_MAX];
    for (int i = 0; i < size; i++) {
        double angle = 2 * M_PI * mt_random_unit(random), radius = extent * sqrt(mt_random_unit(random));
        if (mt_random_one_in(random, 2)) radius = extent * 0.95;
        spots[i] = (mt_spot){lround(radius * cos(angle)), lround(radius * sin(angle))};
    }
    int count = mt_oracle_hull(spots, size, hull);
    for (int i = 0; i < count; i++) add(s, (double)hull[i].x, (double)hull[i].y);
}

static void draw_star(mt_random *random, sketch *s, int size, double extent) {
    double inner = 0.15 + 0.7 * mt_random_unit(random);
    for (int i = 0; i < size; i++) {
        double angle = 2 * M_PI * (i + 0.8 * mt_random_unit(random)) / size;
        double radius = extent * (inner + (1 - inner) * mt_random_unit(random));
        add(s, radius * cos(angle), radius * sin(angle));
    }
}

static void draw_comb(mt_random *random, sketch *s, int size, double extent) {
    int teeth = size / 4 > 1 ? size / 4 : 1;
    double pitch = extent / teeth, slant = extent * (mt_random_unit(random) - 0.5) / 2;
    add(s, -extent / 2, -extent / 2);
    add(s, extent / 2, -extent / 2);
    for (int i = teeth; i > 0; i--) {
        double right = -extent / 2 + i * pitch, gap = pitch * (0.1 + 0.8 * mt_random_unit(random));
        double top = extent * (0.1 + 0.4 * mt_random_unit(random));
        add(s, right, -extent / 4);
        add(s, right + slant, top);
        if (mt_random_one_in(random, 2)) add(s, right - pitch + gap + slant, top);
        add(s, right - pitch + gap, -extent / 4);
    }
    if (s->points[s->count - 1].x > -extent / 2) add(s, -extent / 2, -extent / 4);
}

static void draw_spiral(mt_random *random, sketch *s, int size, double extent) {
    int steps = size / 2 > 6 ? size / 2 : 6;
    double turns = 1 + mt_random_unit(random) * steps / 12, pitch = 0.8 * extent / (turns + 1);
    double width = pitch * (0.1 + 0.5 * mt_random_unit(random));
    for (int i = 0; i <= 2 * steps + 1; i++) {
        bool outward = i <= steps;
        double at = (double)(outward ? i : 2 * steps + 1 - i) / steps;
        double radius = 0.1 * extent + pitch * turns * at + (outward ? width : 0);
        add(s, radius * cos(2 * M_PI * turns * at), radius * sin(2 * M_PI * turns * at));
    }
}

static bool edges_cross(const sketch *s, int i, int k) {
    return mt_oracle_cross(mt_spot_of(s->points[i], 1), mt_spot_of(s->points[(i + 1) % s->count], 1),
                           mt_spot_of(s->points[k], 1), mt_spot_of(s->points[(k + 1) % s->count], 1));
}

static void reverse(mt_point *points, int from, int to) {
    for (; from < to; from++, to--) {
        mt_point p = points[from];
        points[from] = points[to];
        points[to] = p;
    }
}

/* Random points; each pair of crossing edges is exchanged for the pair that does not cross, which is
 * shorter. */
static void draw_tangle(mt_random *random, sketch *s, int size, double extent) {
    int reach = mt_random_one_in(random, 3) ? 8 : (int)extent;
    int unit = (int)extent / reach, count = size < 40 ? size : 40;
    for (int i = 0; i < count; i++) {
        mt_point at = mt_random_point(random, -reach, reach);
        add(s, at.x * unit, at.y * unit);
    }
    bool changed = true;
    for (int round = 0; changed && round < 200; round++) {
        changed = false;
        for (int i = 0; i < count; i++)
            for (int k = i + 2; k < count; k++) {
                if (!edges_cross(s, i, k)) continue;
                reverse(s->points, i + 1, k);
                changed = true;
            }
    }
}

typedef void (*draw_kind)(mt_random *random, sketch *s, int size, double extent);
static const draw_kind draws[] = {draw_convex, draw_star, draw_comb, draw_spiral, draw_tangle};

/* ---- cells --------------------------------------------------------------------------------------------- */

typedef struct cells {
    bool ink[CELLS_SIDE_MAX + 2][CELLS_SIDE_MAX + 2];
    bool traced[CELLS_SIDE_MAX + 2][CELLS_SIDE_MAX + 2]
               [4]; /* the edges that leave a grid point, by direction */
    bool joins;     /* whether cells that only touch at a corner are walked as one */
    bool keeps;     /* points in line */
    int side, unit;
} cells;

static const int step_x[4] = {1, 0, -1, 0}, step_y[4] = {0, 1, 0, -1};

/* A connected heap of cells. */
static void grow(mt_random *random, cells *c, int size) {
    int middle = c->side / 2 + 1, grown = 1;
    c->ink[middle][middle] = true;
    for (int tries = 0; grown < size && tries < 100 * size; tries++) {
        int x = mt_random_between(random, 1, c->side), y = mt_random_between(random, 1, c->side);
        if (c->ink[x][y]) continue;
        if (!c->ink[x - 1][y] && !c->ink[x + 1][y] && !c->ink[x][y - 1] && !c->ink[x][y + 1]) continue;
        c->ink[x][y] = true;
        grown++;
    }
}

/* Whether a boundary edge with ink on its left leaves grid point (x, y), the lower left of cell (x, y),
 * that way. */
static bool is_edge(const cells *c, int x, int y, int way) {
    static const int left_x[4] = {0, -1, -1, 0}, left_y[4] = {0, 0, -1, -1};
    static const int right_x[4] = {0, 0, -1, -1}, right_y[4] = {-1, 0, 0, -1};
    return c->ink[x + left_x[way]][y + left_y[way]] && !c->ink[x + right_x[way]][y + right_y[way]];
}

static int next_way(const cells *c, int x, int y, int way) {
    int first = c->joins ? 3 : 1; /* a turn to the right, or to the left, where there are both */
    for (int turn = 0; turn < 3; turn++) {
        static const int order[2][3] = {{1, 0, 3}, {3, 0, 1}};
        int to = (way + order[first == 3][turn]) % 4;
        if (is_edge(c, x, y, to)) return to;
    }
    fail_msg("a cell boundary ends");
    return way;
}

static void trace(cells *c, int x, int y, int way, sketch *s) {
    int before = -1;
    while (!c->traced[x][y][way]) {
        c->traced[x][y][way] = true;
        if (way != before || c->keeps) add(s, x * c->unit, y * c->unit);
        before = way;
        x += step_x[way];
        y += step_y[way];
        way = next_way(c, x, y, way);
    }
}

static mt_component draw_cells(mt_random *random, mt_arena *arena, int size, int extent) {
    cells c = {.joins = mt_random_one_in(random, 2), .keeps = mt_random_one_in(random, 2)};
    c.side = (int)sqrt(2.0 * size) + 2 < CELLS_SIDE_MAX ? (int)sqrt(2.0 * size) + 2 : CELLS_SIDE_MAX;
    c.unit = extent / (c.side + 2);
    grow(random, &c, size);
    mt_component component = mt_test_rings(arena, CELLS_SIDE_MAX * CELLS_SIDE_MAX);
    component.count = 0;
    for (int x = 1; x <= c.side + 1; x++)
        for (int y = 1; y <= c.side + 1; y++)
            for (int way = 0; way < 4; way++) {
                if (!is_edge(&c, x, y, way) || c.traced[x][y][way]) continue;
                sketch s = {0};
                trace(&c, x, y, way, &s);
                mt_ring ring = ring_of(arena, &s, false);
                mt_rings alone = {1, &ring};
                bool outer = mt_oracle_area2(&alone) > 0;
                component.rings[component.count++] = outer ? component.rings[0] : ring;
                if (outer) component.rings[0] = ring;
            }
    return component;
}

/* ---- holes --------------------------------------------------------------------------------------------- */

/* Tries a clockwise star around a random point as far from all edges as it can be. */
static void add_hole(mt_random *random, mt_arena *arena, mt_component *component, int size, int extent) {
    mt_point at = mt_random_point(random, -extent, extent);
    double room = mt_oracle_distance(component, 1, mt_spot_of(at, 1));
    if (mt_oracle_winding(component, 1, mt_spot_of(at, 1)) != 1 || room < 16) return;
    sketch s = {0};
    draw_star(random, &s, mt_random_between(random, 3, size < 8 ? 8 : size / 2), 0.9 * room);
    mt_ring hole = ring_of(arena, &s, true);
    mt_rings alone = {1, &hole};
    if (!mt_oracle_is_clean(&alone) || mt_oracle_area2(&alone) >= 0) return;
    for (int i = 0; i < hole.count; i++)
        hole.points[i] = (mt_point){hole.points[i].x + at.x, hole.points[i].y + at.y};
    component->rings[component->count++] = hole;
}

mt_component mt_random_polygon(mt_random *random, mt_arena *arena, mt_polygon_kind kind, int size,
                               int extent) {
    if (kind == MT_POLYGON_CELLS) return draw_cells(random, arena, size, extent);
    mt_component component = mt_test_rings(arena, 4);
    component.count = 1;
    for (int tries = 0;; tries++) {
        sketch s = {0};
        draws[kind](random, &s, size, extent);
        component.rings[0] = ring_of(arena, &s, false);
        if (mt_oracle_area2(&component) < 0) component.rings[0] = ring_of(arena, &s, true);
        if (mt_oracle_area2(&component) > 0 && mt_oracle_is_clean(&component)) break;
        if (tries >= TRIES) kind = MT_POLYGON_CONVEX;
    }
    for (int holes = mt_random_between(random, 0, 3); holes > 0; holes--)
        for (int tries = 0, before = component.count; tries < 10 && component.count == before; tries++)
            add_hole(random, arena, &component, size, extent);
    return component;
}

/* ---- decorations --------------------------------------------------------------------------------------- */

static int divisor(int a, int b) {
    return b ? divisor(b, a % b) : a;
}

/* A grid point on the edge, or its end when there is none; one unit beside it for a dent. */
static mt_point point_on(mt_random *random, mt_point a, mt_point b, bool dent) {
    int dx = b.x - a.x, dy = b.y - a.y, n = divisor(abs(dx), abs(dy));
    if (dent) return (mt_point){a.x + dx / 2 + mt_random_between(random, -1, 1), a.y + dy / 2};
    int k = n > 1 ? mt_random_between(random, 1, n - 1) : 0;
    return n > 1 ? (mt_point){a.x + dx / n * k, a.y + dy / n * k} : a;
}

static mt_ring with_point(mt_arena *arena, const mt_ring *ring, int after, mt_point p) {
    mt_ring longer = mt_test_ring(arena, ring->count + 1);
    for (int i = 0; i < longer.count; i++)
        longer.points[i] = i == after + 1 ? p : ring->points[i > after ? i - 1 : i];
    return longer;
}

static void decorate(mt_random *random, mt_arena *arena, mt_component *component, bool dent) {
    int r = mt_random_between(random, 0, component->count - 1);
    mt_ring *ring = &component->rings[r], before = *ring;
    int at = mt_random_between(random, 0, ring->count - 1);
    mt_point a = ring->points[at], b = ring->points[(at + 1) % ring->count];
    bool clean = !dent || mt_oracle_is_clean(component);
    *ring = with_point(arena, ring, at, mt_random_one_in(random, 3) ? a : point_on(random, a, b, dent));
    if (dent && !(clean && mt_oracle_is_clean(component))) *ring = before;
}

mt_component mt_random_component(mt_random *random, mt_arena *arena, int size, int extent) {
    mt_polygon_kind kind = (mt_polygon_kind)mt_random_between(random, 0, MT_POLYGON_KINDS - 1);
    mt_component component = mt_random_polygon(random, arena, kind, size, extent);
    if (!mt_random_one_in(random, 3)) return component;
    for (int i = mt_random_between(random, 1, 6); i > 0; i--)
        decorate(random, arena, &component, mt_random_one_in(random, 2));
    return component;
}

mt_shape mt_random_shape(mt_random *random, mt_arena *arena, int most, int size, int extent) {
    int count = mt_random_between(random, 1, most);
    mt_shape shape = {count, mt_arena_new(arena, (size_t)count, sizeof(mt_component))};
    assert_non_null(shape.components);
    for (int i = 0; i < count; i++) {
        mt_component component = mt_random_component(random, arena, size, extent / count * 4 / 5);
        mt_point by = {extent * (2 * i + 1 - count) / count,
                       mt_random_between(random, -extent / 8, extent / 8)};
        shape.components[i] = mt_test_moved(arena, &component, 1, by);
    }
    return shape;
}

mt_ring mt_random_scrawl(mt_random *random, mt_arena *arena, int count, int extent) {
    mt_ring ring = mt_test_ring(arena, count);
    for (int i = 0; i < count; i++) ring.points[i] = mt_random_point(random, -extent, extent);
    return ring;
}
