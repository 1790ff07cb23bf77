#include "geometry/limits.h"
#include "morph/aside.h"
#include "support/check.h"
#include "support/polygons.h"

#include <limits.h>
#include <stdlib.h>

enum { UNIT = MT_EM / 1000 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* A square of 100/1000 em. */
static mt_component square(int x, int y) {
    const int points[][2] = {{x, y}, {x + 100, y}, {x + 100, y + 100}, {x, y + 100}};
    mt_component component = mt_test_rings(&arena, 1);
    component.rings[0] = mt_test_ring_of(&arena, points, 4, UNIT);
    return component;
}

static mt_contour contour_of(const mt_component *component) {
    mt_contour contour = {4, mt_arena_new(&arena, 4, sizeof(mt_segment))};
    for (int i = 0; i < 4; i++)
        contour.segments[i] = (mt_segment){.degree = 1, .end = component->rings[0].points[i]};
    return contour;
}

static mt_side side_of(const mt_component *squares, int count) {
    mt_side side = {.whole = {count, mt_arena_new(&arena, (size_t)count, sizeof(mt_component))}};
    for (int i = 0; i < count; i++) side.whole.components[i] = squares[i];
    side.shape = side.whole;
    side.box = mt_shape_box(&side.whole);
    return side;
}

/* Squares that move from places of A to places of B. */
static mt_morph morph_of(const int (*a)[2], const int (*b)[2], int count) {
    mt_component in_a[4], in_b[4];
    mt_morph morph = {.contour_count = count, .contours = mt_arena_new(&arena, 4, sizeof(mt_masters))};
    for (int i = 0; i < count; i++) {
        in_a[i] = square(a[i][0], a[i][1]);
        in_b[i] = square(b[i][0], b[i][1]);
        morph.contours[i] = (mt_masters){.a = contour_of(&in_a[i]), .b = contour_of(&in_b[i])};
    }
    morph.a = side_of(in_a, count);
    morph.b = side_of(in_b, count);
    return morph;
}

static mt_straying strays(const mt_morph *morph) {
    mt_params params = mt_params_default();
    mt_straying by;
    mt_assert_ok(mt_morph_strays(morph, INT_MAX, &params, &arena, &by));
    return by;
}

static mt_straying stand_aside(mt_morph *morph) {
    mt_params params = mt_params_default();
    mt_straying by = strays(morph);
    mt_assert_ok(mt_stand_aside(morph, &params, &arena, &by));
    assert_int_equal(by.parts, strays(morph).parts);
    return by;
}

static bool stands_aside(const mt_morph *morph, int contour) {
    return !mt_point_equal(morph->contours[contour].aside, (mt_point){0, 0});
}

/* One passes under the other, and half-way and after it comes a few thousandths of the em too high. */
static const int left[][2] = {{0, 0}, {150, 104}}, right[][2] = {{300, 10}, {150, 104}};

static void one_makes_way_for_the_other(void **state) {
    (void)state;
    mt_morph morph = morph_of(left, right, 2);
    assert_true(strays(&morph).parts > 0);
    assert_int_equal(stand_aside(&morph).parts, 0);
    assert_true(stands_aside(&morph, 0) != stands_aside(&morph, 1));
    for (int i = 0; i < 2; i++)
        assert_true(abs(morph.contours[i].aside.x) <= 12 * UNIT &&
                    abs(morph.contours[i].aside.y) <= 12 * UNIT);
}

static void the_ends_stay(void **state) {
    (void)state;
    mt_params params = mt_params_default();
    mt_morph morph = morph_of(left, right, 2);
    stand_aside(&morph);
    for (int t = 0; t < 2; t++) {
        const mt_side *side = t ? &morph.b : &morph.a;
        mt_shape blend;
        mt_assert_ok(mt_morph_blend(&morph, mt_weights_at(t), &params, &arena, &blend));
        assert_int_equal(mt_shape_area2(&blend), mt_shape_area2(&side->whole));
        mt_box box = mt_shape_box(&blend);
        assert_memory_equal(&box, &side->box, sizeof box);
    }
}

/* What is one component at an end, here by an edge that both have, has nothing to make way for. */
static void what_is_one_at_an_end_stays_together(void **state) {
    (void)state;
    const int apart[][2] = {{0, 0}, {150, 104}}, lying_on[][2] = {{300, 10}, {300, 110}};
    mt_morph morph = morph_of(apart, lying_on, 2);
    const int points[][2] = {{300, 10}, {400, 10}, {400, 210}, {300, 210}};
    mt_component tower = mt_test_rings(&arena, 1);
    tower.rings[0] = mt_test_ring_of(&arena, points, 4, UNIT);
    morph.b = side_of(&tower, 1);
    stand_aside(&morph);
    assert_false(stands_aside(&morph, 0) || stands_aside(&morph, 1));
}

static void what_passes_freely_stays(void **state) {
    (void)state;
    const int higher[][2] = {{150, 124}, {0, 0}}, still[][2] = {{150, 124}, {300, 10}};
    mt_morph morph = morph_of(higher, still, 2);
    assert_int_equal(stand_aside(&morph).parts, 0);
    assert_false(stands_aside(&morph, 0) || stands_aside(&morph, 1));
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
