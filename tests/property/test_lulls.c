/* Random polygons that move at random: during a lull the ink has as many components and holes at all of 99 places, found by a union of
 * the edges at each. Places so near to a meeting that rounding to the grid decides are left out. */
#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/check/lulls.h"
#include "support/check.h"
#include "support/moves.h"
#include "support/polygons.h"

#include <math.h>

enum { PLACES = 99, MOST = 4 };

/* T within which the grid's rounding may decide: points move by some 50 units. */
#define NEAR 1e-4

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_ring jittered(const mt_ring *ring, mt_random *random, mt_point by, int most) {
    mt_ring made = mt_test_ring(&arena, ring->count);
    for (int i = 0; i < ring->count; i++) {
        mt_point jitter = mt_random_point(random, -most, most);
        made.points[i] = (mt_point){ring->points[i].x + by.x + jitter.x, ring->points[i].y + by.y + jitter.y};
    }
    return made;
}

/* The outer rings of polygons of any kind, each moved and jittered; some are displaced. */
static mt_morph random_morph(mt_random *random) {
    mt_ring in_a[MOST], in_b[MOST];
    int count = mt_random_between(random, 1, MOST), extent = MT_EM / 4;
    for (int i = 0; i < count; i++) {
        mt_polygon_kind kind = (mt_polygon_kind)mt_random_between(random, 0, MT_POLYGON_SPIRAL);
        mt_component drawn =
            mt_random_polygon(random, &arena, kind, mt_random_between(random, 3, 20), extent);
        mt_point by = mt_random_point(random, -extent, extent),
                 from = mt_random_point(random, -extent, extent);
        in_a[i] = jittered(&drawn.rings[0], random, from, 0);
        in_b[i] = jittered(&in_a[i], random, by, mt_random_between(random, 1, extent / 10));
    }
    mt_morph morph = mt_test_morph_of(&arena, in_a, in_b, count);
    if (mt_random_one_in(random, 4))
        morph.contours[0].displacement = mt_random_point(random, -extent / 8, extent / 8);
    return morph;
}

/* Components and holes: all of them, and those wider than what rounding makes of nothing. */
typedef struct mt_counts {
    int all[2], wide[2];
} mt_counts;

static mt_counts counts_at(const mt_morph *morph, double t, mt_rule rule, const mt_subject *subject) {
    mt_params params = mt_params_default();
    mt_rings rings;
    mt_shape shape;
    mt_counts counts = {0};
    mt_require(mt_morph_rings(morph, mt_weights_at(t), &params, &arena, &rings) == MT_OK, subject);
    mt_require(mt_union_unmarked(&rings, rule, &arena, &shape) == MT_OK, subject);
    for (int k = 0; k < shape.count; k++)
        for (int i = 0; i < shape.components[k].count; i++) {
            const mt_ring *ring = &shape.components[k].rings[i];
            counts.all[i > 0]++;
            counts.wide[i > 0] += fabs((double)mt_ring_area2(ring)) > 4 * mt_ring_length(ring);
        }
    return counts;
}

static bool agree(const mt_counts *p, const mt_counts *q) {
    return p->wide[0] <= q->all[0] && p->wide[1] <= q->all[1] && q->wide[0] <= p->all[0] &&
           q->wide[1] <= p->all[1];
}

/* Returns how many places were compared. */
static int check_lull(const mt_morph *morph, const mt_lull *lull, mt_rule rule, const mt_subject *subject) {
    int compared = 0;
    mt_counts half = counts_at(morph, (lull->from + lull->to) / 2, rule, subject);
    for (int i = 1; i <= PLACES; i++) {
        double t = (double)i / (PLACES + 1);
        if (t < lull->from + NEAR || t > lull->to - NEAR) continue;
        mt_counts here = counts_at(morph, t, rule, subject);
        mt_require(agree(&here, &half), subject);
        compared++;
    }
    return compared;
}

/* The edges of these morphs are those of their rings. */
static void counts_stay_during_a_lull(void **state) {
    (void)state;
    int known = 0, meeting = 0, plain = 0, compared = 0, cases = mt_test_cases(300);
    for (int i = 0; i < cases; i++) {
        mt_random random = mt_random_case(i);
        mt_morph morph = random_morph(&random);
        mt_rings ends[2];
        mt_moving_edges edges;
        mt_lulls lulls;
        for (int k = 0; k < 2; k++)
            mt_assert_ok(mt_shape_rings(k ? &morph.b.whole : &morph.a.whole, &arena, &ends[k]));
        mt_subject subject = {"lulls", i, {&ends[0], &ends[1]}};
        mt_require(mt_moving_edges_of(&morph, 1, &arena, &edges) == MT_OK, &subject);
        mt_require(mt_find_lulls(&edges, 1, &arena, &lulls) == MT_OK, &subject);
        for (int k = 0; k < lulls.count; k++)
            compared += check_lull(&morph, &lulls.lulls[k], i % 2 ? MT_NONZERO : MT_POSITIVE, &subject);
        known += lulls.known;
        meeting += lulls.count > 1;
        plain += lulls.plain;
        mt_arena_reset(&arena);
    }
    assert_true(known > cases / 4 && meeting > cases / 8 && plain > cases / 20 && compared > 50 * plain);
    print_message("%d cases: %d known, %d meet, %d plain, %d places\n", cases, known, meeting, plain,
                  compared);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(counts_stay_during_a_lull)};
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
