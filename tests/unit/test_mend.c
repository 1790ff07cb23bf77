#include "geometry/limits.h"
#include "morph/check/contour_origin.h"
#include "morph/check/mend.h"
#include "morph/check/reconnect.h"
#include "support/check.h"
#include "support/moves.h"

#include <math.h>

enum { UNIT = MT_EM / 1000, ENOUGH = 1000000 };

static mt_arena arena;
static mt_params params;

static int set_up(void **state) {
    (void)state;
    params = mt_params_default();
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* Two squares that overlap by 50/1000 em at both ends, and half-way are 10/1000 em apart. */
static mt_morph coming_apart(void) {
    mt_ring in_a[] = {mt_test_square(&arena, 0, 0), mt_test_square(&arena, 50, 60)},
            in_b[] = {mt_test_square(&arena, 0, 0), mt_test_square(&arena, 60, 50)};
    mt_morph morph = mt_test_morph_of(&arena, in_a, in_b, 2);
    morph.contours[1].displacement = (mt_point){55 * UNIT, 55 * UNIT};
    return morph;
}

static mt_mending mending_of(mt_morph *morph, int64_t effort) {
    mt_mending m = {.morph = morph, .params = &params, .arena = &arena, .effort = effort};
    mt_assert_ok(mt_mend_begin(&m));
    return m;
}

/* Two squares are proved once, and looked at in the places of their lulls; where they stray once more. */
static void looking_is_charged(void **state) {
    (void)state;
    mt_morph morph = coming_apart();
    mt_mending m = mending_of(&morph, ENOUGH);
    assert_int_equal(m.effort, ENOUGH - m.error.corners);
    assert_true(m.error.corners >= 8 + 3 * 8 && m.error.corners <= 8 + 2 * 19 * 8);
    int64_t before = m.effort;
    mt_shape shape;
    mt_assert_ok(mt_mend_shape(&m, 0.5, MT_NONZERO, &shape));
    assert_int_equal(shape.count, 2);
    assert_int_equal(m.effort, before - 8);
}

static void better_is_what_strays_less(void **state) {
    (void)state;
    mt_morph morph = coming_apart();
    mt_mending m = mending_of(&morph, ENOUGH);
    int before = m.error.parts;
    bool better;
    assert_true(before > 0);
    mt_assert_ok(mt_mend_compare(&m, &better));
    assert_false(better);
    assert_int_equal(m.error.parts, before);
    mt_shift_contour(&morph.contours[1], (mt_point){-30 * UNIT, -30 * UNIT});
    mt_assert_ok(mt_mend_compare(&m, &better));
    assert_true(better);
    assert_int_equal(m.error.parts, 0);
    assert_false(mt_mend_goes_on(&m));
}

static void without_effort_nothing_changes(void **state) {
    (void)state;
    mt_morph morph = coming_apart();
    mt_mending m = mending_of(&morph, 1);
    int before = m.error.parts;
    assert_false(mt_mend_goes_on(&m));
    mt_assert_ok(mt_reconnect_parts(&m));
    assert_int_equal(m.error.parts, before);
    assert_int_equal(morph.contours[0].displacement.x, 0);
    assert_int_equal(morph.contours[1].displacement.x, 55 * UNIT);
}

static struct {
    int count;
    double places[MT_TOPOLOGY_STEPS];
} visits;

static mt_status visit(mt_mending *m, const void *stage, double t, bool *closed) {
    (void)m, (void)stage;
    visits.places[visits.count++] = t;
    *closed = t > 0.42 && t < 0.58;
    return MT_OK;
}

static void places_go_outwards_as_long_as_all_is_closed(void **state) {
    (void)state;
    mt_morph morph = coming_apart();
    mt_mending m = mending_of(&morph, ENOUGH);
    mt_assert_ok(mt_mend_outwards(&m, visit, NULL));
    assert_int_equal(visits.count, 4);
    const int from_half[] = {0, 50, 50, 100}; /* thousandths */
    for (int i = 0; i < 4; i++) assert_int_equal(lround(1000 * fabs(visits.places[i] - 0.5)), from_half[i]);
    assert_true((visits.places[1] < 0.5) != (visits.places[2] < 0.5));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(looking_is_charged),
        cmocka_unit_test(better_is_what_strays_less),
        cmocka_unit_test(without_effort_nothing_changes),
        cmocka_unit_test(places_go_outwards_as_long_as_all_is_closed),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
