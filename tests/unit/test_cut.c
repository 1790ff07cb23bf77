#include "morph/divide/cut.h"
#include "support/check.h"
#include "support/oracle.h"
#include "support/polygons.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* ---- a component and its cuts -------------------------------------------------------------------------- */

typedef struct sheet {
    mt_component component;
    mt_half_edges mesh;
    bool *drawn, *cut;
    int *part_of;
} sheet;

static sheet sheet_of(const mt_component *component) {
    sheet s = {.component = *component};
    mt_assert_ok(mt_triangulate(component, &arena, &s.mesh));
    size_t edges = 3 * (size_t)s.mesh.triangle_count;
    s.drawn = mt_arena_new(&arena, (size_t)s.mesh.vertex_count, sizeof *s.drawn);
    s.cut = mt_arena_new(&arena, edges, sizeof *s.cut);
    s.part_of = mt_arena_new(&arena, edges, sizeof *s.part_of);
    for (int i = 0; i < s.mesh.vertex_count; i++) s.drawn[i] = true;
    return s;
}

static mt_shape parts_of(sheet *s) {
    mt_cut_plan plan = {&s->mesh, s->drawn, s->cut};
    mt_shape parts;
    mt_assert_ok(mt_cut(&plan, &arena, &parts, s->part_of));
    return parts;
}

static int end_of(const mt_half_edges *mesh, int e) {
    return mesh->start[e % 3 == 2 ? e - 2 : e + 1];
}

static void cut_edge(sheet *s, int e) {
    assert_true(s->mesh.twin[e] >= 0);
    s->cut[e] = s->cut[s->mesh.twin[e]] = true;
}

/* Cuts along the diagonal between two vertices, which has to be there. */
static void cut_between(sheet *s, int from, int to) {
    for (int e = 0; e < 3 * s->mesh.triangle_count; e++)
        if (s->mesh.start[e] == from && end_of(&s->mesh, e) == to) {
            cut_edge(s, e);
            return;
        }
    fail_msg("no diagonal from %d to %d", from, to);
}

/* The points of a ring that are there, with their marks. */
static int count_of(const mt_ring *ring, mt_point point, int mark) {
    int count = 0;
    for (int i = 0; i < ring->count; i++)
        count += mt_point_equal(ring->points[i], point) && (ring->marks[i] & mark) == mark;
    return count;
}

static mt_component frame(void) {
    static const int outer[][2] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}},
                     hole[][2] = {{20, 20}, {20, 80}, {80, 80}, {80, 20}};
    mt_component component = mt_test_rings(&arena, 2);
    component.rings[0] = mt_test_ring_of(&arena, outer, 4, 1000);
    component.rings[1] = mt_test_ring_of(&arena, hole, 4, 1000);
    return component;
}

/* A bar with a place in the middle of its long sides, smooth there; vertices 1 and 4. */
static mt_component bar(void) {
    static const int points[][2] = {{0, 0}, {50, 0}, {100, 0}, {100, 20}, {50, 20}, {0, 20}};
    mt_component component = mt_test_rings(&arena, 1);
    component.rings[0] = mt_test_ring_of(&arena, points, 6, 1000);
    component.rings[0].marks[1] = component.rings[0].marks[4] = MT_CHORD;
    return component;
}

/* ---- by hand ------------------------------------------------------------------------------------------- */

static void without_cuts(void **state) {
    (void)state;
    mt_component whole = frame();
    sheet s = sheet_of(&whole);
    mt_shape parts = parts_of(&s);
    assert_int_equal(parts.count, 1);
    assert_int_equal(parts.components[0].count, 2);
    for (int r = 0; r < 2; r++) {
        assert_int_equal(parts.components[0].rings[r].count, 4);
        for (int i = 0; i < 4; i++)
            assert_int_equal(
                count_of(&parts.components[0].rings[r], whole.rings[r].points[i], whole.rings[r].marks[i]),
                1);
    }
    for (int t = 0; t < s.mesh.triangle_count; t++) assert_int_equal(s.part_of[t], 0);
}

/* From the hole to the outer ring: one ring, which runs along the cut to and fro. */
static void from_ring_to_ring(void **state) {
    (void)state;
    mt_component whole = frame();
    whole.rings[0].marks[0] = whole.rings[1].marks[0] = MT_CHORD;
    sheet s = sheet_of(&whole);
    cut_between(&s, 0, 4);
    mt_shape parts = parts_of(&s);
    assert_int_equal(parts.count, 1);
    assert_int_equal(parts.components[0].count, 1);
    const mt_ring *ring = &parts.components[0].rings[0];
    assert_int_equal(ring->count, 10);
    assert_true(mt_ring_area2(ring) == mt_component_area2(&whole));
    const mt_point ends[] = {{0, 0}, {20000, 20000}};
    for (int i = 0; i < 2; i++) {
        assert_int_equal(count_of(ring, ends[i], MT_CORNER), 2);
        assert_int_equal(count_of(ring, ends[i], MT_CORNER | MT_LINE), 1);  /* along the cut */
        assert_int_equal(count_of(ring, ends[i], MT_CORNER | MT_CHORD), 1); /* and along the drawing */
    }
}

/* Two of these part the frame; no hole is left. */
static void twice_from_ring_to_ring(void **state) {
    (void)state;
    mt_component whole = frame();
    sheet s = sheet_of(&whole);
    cut_between(&s, 0, 4);
    cut_between(&s, 2, 6);
    mt_shape parts = parts_of(&s);
    assert_int_equal(parts.count, 2);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(parts.components[i].count, 1);
        assert_int_equal(parts.components[i].rings[0].count, 6);
        assert_true(2 * mt_component_area2(&parts.components[i]) == mt_component_area2(&whole));
    }
}

/* From a ring to itself: two components. The ends of the cut are corners of both, though drawn smooth. */
static void from_a_ring_to_itself(void **state) {
    (void)state;
    mt_component whole = bar();
    sheet s = sheet_of(&whole);
    cut_between(&s, 1, 4);
    mt_shape parts = parts_of(&s);
    assert_int_equal(parts.count, 2);
    for (int i = 0; i < 2; i++) {
        assert_int_equal(parts.components[i].count, 1);
        const mt_ring *ring = &parts.components[i].rings[0];
        assert_int_equal(ring->count, 4);
        assert_true(mt_ring_area2(ring) == 2 * 50000LL * 20000);
        assert_int_equal(count_of(ring, (mt_point){50000, 0}, MT_CORNER), 1);
        assert_int_equal(count_of(ring, (mt_point){50000, 20000}, MT_CORNER), 1);
        /* one of the two edges at each end is the cut, a line; the other is the drawing's */
        int cuts =
            count_of(ring, (mt_point){50000, 0}, MT_LINE) + count_of(ring, (mt_point){50000, 20000}, MT_LINE);
        assert_int_equal(cuts, 1);
    }
}

/* Places that only divided an edge are left out, but for the ends of cuts. */
static void undrawn_vertices_are_dropped(void **state) {
    (void)state;
    mt_component whole = bar();
    sheet s = sheet_of(&whole);
    s.drawn[1] = s.drawn[4] = false;
    mt_shape uncut = parts_of(&s);
    assert_int_equal(uncut.count, 1);
    assert_int_equal(uncut.components[0].rings[0].count, 4);
    assert_int_equal(count_of(&uncut.components[0].rings[0], (mt_point){50000, 0}, 0), 0);
    cut_between(&s, 1, 4);
    s.drawn[0] = false; /* and a corner of the drawing, were it not one */
    mt_shape parted = parts_of(&s);
    assert_int_equal(parted.count, 2);
    int first = mt_ring_box(&parted.components[0].rings[0]).max.x > 50000;
    assert_int_equal(parted.components[first].rings[0].count, 3);
    assert_int_equal(parted.components[1 - first].rings[0].count, 4);
}

/* ---- at random ----------------------------------------------------------------------------------------- */

static int64_t triangle_area2(const mt_half_edges *mesh, int t) {
    const int *v = &mesh->start[3 * (size_t)t];
    return mt_orient(mesh->points[v[0]], mesh->points[v[1]], mesh->points[v[2]]);
}

static mt_spot thirds(const mt_half_edges *mesh, int t) {
    mt_spot sum = {0, 0};
    for (int k = 0; k < 3; k++) {
        mt_point p = mesh->points[mesh->start[3 * (size_t)t + (size_t)k]];
        sum = (mt_spot){sum.x + p.x, sum.y + p.y};
    }
    return sum;
}

/* A part has the area of its triangles, exactly, and lies where they lie; its outer ring alone runs anticlockwise. */
static void check_part(const sheet *s, const mt_component *part, int number, const mt_subject *subject) {
    int64_t area = 0;
    for (int t = 0; t < s->mesh.triangle_count; t++) {
        area += s->part_of[t] == number ? triangle_area2(&s->mesh, t) : 0;
        int winding = mt_oracle_winding(part, 3, thirds(&s->mesh, t));
        mt_require(winding == (s->part_of[t] == number), subject);
    }
    mt_require(area > 0 && mt_oracle_area2(part) == area, subject);
    for (int r = 0; r < part->count; r++)
        mt_require((mt_ring_area2(&part->rings[r]) > 0) == (r == 0), subject);
}

static void random_cuts(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(200); n++) {
        mt_random random = mt_random_case(n);
        mt_polygon_kind kind = (mt_polygon_kind)mt_random_between(&random, 0, MT_POLYGON_CELLS - 1);
        mt_component whole =
            mt_random_polygon(&random, &arena, kind, mt_random_between(&random, 3, 60), 100000);
        mt_subject subject = {"random_cuts", n, {&whole}};
        sheet s = sheet_of(&whole);
        int one_in = mt_random_between(&random, 1, 8);
        for (int e = 0; e < 3 * s.mesh.triangle_count; e++)
            if (s.mesh.twin[e] > e && mt_random_one_in(&random, one_in)) cut_edge(&s, e);
        mt_shape parts = parts_of(&s);
        for (int i = 0; i < parts.count; i++) check_part(&s, &parts.components[i], i, &subject);
        mt_require(mt_oracle_shape_area2(&parts) == mt_oracle_area2(&whole), &subject);
        mt_arena_reset(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_cuts),
        cmocka_unit_test(from_ring_to_ring),
        cmocka_unit_test(twice_from_ring_to_ring),
        cmocka_unit_test(from_a_ring_to_itself),
        cmocka_unit_test(undrawn_vertices_are_dropped),
        cmocka_unit_test(random_cuts),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
