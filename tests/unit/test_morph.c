#include "geometry/limits.h"
#include "geometry/white.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/model/morph.h"
#include "morph/prepare.h"
#include "support/check.h"
#include "support/corpus.h"
#include "support/curves.h"
#include "support/oracle.h"
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

static mt_params by(mt_method method) {
    mt_params params = mt_params_default();
    params.method = method;
    return params;
}

/* A shape of the corpus, a thousand grid units to its unit. */
static mt_shape shape_named(const char *name) {
    mt_component component = mt_test_moved(&arena, mt_corpus_find(&corpus, name), 1000, (mt_point){0, 0});
    return mt_test_shape_of(&arena, &component);
}

static mt_shape bars(const int (*boxes)[4], int count) {
    mt_shape shape = {count, mt_arena_new(&arena, (size_t)count, sizeof(mt_component))};
    for (int i = 0; i < count; i++) {
        const int *b = boxes[i];
        mt_point corners[] = {{b[0], b[1]}, {b[2], b[1]}, {b[2], b[3]}, {b[0], b[3]}};
        shape.components[i] = mt_test_rings(&arena, 1);
        shape.components[i].rings[0] = mt_test_ring(&arena, 4);
        for (int k = 0; k < 4; k++)
            shape.components[i].rings[0].points[k] = (mt_point){corners[k].x * 1000, corners[k].y * 1000};
    }
    return shape;
}

static mt_morph morph_of(mt_shape a, mt_shape b, const mt_params *params) {
    mt_morph morph;
    mt_assert_ok(mt_morph_prepare(&a, &b, NULL, params, &arena, &morph));
    return morph;
}

static mt_shape blend_at(const mt_morph *morph, double t, const mt_params *params) {
    mt_shape blend;
    mt_assert_ok(mt_morph_blend(morph, mt_weights_at(t), params, &arena, &blend));
    return blend;
}

static mt_outline outline_at(const mt_morph *morph, double t, const mt_params *params) {
    mt_outline outline;
    mt_assert_ok(mt_morph_outline(morph, mt_weights_at(t), params, &arena, &outline));
    return outline;
}

static double area_of(const mt_shape *shape) {
    return (double)mt_oracle_shape_area2(shape) / 2e6; /* in squares of 1000 units */
}

static void nothing_and_something(void **state) {
    (void)state;
    mt_shape none = {0}, square = shape_named("square"), blend;
    for (int method = MT_METHOD_JOINT; method <= MT_METHOD_PAPER; method++) {
        mt_params params = by((mt_method)method);
        mt_morph morph;
        assert_int_equal(mt_morph_prepare(&none, &square, NULL, &params, &arena, &morph), MT_NO_COUNTERPART);
        assert_int_equal(mt_morph_prepare(&square, &none, NULL, &params, &arena, &morph), MT_NO_COUNTERPART);
        mt_assert_ok(mt_morph_prepare(&none, &none, NULL, &params, &arena, &morph));
        mt_assert_ok(mt_morph_blend(&morph, mt_weights_at(0.5), &params, &arena, &blend));
        assert_int_equal(blend.count, 0);
        assert_int_equal(outline_at(&morph, 0.5, &params).count, 0);
    }
}

static void boxes_between_boxes(void **state) {
    (void)state;
    const int small[1][4] = {{10, 0, 30, 100}}, large[1][4] = {{50, 40, 130, 60}};
    for (int method = MT_METHOD_JOINT; method <= MT_METHOD_PAPER; method++) {
        mt_params params = by((mt_method)method);
        mt_morph morph = morph_of(bars(small, 1), bars(large, 1), &params);
        mt_shape blend = blend_at(&morph, 0.25, &params);
        mt_box box = mt_shape_box(&blend);
        assert_true(box.min.x == 20000 && box.min.y == 10000 && box.max.x == 55000 && box.max.y == 90000);
        assert_true(area_of(&blend) == 35 * 80);
    }
}

/* Sides as documented: pieces by component, links in order, inside matched components, none left out. */
static void structure(void **state) {
    (void)state;
    mt_params params = by(MT_METHOD_PAPER);
    for (int n = 0; n < mt_test_cases(60); n++) {
        mt_random random = mt_random_case(n);
        mt_arena_place place = mt_arena_mark(&arena);
        mt_shape a = mt_random_shape(&random, &arena, 4, 20, MT_EM / 2),
                 b = mt_random_shape(&random, &arena, 4, 20, MT_EM / 2);
        mt_morph morph = morph_of(a, b, &params);
        assert_int_equal(morph.a.first[a.count], morph.a.pieces.count);
        assert_int_equal(morph.b.first[b.count], morph.b.pieces.count);
        assert_int_equal(morph.contour_count, 0);
        bool *linked = mt_test_new((size_t)morph.a.pieces.count + morph.b.pieces.count, sizeof *linked);
        for (int i = 0; i < morph.links.count; i++) {
            mt_link link = morph.links.links[i], last = i ? morph.links.links[i - 1] : (mt_link){-1, 0};
            assert_true(link.a > last.a || (link.a == last.a && link.b > last.b));
            int k = 0, l = 0, matched = 0;
            while (link.a >= morph.a.first[k + 1]) k++;
            while (link.b >= morph.b.first[l + 1]) l++;
            for (int m = 0; m < morph.matches.count; m++)
                matched += morph.matches.links[m].a == k && morph.matches.links[m].b == l;
            assert_int_equal(matched, 1);
            linked[link.a] = linked[morph.a.pieces.count + link.b] = true;
        }
        for (int i = 0; i < morph.a.pieces.count + morph.b.pieces.count; i++) assert_true(linked[i]);
        free(linked);
        mt_arena_rewind(&arena, place);
    }
}

/* ---- the joint method --------------------------------------------------------------------------------- */

/* The ink of all parts together: those that meet at a cut may lie over one another (divide/extended_cuts.h). */
static mt_wide ink_area2(const mt_shape *parts) {
    mt_rings all = {0, mt_arena_new(&arena, (size_t)mt_shape_ring_count(parts) + 1, sizeof(mt_ring))};
    mt_shape ink;
    for (int k = 0; k < parts->count; k++)
        for (int i = 0; i < parts->components[k].count; i++)
            all.rings[all.count++] = parts->components[k].rings[i];
    mt_assert_ok(mt_union(&all, MT_NONZERO, &arena, &ink));
    return mt_oracle_shape_area2(&ink);
}

/* `filled`: what the parts may be of instead, with white that has no counterpart as ink; nothing where there is none. */
static void check_joint_side(const mt_side *side, const mt_shape *drawn, const mt_shape *filled) {
    assert_int_equal(side->whole.count, drawn->count);
    assert_true(mt_oracle_shape_area2(&side->whole) == mt_oracle_shape_area2(drawn));
    double off = (double)(ink_area2(&side->shape) - mt_oracle_shape_area2(drawn)),
           off_filled = (double)(ink_area2(&side->shape) - mt_oracle_shape_area2(filled));
    double most = sqrt(0.5) * mt_oracle_shape_length(drawn); /* the ends of cuts are rounded to the grid */
    assert_true(fabs(off) <= most || (filled->count > 0 && fabs(off_filled) <= most));
    for (int k = 0; k < side->shape.count; k++)
        assert_true(side->aligned[k] == (side->first[k] == side->first[k + 1]));
    assert_int_equal(side->first[side->shape.count], side->pieces.count);
}

static void check_joint_links(const mt_morph *morph) {
    bool *in_a = mt_test_new((size_t)morph->a.pieces.count + 1, sizeof *in_a),
         *in_b = mt_test_new((size_t)morph->b.pieces.count + 1, sizeof *in_b);
    for (int i = 0; i < morph->matches.count; i++) {
        mt_link match = morph->matches.links[i];
        assert_true(morph->a.aligned[match.a] == morph->b.aligned[match.b]);
    }
    for (int i = 0; i < morph->links.count; i++)
        in_a[morph->links.links[i].a] = in_b[morph->links.links[i].b] = true;
    for (int i = 0; i < morph->a.pieces.count; i++) assert_true(in_a[i]);
    for (int i = 0; i < morph->b.pieces.count; i++) assert_true(in_b[i]);
    free(in_a);
    free(in_b);
}

/* By the joint method: a component is aligned and has no pieces, or has pieces and each of them a link; matched components are
 * aligned both or neither; contours as compatible masters; what was drawn is kept, and the shares have its ink. */
static void aligned_components_have_no_pieces(void **state) {
    (void)state;
    mt_params params = by(MT_METHOD_JOINT);
    for (int n = 0; n < mt_test_cases(25); n++) {
        mt_random random = mt_random_case(n);
        mt_arena_place place = mt_arena_mark(&arena);
        mt_shape a = mt_random_shape(&random, &arena, 3, 12, MT_EM / 2),
                 b = mt_random_shape(&random, &arena, 3, 12, MT_EM / 2);
        mt_morph morph = morph_of(a, b, &params);
        mt_white white[2];
        mt_assert_ok(mt_find_white(&a, &b, &arena, white));
        check_joint_side(&morph.a, &a, &white[0].filled);
        check_joint_side(&morph.b, &b, &white[1].filled);
        check_joint_links(&morph);
        for (int i = 0; i < morph.contour_count; i++) {
            assert_true(morph.contours[i].a.count > 0);
            assert_int_equal(morph.contours[i].a.count, morph.contours[i].b.count);
        }
        mt_arena_rewind(&arena, place);
    }
}

/* ---- figure 2 ---------------------------------------------------------------------------------------- */

static const int three_bars[3][4] = {{20, 80, 80, 90}, {25, 45, 75, 55}, {0, 0, 100, 10}},
                 two_bars[2][4] = {{20, 60, 80, 90}, {0, 0, 100, 12}};

/* By the paper: 三 as three strokes and as two, the upper two of the three both into the upper of the two. */
static void three_strokes_and_two(void **state) {
    (void)state;
    mt_params params = by(MT_METHOD_PAPER);
    mt_morph morph = morph_of(bars(three_bars, 3), bars(two_bars, 2), &params);
    assert_int_equal(morph.matches.count, 3);
    const mt_link *m = morph.matches.links;
    assert_true(m[0].a == 0 && m[0].b == 0 && m[1].a == 1 && m[1].b == 0 && m[2].a == 2 && m[2].b == 1);
    mt_shape at_a = blend_at(&morph, 0, &params), at_b = blend_at(&morph, 1, &params);
    assert_true(area_of(&at_a) == 600 + 500 + 1000 && area_of(&at_b) == 1800 + 1200);
}

/* Jointly each of the two has one counterpart, and the third bar closes into the ink of the other side. */
static void three_strokes_and_two_jointly(void **state) {
    (void)state;
    mt_params params = by(MT_METHOD_JOINT);
    mt_morph morph = morph_of(bars(three_bars, 3), bars(two_bars, 2), &params);
    assert_int_equal(morph.matches.count, 2);
    assert_int_equal(morph.contour_count, 3);
    assert_int_equal(morph.links.count, 0);
    for (int k = 0; k < 3; k++) assert_true(morph.a.aligned[k]);
    for (int k = 0; k < 2; k++) assert_true(morph.b.aligned[k]);
    mt_shape at_a = blend_at(&morph, 0, &params), at_b = blend_at(&morph, 1, &params);
    assert_true(area_of(&at_a) == 600 + 500 + 1000 && area_of(&at_b) == 1800 + 1200);
    assert_int_equal(at_a.count, 3);
    assert_int_equal(at_b.count, 2);
}

/* Two bars, and an H that has them joined: the H is cut, each stem goes with a bar, and at the end it is as it was drawn, without
 * a seam. */
static void an_h_between_two_bars(void **state) {
    (void)state;
    static const int left[][2] = {{0, 0}, {100, 0}, {100, 700}, {0, 700}},
                     right[][2] = {{160, 0}, {260, 0}, {260, 700}, {160, 700}},
                     joined[][2] = {{0, 0},     {100, 0},   {100, 330}, {160, 330}, {160, 0},   {260, 0},
                                    {260, 700}, {160, 700}, {160, 370}, {100, 370}, {100, 700}, {0, 700}};
    mt_component parts[] = {mt_test_rings(&arena, 1), mt_test_rings(&arena, 1), mt_test_rings(&arena, 1)};
    parts[0].rings[0] = mt_test_ring_of(&arena, left, 4, MT_EM / 1000);
    parts[1].rings[0] = mt_test_ring_of(&arena, right, 4, MT_EM / 1000);
    parts[2].rings[0] = mt_test_ring_of(&arena, joined, 12, MT_EM / 1000);
    mt_shape stems = {2, parts}, h = {1, parts + 2};
    mt_params params = by(MT_METHOD_JOINT);
    mt_morph morph = morph_of(stems, h, &params), back = morph_of(h, stems, &params);
    assert_true(morph.a.shape.count == 2 && morph.b.shape.count == 2 && morph.b.whole.count == 1);
    assert_true(back.a.shape.count == 2 && back.b.shape.count == 2 && back.a.whole.count == 1);
    assert_true(morph.matches.count == 2 && morph.contour_count == 2 && morph.links.count == 0);
    assert_int_equal(outline_at(&morph, 0, &params).count, 2);
    assert_int_equal(outline_at(&morph, 0.25, &params).count, 2);
    for (int i = 0; i < 2; i++) {
        mt_outline drawn = outline_at(i ? &back : &morph, i ? 0 : 1, &params);
        assert_int_equal(drawn.count, 1);
        assert_int_equal(drawn.contours[0].count, 12);
    }
}

static void holes_stay_open(void **state) {
    (void)state;
    mt_shape frame = shape_named("frame"),
             other = mt_test_shape_moved(&arena, &frame, 2, (mt_point){5000, 7000});
    for (int method = MT_METHOD_JOINT; method <= MT_METHOD_PAPER; method++) {
        mt_params params = by((mt_method)method);
        mt_morph morph = morph_of(frame, other, &params);
        mt_shape blend = blend_at(&morph, 0.5, &params);
        assert_int_equal(blend.count, 1);
        assert_int_equal(blend.components[0].count, 2);
        assert_true(fabs(area_of(&blend) - 1.5 * 1.5 * 6400) < 1);
    }
}

/* ---- rotation ------------------------------------------------------------------------------------------ */

/* Without rotation a bar and the same bar upright swell into a square between; with it the bar turns. */
static void turning_bars(void **state) {
    (void)state;
    const int flat[1][4] = {{0, 45, 100, 55}}, upright[1][4] = {{45, 0, 55, 100}};
    mt_params params = by(MT_METHOD_PAPER);
    mt_morph morph = morph_of(bars(flat, 1), bars(upright, 1), &params);
    mt_shape blend = blend_at(&morph, 0.5, &params);
    assert_true(area_of(&blend) == 55 * 55);
    params.rotation = MT_ROTATION_GIVEN;
    params.degrees = 90;
    morph = morph_of(bars(flat, 1), bars(upright, 1), &params);
    blend = blend_at(&morph, 0.5, &params);
    assert_true(fabs(area_of(&blend) - 1000) < 1);
    mt_box box = mt_shape_box(&blend);
    double side = 110 / sqrt(2) * 1000;
    assert_true(fabs((double)box.max.x - box.min.x - side) < 3 &&
                fabs((double)box.max.y - box.min.y - side) < 3);
    mt_shape at_b = blend_at(&morph, 1, &params);
    box = mt_shape_box(&at_b);
    assert_true(box.min.x == 45000 && box.max.y == 100000 && area_of(&at_b) == 1000);
}

static void rotation_is_found(void **state) {
    (void)state;
    const int flat[1][4] = {{0, 45, 100, 55}};
    mt_params params = by(MT_METHOD_PAPER);
    params.rotation = MT_ROTATION_GIVEN;
    params.degrees = 35;
    mt_shape bar = bars(flat, 1);
    mt_morph turned =
        morph_of(bar, bar, &params); /* to turn a bar: at T = 1 formula (5) turns it to and fro */
    params.rotation = MT_ROTATION_FOUND;
    mt_morph straight = morph_of(bar, bar, &params);
    assert_true(turned.degrees == 35);
    assert_true(fabs(straight.degrees) < 1e-9);
    mt_morph back = morph_of(bar, turned.b.shape, &params);
    assert_true(fabs(back.degrees + 35) < 0.01);
    mt_shape blend = blend_at(&back, 0.5, &params);
    assert_true(fabs(area_of(&blend) - 1000) < 2);
}

/* ---- curves -------------------------------------------------------------------------------------------- */

/* A round between radii r and q (0 for none). */
static mt_shape round_of(int r, int q) {
    mt_contour contours[2];
    for (int i = 0; i < 2; i++) {
        int s = i ? q : r, c = (int)(s * 0.5523), d = i ? -1 : 1;
        contours[i] = (mt_contour){4, mt_arena_new(&arena, 4, sizeof(mt_segment))};
        contours[i].segments[0] = (mt_segment){3, {{s, d * c}, {c, d * s}}, {0, d * s}};
        contours[i].segments[1] = (mt_segment){3, {{-c, d * s}, {-s, d * c}}, {-s, 0}};
        contours[i].segments[2] = (mt_segment){3, {{-s, -d * c}, {-c, -d * s}}, {0, -d * s}};
        contours[i].segments[3] = (mt_segment){3, {{c, -d * s}, {s, -d * c}}, {s, 0}};
    }
    mt_outline outline = {q ? 2 : 1, contours};
    mt_component component;
    mt_assert_ok(mt_flatten(&outline, 128, &arena, &component));
    return mt_test_shape_of(&arena, &component);
}

/* Rounds between rounds are round: on the circle of the mean radius, with few curves and no lines. */
static void rounds_between_rounds(void **state) {
    (void)state;
    for (int method = MT_METHOD_JOINT; method <= MT_METHOD_PAPER; method++) {
        mt_params params = by((mt_method)method);
        mt_morph morph = morph_of(round_of(100000, 0), round_of(60000, 0), &params);
        mt_outline outline = outline_at(&morph, 0.5, &params);
        assert_int_equal(outline.count, 1);
        assert_true(outline.contours[0].count <= 16);
        for (int i = 0; i < outline.contours[0].count; i++) {
            assert_int_equal(outline.contours[0].segments[i].degree, 2);
            for (int k = 0; k < 8; k++) {
                mt_place2 p = mt_curves_at(&outline.contours[0], i, k / 8.0);
                assert_true(fabs(hypot(p.x, p.y) - 80000) <= 256); /* 1/1000 em */
            }
        }
    }
}

/* Jointly, an o and another o are two moving contours and no links. */
static void contours_of_an_o(void **state) {
    (void)state;
    mt_params params = by(MT_METHOD_JOINT);
    mt_morph morph = morph_of(round_of(100000, 70000), round_of(60000, 30000), &params);
    assert_int_equal(morph.contour_count, 2);
    assert_int_equal(morph.links.count, 0);
    for (int i = 0; i < 2; i++) {
        const mt_contour_pair *masters = &morph.contours[i];
        assert_int_equal(masters->a.count, masters->b.count);
        for (int k = 0; k < masters->a.count; k++)
            assert_int_equal(masters->a.segments[k].degree, masters->b.segments[k].degree);
    }
    mt_outline outline = outline_at(&morph, 0.5, &params);
    assert_int_equal(outline.count, 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_and_something),
        cmocka_unit_test(boxes_between_boxes),
        cmocka_unit_test(structure),
        cmocka_unit_test(three_strokes_and_two),
        cmocka_unit_test(three_strokes_and_two_jointly),
        cmocka_unit_test(aligned_components_have_no_pieces),
        cmocka_unit_test(an_h_between_two_bars),
        cmocka_unit_test(holes_stay_open),
        cmocka_unit_test(turning_bars),
        cmocka_unit_test(rotation_is_found),
        cmocka_unit_test(rounds_between_rounds),
        cmocka_unit_test(contours_of_an_o),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
