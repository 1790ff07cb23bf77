#include "morph/fit/contour_pair.h"
#include "support/check.h"
#include "support/curves.h"
#include "support/oracle.h"

#include <math.h>

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

enum { CHORD = 128 };

typedef struct side {
    mt_rings rings;
    mt_ring_samples samples;
} side;

static side side_of(const mt_contour *contour, double step) {
    side made;
    mt_outline outline = mt_curves_outline(&arena, contour);
    mt_trace trace;
    mt_assert_ok(mt_flatten(&outline, CHORD, &arena, &made.rings));
    assert_int_equal(made.rings.count, 1);
    mt_assert_ok(mt_trace_ring(&made.rings.rings[0], CHORD, &arena, &trace));
    mt_assert_ok(mt_ring_samples_of(&trace, 128, step, &arena, &made.samples));
    return made;
}

static mt_contour_pair masters_of(const side *a, const side *b, double tolerance) {
    mt_alignment alignment;
    mt_contour_pair masters;
    mt_frame frame_a = mt_frame_of_box(mt_ring_box(&a->rings.rings[0])),
             frame_b = mt_frame_of_box(mt_ring_box(&b->rings.rings[0]));
    mt_assert_ok(mt_align(&a->samples, &frame_a, &b->samples, &frame_b, &(mt_cost_weights){3, 4, 2},
                          &(mt_links){0}, &arena, &alignment));
    mt_assert_ok(mt_contour_pair_fit(&a->samples, &b->samples, &alignment, tolerance, &arena, &masters));
    return masters;
}

static void check_compatible(const mt_contour_pair *masters) {
    assert_int_equal(masters->a.count, masters->b.count);
    for (int i = 0; i < masters->a.count; i++) {
        assert_int_equal(masters->a.segments[i].degree, masters->b.segments[i].degree);
        assert_in_range(masters->a.segments[i].degree, 1, 2);
    }
}

static mt_contour mixed(const mt_contour_pair *masters, double t) {
    mt_contour contour;
    mt_assert_ok(mt_contour_pair_mix(masters, mt_weights_at(t), &arena, &contour));
    return contour;
}

static mt_contour ellipse(mt_segment quarters[4], int w, int h) {
    const double k = 0.5522847;
    int p = (int)lround(w * k), q = (int)lround(h * k);
    quarters[0] = (mt_segment){3, {{w, q}, {p, h}}, {0, h}};
    quarters[1] = (mt_segment){3, {{-p, h}, {-w, q}}, {-w, 0}};
    quarters[2] = (mt_segment){3, {{-w, -q}, {-p, -h}}, {0, -h}};
    quarters[3] = (mt_segment){3, {{p, -h}, {w, -q}}, {w, 0}};
    return (mt_contour){4, quarters};
}

static double worst_off_ellipse(const mt_contour *contour, double w, double h) {
    double worst = 0;
    for (int i = 0; i < contour->count; i++)
        for (int k = 0; k < 32; k++) {
            mt_place2 p = mt_curves_at(contour, i, k / 32.0);
            double radius = hypot(p.x / w, p.y / h); /* off by at most this share of the longer half-axis */
            worst = fmax(worst, fabs(radius - 1) * fmax(w, h));
        }
    return worst;
}

/* Between two ellipses lie ellipses, in a few quadratics. */
static void ellipses(void **state) {
    (void)state;
    mt_segment one[4], other[4];
    mt_contour wide = ellipse(one, 100000, 60000), tall = ellipse(other, 50000, 90000);
    side a = side_of(&wide, 10000), b = side_of(&tall, 10000);
    mt_contour_pair masters = masters_of(&a, &b, 128);
    check_compatible(&masters);
    assert_true(masters.a.count <= 24);
    for (int i = 0; i <= 4; i++) {
        mt_contour contour = mixed(&masters, i / 4.0);
        for (int k = 0; k < contour.count; k++) assert_int_equal(contour.segments[k].degree, 2);
        assert_true(worst_off_ellipse(&contour, 100000 - i * 12500, 60000 + i * 7500) <= 1000);
    }
}

/* The ends and the controls of the mix lie where the weights say. */
static void mixes(void **state) {
    (void)state;
    mt_segment one[] = {{1, {{0}}, {0, 0}}, {2, {{100, 0}}, {100, 100}}},
               other[] = {{1, {{0}}, {40, 80}}, {2, {{80, 0}}, {0, 0}}};
    mt_contour_pair masters = {.a = {2, one}, .b = {2, other}};
    mt_contour contour = mixed(&masters, 0.25);
    assert_int_equal(contour.count, 2);
    assert_true(contour.segments[0].degree == 1 && contour.segments[1].degree == 2);
    assert_true(contour.segments[0].end.x == 10 && contour.segments[0].end.y == 20);
    assert_true(contour.segments[1].control[0].x == 95 && contour.segments[1].end.y == 75);
}

/* Polygons keep their corners on both sides, and lines stay lines. */
static void corners_on_both_sides(void **state) {
    (void)state;
    mt_segment box[] = {
        {1, {{0}}, {90000, 0}}, {1, {{0}}, {90000, 50000}}, {1, {{0}}, {0, 50000}}, {1, {{0}}, {0, 0}}};
    mt_segment slanted[] = {{1, {{0}}, {80000, 5000}},
                            {1, {{0}}, {99000, 60000}},
                            {1, {{0}}, {20000, 50000}},
                            {1, {{0}}, {0, 0}}};
    side a = side_of(&(mt_contour){4, box}, 10000), b = side_of(&(mt_contour){4, slanted}, 10000);
    mt_contour_pair masters = masters_of(&a, &b, 128);
    check_compatible(&masters);
    assert_in_range(masters.a.count, 4, 8); /* a corner may come a step before the other side's */
    mt_outline in_a = mt_curves_outline(&arena, &masters.a), in_b = mt_curves_outline(&arena, &masters.b);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(masters.a.segments[i].degree, 1);
        assert_true(mt_curves_distance(&in_a, box[i].end.x, box[i].end.y) == 0);
        assert_true(mt_curves_distance(&in_b, slanted[i].end.x, slanted[i].end.y) == 0);
    }
}

/* Each side within its tolerance, and a tenth of that where nodes were moved, at its vertices. */
static void random_contours(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(12); n++) {
        mt_random random = mt_random_case(n);
        mt_contour one = mt_random_contour(&random, &arena, mt_random_between(&random, 4, 7), 200000);
        mt_contour other = mt_random_contour(&random, &arena, mt_random_between(&random, 4, 7), 150000);
        side sides[] = {side_of(&one, 6000), side_of(&other, 6000)};
        const double tolerance = 256;
        mt_contour_pair masters = masters_of(&sides[0], &sides[1], tolerance);
        check_compatible(&masters);
        for (int s = 0; s < 2; s++) {
            mt_outline fitted = mt_curves_outline(&arena, s ? &masters.b : &masters.a);
            mt_subject subject = {"random_contours", n, {&sides[s].rings}};
            const mt_ring *ring = &sides[s].rings.rings[0];
            for (int i = 0; i < ring->count; i++)
                mt_require(mt_curves_distance(&fitted, ring->points[i].x, ring->points[i].y) <=
                               1.1 * tolerance + 1,
                           &subject);
        }
        mt_arena_reset(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ellipses),
        cmocka_unit_test(mixes),
        cmocka_unit_test(corners_on_both_sides),
        cmocka_unit_test(random_contours),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
