#include "geometry/limits.h"
#include "morph/align/cache.h"
#include "morph/model/frame.h"
#include "morph/align/pairing.h"
#include "support/check.h"
#include "support/polygons.h"

enum { UNIT = MT_EM / 1000, CHORD = MT_EM / 2000 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* A bar of 1/1000 em; a ring of its own at each call. */
static const mt_ring *bar(int x, int width) {
    const int points[][2] = {{x, 0}, {x + width, 0}, {x + width, 100}, {x, 100}};
    mt_ring *ring = mt_arena_new(&arena, 1, sizeof *ring);
    *ring = mt_test_ring_of(&arena, points, 4, UNIT);
    return ring;
}

static mt_cache_key case_of(const mt_ring *p, const mt_ring *q) {
    return (mt_cache_key){p,         q,    mt_frame_of_box(mt_ring_box(p)), mt_frame_of_box(mt_ring_box(q)),
                          {3, 4, 2}, false};
}

static void the_same_case_is_known(void **state) {
    (void)state;
    mt_alignment_cache *cache = mt_arena_new(&arena, 1, sizeof *cache);
    mt_cache_key of = case_of(bar(0, 300), bar(50, 200)), alike = case_of(bar(0, 300), bar(50, 200));
    assert_null(mt_alignment_cache_find(cache, &of));
    mt_assert_ok(mt_alignment_cache_add(cache, &of, 0.25, NULL, &arena));
    assert_true(mt_alignment_cache_find(cache, &alike)->cost == 0.25);
    assert_null(mt_alignment_cache_find(NULL, &of));
    mt_assert_ok(mt_alignment_cache_add(NULL, &of, 0.25, NULL, &arena));
}

static void any_other_case_is_not(void **state) {
    (void)state;
    mt_alignment_cache *cache = mt_arena_new(&arena, 1, sizeof *cache);
    mt_cache_key of = case_of(bar(0, 300), bar(50, 200));
    mt_assert_ok(mt_alignment_cache_add(cache, &of, 0.25, NULL, &arena));
    mt_cache_key others[] = {
        of, of, of, of, case_of(bar(0, 301), bar(50, 200)), case_of(bar(50, 200), bar(0, 300))};
    others[0].weights.distance = 16;
    others[1].joined = true;
    others[2].frame_p.box.max.x += 1;
    others[3].frame_q.x[2] += 0.1;
    for (int i = 0; i < 6; i++) assert_null(mt_alignment_cache_find(cache, &others[i]));
    others[1].q->marks[2] ^=
        MT_CORNER; /* the ring that is known has changed with it, but not a copy of what it was */
    mt_cache_key before = case_of(bar(0, 300), bar(50, 200));
    assert_null(mt_alignment_cache_find(cache, &before));
}

/* A cost is found once: afterwards the known one is taken, whatever it says. */
static void a_cached_cost_is_taken(void **state) {
    (void)state;
    mt_alignment_cache *cache = mt_arena_new(&arena, 1, sizeof *cache);
    mt_settings plain = {.flatness = CHORD, .align = {3, 4, 2}}, caching = plain;
    caching.cache = cache;
    const mt_ring *p = bar(0, 300), *q = bar(50, 200);
    mt_frame in_p = mt_frame_of_box(mt_ring_box(p)), in_q = mt_frame_of_box(mt_ring_box(q));
    double found = 0, first = 0, again = 0;
    mt_assert_ok(mt_pair_cost(p, &in_p, q, &in_q, &plain, &arena, &found));
    mt_assert_ok(mt_pair_cost(p, &in_p, q, &in_q, &caching, &arena, &first));
    assert_true(found == first);
    mt_cache_key of = case_of(p, q);
    assert_true(mt_alignment_cache_find(cache, &of)->cost == found);
    mt_assert_ok(
        mt_alignment_cache_add(cache, &of, 7, NULL, &arena)); /* what was added last is found first */
    mt_assert_ok(mt_pair_cost(p, &in_p, q, &in_q, &caching, &arena, &again));
    assert_true(again == 7);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_same_case_is_known),
        cmocka_unit_test(any_other_case_is_not),
        cmocka_unit_test(a_cached_cost_is_taken),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
