/* The promises and theorems on real glyphs: DejaVu Sans Bold with DejaVu Serif, and wqy-zenhei with AR PL
 * UKai. */
#include "blend/pair.h"
#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "support/check.h"
#include "support/fonts.h"
#include "support/polygons.h"
#include "support/promises.h"
#include "support/sums.h"

#include <stdio.h>

enum { LATIN_STEP = 5, HAN_STEP = 12, SUM_POINTS = 12 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

typedef void (*check)(mt_font *a, mt_font *b, uint32_t code_point, mt_random *random, mt_subject *subject);

static void each(const char *first, const char *second, const uint32_t *code_points, int count, int step,
                 check call) {
    mt_font *a = mt_test_font(first), *b = mt_test_font(second);
    for (int i = 0; i < count; i += step) {
        char name[32];
        snprintf(name, sizeof name, "U+%04X", (unsigned)code_points[i]);
        mt_random random = mt_random_case(i);
        mt_subject subject = {name, i, {NULL}};
        call(a, b, code_points[i], &random, &subject);
        mt_arena_reset(&arena);
    }
    mt_font_close(a);
    mt_font_close(b);
}

static void each_latin(check call, int step) {
    each(MT_TEST_SANS, MT_TEST_SERIF, mt_test_latin, mt_test_latin_count, step, call);
}

static void each_han(check call, int step) {
    each(MT_TEST_HEI, MT_TEST_KAI, mt_test_han, mt_test_han_count, step, call);
}

static mt_params paper(void) {
    mt_params params = mt_params_default();
    params.method = MT_METHOD_PAPER;
    return params;
}

static void prepare(mt_font *a, mt_font *b, uint32_t code_point, mt_glyph_pair *pair,
                    const mt_subject *subject) {
    mt_params params = paper();
    mt_row row;
    mt_require(mt_row_open((mt_font *[]){a, b}, 2, &params, &row) == MT_OK, subject);
    mt_require(mt_pair_prepare_char(&row, code_point, &arena, pair) == MT_OK, subject);
    mt_row_close(&row);
}

static mt_shape blend_of(const mt_morph *morph, mt_weights weights, const mt_subject *subject) {
    mt_params params = paper();
    mt_shape blend = {0};
    mt_require(mt_morph_blend(morph, weights, &params, &arena, &blend) == MT_OK, subject);
    return blend;
}

/* ---- 2.1 ----------------------------------------------------------------------------------------------- */

static void check_side(const mt_side *side, mt_subject *subject) {
    for (int k = 0; k < side->shape.count; k++) {
        mt_component *component = &side->shape.components[k];
        mt_pieces pieces = {side->first[k + 1] - side->first[k], side->pieces.rings + side->first[k]};
        mt_half_edges mesh;
        subject->shapes[0] = component;
        mt_check_pieces(component, &pieces, subject);
        mt_require(mt_triangulate(component, &arena, &mesh) == MT_OK, subject);
        mt_check_mesh(component, &mesh, subject);
    }
}

static void decomposition(mt_font *a, mt_font *b, uint32_t code_point, mt_random *random,
                          mt_subject *subject) {
    (void)random;
    mt_glyph_pair pair;
    prepare(a, b, code_point, &pair, subject);
    check_side(&pair.morph.a, subject);
    check_side(&pair.morph.b, subject);
}

static void decompositions(void **state) {
    (void)state;
    each_latin(decomposition, LATIN_STEP);
    each_han(decomposition, HAN_STEP);
}

/* ---- the union against the contours as drawn ----------------------------------------------------------- */

static void ink(mt_font *a, mt_font *b, uint32_t code_point, mt_random *random, mt_subject *subject) {
    (void)b;
    mt_outline outline;
    mt_rings rings;
    mt_shape shape;
    double advance;
    mt_require(mt_font_outline(a, mt_font_glyph(a, code_point), &arena, &outline, &advance) == MT_OK,
               subject);
    mt_require(mt_flatten(&outline, MT_EM / 2000, &arena, &rings) == MT_OK, subject);
    mt_require(mt_union(&rings, MT_NONZERO, &arena, &shape) == MT_OK, subject);
    for (int i = 0; i < 200; i++) {
        mt_spot spot = {mt_random_between(random, -50000, MT_EM), mt_random_between(random, -80000, MT_EM)};
        if (mt_oracle_distance(&rings, 1, spot) <= 1) continue;
        mt_require((mt_oracle_winding(&rings, 1, spot) != 0) == mt_oracle_in_shape(&shape, 1, spot), subject);
    }
}

static void resolved_ink(void **state) {
    (void)state;
    each_latin(ink, LATIN_STEP);
    each_han(ink, HAN_STEP);
}

/* ---- Theorem 1 ----------------------------------------------------------------------------------------- */

/* Exactly the same ink, on every glyph that is tried here. */
static void check_equal(const mt_shape *p, const mt_shape *q, const mt_subject *subject) {
    mt_rings one = mt_test_all_rings(&arena, p), other = mt_test_all_rings(&arena, q);
    mt_rings both = mt_test_rings(&arena, one.count + other.count);
    for (int i = 0; i < both.count; i++)
        both.rings[i] = i < one.count ? one.rings[i] : other.rings[i - one.count];
    mt_shape together;
    mt_require(mt_union(&both, MT_NONZERO, &arena, &together) == MT_OK, subject);
    mt_require(mt_oracle_shape_area2(p) == mt_oracle_shape_area2(q), subject);
    mt_require(mt_oracle_shape_area2(&together) == mt_oracle_shape_area2(p), subject);
}

static void theorem_one(mt_font *a, mt_font *b, uint32_t code_point, mt_random *random, mt_subject *subject) {
    mt_glyph_pair pair;
    prepare(a, b, code_point, &pair, subject);
    mt_shape at_a = blend_of(&pair.morph, mt_weights_at(0), subject);
    mt_shape at_b = blend_of(&pair.morph, mt_weights_at(1), subject);
    check_equal(&at_a, &pair.a, subject);
    check_equal(&at_b, &pair.b, subject);
    prepare(a, a, code_point, &pair, subject);
    mt_shape between = blend_of(&pair.morph, mt_weights_at(mt_random_unit(random)), subject);
    check_equal(&between, &pair.a, subject);
}

static void ends(void **state) {
    (void)state;
    each_latin(theorem_one, LATIN_STEP);
    each_han(theorem_one, HAN_STEP);
}

/* ---- Theorem 2, Inference 1 ---------------------------------------------------------------------------- */

/* Corners of the blend, within 2 grid units as in test_theorems.c. */
static void theorem_two(mt_font *a, mt_font *b, uint32_t code_point, mt_random *random, mt_subject *subject) {
    mt_glyph_pair pair;
    prepare(a, b, code_point, &pair, subject);
    mt_weights weights = mt_weights_at(mt_random_unit(random));
    mt_shape blend = blend_of(&pair.morph, weights, subject);
    for (int i = 0; i < SUM_POINTS && blend.count > 0; i++) {
        const mt_component *component = &blend.components[mt_random_between(random, 0, blend.count - 1)];
        const mt_ring *ring = &component->rings[mt_random_between(random, 0, component->count - 1)];
        mt_point corner = ring->points[mt_random_between(random, 0, ring->count - 1)];
        mt_require(mt_sums_distance(&pair.a, &pair.b, weights, corner) <= 2, subject);
    }
}

static void corners_in_the_sum(void **state) {
    (void)state;
    each_latin(theorem_two, 3 * LATIN_STEP);
    each_han(theorem_two, 3 * HAN_STEP);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(decompositions),
        cmocka_unit_test(resolved_ink),
        cmocka_unit_test(ends),
        cmocka_unit_test(corners_in_the_sum),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
