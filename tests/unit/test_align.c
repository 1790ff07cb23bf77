#include "morph/align/align.h"
#include "support/check.h"
#include "support/corpus.h"
#include "support/polygons.h"

#include <math.h>

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

/* A ring of the corpus, a thousand grid units to its unit, moved. */
static mt_ring ring_named(const char *name, int factor, mt_point by) {
    return mt_test_moved(&arena, mt_corpus_find(&corpus, name), 1000 * factor, by).rings[0];
}

static mt_ring_samples samples_of(const mt_ring *ring, double step) {
    mt_trace trace;
    mt_ring_samples samples;
    mt_assert_ok(mt_trace_ring(ring, 128, &arena, &trace));
    mt_assert_ok(mt_ring_samples_of(&trace, 128, step, &arena, &samples));
    return samples;
}

static mt_alignment aligned(const mt_ring *a, const mt_ring_samples *in_a, const mt_ring *b,
                            const mt_ring_samples *in_b) {
    mt_alignment alignment;
    mt_frame frame_a = mt_frame_of_box(mt_ring_box(a)), frame_b = mt_frame_of_box(mt_ring_box(b));
    mt_assert_ok(mt_align(in_a, &frame_a, in_b, &frame_b, &(mt_cost_weights){3, 4, 2}, &(mt_links){0}, &arena,
                          &alignment));
    return alignment;
}

static void stops_of_a_square(void **state) {
    (void)state;
    mt_ring square = ring_named("square", 1, (mt_point){0, 0});
    assert_int_equal(samples_of(&square, 1e6).count, 4);
    mt_ring_samples samples = samples_of(&square, 30000);
    assert_int_equal(samples.count, 16);
    for (int i = 0; i < 16; i++) {
        assert_true(samples.samples[i].corner == (i % 4 == 0) && samples.samples[i].breaks == (i % 4 == 0));
        double side = i / 4 * M_PI / 2;
        assert_true(fabs(remainder(samples.samples[i].out - side, 2 * M_PI)) < 1e-9);
    }
    assert_true(samples.samples[1].x == 25000 && samples.samples[1].y == 0 && samples.samples[6].y == 50000);
}

/* Once around both, one step at a time. */
static void check_steps(const mt_alignment *alignment, int n, int m) {
    int moved_a = 0, moved_b = 0;
    for (int i = 0; i < alignment->count; i++) {
        mt_link from = alignment->steps[i], to = alignment->steps[(i + 1) % alignment->count];
        int da = (to.a - from.a + n) % n, db = (to.b - from.b + m) % m;
        assert_true(da <= 1 && db <= 1 && da + db >= 1);
        moved_a += da;
        moved_b += db;
    }
    assert_int_equal(moved_a, n);
    assert_int_equal(moved_b, m);
    assert_true(alignment->cost >= 0);
}

/* A ring with itself, moved, made larger and started elsewhere: each sample goes with its own, at no cost. */
static void with_itself(void **state) {
    (void)state;
    static const char *const names[] = {"square", "plus", "comb", "spiral", "star_of_five", "triangle"};
    for (int n = 0; n < 6; n++) {
        mt_ring a = ring_named(names[n], 1, (mt_point){0, 0}),
                b = ring_named(names[n], 2, (mt_point){-7000, 9000});
        mt_ring_samples in_a = samples_of(&a, 20000), in_b = samples_of(&b, 40000);
        assert_int_equal(in_a.count, in_b.count);
        int shift = in_b.count / 3;
        mt_ring_sample *turned = mt_arena_new(&arena, (size_t)in_b.count, sizeof *turned);
        for (int i = 0; i < in_b.count; i++) turned[i] = in_b.samples[(i + shift) % in_b.count];
        in_b.samples = turned;
        mt_alignment alignment = aligned(&a, &in_a, &b, &in_b);
        check_steps(&alignment, in_a.count, in_b.count);
        assert_true(fabs(alignment.cost) < 1e-6);
        assert_int_equal(alignment.count, in_a.count);
        for (int i = 0; i < alignment.count; i++)
            assert_int_equal((alignment.steps[i].b + shift) % in_b.count, alignment.steps[i].a);
    }
}

/* Corners of a box go to corners of a box of other proportions. */
static void corners_to_corners(void **state) {
    (void)state;
    mt_ring a = ring_named("square", 1, (mt_point){0, 0}), b = ring_named("square", 1, (mt_point){0, 0});
    for (int i = 0; i < 4; i++) b.points[i].x *= 3;
    mt_ring_samples in_a = samples_of(&a, 10000), in_b = samples_of(&b, 10000);
    mt_alignment alignment = aligned(&a, &in_a, &b, &in_b);
    check_steps(&alignment, in_a.count, in_b.count);
    int corners = 0;
    for (int i = 0; i < alignment.count; i++)
        corners += in_a.samples[alignment.steps[i].a].corner && in_b.samples[alignment.steps[i].b].corner;
    assert_int_equal(corners, 4);
}

static void random_rings(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(30); i++) {
        mt_random random = mt_random_case(i);
        mt_arena_place place = mt_arena_mark(&arena);
        mt_ring a =
            mt_random_polygon(&random, &arena, MT_POLYGON_STAR, mt_random_between(&random, 3, 30), 100000)
                .rings[0];
        mt_ring b =
            mt_random_polygon(&random, &arena, MT_POLYGON_SPIRAL, mt_random_between(&random, 3, 30), 100000)
                .rings[0];
        mt_ring_samples in_a = samples_of(&a, 30000), in_b = samples_of(&b, 30000);
        mt_alignment alignment = aligned(&a, &in_a, &b, &in_b), back = aligned(&b, &in_b, &a, &in_a);
        check_steps(&alignment, in_a.count, in_b.count);
        check_steps(&back, in_b.count, in_a.count);
        mt_arena_rewind(&arena, place);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(stops_of_a_square),
        cmocka_unit_test(with_itself),
        cmocka_unit_test(corners_to_corners),
        cmocka_unit_test(random_rings),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
