#include "geometry/limits.h"
#include "geometry/outline.h"
#include "support/check.h"
#include "support/corpus.h"
#include "support/curves.h"
#include "support/oracle.h"
#include "support/polygons.h"

#include <math.h>

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_rings flattened(const mt_contour *contour, double tolerance) {
    mt_outline outline = mt_curves_outline(&arena, contour);
    mt_rings rings;
    mt_assert_ok(mt_flatten(&outline, tolerance, &arena, &rings));
    return rings;
}

static mt_outline fitted(const mt_rings *rings, double chord, double tolerance) {
    mt_outline outline;
    mt_assert_ok(mt_fit(rings, chord, tolerance, &arena, &outline));
    return outline;
}

static int segments_of_degree(const mt_outline *outline, int degree) {
    int count = 0;
    for (int c = 0; c < outline->count; c++)
        for (int i = 0; i < outline->contours[c].count; i++)
            count += outline->contours[c].segments[i].degree == degree;
    return count;
}

static bool ends_at(const mt_outline *outline, mt_point p) {
    for (int c = 0; c < outline->count; c++)
        for (int i = 0; i < outline->contours[c].count; i++)
            if (mt_point_equal(outline->contours[c].segments[i].end, p)) return true;
    return false;
}

/* Every vertex of the rings within `far` of the contours, and every point of the contours within `far` of
 * the rings. */
static void check_close(const mt_rings *rings, const mt_outline *outline, double to_outline, double to_rings,
                        const mt_subject *subject) {
    for (int r = 0; r < rings->count; r++)
        for (int i = 0; i < rings->rings[r].count; i++) {
            mt_point p = rings->rings[r].points[i];
            mt_require(mt_curves_distance(outline, p.x, p.y) <= to_outline, subject);
        }
    for (int c = 0; c < outline->count; c++)
        for (int i = 0; i < outline->contours[c].count; i++)
            for (int k = 0; k < 32; k++) {
                mt_place2 p = mt_curves_at(&outline->contours[c], i, k / 32.0);
                mt_spot spot = {llround(p.x * 1024), llround(p.y * 1024)};
                mt_require(mt_oracle_distance(rings, 1024, spot) <= to_rings, subject);
            }
}

/* Polygons drawn with lines come back as they are, point for point. */
static void polygons_stay_polygons(void **state) {
    (void)state;
    mt_corpus corpus = mt_corpus_read(&arena);
    static const char *const names[] = {"triangle", "square",       "plus",  "frame",
                                        "comb",     "star_of_five", "zigzag"};
    for (int n = 0; n < 7; n++) {
        mt_rings rings = mt_test_moved(&arena, mt_corpus_find(&corpus, names[n]), 1000, (mt_point){0, 0});
        mt_subject subject = {names[n], -1, {&rings}};
        mt_outline outline = fitted(&rings, 256, 128);
        mt_require(outline.count == rings.count, &subject);
        for (int c = 0; c < outline.count; c++) {
            mt_require(outline.contours[c].count == rings.rings[c].count, &subject);
            for (int i = 0; i < outline.contours[c].count; i++) {
                mt_require(outline.contours[c].segments[i].degree == 1, &subject);
                mt_require(ends_at(&outline, rings.rings[c].points[i]), &subject);
            }
        }
    }
}

static mt_contour circle(int r, mt_segment quarters[4]) {
    int c = (int)lround(r * 0.5522847);
    quarters[0] = (mt_segment){3, {{r, c}, {c, r}}, {0, r}};
    quarters[1] = (mt_segment){3, {{-c, r}, {-r, c}}, {-r, 0}};
    quarters[2] = (mt_segment){3, {{-r, -c}, {-c, -r}}, {0, -r}};
    quarters[3] = (mt_segment){3, {{c, -r}, {r, -c}}, {r, 0}};
    return (mt_contour){4, quarters};
}

/* A circle comes back as quadratics only, no more than sixteen of them, whatever it was flattened with;
 * within the tolerance, to which flattening adds nothing, since its vertices lie on the circle. */
static void circles(void **state) {
    (void)state;
    mt_segment quarters[4];
    static const int radii[] = {5000, 30000, 100000};
    static const double chords[] = {32, 256, 1000};
    for (int n = 0; n < 9; n++) {
        mt_contour contour = circle(radii[n % 3], quarters);
        mt_outline truth = mt_curves_outline(&arena, &contour);
        mt_rings rings = flattened(&contour, chords[n / 3]);
        mt_subject subject = {"circles", n, {&rings}};
        mt_outline outline = fitted(&rings, chords[n / 3], 128);
        mt_require(outline.count == 1, &subject);
        mt_require(segments_of_degree(&outline, 2) == outline.contours[0].count, &subject);
        mt_require(outline.contours[0].count <= 16, &subject);
        for (int i = 0; i < outline.contours[0].count; i++)
            for (int k = 0; k < 16; k++) {
                mt_place2 p = mt_curves_at(&outline.contours[0], i, k / 16.0);
                mt_require(mt_curves_distance(&truth, p.x, p.y) <= 256, &subject);
            }
    }
}

/* The ends of lines and the extremes of rounds are nodes. */
static void rounded_box(void **state) {
    (void)state;
    const int m = 100000, r = 30000, c = 13431; /* r - c is 0.5523 r */
    mt_segment sides[] = {
        {1, {{0}}, {m - r, 0}}, {3, {{m - c, 0}, {m, c}}, {m, r}},
        {1, {{0}}, {m, m - r}}, {3, {{m, m - c}, {m - c, m}}, {m - r, m}},
        {1, {{0}}, {r, m}},     {3, {{c, m}, {0, m - c}}, {0, m - r}},
        {1, {{0}}, {0, r}},     {3, {{0, c}, {c, 0}}, {r, 0}},
    };
    mt_contour contour = {8, sides};
    mt_rings rings = flattened(&contour, 128);
    mt_subject subject = {"rounded_box", -1, {&rings}};
    mt_outline outline = fitted(&rings, 128, 128);
    mt_require(segments_of_degree(&outline, 1) == 4, &subject);
    mt_require(segments_of_degree(&outline, 2) <= 16, &subject);
    for (int i = 0; i < 8; i++) mt_require(ends_at(&outline, sides[i].end), &subject);
    check_close(&rings, &outline, 129, 128 + 128 + 1, &subject);
}

static void corners_are_kept(void **state) {
    (void)state;
    const int r = 80000, c = 44183;
    mt_segment sides[] = {{3, {{r, c}, {c, r}}, {0, r}}, {1, {{0}}, {0, 0}}, {3, {{0, -c}, {r, -c}}, {r, 0}}};
    mt_rings rings = flattened(&(mt_contour){3, sides}, 128);
    mt_subject subject = {"corners_are_kept", -1, {&rings}};
    mt_outline outline = fitted(&rings, 128, 128);
    for (int i = 0; i < 3; i++) mt_require(ends_at(&outline, sides[i].end), &subject);
    check_close(&rings, &outline, 129, 128 + 128 + 1, &subject);
}

/* Random contours, flattened finely: every vertex within the tolerance, and no point of a contour farther
 * from the ring than tolerance and chord error allow at a vertex and, between two vertices, where a
 * quadratic is free, twice that. */
static void random_contours(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(20); n++) {
        mt_random random = mt_random_case(n);
        mt_contour contour = mt_random_contour(&random, &arena, mt_random_between(&random, 4, 9), MT_EM);
        const double chord = 64, tolerance = n % 2 ? 256 : 64;
        mt_rings rings = flattened(&contour, chord);
        mt_subject subject = {"random_contours", n, {&rings}};
        mt_outline outline = fitted(&rings, chord, tolerance);
        mt_require(outline.count == 1, &subject);
        mt_require(outline.contours[0].count <= rings.rings[0].count, &subject);
        check_close(&rings, &outline, tolerance + 1, 2 * (tolerance + chord), &subject);
        for (int i = 0; i < rings.rings[0].count; i++)
            if (rings.rings[0].marks[i] & MT_CORNER)
                mt_require(ends_at(&outline, rings.rings[0].points[i]), &subject);
        mt_arena_reset(&arena);
    }
}

static mt_rings one_ring(const mt_point *points, int count, uint8_t marks) {
    mt_rings rings = mt_test_rings(&arena, 1);
    rings.rings[0] = mt_test_ring(&arena, count);
    for (int i = 0; i < count; i++) {
        rings.rings[0].points[i] = points[i];
        rings.rings[0].marks[i] = marks;
    }
    return rings;
}

/* A ring less wide than MT_SEAM_WIDTH goes, one a little wider stays. */
static void seams_are_left_out(void **state) {
    (void)state;
    const int narrow = MT_SEAM_WIDTH - 4, wide = MT_SEAM_WIDTH + 4;
    mt_point seam[] = {{0, 0}, {100000, 0}, {100000, narrow}, {0, narrow}};
    mt_point hairline[] = {{0, 0}, {100000, 0}, {100000, wide}, {0, wide}};
    mt_rings rings = one_ring(seam, 4, MT_CORNER | MT_LINE);
    assert_int_equal(fitted(&rings, 256, 128).count, 0);
    rings = one_ring(hairline, 4, MT_CORNER | MT_LINE);
    assert_int_equal(fitted(&rings, 256, 128).count, 1);
}

/* Where two sums meet short of each other, the crossing between them is bridged; a corner as deep was
 * drawn, and a crossing deeper than MT_DENT is a real one: both stay. */
static void dents_are_bridged(void **state) {
    (void)state;
    mt_point box[] = {{0, 0}, {100000, 0}, {100000, 50000}, {50000, 50000 - MT_DENT + 4}, {0, 50000}};
    mt_rings rings = one_ring(box, 5, MT_CORNER | MT_LINE);
    mt_outline outline = fitted(&rings, 256, 128);
    assert_true(ends_at(&outline, box[3]));
    rings.rings[0].marks[3] = MT_CROSSING | MT_LINE;
    outline = fitted(&rings, 256, 128);
    assert_false(ends_at(&outline, box[3]));
    assert_int_equal(outline.contours[0].count, 4);
    rings.rings[0].points[3].y -= 8;
    outline = fitted(&rings, 256, 128);
    assert_true(ends_at(&outline, rings.rings[0].points[3]));
}

static void nothing_gives_nothing(void **state) {
    (void)state;
    mt_rings none = {0};
    assert_int_equal(fitted(&none, 256, 128).count, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(polygons_stay_polygons),
        cmocka_unit_test(circles),
        cmocka_unit_test(rounded_box),
        cmocka_unit_test(corners_are_kept),
        cmocka_unit_test(random_contours),
        cmocka_unit_test(seams_are_left_out),
        cmocka_unit_test(dents_are_bridged),
        cmocka_unit_test(nothing_gives_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
