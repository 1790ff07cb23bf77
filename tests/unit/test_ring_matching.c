#include "geometry/limits.h"
#include "morph/divide/ring_matching.h"
#include "support/check.h"
#include "support/corpus.h"
#include "support/polygons.h"

#include <math.h>

enum { UNIT = MT_EM / 1000, CHORD = MT_EM / 2000 };

static mt_arena arena;
static const mt_settings settings = {.flatness = CHORD, .match = {1, 4, 0}, .step = 12, .jumps = true};
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

/* A shape's boundary in its own box, samples 12/1000 em apart, chords up to 300/1000. */
static mt_boundary boundary_of(const mt_shape *shape) {
    mt_boundary boundary;
    mt_frame frame = mt_frame_of_box(mt_shape_box(shape));
    mt_assert_ok(mt_boundary_of(shape, &frame, &settings, 300 * UNIT, &arena, &boundary));
    return boundary;
}

static mt_ring_match match_around(const mt_boundary *from, int ring, const mt_boundary *to) {
    mt_ring_match match;
    mt_assert_ok(mt_match_ring(from, ring, to, &settings.match, NULL, &arena, &match));
    return match;
}

static int chords_of(const mt_ring_match *match) {
    int count = 0;
    for (int k = 0; k < match->count; k++) count += match->steps[k].chord >= 0;
    return count;
}

/* The sample after a sample on its ring. */
static int next_sample(const mt_boundary *boundary, int sample) {
    int ring = mt_boundary_ring(boundary, sample);
    return sample + 1 < boundary->first_of_ring[ring + 1] ? sample + 1 : boundary->first_of_ring[ring];
}

/* Closed, once around the ring, and from step to step along a ring of the boundary or over a chord of it. */
static void check_match(const mt_boundary *from, int ring, const mt_boundary *to,
                        const mt_ring_match *match) {
    int low = from->first_of_ring[ring], high = from->first_of_ring[ring + 1], moved = 0;
    assert_true(match->count > high - low && match->cost >= 0);
    assert_int_equal(match->steps[0].here, match->steps[match->count - 1].here);
    assert_int_equal(match->steps[0].there, match->steps[match->count - 1].there);
    for (int k = 0; k < match->count; k++) {
        mt_match_step step = match->steps[k], last = match->steps[k ? k - 1 : 0];
        assert_in_range(step.here, low, high - 1);
        assert_in_range(step.there, 0, to->count - 1);
        bool moves = k > 0 && step.here != last.here;
        if (moves) assert_int_equal(step.here, next_sample(from, last.here));
        moved += moves;
        if (step.chord >= 0) {
            assert_false(moves);
            assert_int_equal(mt_chord_source(to, step.chord), last.there);
            assert_int_equal(to->chords[step.chord].to, step.there);
        } else if (step.there != last.there) {
            assert_int_equal(step.there, next_sample(to, last.there));
        }
    }
    assert_int_equal(moved, high - low);
}

/* A ring on its own glyph's boundary goes with itself, sample by sample, at no cost and over no chord. */
static void on_its_own_boundary(void **state) {
    (void)state;
    static const char *const names[] = {"square", "plus", "comb", "spiral", "frame", "l_shape"};
    for (int n = 0; n < 6; n++) {
        mt_component component =
            mt_test_moved(&arena, mt_corpus_find(&corpus, names[n]), 1000, (mt_point){0, 0});
        mt_shape shape = mt_test_shape_of(&arena, &component);
        mt_boundary boundary = boundary_of(&shape);
        for (int r = 0; r < boundary.ring_count; r++) {
            mt_ring_match match = match_around(&boundary, r, &boundary);
            check_match(&boundary, r, &boundary, &match);
            assert_int_equal(match.count, boundary.first_of_ring[r + 1] - boundary.first_of_ring[r] + 1);
            assert_int_equal(chords_of(&match), 0);
            assert_true(match.cost < 1e-6);
            for (int k = 0; k < match.count; k++) assert_int_equal(match.steps[k].here, match.steps[k].there);
        }
    }
}

/* ---- a dot that is merged into a bar --------------------------------------------------------------------- */

/* A bar with a dot above it: apart, or joined by a neck 40/1000 em wide. */
static mt_shape bar_and_dot(void) {
    static const int bar[][2] = {{0, 0}, {600, 0}, {600, 120}, {0, 120}},
                     dot[][2] = {{220, 160}, {380, 160}, {380, 320}, {220, 320}};
    mt_shape shape = {2, mt_arena_new(&arena, 2, sizeof(mt_component))};
    for (int i = 0; i < 2; i++) {
        shape.components[i] = mt_test_rings(&arena, 1);
        shape.components[i].rings[0] = mt_test_ring_of(&arena, i ? dot : bar, 4, UNIT);
    }
    return shape;
}

static mt_shape merged(void) {
    static const int points[][2] = {{0, 0},     {600, 0},   {600, 120}, {320, 120}, {320, 160}, {380, 160},
                                    {380, 320}, {220, 320}, {220, 160}, {280, 160}, {280, 120}, {0, 120}};
    mt_component component = mt_test_rings(&arena, 1);
    component.rings[0] = mt_test_ring_of(&arena, points, 12, UNIT);
    return mt_test_shape_of(&arena, &component);
}

/* Of a sample of a boundary of one component. */
static mt_point place_of(const mt_boundary *boundary, int sample) {
    assert_int_equal(boundary->component_count, 1);
    return boundary->meshes[0].points[sample];
}

/* The one chord of a walk. It has to lie across the neck. */
static int only_chord(const mt_ring_match *match, const mt_boundary *to) {
    assert_int_equal(chords_of(match), 1);
    int k = 0;
    while (match->steps[k].chord < 0) k++;
    int chord = match->steps[k].chord, ends[] = {mt_chord_source(to, chord), to->chords[chord].to};
    for (int i = 0; i < 2; i++) {
        mt_point p = place_of(to, ends[i]);
        int x = p.x / UNIT, y = p.y / UNIT;
        assert_true(x > 250 && x < 350 && y > 100 && y < 180);
    }
    return chord;
}

static void a_dot_merged_into_a_bar(void **state) {
    (void)state;
    mt_shape apart = bar_and_dot(), together = merged();
    mt_boundary from = boundary_of(&apart), to = boundary_of(&together);
    mt_ring_match around_bar = match_around(&from, 0, &to), around_dot = match_around(&from, 1, &to);
    check_match(&from, 0, &to, &around_bar);
    check_match(&from, 1, &to, &around_dot);
    int under = only_chord(&around_bar, &to), over = only_chord(&around_dot, &to);
    /* the bar's upper side runs to the left, the dot's lower side to the right */
    assert_true(place_of(&to, to.chords[under].to).x < place_of(&to, mt_chord_source(&to, under)).x);
    assert_true(place_of(&to, to.chords[over].to).x > place_of(&to, mt_chord_source(&to, over)).x);
}

/* The merged shape's ring goes around the bar and around the dot, and over the white between them by jumps. */
static void jumps_over_a_gap(void **state) {
    (void)state;
    mt_shape apart = bar_and_dot(), together = merged();
    mt_boundary from = boundary_of(&together), to = boundary_of(&apart);
    mt_ring_match match = match_around(&from, 0, &to);
    check_match(&from, 0, &to, &match);
    int jumps = 0;
    for (int k = 1; k < match.count; k++) {
        bool in_dot = match.steps[k].there >= to.first_sample[1];
        if (in_dot == (match.steps[k - 1].there >= to.first_sample[1])) continue;
        assert_true(match.steps[k].chord >= 0);
        assert_int_equal(to.chords[match.steps[k].chord].edge, -1);
        jumps++;
    }
    assert_int_equal(jumps, 2);
}

/* Where a chord is barred, another way is taken, even the long one. */
static void barred_bridges_are_not_taken(void **state) {
    (void)state;
    mt_shape apart = bar_and_dot(), together = merged();
    mt_boundary from = boundary_of(&apart), to = boundary_of(&together);
    double before = match_around(&from, 1, &to).cost;
    for (int i = 0; i < to.first_chord[to.count]; i++) to.chords[i].cost = INFINITY;
    mt_ring_match match = match_around(&from, 1, &to);
    check_match(&from, 1, &to, &match);
    assert_int_equal(chords_of(&match), 0);
    assert_true(match.cost > before && match.cost < INFINITY);
}

/* Every chord has one back, over the same diagonal. */
static void chords_lead_back(void **state) {
    (void)state;
    mt_shape together = merged();
    mt_boundary boundary = boundary_of(&together);
    int total = boundary.first_chord[boundary.count];
    assert_true(total > 0);
    for (int i = 0; i < total; i++) {
        int back = mt_chord_back(&boundary, i);
        assert_int_equal(mt_chord_back(&boundary, back), i);
        assert_int_equal(mt_chord_source(&boundary, back), boundary.chords[i].to);
        assert_int_equal(boundary.meshes[0].twin[boundary.chords[i].edge], boundary.chords[back].edge);
    }
}

static void random_walks(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(12); n++) {
        mt_random random = mt_random_case(n);
        mt_arena_place place = mt_arena_mark(&arena);
        mt_shape a = mt_random_shape(&random, &arena, 2, 12, 60000),
                 b = mt_random_shape(&random, &arena, 2, 12, 60000);
        mt_boundary from = boundary_of(&a), to = boundary_of(&b);
        for (int r = 0; r < from.ring_count; r++) {
            mt_ring_match match = match_around(&from, r, &to);
            check_match(&from, r, &to, &match);
        }
        mt_arena_rewind(&arena, place);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_its_own_boundary), cmocka_unit_test(a_dot_merged_into_a_bar),
        cmocka_unit_test(jumps_over_a_gap),    cmocka_unit_test(barred_bridges_are_not_taken),
        cmocka_unit_test(chords_lead_back),    cmocka_unit_test(random_walks),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
