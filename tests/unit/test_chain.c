#include "geometry/chain.h"
#include "support/check.h"
#include "support/curves.h"

#include <math.h>

enum { SAMPLES = 41, ROOM = 6 };

static mt_arena arena;
static mt_sample samples[2][SAMPLES];
static mt_vec controls[2][ROOM];
static double shares[ROOM];

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* A quarter of an ellipse, from its right end to its top. */
static mt_chain_end ellipse(int master, double w, double h, bool end) {
    for (int i = 0; i < SAMPLES; i++) {
        double angle = M_PI / 2 * i / (SAMPLES - 1), x = w * cos(angle), y = h * sin(angle);
        double heading = atan2(h * cos(angle), -w * sin(angle));
        samples[master][i] = mt_sample_at(x, y, heading, false);
    }
    return end ? (mt_chain_end){{0, h}, {-1, 0}, 0} : (mt_chain_end){{w, 0}, {0, 1}, 0};
}

/* Two quadratics for a quarter, joined where the angle is `degrees`; a poor guess, and another in each master. */
static void guess(mt_chain *c, int master, double w, double h, double degrees) {
    double turn = degrees * M_PI / 180, rest = M_PI / 2 - turn;
    c->control[master][0] = (mt_vec){w, h * tan(turn / 2)};
    c->control[master][1] = (mt_vec){w * tan(rest / 2), h};
}

static mt_chain quarters(int room, double w, double h) {
    mt_chain c = {.count = 2, .room = room, .control = {controls[0], controls[1]}, .share = shares};
    ellipse(0, 100000, 100000, false);
    ellipse(1, w, h, false);
    c.start[0] = ellipse(0, 100000, 100000, false);
    c.end[0] = ellipse(0, 100000, 100000, true);
    c.start[1] = ellipse(1, w, h, false);
    c.end[1] = ellipse(1, w, h, true);
    guess(&c, 0, 100000, 100000, 30);
    guess(&c, 1, w, h, 60);
    shares[0] = 0.4;
    return c;
}

static bool fit(mt_chain *c, double tolerance) {
    mt_run runs[2] = {{SAMPLES - 2, samples[0] + 1}, {SAMPLES - 2, samples[1] + 1}};
    bool fits = false;
    mt_assert_ok(mt_chain_fit(runs, tolerance, &arena, c, &fits));
    return fits;
}

/* A master of the chain as a contour, closed by a line. */
static mt_contour contour_of(const mt_chain *c, int master, mt_segment segments[ROOM + 1]) {
    segments[0] = (mt_segment){
        .degree = 1, .end = {(int32_t)lround(c->start[master].at.x), (int32_t)lround(c->start[master].at.y)}};
    for (int k = 0; k < c->count; k++) {
        mt_vec p = c->control[master][k], end = mt_chain_node(c, master, k + 1);
        segments[k + 1] = (mt_segment){.degree = 2,
                                       .control = {{(int32_t)lround(p.x), (int32_t)lround(p.y)}},
                                       .end = {(int32_t)lround(end.x), (int32_t)lround(end.y)}};
    }
    return (mt_contour){c->count + 1, segments};
}

static double worst_distance(const mt_chain *c, int master) {
    mt_segment segments[ROOM + 1];
    mt_contour contour = contour_of(c, master, segments);
    mt_outline outline = mt_curves_outline(&arena, &contour);
    double worst = 0;
    for (int i = 0; i < SAMPLES; i++)
        worst = fmax(worst, mt_curves_distance(&outline, samples[master][i].x, samples[master][i].y));
    return worst;
}

/* Half-way between two ellipses no node turns: the handles on its sides are in line. */
static void no_node_turns(const mt_chain *c) {
    for (int k = 1; k < c->count; k++)
        for (int i = 1; i < 4; i++) {
            double t = i / 4.0;
            mt_vec p[3];
            for (int j = 0; j < 3; j++) {
                mt_vec a = j == 1 ? mt_chain_node(c, 0, k) : c->control[0][k - 1 + j / 2];
                mt_vec b = j == 1 ? mt_chain_node(c, 1, k) : c->control[1][k - 1 + j / 2];
                p[j] = (mt_vec){a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
            }
            mt_vec in = {p[1].x - p[0].x, p[1].y - p[0].y}, out = {p[2].x - p[1].x, p[2].y - p[1].y};
            assert_true(fabs(atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y)) < 1e-9);
        }
}

static void fits_both(void **state) {
    (void)state;
    for (double tolerance = 1000; tolerance >= 60; tolerance /= 2) {
        mt_chain c = quarters(ROOM, 60000, 110000);
        assert_true(fit(&c, tolerance));
        assert_true(worst_distance(&c, 0) <= tolerance + 1);
        assert_true(worst_distance(&c, 1) <= tolerance + 1);
        no_node_turns(&c);
    }
}

/* Nodes half-way between their controls come first; circles need no others. */
static void shares_are_even_where_they_can(void **state) {
    (void)state;
    mt_chain c = quarters(ROOM, 50000, 50000);
    assert_true(fit(&c, 1000));
    assert_int_equal(c.count, 2);
    assert_true(c.share[0] == 0.5);
}

/* The tighter, the more segments, as long as there is room. */
static void divides(void **state) {
    (void)state;
    mt_chain c = quarters(ROOM, 60000, 110000);
    assert_true(fit(&c, 100));
    assert_true(c.count > 2);
    c = quarters(2, 60000, 110000);
    assert_false(fit(&c, 100));
    c = quarters(ROOM, 60000, 110000);
    assert_false(fit(&c, 0.01));
}

/* A handle that goes on from a line has the ratio that the lines have. */
static void arms_have_their_ratio(void **state) {
    (void)state;
    mt_chain c = quarters(ROOM, 60000, 110000);
    c.start[0].arm = 20000;
    c.start[1].arm = 50000;
    assert_true(fit(&c, 200));
    double one = c.control[0][0].y, other = c.control[1][0].y;
    assert_true(c.control[0][0].x == 100000 && c.control[1][0].x == 60000);
    assert_true(one > 0 && fabs(one / other - 0.4) < 1e-9);
    assert_true(worst_distance(&c, 0) <= 201 && worst_distance(&c, 1) <= 201);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fits_both),
        cmocka_unit_test(shares_are_even_where_they_can),
        cmocka_unit_test(divides),
        cmocka_unit_test(arms_have_their_ratio),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
