#include "geometry/limits.h"
#include "morph/align/view.h"
#include "morph/align/lifted.h"
#include "morph/align/registration.h"
#include "support/check.h"
#include "support/polygons.h"

#include <math.h>

enum { UNIT = MT_EM / 1000, CHORD = MT_EM / 2000 };

static mt_arena arena;
static const mt_settings settings = {.flatness = CHORD, .align = {3, 4, 2}};

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* An E: three arms on a stem, each line `pen` thick, `wide` broad, and leaning by `slant`. */
static mt_shape letter(int pen, int wide, double slant) {
    const int x[] = {0, wide, wide, pen, pen, wide * 3 / 4, wide * 3 / 4, pen, pen, wide, wide, 0};
    const int half = 350 - pen / 2,
              y[] = {0, 0, pen, pen, half, half, half + pen, half + pen, 700 - pen, 700 - pen, 700, 700};
    mt_component *component = mt_arena_new(&arena, 1, sizeof *component);
    *component = (mt_component){1, mt_arena_new(&arena, 1, sizeof(mt_ring))};
    component->rings[0] = mt_test_ring(&arena, 12);
    for (int i = 0; i < 12; i++)
        component->rings[0].points[i] =
            (mt_point){(int32_t)lround(UNIT * (x[i] + slant * y[i])), UNIT * y[i]};
    return (mt_shape){1, component};
}

static mt_side side_of(mt_shape shape) {
    mt_box box = mt_shape_box(&shape);
    return (mt_side){.whole = shape, .shape = shape, .box = box, .frame = mt_frame_of_box(box)};
}

/* Sets the frames of a placing. *applies: it is one for these two. */
static void place(mt_side *a, mt_side *b, double lean, mt_placing placing, bool *applies) {
    mt_registered registered;
    mt_assert_ok(mt_register(a, b, lean, &settings, &arena, &registered));
    a->frame = registered.a[placing];
    b->frame = registered.b[placing];
    *applies = registered.applies[placing];
}

/* How far each vertex is seen from where the same one of the other letter is, at most. */
static double farthest(const mt_side *a, const mt_side *b) {
    mt_ring_samples in_a, in_b;
    double most = 0;
    mt_assert_ok(mt_ring_samples_at_least(&a->shape.components[0].rings[0], CHORD, 1, &arena, &in_a));
    mt_assert_ok(mt_ring_samples_at_least(&b->shape.components[0].rings[0], CHORD, 1, &arena, &in_b));
    for (int i = 0; i < 12; i++) {
        mt_sample_view p = mt_sample_view_of(&in_a.samples[i], &a->frame),
                       q = mt_sample_view_of(&in_b.samples[i], &b->frame);
        most = fmax(most, hypot(p.x - q.x, p.y - q.y));
    }
    return most;
}

/* Light and wide, heavy and narrow and slanted: as their boxes lie far apart, with the map near each other. */
static void wholes_that_differ_are_registered(void **state) {
    (void)state;
    mt_side a = side_of(letter(20, 600, 0)), b = side_of(letter(140, 400, 0.2));
    double before = farthest(&a, &b);
    bool applies;
    place(&a, &b, 0, MT_REGISTERED, &applies);
    assert_true(before > 0.2 && farthest(&a, &b) < 0.4 * before);
}

static void either_may_come_first(void **state) {
    (void)state;
    for (int placing = 0; placing < MT_PLACINGS; placing++) {
        mt_side a = side_of(letter(20, 600, 0)), b = side_of(letter(140, 400, 0.2)), c = a, d = b;
        bool applies, swapped;
        place(&a, &b, 11, (mt_placing)placing, &applies);
        place(&d, &c, -11, (mt_placing)placing, &swapped);
        assert_true(applies && swapped);
        for (int i = 0; i < 4; i++) {
            assert_true(a.frame.x[i] == c.frame.x[i] && a.frame.y[i] == c.frame.y[i]);
            assert_true(b.frame.x[i] == d.frame.x[i] && b.frame.y[i] == d.frame.y[i]);
        }
    }
}

/* One letter upright and slanted: its vertices fall together once the slant is taken off, and there is none to take off without one. */
static void a_slant_is_taken_off(void **state) {
    (void)state;
    mt_side a = side_of(letter(80, 500, 0)), b = side_of(letter(80, 500, 0.25));
    bool applies;
    place(&a, &b, atan(0.25) * 180 / M_PI, MT_LEANING, &applies);
    assert_true(applies && farthest(&a, &b) < 0.01);
    place(&a, &b, 0, MT_LEANING, &applies);
    assert_true(!applies && farthest(&a, &b) > 0.1);
}

/* Laid on one another, a letter half as large is seen as near the middle as it is drawn. */
static void letters_are_laid_on_one_another(void **state) {
    (void)state;
    const int large[][2] = {{0, 0}, {600, 0}, {600, 700}, {0, 700}},
              small[][2] = {{1150, 0}, {1450, 0}, {1450, 350}, {1150, 350}};
    mt_ring rings[] = {mt_test_ring_of(&arena, large, 4, UNIT), mt_test_ring_of(&arena, small, 4, UNIT)};
    mt_component whole[] = {{1, &rings[0]}, {1, &rings[1]}};
    mt_side a = side_of((mt_shape){1, &whole[0]}), b = side_of((mt_shape){1, &whole[1]});
    bool applies;
    place(&a, &b, 0, MT_LAID, &applies);
    mt_sample_view of_a = mt_view_of_place(&a.frame, 450 * UNIT, 350 * UNIT),
                   of_b = mt_view_of_place(&b.frame, 1450 * UNIT, 350 * UNIT);
    assert_true(applies && fabs(of_a.x - of_b.x) < 1e-9 && fabs(of_a.y - of_b.y) < 1e-9);
}

/* A letter in two halves, as stencils have it, and a whole one: the half that has a partner does not tell where the whole goes. */
static void halves_keep_their_boxes(void **state) {
    (void)state;
    mt_component halves[2];
    mt_ring rings[2];
    for (int i = 0; i < 2; i++) {
        const int left = i ? 320 : 0,
                  points[][2] = {{left, 0}, {left + 280, 0}, {left + 280, 700}, {left, 700}};
        rings[i] = mt_test_ring_of(&arena, points, 4, UNIT);
        halves[i] = (mt_component){1, &rings[i]};
    }
    const int points[][2] = {{0, 0}, {600, 0}, {600, 700}, {0, 700}};
    mt_ring ring = mt_test_ring_of(&arena, points, 4, UNIT);
    mt_component whole = {1, &ring};
    mt_side a = side_of((mt_shape){2, halves}), b = side_of((mt_shape){1, &whole});
    bool applies;
    place(&a, &b, 0, MT_REGISTERED, &applies);
    assert_true(a.frame.x[1] == 1 && a.frame.x[2] == 0 && b.frame.x[1] == 1 && b.frame.x[3] == 0);
}

/* Each ring weighs 1; the flat end of a bar has a half turn, however thin it is. */
static void lifted_length_is_shared_out(void **state) {
    (void)state;
    for (int thick = 4; thick <= 200; thick += 49) {
        const int points[][2] = {{0, 0}, {600, 0}, {600, thick}, {0, thick}};
        mt_ring ring = mt_test_ring_of(&arena, points, 4, UNIT);
        mt_ring_samples samples;
        mt_lifted_ring lifted;
        mt_frame frame = mt_frame_of_box(mt_ring_box(&ring));
        double sum = 0, at_end = 0;
        mt_assert_ok(mt_ring_samples_at_least(&ring, CHORD, 60, &arena, &samples));
        mt_assert_ok(mt_lift_ring(&samples, &frame, &arena, &lifted));
        for (int i = 0; i < lifted.count; i++) {
            sum += lifted.weight[i];
            if (samples.samples[lifted.of[i]].x == 600 * UNIT) at_end += lifted.weight[i];
        }
        assert_true(fabs(sum - 1) < 1e-5);
        assert_true(at_end >= 0.25 && at_end < 0.45);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wholes_that_differ_are_registered),
        cmocka_unit_test(either_may_come_first),
        cmocka_unit_test(a_slant_is_taken_off),
        cmocka_unit_test(letters_are_laid_on_one_another),
        cmocka_unit_test(halves_keep_their_boxes),
        cmocka_unit_test(lifted_length_is_shared_out),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
