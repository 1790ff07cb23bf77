#include "geometry/union.h"
#include "geometry/limits.h"
#include "support/check.h"
#include "support/corpus.h"
#include "support/oracle.h"
#include "support/polygons.h"

static mt_arena arena;
static mt_corpus corpus;

static int set_up(void **state) {
    (void)state;
    corpus = mt_corpus_read(&arena);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_shape union_of(const mt_rings *rings) {
    mt_shape shape = {0};
    mt_assert_ok(mt_union(rings, MT_NONZERO, &arena, &shape));
    return shape;
}

/* Components, rings in all, doubled area. */
static void expect(const char *name, int components, int rings, int64_t area2) {
    mt_shape shape = union_of(mt_corpus_find(&corpus, name));
    mt_rings all = mt_test_all_rings(&arena, &shape);
    mt_subject subject = {name, -1, {&all}};
    mt_require(shape.count == components, &subject);
    mt_require(all.count == rings, &subject);
    mt_require(mt_oracle_area2(&all) == area2, &subject);
}

static void drawings(void **state) {
    (void)state;
    expect("square", 1, 1, 20000);
    expect("square_with_runs", 1, 1, 20000);
    expect("backwards_square", 1, 1, 20000);
    expect("bow_tie", 2, 2, 10000);
    expect("crossed_bars", 1, 1, 2 * (2000 + 2000 - 400));
}

static void overlaps(void **state) {
    (void)state;
    expect("frame", 1, 2, 20000 - 7200);
    expect("frame_drawn_the_same_way_round", 1, 1, 20000);
    expect("nested_rings", 3, 5, 2 * (10000 - 6400 + 3600 - 1600 + 400));
    expect("same_ring_twice", 1, 1, 20000);
    expect("ring_and_its_reverse", 0, 0, 0);
    expect("no_area", 0, 0, 0);
    expect("one_point", 0, 0, 0);
    expect("spikes_everywhere", 1, 1, 20000);
    expect("squares_side_by_side", 1, 1, 10000);
    expect("hole_one_unit_wide", 1, 2, 20000 - 160);
    expect("slit_into_the_ink", 1, 1, 20000);
}

/* A hole that leaves its ink to the right by 20 units of 60, and rings that run the other way. */
static void contours_by_the_positive_rule(void **state) {
    (void)state;
    const int outer[][2] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}},
              hole[][2] = {{60, 20}, {60, 80}, {120, 80}, {120, 20}};
    mt_ring both[] = {mt_test_ring_of(&arena, outer, 4, 1), mt_test_ring_of(&arena, hole, 4, 1)};
    mt_rings rings = {2, both}, backwards = {1, &both[1]};
    mt_shape shape;
    mt_assert_ok(mt_union(&rings, MT_POSITIVE, &arena, &shape));
    assert_int_equal(mt_shape_area2(&shape), 2 * (100 * 100 - 40 * 60));
    mt_assert_ok(mt_union(&rings, MT_NONZERO, &arena, &shape));
    assert_int_equal(mt_shape_area2(&shape), 2 * (100 * 100 - 40 * 60 + 20 * 60));
    mt_assert_ok(mt_union(&backwards, MT_POSITIVE, &arena, &shape));
    assert_int_equal(shape.count, 0);
}

/* What mt_union_unmarked makes is the same but for the marks, of which it has none. */
static void without_marks(void **state) {
    (void)state;
    for (int i = 0; i < corpus.count; i++) {
        mt_subject subject = {corpus.shapes[i].name, -1, {&corpus.shapes[i].rings}};
        mt_shape marked = union_of(&corpus.shapes[i].rings), plain;
        mt_assert_ok(mt_union_unmarked(&corpus.shapes[i].rings, MT_NONZERO, &arena, &plain));
        mt_rings all = mt_test_all_rings(&arena, &marked), bare = mt_test_all_rings(&arena, &plain);
        mt_require(marked.count == plain.count && all.count == bare.count, &subject);
        for (int r = 0; r < all.count; r++) {
            mt_require(all.rings[r].count == bare.rings[r].count, &subject);
            for (int k = 0; k < all.rings[r].count; k++) {
                mt_require(mt_point_equal(all.rings[r].points[k], bare.rings[r].points[k]), &subject);
                mt_require(bare.rings[r].marks[k] == 0, &subject);
            }
        }
    }
}

static void nothing(void **state) {
    (void)state;
    mt_rings none = {0};
    assert_int_equal(union_of(&none).count, 0);
    mt_ring empty = {0};
    mt_rings one = {1, &empty};
    assert_int_equal(union_of(&one).count, 0);
}

static bool lower(mt_point p, mt_point q) {
    return p.y < q.y || (p.y == q.y && p.x < q.x);
}

/* Outer rings anticlockwise, holes clockwise, each from its lowest point on, in the order of these; no
 * point repeated. */
static void check_order(const mt_shape *shape, const mt_subject *subject) {
    for (int i = 0; i < shape->count; i++) {
        const mt_component *component = &shape->components[i];
        for (int r = 0; r < component->count; r++) {
            const mt_ring *ring = &component->rings[r];
            mt_rings alone = {1, &component->rings[r]};
            mt_require(r == 0 ? mt_oracle_area2(&alone) > 0 : mt_oracle_area2(&alone) < 0, subject);
            for (int k = 0; k < ring->count; k++) {
                mt_require(!lower(ring->points[k], ring->points[0]), subject);
                mt_require(!mt_point_equal(ring->points[k], ring->points[(k + 1) % ring->count]), subject);
            }
            if (r > 1) mt_require(!lower(ring->points[0], component->rings[r - 1].points[0]), subject);
        }
        if (i > 0)
            mt_require(!lower(component->rings[0].points[0], shape->components[i - 1].rings[0].points[0]),
                       subject);
    }
}

static void corpus_in_order(void **state) {
    (void)state;
    for (int i = 0; i < corpus.count; i++) {
        mt_subject subject = {corpus.shapes[i].name, -1, {&corpus.shapes[i].rings}};
        mt_shape shape = union_of(&corpus.shapes[i].rings);
        check_order(&shape, &subject);
        bool free_of_slits = mt_oracle_is_clean(&corpus.shapes[i].rings);
        if (corpus.shapes[i].is_component && free_of_slits)
            mt_require(mt_oracle_shape_area2(&shape) == mt_oracle_area2(&corpus.shapes[i].rings), &subject);
    }
}

/* The order of rings and the point where each starts do not show. */
static void same_whatever_the_order(void **state) {
    (void)state;
    mt_rings bars = mt_test_moved(&arena, mt_corpus_find(&corpus, "nested_rings"), 1, (mt_point){0, 0});
    mt_shape one = union_of(&bars);
    mt_ring last = bars.rings[4];
    for (int i = 4; i > 0; i--) bars.rings[i] = bars.rings[i - 1];
    bars.rings[0] = last;
    mt_point first = last.points[0];
    for (int i = 0; i < 3; i++) last.points[i] = last.points[i + 1];
    last.points[3] = first;
    mt_shape other = union_of(&bars);
    assert_int_equal(one.count, other.count);
    for (int i = 0; i < one.count; i++) {
        assert_int_equal(one.components[i].count, other.components[i].count);
        for (int r = 0; r < one.components[i].count; r++)
            for (int k = 0; k < one.components[i].rings[r].count; k++)
                assert_true(mt_point_equal(one.components[i].rings[r].points[k],
                                           other.components[i].rings[r].points[k]));
    }
}

static const mt_ring *only_ring(const mt_shape *shape) {
    assert_int_equal(shape->count, 1);
    assert_int_equal(shape->components[0].count, 1);
    return &shape->components[0].rings[0];
}

static bool has_point(const mt_rings *rings, mt_point p, uint8_t marks) {
    for (int r = 0; r < rings->count; r++)
        for (int i = 0; i < rings->rings[r].count; i++)
            if (mt_point_equal(rings->rings[r].points[i], p) && rings->rings[r].marks[i] == marks)
                return true;
    return false;
}

/* Corners of the drawing keep theirs; where edges cross stands a crossing. */
static void marks_of_points(void **state) {
    (void)state;
    const mt_rings *bars = mt_corpus_find(&corpus, "crossed_bars");
    mt_shape shape = union_of(bars);
    const mt_ring *ring = only_ring(&shape);
    assert_int_equal(ring->count, 12);
    for (int i = 0; i < 12; i++) {
        bool drawn = has_point(bars, ring->points[i], MT_CORNER | MT_LINE);
        assert_int_equal(ring->marks[i] & MT_POINT_MARKS, drawn ? MT_CORNER : MT_CROSSING);
    }
}

/* With one bar backwards they take each other away where they cross: four arms are left, which touch at
 * corners. */
static void against_each_other(void **state) {
    (void)state;
    mt_shape shape = union_of(mt_corpus_find(&corpus, "crossed_bars_one_backwards"));
    assert_true(mt_oracle_shape_area2(&shape) == 2 * 4 * 800);
    assert_false(mt_oracle_in_shape(&shape, 1, (mt_spot){50, 50}));
    assert_true(mt_oracle_in_shape(&shape, 1, (mt_spot){50, 20}));
}

static void at_the_limits(void **state) {
    (void)state;
    mt_rings huge =
        mt_test_moved(&arena, mt_corpus_find(&corpus, "square"), MT_COORD_MAX / 100, (mt_point){0, 0});
    mt_shape shape = union_of(&huge);
    assert_true(mt_shape_area2(&shape) == mt_component_area2(&huge));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drawings),
        cmocka_unit_test(overlaps),
        cmocka_unit_test(contours_by_the_positive_rule),
        cmocka_unit_test(without_marks),
        cmocka_unit_test(nothing),
        cmocka_unit_test(corpus_in_order),
        cmocka_unit_test(same_whatever_the_order),
        cmocka_unit_test(marks_of_points),
        cmocka_unit_test(against_each_other),
        cmocka_unit_test(at_the_limits),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
