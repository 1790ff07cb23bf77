#include "morph/between/seam_overlap.h"

#include <math.h>

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/between/variable_outline.h"
#include "morph/prepare.h"
#include "support/check.h"
#include "support/polygons.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static void check_compatible(const mt_variable_outline *moving) {
    for (int i = 0; i < moving->count; i++) {
        const mt_contour_pair *m = &moving->contours[i];
        assert_int_equal(m->a.count, m->b.count);
        for (int k = 0; k < m->a.count; k++) {
            assert_int_equal(m->a.segments[k].degree, m->b.segments[k].degree);
            assert_in_range(m->a.segments[k].degree, 1, 2);
        }
    }
}

static mt_shape ink_at(const mt_morph *morph, const mt_variable_outline *moving, double t,
                       const mt_params *params) {
    mt_outline outline;
    mt_shape ink;
    bool clean;
    mt_assert_ok(mt_variable_outline_at(morph, moving, mt_weights_at(t), &arena, &outline));
    mt_assert_ok(mt_outline_resolve(&outline, mt_grid_units(params->tolerance) / 4, &arena, &ink, &clean));
    return ink;
}

/* Of the ink of both, how much is in one of them only, over all. */
static double difference(const mt_shape *a, const mt_shape *b) {
    mt_rings in_a = mt_test_all_rings(&arena, a), in_b = mt_test_all_rings(&arena, b);
    mt_rings all = mt_test_rings(&arena, in_a.count + in_b.count);
    mt_shape both;
    for (int i = 0; i < in_a.count; i++) all.rings[i] = in_a.rings[i];
    for (int i = 0; i < in_b.count; i++) all.rings[in_a.count + i] = in_b.rings[i];
    mt_assert_ok(mt_union(&all, MT_NONZERO, &arena, &both));
    double whole = (double)mt_shape_area2(&both);
    return whole > 0 ? (2 * whole - (double)mt_shape_area2(a) - (double)mt_shape_area2(b)) / whole : 0;
}

/* The contours that move cover what the blend covers, at any place, by either method. */
static void moving_contours_are_the_blend(void **state) {
    (void)state;
    static const double places[] = {0, 0.2, 0.5, 0.9, 1};
    for (int n = 0; n < mt_test_cases(60); n++) {
        mt_random random = mt_random_case(n);
        mt_params params = mt_params_default();
        params.method = n % 2 ? MT_METHOD_PAPER : MT_METHOD_JOINT;
        mt_shape a = mt_random_shape(&random, &arena, 2, 12, MT_EM / 2);
        mt_shape b = mt_random_shape(&random, &arena, 2, 12, MT_EM / 2);
        mt_morph morph;
        mt_variable_outline moving;
        mt_assert_ok(mt_morph_prepare(&a, &b, NULL, &params, &arena, &morph));
        mt_assert_ok(mt_variable_outline_make(&morph, &params, &arena, &moving));
        check_compatible(&moving);
        for (int i = 0; i < 5; i++) {
            mt_shape blend, ink = ink_at(&morph, &moving, places[i], &params);
            mt_assert_ok(mt_morph_blend(&morph, mt_weights_at(places[i]), &params, &arena, &blend));
            assert_true(difference(&ink, &blend) < 0.03);
        }
        mt_arena_reset(&arena);
    }
}

/* A contour of straight lines through these points, anticlockwise. */
static mt_contour lines(const int (*points)[2]) {
    mt_contour contour = {4, mt_arena_new(&arena, 4, sizeof(mt_segment))};
    assert_non_null(contour.segments);
    for (int i = 0; i < 4; i++)
        contour.segments[i] = (mt_segment){.degree = 1, .end = {256 * points[i][0], 256 * points[i][1]}};
    return contour;
}

/* One bar that parts into two: at its end the parts cover a strip along the cut twice, and no more ink than there was; at the
 * other end nothing moves. */
static void contours_lie_over_one_another_at_a_cut(void **state) {
    (void)state;
    const int bar[4][2] = {{0, 0}, {600, 0}, {600, 300}, {0, 300}};
    const int halves[2][4][2] = {{{0, 0}, {300, 0}, {300, 300}, {0, 300}},
                                 {{300, 0}, {600, 0}, {600, 300}, {300, 300}}};
    const int apart[2][4][2] = {{{-200, 0}, {100, 0}, {100, 300}, {-200, 300}},
                                {{500, 0}, {800, 0}, {800, 300}, {500, 300}}};
    mt_ring rings[] = {mt_test_ring_of(&arena, bar, 4, 256), mt_test_ring_of(&arena, apart[0], 4, 256),
                       mt_test_ring_of(&arena, apart[1], 4, 256)};
    mt_component parts[] = {{1, &rings[0]}, {1, &rings[1]}, {1, &rings[2]}};
    mt_morph morph = {.a.whole = {1, &parts[0]}, .b.whole = {2, &parts[1]}};
    mt_contour_pair masters[2] = {{lines(halves[0]), lines(apart[0]), {0, 0}},
                                  {lines(halves[1]), lines(apart[1]), {0, 0}}};
    mt_variable_outline moving = {2, masters};
    mt_params params = mt_params_default();
    const double reach = 384;
    mt_assert_ok(mt_overlap_seams(&morph, reach, &arena, &moving));
    check_compatible(&moving);
    mt_shape at_a = ink_at(&morph, &moving, 0, &params), at_b = ink_at(&morph, &moving, 1, &params);
    assert_true(difference(&at_a, &morph.a.whole) < 1e-9);
    assert_true(difference(&at_b, &morph.b.whole) < 1e-9);
    mt_outline outline;
    mt_rings drawn;
    int64_t covered = 0;
    mt_assert_ok(mt_variable_outline_at(&morph, &moving, mt_weights_at(0), &arena, &outline));
    mt_assert_ok(mt_flatten(&outline, 64, &arena, &drawn));
    for (int i = 0; i < drawn.count; i++) covered += mt_ring_area2(&drawn.rings[i]);
    double twice = (double)(covered - mt_shape_area2(&at_a)) / 2, length = 300 * 256;
    assert_true(twice > 1.9 * reach * (length - 4 * reach) && twice < 2 * reach * length);
}

static void steps_follow_the_arc(void **state) {
    (void)state;
    const int square[4][2] = {{-400, -400}, {400, -400}, {400, 400}, {-400, 400}};
    mt_params params = mt_params_default();
    params.rotation = MT_ROTATION_GIVEN;
    params.degrees = 90;
    mt_ring ring = mt_test_ring_of(&arena, square, 4, 256);
    mt_component part = {1, &ring};
    mt_shape shape = {1, &part};
    mt_morph morph;
    mt_variable_outline moving;
    mt_assert_ok(mt_morph_prepare(&shape, &shape, NULL, &params, &arena, &morph));
    mt_assert_ok(mt_variable_outline_make(&morph, &params, &arena, &moving));
    double bound = mt_grid_units(1);
    int steps = mt_variable_outline_steps(&morph, &moving, bound);
    assert_in_range(steps, 2, MT_TURN_STEPS_MAX - 1);
    mt_outline from, to, half;
    mt_assert_ok(mt_variable_outline_at(&morph, &moving, mt_weights_at(0), &arena, &from));
    mt_assert_ok(mt_variable_outline_at(&morph, &moving, mt_weights_at(1.0 / steps), &arena, &to));
    mt_assert_ok(mt_variable_outline_at(&morph, &moving, mt_weights_at(0.5 / steps), &arena, &half));
    for (int k = 0; k < from.contours[0].count; k++) {
        mt_point p = from.contours[0].segments[k].end, q = to.contours[0].segments[k].end,
                 m = half.contours[0].segments[k].end;
        assert_true(hypot((p.x + q.x) / 2.0 - m.x, (p.y + q.y) / 2.0 - m.y) <= bound + 2);
    }
    params.degrees = 0;
    params.rotation = MT_ROTATION_NONE;
    mt_assert_ok(mt_morph_prepare(&shape, &shape, NULL, &params, &arena, &morph));
    assert_int_equal(mt_variable_outline_steps(&morph, &moving, bound), 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moving_contours_are_the_blend),
        cmocka_unit_test(contours_lie_over_one_another_at_a_cut),
        cmocka_unit_test(steps_follow_the_arc),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
