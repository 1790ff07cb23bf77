#include "geometry/limits.h"
#include "morph/divide/ring_matching.h"
#include "support/check.h"
#include "support/corpus.h"
#include "support/polygons.h"

#include <math.h>

enum { UNIT = MT_EM / 1000, CHORD = MT_EM / 2000 };

static mt_arena arena;
static const mt_manner manner = {.chord = CHORD, .walk = {1, 4, 0}, .step = 12, .leaps = true};
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

/* A shape's border in its own box, stops 12/1000 em apart, bridges up to 300/1000. */
static mt_border border_of(const mt_shape *shape) {
    mt_border border;
    mt_assert_ok(mt_border_of(shape, mt_shape_box(shape), &manner, 300 * UNIT, &arena, &border));
    return border;
}

static mt_walk walk_around(const mt_border *from, int ring, const mt_border *to) {
    mt_walk walk;
    mt_assert_ok(mt_walk_around(from, ring, to, &manner.walk, NULL, &arena, &walk));
    return walk;
}

static int bridges_of(const mt_walk *walk) {
    int count = 0;
    for (int k = 0; k < walk->count; k++) count += walk->paces[k].bridge >= 0;
    return count;
}

/* The stop after a stop on its ring. */
static int next_stop(const mt_border *border, int stop) {
    int ring = mt_border_ring(border, stop);
    return stop + 1 < border->first_of_ring[ring + 1] ? stop + 1 : border->first_of_ring[ring];
}

/* Closed, once around the ring, and from pace to pace along a ring of the border or over a bridge of it. */
static void check_walk(const mt_border *from, int ring, const mt_border *to, const mt_walk *walk) {
    int low = from->first_of_ring[ring], high = from->first_of_ring[ring + 1], moved = 0;
    assert_true(walk->count > high - low && walk->price >= 0);
    assert_int_equal(walk->paces[0].here, walk->paces[walk->count - 1].here);
    assert_int_equal(walk->paces[0].there, walk->paces[walk->count - 1].there);
    for (int k = 0; k < walk->count; k++) {
        mt_pace pace = walk->paces[k], last = walk->paces[k ? k - 1 : 0];
        assert_in_range(pace.here, low, high - 1);
        assert_in_range(pace.there, 0, to->count - 1);
        bool moves = k > 0 && pace.here != last.here;
        if (moves) assert_int_equal(pace.here, next_stop(from, last.here));
        moved += moves;
        if (pace.bridge >= 0) {
            assert_false(moves);
            assert_int_equal(mt_bridge_source(to, pace.bridge), last.there);
            assert_int_equal(to->bridges[pace.bridge].to, pace.there);
        } else if (pace.there != last.there) {
            assert_int_equal(pace.there, next_stop(to, last.there));
        }
    }
    assert_int_equal(moved, high - low);
}

/* A ring on its own glyph's border goes with itself, stop by stop, at no price and over no bridge. */
static void on_its_own_border(void **state) {
    (void)state;
    static const char *const names[] = {"square", "plus", "comb", "spiral", "frame", "l_shape"};
    for (int n = 0; n < 6; n++) {
        mt_component component =
            mt_test_moved(&arena, mt_corpus_find(&corpus, names[n]), 1000, (mt_point){0, 0});
        mt_shape shape = mt_test_shape_of(&arena, &component);
        mt_border border = border_of(&shape);
        for (int r = 0; r < border.ring_count; r++) {
            mt_walk walk = walk_around(&border, r, &border);
            check_walk(&border, r, &border, &walk);
            assert_int_equal(walk.count, border.first_of_ring[r + 1] - border.first_of_ring[r] + 1);
            assert_int_equal(bridges_of(&walk), 0);
            assert_true(walk.price < 1e-6);
            for (int k = 0; k < walk.count; k++) assert_int_equal(walk.paces[k].here, walk.paces[k].there);
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

/* Of a stop of a border of one component. */
static mt_point place_of(const mt_border *border, int stop) {
    assert_int_equal(border->component_count, 1);
    return border->meshes[0].points[stop];
}

/* The one bridge of a walk. It has to lie across the neck. */
static int only_bridge(const mt_walk *walk, const mt_border *to) {
    assert_int_equal(bridges_of(walk), 1);
    int k = 0;
    while (walk->paces[k].bridge < 0) k++;
    int bridge = walk->paces[k].bridge, ends[] = {mt_bridge_source(to, bridge), to->bridges[bridge].to};
    for (int i = 0; i < 2; i++) {
        mt_point p = place_of(to, ends[i]);
        int x = p.x / UNIT, y = p.y / UNIT;
        assert_true(x > 250 && x < 350 && y > 100 && y < 180);
    }
    return bridge;
}

static void a_dot_merged_into_a_bar(void **state) {
    (void)state;
    mt_shape apart = bar_and_dot(), together = merged();
    mt_border from = border_of(&apart), to = border_of(&together);
    mt_walk around_bar = walk_around(&from, 0, &to), around_dot = walk_around(&from, 1, &to);
    check_walk(&from, 0, &to, &around_bar);
    check_walk(&from, 1, &to, &around_dot);
    int under = only_bridge(&around_bar, &to), over = only_bridge(&around_dot, &to);
    /* the bar's upper side runs to the left, the dot's lower side to the right */
    assert_true(place_of(&to, to.bridges[under].to).x < place_of(&to, mt_bridge_source(&to, under)).x);
    assert_true(place_of(&to, to.bridges[over].to).x > place_of(&to, mt_bridge_source(&to, over)).x);
}

/* The merged shape's ring goes around the bar and around the dot, and over the white between them by leaps. */
static void leaps_over_a_gap(void **state) {
    (void)state;
    mt_shape apart = bar_and_dot(), together = merged();
    mt_border from = border_of(&together), to = border_of(&apart);
    mt_walk walk = walk_around(&from, 0, &to);
    check_walk(&from, 0, &to, &walk);
    int leaps = 0;
    for (int k = 1; k < walk.count; k++) {
        bool in_dot = walk.paces[k].there >= to.first_stop[1];
        if (in_dot == (walk.paces[k - 1].there >= to.first_stop[1])) continue;
        assert_true(walk.paces[k].bridge >= 0);
        assert_int_equal(to.bridges[walk.paces[k].bridge].edge, -1);
        leaps++;
    }
    assert_int_equal(leaps, 2);
}

/* Where a bridge is barred, another way is taken, even the long one. */
static void barred_bridges_are_not_taken(void **state) {
    (void)state;
    mt_shape apart = bar_and_dot(), together = merged();
    mt_border from = border_of(&apart), to = border_of(&together);
    double before = walk_around(&from, 1, &to).price;
    for (int i = 0; i < to.first_bridge[to.count]; i++) to.bridges[i].price = INFINITY;
    mt_walk walk = walk_around(&from, 1, &to);
    check_walk(&from, 1, &to, &walk);
    assert_int_equal(bridges_of(&walk), 0);
    assert_true(walk.price > before && walk.price < INFINITY);
}

/* Every bridge has one back, over the same diagonal. */
static void bridges_lead_back(void **state) {
    (void)state;
    mt_shape together = merged();
    mt_border border = border_of(&together);
    int total = border.first_bridge[border.count];
    assert_true(total > 0);
    for (int i = 0; i < total; i++) {
        int back = mt_bridge_back(&border, i);
        assert_int_equal(mt_bridge_back(&border, back), i);
        assert_int_equal(mt_bridge_source(&border, back), border.bridges[i].to);
        assert_int_equal(border.meshes[0].twin[border.bridges[i].edge], border.bridges[back].edge);
    }
}

static void random_walks(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(12); n++) {
        mt_random random = mt_random_case(n);
        mt_arena_place place = mt_arena_mark(&arena);
        mt_shape a = mt_random_shape(&random, &arena, 2, 12, 60000),
                 b = mt_random_shape(&random, &arena, 2, 12, 60000);
        mt_border from = border_of(&a), to = border_of(&b);
        for (int r = 0; r < from.ring_count; r++) {
            mt_walk walk = walk_around(&from, r, &to);
            check_walk(&from, r, &to, &walk);
        }
        mt_arena_rewind(&arena, place);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_its_own_border), cmocka_unit_test(a_dot_merged_into_a_bar),
        cmocka_unit_test(leaps_over_a_gap),  cmocka_unit_test(barred_bridges_are_not_taken),
        cmocka_unit_test(bridges_lead_back), cmocka_unit_test(random_walks),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
