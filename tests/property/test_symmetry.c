/* Which of two shapes is A makes no difference: the blend of A and B at T is that of B and A at 1 - T, by the joint
 * method, within 1/1000 em. Every vertex and every middle of an edge of the one blend lies so near to the other's
 * boundary, and the ink that only one of them has is no more than a band of that width along it.
 * Whether links are left, and into how many shares and contours the sides are cut, is the same too. */
#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/model/morph.h"
#include "morph/prepare.h"
#include "support/check.h"
#include "support/corpus.h"
#include "support/oracle.h"
#include "support/polygons.h"

#include <math.h>

enum { NEAR = MT_EM / 1000 };

static mt_arena arena, arena_of_corpus;
static mt_corpus corpus;

static int set_up(void **state) {
    (void)state;
    corpus = mt_corpus_read(&arena_of_corpus);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    mt_arena_release(&arena_of_corpus);
    return 0;
}

static mt_morph morph_of(const mt_shape *a, const mt_shape *b, const mt_subject *subject) {
    mt_params params = mt_params_default();
    mt_morph morph = {0};
    mt_require(mt_morph_prepare(a, b, NULL, &params, &arena, &morph) == MT_OK, subject);
    return morph;
}

static mt_shape blend_of(const mt_morph *morph, double t, const mt_subject *subject) {
    mt_params params = mt_params_default();
    mt_shape blend = {0};
    mt_require(mt_morph_blend(morph, mt_weights_at(t), &params, &arena, &blend) == MT_OK, subject);
    return blend;
}

static bool is_near(const mt_shape *shape, int64_t x, int64_t y) {
    return mt_oracle_shape_distance(shape, 2, (mt_spot){x, y}) <= NEAR;
}

/* Vertices, and middles of edges, at twice the grid's scale. */
static bool lies_along(const mt_shape *one, const mt_shape *other) {
    mt_rings rings = mt_test_all_rings(&arena, one);
    for (int r = 0; r < rings.count; r++)
        for (int i = 0; i < rings.rings[r].count; i++) {
            mt_point p = rings.rings[r].points[i], q = rings.rings[r].points[(i + 1) % rings.rings[r].count];
            if (!is_near(other, 2LL * p.x, 2LL * p.y) ||
                !is_near(other, (int64_t)p.x + q.x, (int64_t)p.y + q.y))
                return false;
        }
    return true;
}

/* The area of the ink that only one of the two has, grid units squared. */
static double area_apart(const mt_shape *p, const mt_shape *q, const mt_subject *subject) {
    mt_rings one = mt_test_all_rings(&arena, p), other = mt_test_all_rings(&arena, q);
    mt_rings both = mt_test_rings(&arena, one.count + other.count);
    for (int i = 0; i < both.count; i++)
        both.rings[i] = i < one.count ? one.rings[i] : other.rings[i - one.count];
    mt_shape together;
    mt_require(mt_union(&both, MT_NONZERO, &arena, &together) == MT_OK, subject);
    mt_wide each = mt_oracle_shape_area2(p) + mt_oracle_shape_area2(q);
    return (double)(2 * mt_oracle_shape_area2(&together) - each) / 2;
}

static void check_swap(const mt_shape *a, const mt_shape *b, double t, const mt_subject *subject) {
    mt_morph ab = morph_of(a, b, subject), ba = morph_of(b, a, subject);
    mt_require(ab.a.shape.count == ba.b.shape.count && ab.b.shape.count == ba.a.shape.count, subject);
    mt_require(ab.contour_count == ba.contour_count, subject);
    mt_require((ab.links.count > 0) == (ba.links.count > 0), subject);
    mt_shape forth = blend_of(&ab, t, subject), back = blend_of(&ba, 1 - t, subject);
    mt_require(area_apart(&forth, &back, subject) <= NEAR * mt_oracle_shape_length(&forth), subject);
    mt_require(lies_along(&forth, &back), subject);
    mt_require(lies_along(&back, &forth), subject);
}

/* A component of the corpus at some 700/1000 em. */
static mt_shape large(const mt_named *named) {
    mt_box box = mt_ring_box(&named->rings.rings[0]);
    double side = fmax(mt_box_width(box), mt_box_height(box));
    int factor = (int)fmax(1, 0.7 * MT_EM / side);
    mt_component component = mt_test_moved(&arena, &named->rings, factor, (mt_point){0, 0});
    return mt_test_shape_of(&arena, &component);
}

/* Two different components of the corpus, at random. */
static void named_shapes(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(50); n++) {
        mt_random random = mt_random_case(n);
        const mt_named *p, *q;
        do {
            p = &corpus.shapes[mt_random_between(&random, 0, corpus.count - 1)];
            q = &corpus.shapes[mt_random_between(&random, 0, corpus.count - 1)];
        } while (p == q || !p->is_component || !q->is_component);
        mt_subject subject = {p->name, n, {&p->rings, &q->rings}};
        mt_shape a = large(p), b = large(q);
        check_swap(&a, &b, n % 2 ? 0.5 : mt_random_unit(&random), &subject);
        mt_arena_reset(&arena);
    }
}

static void random_shapes(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(60); n++) {
        mt_random random = mt_random_case(n);
        int most = n % 2 ? 3 : 1, size = mt_random_between(&random, 3, 30);
        mt_shape a = mt_random_shape(&random, &arena, most, size, MT_EM / 2),
                 b = mt_random_shape(&random, &arena, most, size, MT_EM / 2);
        mt_rings all_a = mt_test_all_rings(&arena, &a), all_b = mt_test_all_rings(&arena, &b);
        mt_subject subject = {"symmetry", n, {&all_a, &all_b}};
        check_swap(&a, &b, mt_random_unit(&random), &subject);
        mt_arena_reset(&arena);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(named_shapes),
        cmocka_unit_test(random_shapes),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
