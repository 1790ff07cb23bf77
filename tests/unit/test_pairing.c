#include "geometry/limits.h"
#include "morph/align/pairing.h"
#include "support/check.h"
#include "support/polygons.h"

#include <math.h>

enum { UNIT = MT_EM / 1000, CHORD = MT_EM / 2000, MOST = 8 };

#define ANY 1e9 /* a cost that nothing costs */

static mt_arena arena;
static const mt_settings settings = {.flatness = CHORD, .align = {3, 4, 2}};

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* A box of 1/1000 em. */
static mt_ring block(int x, int y, int width, int height) {
    const int points[][2] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    return mt_test_ring_of(&arena, points, 4, UNIT);
}

static mt_box glyph_box(int width, int height) {
    return (mt_box){{0, 0}, {width * UNIT, height * UNIT}};
}

static mt_ring_list list_of(mt_ring *rings, int count, mt_box box) {
    mt_ring_list list = {count, mt_arena_new(&arena, MOST, sizeof(mt_ring *)), mt_frame_of_box(box)};
    for (int i = 0; i < count; i++) list.rings[i] = &rings[i];
    return list;
}

/* Pairs both ways round, which has to come to the same, and checks that partners are mutual. */
static void pair(const mt_ring_list *a, const mt_ring_list *b, double most, int *in_a, int *in_b) {
    int back_b[MOST], back_a[MOST];
    for (int i = 0; i < MOST; i++) in_a[i] = in_b[i] = back_a[i] = back_b[i] = -1;
    mt_assert_ok(mt_pair_rings(a, b, most, &settings, &arena, in_a, in_b));
    mt_assert_ok(mt_pair_rings(b, a, most, &settings, &arena, back_b, back_a));
    for (int i = 0; i < a->count; i++) {
        assert_in_range(in_a[i] + 1, 0, b->count);
        if (in_a[i] >= 0) assert_int_equal(in_b[in_a[i]], i);
        assert_int_equal(in_a[i], back_a[i]);
    }
    for (int k = 0; k < b->count; k++) {
        if (in_b[k] >= 0) assert_int_equal(in_a[in_b[k]], k);
        assert_int_equal(in_b[k], back_b[k]);
    }
}

static double cost_of(const mt_ring *p, mt_box box_p, const mt_ring *q, mt_box box_q) {
    double cost = -1;
    mt_frame frame_p = mt_frame_of_box(box_p), frame_q = mt_frame_of_box(box_q);
    mt_assert_ok(mt_pair_cost(p, &frame_p, q, &frame_q, &settings, &arena, &cost));
    return cost;
}

/* Four strokes of 王, all permutations of them, a little moved and thinner on the other side. */
static void permuted_rings_are_found(void **state) {
    (void)state;
    mt_ring a[4] = {block(100, 800, 800, 100), block(150, 400, 700, 100), block(0, 0, 1000, 100),
                    block(450, 0, 100, 900)};
    for (int n = 0; n < 24; n++) {
        int order[4] = {n % 4, 0, 0, 0}, left = n / 4, used = 1 << order[0];
        for (int i = 1; i < 4; i++) {
            int skip = left % (4 - i);
            left /= 4 - i;
            while (used >> order[i] & 1 || skip-- > 0) order[i]++;
            used |= 1 << order[i];
        }
        mt_ring thin[4] = {block(120, 810, 750, 60), block(140, 440, 710, 60), block(10, 20, 980, 60),
                           block(480, 20, 60, 850)},
                b[4];
        for (int i = 0; i < 4; i++) b[order[i]] = thin[i];
        mt_ring_list in_a = list_of(a, 4, glyph_box(1000, 900)), in_b = list_of(b, 4, glyph_box(1000, 900));
        int partner_a[MOST], partner_b[MOST];
        pair(&in_a, &in_b, ANY, partner_a, partner_b);
        for (int i = 0; i < 4; i++) assert_int_equal(partner_a[i], order[i]);
    }
}

/* Places are relative to each glyph's own box. */
static void boxes_are_taken_into_account(void **state) {
    (void)state;
    mt_ring a[2] = {block(0, 0, 200, 900), block(800, 0, 200, 900)},
            b[2] = {block(400, 0, 100, 450), block(0, 0, 100, 450)};
    mt_ring_list in_a = list_of(a, 2, glyph_box(1000, 900)), in_b = list_of(b, 2, glyph_box(500, 450));
    int partner_a[MOST], partner_b[MOST];
    pair(&in_a, &in_b, ANY, partner_a, partner_b);
    assert_int_equal(partner_a[0], 1);
    assert_int_equal(partner_a[1], 0);
    assert_true(cost_of(&a[0], in_a.frame.box, &b[1], in_b.frame.box) < 1e-6);
}

/* A dot above and the same dot below are not paired, though they are all that there is. */
static void far_rings_are_not_paired(void **state) {
    (void)state;
    mt_ring above = block(450, 800, 100, 100), below = block(450, 0, 100, 100),
            near = block(450, 600, 100, 100);
    mt_ring_list a = list_of(&above, 1, glyph_box(1000, 900)), b = list_of(&below, 1, glyph_box(1000, 900)),
                 c = list_of(&near, 1, glyph_box(1000, 900));
    int partner_a[MOST], partner_b[MOST];
    pair(&a, &b, ANY, partner_a, partner_b);
    assert_true(partner_a[0] == -1 && partner_b[0] == -1);
    pair(&a, &c, ANY, partner_a, partner_b);
    assert_true(partner_a[0] == 0 && partner_b[0] == 0);
}

/* Two rings of A for one of B: the one that costs less has it, though it comes second. */
static void the_cheapest_pair_comes_first(void **state) {
    (void)state;
    mt_ring a[2] = {block(0, 400, 1000, 100), block(0, 380, 1000, 140)}, b[1] = {block(0, 380, 1000, 140)};
    mt_ring_list in_a = list_of(a, 2, glyph_box(1000, 900)), in_b = list_of(b, 1, glyph_box(1000, 900));
    int partner_a[MOST], partner_b[MOST];
    pair(&in_a, &in_b, ANY, partner_a, partner_b);
    assert_true(partner_a[0] == -1 && partner_a[1] == 0 && partner_b[0] == 1);
}

/* A pair that costs more than it may is none. */
static void dear_pairs_are_left(void **state) {
    (void)state;
    mt_ring p = block(0, 0, 200, 900), q = block(100, 0, 200, 700);
    mt_box box = glyph_box(1000, 900);
    mt_ring_list a = list_of(&p, 1, box), b = list_of(&q, 1, box);
    double cost = cost_of(&p, box, &q, box);
    int partner_a[MOST], partner_b[MOST];
    pair(&a, &b, 1.01 * cost, partner_a, partner_b);
    assert_int_equal(partner_a[0], 0);
    pair(&a, &b, 0.99 * cost, partner_a, partner_b);
    assert_int_equal(partner_a[0], -1);
}

/* What is paired before stays so, however costly; only the others are looked at. */
static void given_pairs_are_kept(void **state) {
    (void)state;
    mt_ring a[3] = {block(0, 0, 200, 900), block(400, 0, 200, 900), block(800, 0, 200, 900)};
    mt_ring_list list = list_of(a, 3, glyph_box(1000, 900));
    int partner_a[] = {-1, -1, 0}, partner_b[] = {2, -1, -1};
    mt_assert_ok(mt_pair_rings(&list, &list, 0.1, &settings, &arena, partner_a, partner_b));
    assert_true(partner_a[0] == -1 && partner_a[1] == 1 && partner_a[2] == 0);
    assert_true(partner_b[0] == 2 && partner_b[1] == 1 && partner_b[2] == -1);
}

static void nothing_to_pair(void **state) {
    (void)state;
    mt_ring a[2] = {block(0, 0, 100, 100), block(300, 0, 100, 100)};
    mt_ring_list some = list_of(a, 2, glyph_box(400, 100)), none = list_of(a, 0, glyph_box(400, 100));
    int partner_a[MOST], partner_b[MOST];
    pair(&some, &none, ANY, partner_a, partner_b);
    assert_true(partner_a[0] == -1 && partner_a[1] == -1);
    pair(&none, &none, ANY, partner_a, partner_b);
}

/* The cost: none for a ring with itself, the same both ways, more the further apart. */
static void costs(void **state) {
    (void)state;
    mt_box box = glyph_box(1000, 900);
    double last = 0;
    mt_ring still = block(100, 100, 200, 300);
    assert_true(cost_of(&still, box, &still, box) < 1e-6);
    for (int by = 50; by <= 600; by += 50) {
        mt_ring moved = block(100 + by, 100, 200, 300);
        double cost = cost_of(&still, box, &moved, box);
        assert_true(cost > last);
        assert_true(fabs(cost - cost_of(&moved, box, &still, box)) < 1e-6);
        last = cost;
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(permuted_rings_are_found), cmocka_unit_test(boxes_are_taken_into_account),
        cmocka_unit_test(far_rings_are_not_paired), cmocka_unit_test(the_cheapest_pair_comes_first),
        cmocka_unit_test(dear_pairs_are_left),      cmocka_unit_test(given_pairs_are_kept),
        cmocka_unit_test(nothing_to_pair),          cmocka_unit_test(costs),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
