#include "geometry/trace.h"
#include "support/check.h"
#include "support/curves.h"
#include "support/polygons.h"

#include <math.h>

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

enum { M = 100000, R = 30000, C = 13431, CHORD = 128 }; /* R - C is 0.5523 R */

/* A box with three round corners and a sharp one at the origin. */
static mt_ring rounded_box(void) {
    mt_segment sides[] = {
        {1, {{0}}, {M - R, 0}}, {3, {{M - C, 0}, {M, C}}, {M, R}},
        {1, {{0}}, {M, M - R}}, {3, {{M, M - C}, {M - C, M}}, {M - R, M}},
        {1, {{0}}, {R, M}},     {3, {{C, M}, {0, M - C}}, {0, M - R}},
        {1, {{0}}, {0, 0}},
    };
    mt_outline outline = mt_curves_outline(&arena, &(mt_contour){7, sides});
    mt_rings rings;
    mt_assert_ok(mt_flatten(&outline, CHORD, &arena, &rings));
    return rings.rings[0];
}

static mt_trace trace_of(const mt_ring *ring) {
    mt_trace trace;
    mt_assert_ok(mt_trace_ring(ring, CHORD, &arena, &trace));
    return trace;
}

static bool is_at(mt_point p, int x, int y) {
    return p.x == x && p.y == y;
}

static void box_by_hand(void **state) {
    (void)state;
    mt_ring ring = rounded_box();
    mt_trace t = trace_of(&ring);
    int corners = 0, lines = 0;
    double turned = 0, length = 0;
    for (int i = 0; i < t.ring.count; i++) {
        mt_point p = t.ring.points[i];
        corners += t.corner[i];
        lines += t.line[i];
        turned += t.turn[i];
        length += t.length[i];
        if (t.corner[i]) assert_true(is_at(p, 0, 0));
        bool end = is_at(p, M - R, 0) || is_at(p, M, R) || is_at(p, M, M - R) || is_at(p, M - R, M) ||
                   is_at(p, R, M) || is_at(p, 0, M - R);
        assert_true(mt_trace_breaks(&t, i) == (end || t.corner[i]));
        assert_int_equal(mt_trace_before(&t, mt_trace_after(&t, i)), i);
    }
    assert_int_equal(corners, 1);
    assert_int_equal(lines, 4);
    assert_true(fabs(turned - 2 * M_PI) < 1e-9);
    assert_true(fabs(length - mt_ring_length(&ring)) < 1e-3);
}

static double angle(double from, double to) {
    return fabs(remainder(to - from, 2 * M_PI));
}

/* Headings are the drawing's: along a line at its ends, and on the rounds within a degree of the circle's
 * own. */
static void headings(void **state) {
    (void)state;
    mt_ring ring = rounded_box();
    mt_trace t = trace_of(&ring);
    for (int i = 0; i < t.ring.count; i++) {
        mt_point p = t.ring.points[i];
        double in = mt_trace_in(&t, i), out = mt_trace_out(&t, i);
        if (is_at(p, 0, 0)) {
            assert_true(angle(in, -M_PI / 2) < 1e-9 && angle(out, 0) < 1e-9);
            continue;
        }
        assert_true(angle(in, out) < 1e-9);
        if (t.line[i]) assert_true(angle(out, t.heading[i]) < 1e-9);
        bool round = p.x > M - R && p.y < R;
        if (round) assert_true(angle(out, atan2(p.x - (M - R), R - p.y)) < M_PI / 180);
    }
}

/* The extremes of a circle, and no other points. */
static void extremes(void **state) {
    (void)state;
    const int c = 55228;
    mt_segment quarters[] = {{3, {{M, c}, {c, M}}, {0, M}},
                             {3, {{-c, M}, {-M, c}}, {-M, 0}},
                             {3, {{-M, -c}, {-c, -M}}, {0, -M}},
                             {3, {{c, -M}, {M, -c}}, {M, 0}}};
    mt_outline outline = mt_curves_outline(&arena, &(mt_contour){4, quarters});
    mt_rings rings;
    mt_assert_ok(mt_flatten(&outline, CHORD, &arena, &rings));
    mt_trace t = trace_of(&rings.rings[0]);
    int found = 0;
    for (int i = 0; i < t.ring.count; i++) {
        mt_point p = t.ring.points[i];
        assert_true(mt_trace_extremum(&t, i) == (p.x == 0 || p.y == 0));
        assert_false(mt_trace_breaks(&t, i));
        found += mt_trace_extremum(&t, i);
    }
    assert_int_equal(found, 4);
}

/* Without any marks, long edges with sharp turns are lines. */
static void a_square_without_marks(void **state) {
    (void)state;
    mt_ring ring = mt_test_ring(&arena, 4);
    mt_point corners[] = {{0, 0}, {M, 0}, {M, M}, {0, M}};
    for (int i = 0; i < 4; i++) {
        ring.points[i] = corners[i];
        ring.marks[i] = 0;
    }
    mt_trace t = trace_of(&ring);
    for (int i = 0; i < 4; i++) assert_true(t.corner[i] && t.line[i]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(box_by_hand),
        cmocka_unit_test(headings),
        cmocka_unit_test(extremes),
        cmocka_unit_test(a_square_without_marks),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
