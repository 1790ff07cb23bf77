#include "geometry/limits.h"
#include "morph/model/frame.h"
#include "morph/divide/reconcile.h"
#include "support/check.h"
#include "support/corpus.h"
#include "support/oracle.h"
#include "support/polygons.h"

#include <math.h>

enum { UNIT = MT_EM / 1000 };

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

static mt_side side_of(mt_shape shape) {
    mt_box box = mt_shape_box(&shape);
    return (mt_side){.whole = shape, .shape = shape, .box = box, .frame = mt_frame_of_box(box)};
}

static void reconcile(mt_shape a, mt_shape b, mt_cut_side *cut_a, mt_cut_side *cut_b) {
    mt_side in_a = side_of(a), in_b = side_of(b);
    const mt_hints none = {0};
    mt_params params = mt_params_default();
    mt_settings settings = mt_settings_at(0, &params);
    mt_assert_ok(mt_reconcile(&in_a, &in_b, &none, &settings, &arena, cut_a, cut_b));
}

/* Partners are mutual; parts are components, outer ring first. */
static void check_partners(const mt_cut_side *cut, const mt_cut_side *other) {
    for (int i = 0; i < cut->parts.count; i++) {
        assert_in_range(cut->partner[i] + 1, 0, other->parts.count);
        if (cut->partner[i] >= 0) assert_int_equal(other->partner[cut->partner[i]], i);
        for (int r = 0; r < cut->parts.components[i].count; r++)
            assert_true((mt_ring_area2(&cut->parts.components[i].rings[r]) > 0) == (r == 0));
    }
}

/* As many parts on both sides, each with a partner, and the ink that was drawn, to the unit. */
static void check_agreement(const mt_cut_side *cut, const mt_cut_side *other, const mt_shape *drawn,
                            int parts) {
    check_partners(cut, other);
    assert_int_equal(cut->parts.count, parts);
    for (int i = 0; i < parts; i++) assert_true(cut->partner[i] >= 0);
    assert_true(mt_oracle_shape_area2(&cut->parts) == mt_oracle_shape_area2(drawn));
}

/* Both ways round, which has to come to the same. */
static void check_both_ways(mt_shape a, mt_shape b, int parts) {
    for (int i = 0; i < 2; i++) {
        mt_cut_side cut_a, cut_b;
        reconcile(i ? b : a, i ? a : b, &cut_a, &cut_b);
        check_agreement(&cut_a, &cut_b, i ? &b : &a, parts);
        check_agreement(&cut_b, &cut_a, i ? &a : &b, parts);
    }
}

static mt_shape shape_of(const mt_ring *rings, int count) {
    mt_shape shape = {count, mt_arena_new(&arena, (size_t)count, sizeof(mt_component))};
    for (int i = 0; i < count; i++) {
        shape.components[i] = mt_test_rings(&arena, 1);
        shape.components[i].rings[0] = rings[i];
    }
    return shape;
}

static mt_ring block(int x, int y, int width, int height) {
    const int points[][2] = {{x, y}, {x + width, y}, {x + width, y + height}, {x, y + height}};
    return mt_test_ring_of(&arena, points, 4, UNIT);
}

/* An H of stems 100 wide, `gap` apart, with a crossbar 40 high; and its stems alone. */
static mt_shape an_h(int gap) {
    const int points[][2] = {{0, 0},           {100, 0},       {100, 330},       {100 + gap, 330},
                             {100 + gap, 0},   {200 + gap, 0}, {200 + gap, 700}, {100 + gap, 700},
                             {100 + gap, 370}, {100, 370},     {100, 700},       {0, 700}};
    mt_ring ring = mt_test_ring_of(&arena, points, 12, UNIT);
    return shape_of(&ring, 1);
}

static mt_shape stems(int gap) {
    mt_ring rings[] = {block(0, 0, 100, 700), block(100 + gap, 0, 100, 700)};
    return shape_of(rings, 2);
}

/* A dot above a stroke, in the other font merged with it by a neck, 60 wide and 30 high. */
static mt_shape dot_and_stroke(void) {
    mt_ring rings[] = {block(0, 0, 600, 120), block(220, 150, 160, 160)};
    return shape_of(rings, 2);
}

static mt_shape dot_in_stroke(void) {
    static const int points[][2] = {{0, 0},     {600, 0},   {600, 120}, {330, 120}, {330, 150}, {380, 150},
                                    {380, 310}, {220, 310}, {220, 150}, {270, 150}, {270, 120}, {0, 120}};
    mt_ring ring = mt_test_ring_of(&arena, points, 12, UNIT);
    return shape_of(&ring, 1);
}

static void an_h_and_its_stems(void **state) {
    (void)state;
    for (int gap = 20; gap <= 80; gap += 20) check_both_ways(stems(gap), an_h(gap), 2);
}

/* The H is cut across its crossbar: each part has one stem in it, and at most the crossbar more. */
static void the_crossbar_is_cut(void **state) {
    (void)state;
    mt_cut_side a, b;
    mt_shape apart = stems(60), joined = an_h(60);
    reconcile(apart, joined, &a, &b);
    check_agreement(&b, &a, &joined, 2);
    for (int i = 0; i < 2; i++) {
        int64_t more =
            mt_component_area2(&b.parts.components[a.partner[i]]) - mt_component_area2(&apart.components[i]);
        assert_true(more >= 0 && more <= 2LL * 60 * UNIT * 40 * UNIT);
        mt_box stem = mt_ring_box(&apart.components[i].rings[0]),
               part = mt_ring_box(&b.parts.components[a.partner[i]].rings[0]);
        assert_true(part.min.y == stem.min.y && part.max.y == stem.max.y);
        assert_true(part.min.x <= stem.min.x && part.max.x >= stem.max.x);
    }
}

/* Chords at both ends of a crossbar are taken for one cut, as long as it is not too wide. */
static void a_wide_h_and_its_stems(void **state) {
    (void)state;
    mt_cut_side a, b;
    mt_shape apart = stems(160), joined = an_h(160);
    reconcile(apart, joined, &a, &b);
    check_partners(&a, &b);
    check_partners(&b, &a);
    assert_true(a.partner[0] >= 0 && a.partner[1] >= 0);
}

/* Three bars one above the other, the lower two joined in the one, the upper two in the other: matchers of what is joined jump
 * over the white. */
static void joined_otherwise(void **state) {
    (void)state;
    static const int low[][2] = {{0, 0},     {600, 0}, {600, 100}, {340, 100}, {340, 200}, {600, 200},
                                 {600, 300}, {0, 300}, {0, 200},   {280, 200}, {280, 100}, {0, 100}};
    mt_ring lower[] = {mt_test_ring_of(&arena, low, 12, UNIT), block(0, 400, 600, 100)};
    mt_ring upper[] = {mt_test_ring_of(&arena, low, 12, UNIT), block(0, 0, 600, 100)};
    for (int i = 0; i < upper[0].count; i++) upper[0].points[i].y += 200 * UNIT;
    check_both_ways(shape_of(lower, 2), shape_of(upper, 2), 3);
}

static void a_dot_merged_into_a_stroke(void **state) {
    (void)state;
    check_both_ways(dot_and_stroke(), dot_in_stroke(), 2);
}

/* Sides that agree are not cut. */
static void nothing_to_cut(void **state) {
    (void)state;
    static const char *const names[] = {"square", "plus", "comb", "spiral", "frame", "l_shape"};
    for (int n = 0; n < 6; n++) {
        mt_component component =
            mt_test_moved(&arena, mt_corpus_find(&corpus, names[n]), 1000, (mt_point){0, 0});
        check_both_ways(mt_test_shape_of(&arena, &component), mt_test_shape_of(&arena, &component), 1);
    }
    check_both_ways(stems(60), stems(30), 2);
    check_both_ways(dot_and_stroke(), dot_and_stroke(), 2);
}

/* What has nothing on the other side has no partner, and no cut is left that does not help. */
static void what_only_one_side_has(void **state) {
    (void)state;
    mt_ring three[] = {block(0, 0, 600, 80), block(0, 300, 600, 80), block(0, 600, 600, 80)};
    mt_ring two[] = {block(0, 0, 600, 80), block(0, 600, 600, 80)};
    mt_shape more = shape_of(three, 3), less = shape_of(two, 2);
    mt_cut_side a, b;
    reconcile(more, less, &a, &b);
    check_partners(&a, &b);
    assert_true(a.parts.count == 3 && b.parts.count == 2);
    assert_true(a.partner[0] == 0 && a.partner[1] == -1 && a.partner[2] == 1);
}

/* At random: partners are mutual, and the ink is what it was but for the ends of cuts, which are rounded to the grid. */
static void random_shapes(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(25); n++) {
        mt_random random = mt_random_case(n);
        mt_arena_place place = mt_arena_mark(&arena);
        mt_shape shapes[2];
        mt_cut_side cut[2];
        for (int i = 0; i < 2; i++) shapes[i] = mt_random_shape(&random, &arena, 3, 16, MT_EM / 2);
        reconcile(shapes[0], shapes[1], &cut[0], &cut[1]);
        for (int i = 0; i < 2; i++) {
            check_partners(&cut[i], &cut[1 - i]);
            double off = (double)(mt_oracle_shape_area2(&cut[i].parts) - mt_oracle_shape_area2(&shapes[i]));
            assert_true(fabs(off) <= sqrt(0.5) * mt_oracle_shape_length(&shapes[i]));
        }
        mt_arena_rewind(&arena, place);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_h_and_its_stems),         cmocka_unit_test(the_crossbar_is_cut),
        cmocka_unit_test(a_wide_h_and_its_stems),     cmocka_unit_test(joined_otherwise),
        cmocka_unit_test(a_dot_merged_into_a_stroke), cmocka_unit_test(nothing_to_cut),
        cmocka_unit_test(what_only_one_side_has),     cmocka_unit_test(random_shapes),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
