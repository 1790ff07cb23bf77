#include "morph/check/separate.h"
#include "support/check.h"
#include "support/moves.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* Two squares that move from places of A to places of B. */
static mt_morph morph_of(const int (*a)[2], const int (*b)[2]) {
    mt_ring in_a[2], in_b[2];
    for (int i = 0; i < 2; i++) {
        in_a[i] = mt_test_square(&arena, a[i][0], a[i][1]);
        in_b[i] = mt_test_square(&arena, b[i][0], b[i][1]);
    }
    return mt_test_morph_of(&arena, in_a, in_b, 2);
}

/* One passes under the other, and half-way and after it comes a few thousandths of the em too high. */
static const int left[][2] = {{0, 0}, {150, 104}}, right[][2] = {{300, 10}, {150, 104}};

static void one_makes_way_for_the_other(void **state) {
    (void)state;
    mt_morph morph = morph_of(left, right);
    assert_true(mt_test_topology_error(&arena, &morph).merged > 0);
    assert_int_equal(mt_test_mend(&arena, mt_separate_parts, &morph).parts, 0);
    assert_true((mt_test_displacement(&morph, 0) > 0) != (mt_test_displacement(&morph, 1) > 0));
    for (int i = 0; i < 2; i++) assert_true(mt_test_displacement(&morph, i) < 17);
}

static void the_ends_stay(void **state) {
    (void)state;
    mt_morph morph = morph_of(left, right);
    mt_test_mend(&arena, mt_separate_parts, &morph);
    mt_test_ends_stay(&arena, &morph);
}

/* What is one component at an end, here as two squares that touch, has nothing to make way for. */
static void what_is_one_at_an_end_stays_together(void **state) {
    (void)state;
    const int apart[][2] = {{0, 0}, {150, 104}}, lying_on[][2] = {{300, 10}, {300, 110}};
    mt_morph morph = morph_of(apart, lying_on);
    assert_int_equal(morph.b.whole.count, 1);
    mt_test_mend(&arena, mt_separate_parts, &morph);
    assert_true(mt_test_displacement(&morph, 0) == 0 && mt_test_displacement(&morph, 1) == 0);
}

static void what_passes_freely_stays(void **state) {
    (void)state;
    const int higher[][2] = {{150, 124}, {0, 0}}, still[][2] = {{150, 124}, {300, 10}};
    mt_morph morph = morph_of(higher, still);
    assert_int_equal(mt_test_mend(&arena, mt_separate_parts, &morph).parts, 0);
    assert_true(mt_test_displacement(&morph, 0) == 0 && mt_test_displacement(&morph, 1) == 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_makes_way_for_the_other),
        cmocka_unit_test(the_ends_stay),
        cmocka_unit_test(what_is_one_at_an_end_stays_together),
        cmocka_unit_test(what_passes_freely_stays),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
