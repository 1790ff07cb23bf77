#include "geometry/spline.h"
#include "support/check.h"
#include "support/curves.h"

#include <math.h>

enum { MOST = 200 };

static mt_arena arena;
static mt_sample samples[MOST];
static mt_segment segments[MOST + 1];
static int ends[MOST];

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_sample at(double x, double y, double angle) {
    return (mt_sample){.x = x, .y = y, .dx = cos(angle), .dy = sin(angle)};
}

static int spline_through(int count, double tolerance) {
    int made = -1;
    const mt_sample *one = samples;
    mt_segment *into = segments + 1;
    mt_assert_ok(mt_spline(&one, 1, count, tolerance, &arena, &into, ends, &made));
    assert_true(made >= 1 && made <= count - 1);
    segments[0] = (mt_segment){1, {{0}}, {(int32_t)lround(samples[0].x), (int32_t)lround(samples[0].y)}};
    mt_point end = segments[made].end;
    assert_true(fabs(end.x - samples[count - 1].x) <= 0.5 && fabs(end.y - samples[count - 1].y) <= 0.5);
    return made;
}

static double worst_distance(int count, int made) {
    mt_contour contour = {made + 1, segments};
    mt_outline outline = mt_curves_outline(&arena, &contour);
    double worst = 0;
    for (int i = 0; i < count; i++)
        worst = fmax(worst, mt_curves_distance(&outline, samples[i].x, samples[i].y));
    return worst;
}

static void straight(void **state) {
    (void)state;
    for (int i = 0; i < 20; i++) samples[i] = at(i * 1000, i * 500 + i % 2, atan2(1, 2));
    assert_int_equal(spline_through(20, 100), 1);
    assert_int_equal(segments[1].degree, 1);
}

/* Samples of one quadratic give that one back. */
static void one_quadratic(void **state) {
    (void)state;
    for (int i = 0; i <= 10; i++) {
        double t = i / 10.0, x = 2 * t * (1 - t) * 30000 + t * t * 80000, y = t * t * 50000;
        samples[i] = at(x, y, atan2(2 * t * 50000, 2 * (1 - 2 * t) * 30000 + 2 * t * 80000));
    }
    assert_int_equal(spline_through(11, 10), 1);
    assert_int_equal(segments[1].degree, 2);
    assert_true(abs(segments[1].control[0].x - 30000) <= 1 && abs(segments[1].control[0].y) <= 1);
}

static void arc(int count, double radius, double turn) {
    for (int i = 0; i < count; i++) {
        double angle = turn * i / (count - 1);
        samples[i] = at(radius * cos(angle), radius * sin(angle), angle + M_PI / 2);
    }
}

/* The tighter, the more segments; always within the tolerance. */
static void arcs(void **state) {
    (void)state;
    int before = 1;
    for (double tolerance = 3000; tolerance > 1; tolerance /= 4) {
        arc(91, 50000, M_PI * 1.5);
        int made = spline_through(91, tolerance);
        assert_true(made >= before);
        assert_true(worst_distance(91, made) <= tolerance + 1);
        before = made;
    }
    assert_true(before > 8);
}

static void nodes_end_segments(void **state) {
    (void)state;
    arc(41, 50000, M_PI / 3);
    int made = spline_through(41, 1000);
    assert_int_equal(made, 1);
    samples[13].node = true;
    assert_int_equal(spline_through(41, 1000), made + 1);
    bool found = false;
    for (int i = 1; i <= made + 1; i++) found |= segments[i].end.x == lround(samples[13].x);
    assert_true(found);
}

/* Two samples always have a segment: a line where no quadratic joins them. */
static void two_samples(void **state) {
    (void)state;
    samples[0] = at(0, 0, 0.5);
    samples[1] = at(1000, 0, 0.5);
    assert_int_equal(spline_through(2, 1), 1);
    assert_int_equal(segments[1].degree, 1);
    samples[1] = at(1000, 0, -0.5);
    assert_int_equal(spline_through(2, 1), 1);
    assert_int_equal(segments[1].degree, 2);
    assert_true(segments[1].control[0].x == 500 && segments[1].control[0].y == lround(500 * tan(0.5)));
}

/* An arc and a straight stretch together: as many segments as the arc needs, and the straight one's are of
 * the same degrees. */
static void two_masters(void **state) {
    (void)state;
    static mt_sample line[MOST];
    static mt_segment of_line[MOST];
    arc(61, 50000, M_PI);
    int alone = spline_through(61, 200), together = 0;
    for (int i = 0; i < 61; i++) line[i] = at(1000 * i, 0, 0);
    const mt_sample *masters[] = {samples, line};
    mt_segment *into[] = {segments + 1, of_line};
    mt_assert_ok(mt_spline(masters, 2, 61, 200, &arena, into, ends, &together));
    assert_int_equal(together, alone);
    assert_true(worst_distance(61, together) <= 201);
    for (int i = 0; i < together; i++) {
        assert_int_equal(of_line[i].degree, segments[i + 1].degree);
        assert_int_equal(of_line[i].end.y, 0);
    }
    assert_int_equal(of_line[together - 1].end.x, 60000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(straight),    cmocka_unit_test(one_quadratic),      cmocka_unit_test(arcs),
        cmocka_unit_test(two_samples), cmocka_unit_test(nodes_end_segments), cmocka_unit_test(two_masters),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
