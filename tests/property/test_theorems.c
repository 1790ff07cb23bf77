/* The paper's theorems on random shapes, C(r) being what mt_morph_blend gives by the paper's own method.
 *
 * Error bound. Corners of sums are rounded to the grid, by at most √½; crossings of the union are rounded
 * likewise, and an edge bent through one stays within √½ of where it was. So every boundary point of C(r)
 * as computed lies within √2 < 2 grid units of the exact C(r), and the other way round, unless no ink is
 * left between: NEAR. Where a theorem says that points are the same no rounding happens, and the ink is
 * the same exactly, but for one thing: where two edges meet at a corner under an angle so small that they
 * are less than a unit apart over some length, Clipper may see them cross there, and round that. So at
 * least 95 of 100 cases have to be exact, and all within a band of one unit along the boundary. */
#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "geometry/triangulate.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/model/morph.h"
#include "morph/prepare.h"
#include "support/check.h"
#include "support/polygons.h"
#include "support/sums.h"

#include <math.h>

#define NEAR 2

enum { SIDE = 14 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* ---- cases --------------------------------------------------------------------------------------------- */

typedef struct trial {
    mt_random random;
    mt_shape a, b;
    mt_rings all_a, all_b; /* for the report */
    mt_subject subject;
    mt_params params;
    mt_weights weights;
} trial;

static void begin(trial *t, const char *name, int number, int most, int size) {
    t->random = mt_random_case(number);
    t->a = mt_random_shape(&t->random, &arena, most, mt_random_between(&t->random, 3, size), MT_EM / 2);
    t->b = mt_random_shape(&t->random, &arena, most, mt_random_between(&t->random, 3, size), MT_EM / 2);
    t->all_a = mt_test_all_rings(&arena, &t->a);
    t->all_b = mt_test_all_rings(&arena, &t->b);
    t->subject = (mt_subject){name, number, {&t->all_a, &t->all_b}};
    t->params = mt_params_default();
    t->params.method = MT_METHOD_PAPER;
    t->params.one_scale = mt_random_one_in(&t->random, 3);
    t->weights = mt_weights_at(mt_random_one_in(&t->random, 4) ? 0.5 : mt_random_unit(&t->random));
}

static mt_shape blend_of(const mt_shape *a, const mt_shape *b, const trial *t, mt_weights weights) {
    mt_morph morph;
    mt_shape blend = {0};
    mt_require(mt_morph_prepare(a, b, NULL, &t->params, &arena, &morph) == MT_OK, &t->subject);
    mt_require(mt_morph_blend(&morph, weights, &t->params, &arena, &blend) == MT_OK, &t->subject);
    return blend;
}

/* ---- comparisons --------------------------------------------------------------------------------------- */

static mt_wide area2(const mt_shape *shape) {
    return mt_oracle_shape_area2(shape);
}

/* The same ink: as much each for itself as together. Returns whether it is so exactly. */
static bool check_equal(const mt_shape *p, const mt_shape *q, const mt_subject *subject) {
    mt_rings one = mt_test_all_rings(&arena, p), other = mt_test_all_rings(&arena, q);
    mt_rings both = mt_test_rings(&arena, one.count + other.count);
    for (int i = 0; i < both.count; i++)
        both.rings[i] = i < one.count ? one.rings[i] : other.rings[i - one.count];
    mt_shape together;
    mt_require(mt_union(&both, MT_NONZERO, &arena, &together) == MT_OK, subject);
    double difference = (double)(2 * area2(&together) - area2(p) - area2(q)) / 2;
    mt_require(fabs(difference) <= mt_oracle_shape_length(q), subject);
    return area2(p) == area2(q) && area2(&together) == area2(q);
}

/* Sample number i of SIDE × SIDE over a box and a margin around it. */
static mt_point sample(mt_box box, int i) {
    int64_t width = (int64_t)box.max.x - box.min.x, height = (int64_t)box.max.y - box.min.y;
    return (mt_point){(int32_t)(box.min.x + width * (2 * (i % SIDE) - 1) / (2 * SIDE - 4)),
                      (int32_t)(box.min.y + height * (2 * (i / SIDE) - 1) / (2 * SIDE - 4))};
}

/* The same ink but within `far` of the boundary of either. */
static void check_near(const mt_shape *p, const mt_shape *q, double far, const mt_subject *subject) {
    for (int i = 0; i < SIDE * SIDE; i++) {
        mt_spot spot = mt_spot_of(sample(mt_shape_box(p), i), 1);
        if (mt_oracle_shape_distance(p, 1, spot) <= far || mt_oracle_shape_distance(q, 1, spot) <= far)
            continue;
        mt_require(mt_oracle_in_shape(p, 1, spot) == mt_oracle_in_shape(q, 1, spot), subject);
    }
}

/* ---- Theorem 1 ----------------------------------------------------------------------------------------- */

static void the_ends_are_a_and_b(void **state) {
    (void)state;
    int exact = 0, cases = mt_test_cases(150);
    for (int i = 0; i < cases; i++) {
        trial t;
        begin(&t, "the_ends_are_a_and_b", i, 4, 60);
        mt_shape at_a = blend_of(&t.a, &t.b, &t, mt_weights_at(0)),
                 at_b = blend_of(&t.a, &t.b, &t, mt_weights_at(1));
        bool a_is_exact = check_equal(&at_a, &t.a, &t.subject),
             b_is_exact = check_equal(&at_b, &t.b, &t.subject);
        exact += a_is_exact && b_is_exact;
        mt_arena_reset(&arena);
    }
    assert_true(100 * exact >= 95 * cases);
}

static void a_with_itself_is_a(void **state) {
    (void)state;
    int exact = 0, cases = mt_test_cases(150);
    for (int i = 0; i < cases; i++) {
        trial t;
        begin(&t, "a_with_itself_is_a", i, 4, 60);
        mt_shape blend = blend_of(&t.a, &t.a, &t, t.weights);
        exact += check_equal(&blend, &t.a, &t.subject);
        mt_arena_reset(&arena);
    }
    assert_true(100 * exact >= 95 * cases);
}

/* By the joint method curves are fitted to both ends, each within the tolerance of the fit; what only one end has is at the other a line
 * that may be a thousandth of the em wide (morph/join/closing.c). */
static void the_ends_by_the_joint_method(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(60); i++) {
        trial t;
        begin(&t, "the_ends_by_the_joint_method", i, 3, 30);
        t.params.method = MT_METHOD_JOINT;
        double far = (t.params.fit + t.params.tolerance + 1) * MT_EM / 1000 + NEAR;
        mt_shape at_a = blend_of(&t.a, &t.b, &t, mt_weights_at(0)),
                 at_b = blend_of(&t.a, &t.b, &t, mt_weights_at(1));
        check_near(&at_a, &t.a, far, &t.subject);
        check_near(&at_b, &t.b, far, &t.subject);
        mt_shape between = blend_of(&t.a, &t.a, &t, t.weights);
        check_near(&between, &t.a, far, &t.subject);
        mt_arena_reset(&arena);
    }
}

/* ---- Theorem 2, Inference 1 ---------------------------------------------------------------------------- */

static void check_in_sum(const mt_shape *blend, const trial *t) {
    for (int k = 0; k < blend->count; k++)
        for (int r = 0; r < blend->components[k].count; r++) {
            const mt_ring *ring = &blend->components[k].rings[r];
            for (int i = 0; i < ring->count; i++)
                mt_require(mt_sums_distance(&t->a, &t->b, t->weights, ring->points[i]) <= NEAR, &t->subject);
        }
    for (int i = 0; i < SIDE * SIDE; i++) {
        mt_point x = sample(mt_shape_box(blend), i);
        if (!mt_oracle_in_shape(blend, 1, mt_spot_of(x, 1))) continue;
        mt_require(mt_sums_distance(&t->a, &t->b, t->weights, x) <= NEAR, &t->subject);
    }
}

static void the_blend_lies_in_the_sum(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(50); i++) {
        trial t;
        begin(&t, "the_blend_lies_in_the_sum", i, 3, 14);
        mt_shape blend = blend_of(&t.a, &t.b, &t, t.weights);
        check_in_sum(&blend, &t);
        mt_arena_reset(&arena);
    }
}

/* ---- Theorem 3 ----------------------------------------------------------------------------------------- */

static void check_is_sum(const mt_shape *blend, const trial *t) {
    check_in_sum(blend, t);
    for (int i = 0; i < SIDE * SIDE; i++) {
        mt_point x = sample(mt_shape_box(blend), i);
        bool inside = mt_oracle_in_shape(blend, 1, mt_spot_of(x, 1));
        if (inside || mt_oracle_shape_distance(blend, 1, mt_spot_of(x, 1)) <= NEAR) continue;
        mt_require(mt_sums_distance(&t->a, &t->b, t->weights, x) > 0, &t->subject);
    }
}

/* With B convex, and so whole, the blend is the sum: for any A of one component, and of several, which all
 * go with B. */
static void a_convex_b_gives_the_sum(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(50); i++) {
        trial t;
        begin(&t, "a_convex_b_gives_the_sum", i, i % 2 ? 3 : 1, 16);
        mt_component convex = mt_random_polygon(&t.random, &arena, MT_POLYGON_CONVEX, 10, MT_EM / 2);
        convex.count = 1; /* without holes */
        t.b = mt_test_shape_of(&arena, &convex);
        t.all_b = convex;
        mt_pieces pieces;
        mt_require(mt_decompose(&convex, &arena, &pieces) == MT_OK && pieces.count == 1, &t.subject);
        mt_shape blend = blend_of(&t.a, &t.b, &t, t.weights), turned;
        check_is_sum(&blend, &t);
        trial swapped = t;
        swapped.a = t.b;
        swapped.b = t.a;
        swapped.weights = (mt_weights){t.weights.b, t.weights.a, 0};
        turned = blend_of(&swapped.a, &swapped.b, &swapped, swapped.weights);
        check_is_sum(&turned, &swapped);
        mt_arena_reset(&arena);
    }
}

/* ---- Inference 2 --------------------------------------------------------------------------------------- */

static mt_pieces triangles_of(const mt_component *component) {
    mt_half_edges mesh;
    mt_assert_ok(mt_triangulate(component, &arena, &mesh));
    mt_pieces triangles = mt_test_rings(&arena, mesh.triangle_count);
    for (int i = 0; i < triangles.count; i++) {
        triangles.rings[i] = mt_test_ring(&arena, 3);
        for (int k = 0; k < 3; k++) triangles.rings[i].points[k] = mesh.points[mesh.start[3 * i + k]];
    }
    return triangles;
}

/* The piece that a triangle is a part of. */
static int origin_of(const mt_ring *triangle, const mt_pieces *pieces) {
    const mt_point *p = triangle->points;
    mt_spot middle = {(int64_t)p[0].x + p[1].x + p[2].x, (int64_t)p[0].y + p[1].y + p[2].y};
    for (int i = 0; i < pieces->count; i++) {
        mt_rings one = {1, &pieces->rings[i]};
        if (mt_oracle_winding(&one, 3, middle)) return i;
    }
    fail_msg("a triangle is in no piece");
    return -1;
}

static void add_sum(const mt_ring *p, const mt_ring *q, mt_weights weights, mt_rings *sums) {
    mt_ring *sum = &sums->rings[sums->count++];
    *sum = mt_test_ring(&arena, p->count + q->count);
    mt_minkowski(p, q, weights, sum);
}

/* Finer pieces whose links refine the coarse ones: each triangle is linked with triangles of pieces that
 * its own piece is linked with. C_fine lies in C_coarse; with all such links it is C_coarse. */
static void finer_links_give_less(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(60); n++) {
        trial t;
        begin(&t, "finer_links_give_less", n, 1, 16);
        mt_morph morph;
        mt_require(mt_morph_prepare(&t.a, &t.b, NULL, &t.params, &arena, &morph) == MT_OK, &t.subject);
        mt_pieces fine_a = triangles_of(&t.a.components[0]), fine_b = triangles_of(&t.b.components[0]);
        mt_rings all = mt_test_rings(&arena, fine_a.count * fine_b.count);
        mt_rings some = mt_test_rings(&arena, fine_a.count * fine_b.count);
        all.count = some.count = 0;
        for (int i = 0; i < fine_a.count; i++)
            for (int j = 0; j < fine_b.count; j++) {
                int a = origin_of(&fine_a.rings[i], &morph.a.pieces),
                    b = origin_of(&fine_b.rings[j], &morph.b.pieces);
                bool linked = false;
                for (int k = 0; k < morph.links.count; k++)
                    linked |= morph.links.links[k].a == a && morph.links.links[k].b == b;
                if (!linked) continue;
                add_sum(&fine_a.rings[i], &fine_b.rings[j], t.weights, &all);
                if (mt_random_one_in(&t.random, 3)) some.rings[some.count++] = all.rings[all.count - 1];
            }
        mt_shape coarse = blend_of(&t.a, &t.b, &t, t.weights), fine, finer;
        mt_require(mt_union(&all, MT_NONZERO, &arena, &fine) == MT_OK &&
                       mt_union(&some, MT_NONZERO, &arena, &finer) == MT_OK,
                   &t.subject);
        check_near(&coarse, &fine, NEAR, &t.subject);
        for (int i = 0; i < SIDE * SIDE; i++) {
            mt_spot spot = mt_spot_of(sample(mt_shape_box(&coarse), i), 1);
            if (!mt_oracle_in_shape(&finer, 1, spot) || mt_oracle_shape_distance(&coarse, 1, spot) <= NEAR)
                continue;
            mt_require(mt_oracle_in_shape(&coarse, 1, spot), &t.subject);
        }
        mt_arena_reset(&arena);
    }
}

/* ---- moving and scaling -------------------------------------------------------------------------------- */

static mt_point even_point(mt_random *random) {
    return (mt_point){2 * mt_random_between(random, -MT_EM, MT_EM),
                      2 * mt_random_between(random, -MT_EM, MT_EM)};
}

/* Both moved by the same way, the blend moves by it; each by its own, the blend by the weighted mean. */
static void moving_commutes(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(60); i++) {
        trial t;
        begin(&t, "moving_commutes", i, 3, 40);
        if (i % 2) t.weights = mt_weights_at(0.5); /* the mean of even points is exact */
        mt_point u = even_point(&t.random), v = i % 2 ? even_point(&t.random) : u;
        mt_shape a = mt_test_shape_moved(&arena, &t.a, 1, u), b = mt_test_shape_moved(&arena, &t.b, 1, v);
        mt_shape blend = blend_of(&t.a, &t.b, &t, t.weights), moved = blend_of(&a, &b, &t, t.weights);
        mt_shape expected = mt_test_shape_moved(&arena, &blend, 1, mt_mix(t.weights, u, v));
        check_near(&expected, &moved, NEAR, &t.subject);
        mt_arena_reset(&arena);
    }
}

/* Both made larger by a whole factor; rounding is made larger with them. */
static void scaling_commutes(void **state) {
    (void)state;
    for (int i = 0; i < mt_test_cases(60); i++) {
        trial t;
        begin(&t, "scaling_commutes", i, 3, 40);
        int factor = mt_random_between(&t.random, 2, 7);
        const mt_point nowhere = {0, 0};
        mt_shape a = mt_test_shape_moved(&arena, &t.a, factor, nowhere),
                 b = mt_test_shape_moved(&arena, &t.b, factor, nowhere);
        mt_shape blend = blend_of(&t.a, &t.b, &t, t.weights), scaled = blend_of(&a, &b, &t, t.weights);
        mt_shape expected = mt_test_shape_moved(&arena, &blend, factor, nowhere);
        check_near(&expected, &scaled, NEAR * (factor + 1), &t.subject);
        mt_arena_reset(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_ends_are_a_and_b),
        cmocka_unit_test(a_with_itself_is_a),
        cmocka_unit_test(the_ends_by_the_joint_method),
        cmocka_unit_test(the_blend_lies_in_the_sum),
        cmocka_unit_test(a_convex_b_gives_the_sum),
        cmocka_unit_test(finer_links_give_less),
        cmocka_unit_test(moving_commutes),
        cmocka_unit_test(scaling_commutes),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
