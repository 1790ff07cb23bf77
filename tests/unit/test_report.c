#include "geometry/limits.h"
#include "morph/prepare.h"
#include "report/report.h"
#include "support/check.h"
#include "support/polygons.h"

#include <math.h>
#include <string.h>

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static const int unit = MT_EM / 1000; /* a thousandth of the em */

/* ---- shapes of upright rectangles, thousandths of the em ------------------------------------------------- */

static mt_ring rectangle(int left, int bottom, int right, int top, bool hole) {
    mt_ring ring = mt_test_ring(&arena, 4);
    mt_point corners[] = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    for (int i = 0; i < 4; i++) {
        mt_point p = corners[hole ? 3 - i : i];
        ring.points[i] = (mt_point){p.x * unit, p.y * unit};
    }
    return ring;
}

/* A square of ink from the origin with a square hole in its middle; none of side 0. */
static mt_shape frame(int side, int hole) {
    mt_component component = mt_test_rings(&arena, hole ? 2 : 1);
    int from = (side - hole) / 2;
    component.rings[0] = rectangle(0, 0, side, side, false);
    if (hole) component.rings[1] = rectangle(from, from, from + hole, from + hole, true);
    return mt_test_shape_of(&arena, &component);
}

static mt_report_glyph measured(mt_shape a, mt_shape b, mt_method method) {
    mt_params params = mt_params_default();
    mt_glyph_pair pair = {.a = a, .b = b};
    mt_report_glyph glyph = {.of.code_point = 'x'};
    params.method = method;
    mt_assert_ok(mt_morph_prepare(&pair.a, &pair.b, NULL, &params, &arena, &pair.morph));
    mt_assert_ok(mt_report_measure(&pair, &params, 1000, &arena, &glyph));
    mt_report_judge(&glyph);
    return glyph;
}

/* ---- ink ------------------------------------------------------------------------------------------------- */

static void parts_and_crumbs_are_told_apart(void **state) {
    (void)state;
    mt_shape large = frame(100, 50), small_hole = frame(100, 4), small = frame(4, 0), least = frame(5, 0);
    mt_topology ink = mt_topology_of(&large);
    assert_int_equal(ink.components, 1);
    assert_int_equal(ink.holes, 1);
    assert_int_equal(ink.crumbs, 0);
    assert_true(fabs(ink.area - 0.0075) < 1e-12);
    ink = mt_topology_of(&small_hole);
    assert_int_equal(ink.holes, 0);
    assert_int_equal(ink.crumbs, 1);
    ink = mt_topology_of(&small); /* 16 square thousandths */
    assert_int_equal(ink.components, 0);
    assert_int_equal(ink.crumbs, 1);
    ink = mt_topology_of(&least); /* 25 */
    assert_int_equal(ink.components, 1);
    assert_int_equal(ink.crumbs, 0);
}

/* A ring as thin as MT_SEAM_WIDTH is a rounding's, and no crumb. */
static void seams_are_nothing(void **state) {
    (void)state;
    mt_component seam = mt_test_rings(&arena, 1);
    seam.rings[0] = rectangle(0, 0, 60, 1, false);
    for (int i = 2; i < 4; i++) seam.rings[0].points[i].y = MT_SEAM_WIDTH / 4;
    mt_shape shape = mt_test_shape_of(&arena, &seam);
    mt_topology ink = mt_topology_of(&shape);
    assert_int_equal(ink.components + ink.holes + ink.crumbs, 0);
}

/* ---- corners --------------------------------------------------------------------------------------------- */

/* The corners of a closed line of `count` points, thousandths of the em. */
static mt_report_drawing corners_of(const mt_point *points, int count) {
    mt_segment segments[16] = {{0}};
    mt_contour contour = {count, segments};
    mt_outline outline = {1, &contour};
    mt_report_drawing drawing = {.points = 7};
    for (int i = 0; i < count; i++)
        segments[i] = (mt_segment){.degree = 1, .end = {points[i].x * unit, points[i].y * unit}};
    mt_report_count_corners(&outline, &drawing);
    assert_int_equal(drawing.points, 7);
    return drawing;
}

static void corners_are_counted_by_angle(void **state) {
    (void)state;
    const mt_point square[] = {{0, 0}, {100, 0}, {100, 100}, {0, 100}};
    const mt_point roof[] = {
        {0, 0}, {100, 0}, {100, 100}, {50, 110}, {0, 100}}; /* turns by 23° in the middle */
    const mt_point flat[] = {{0, 0}, {100, 0}, {100, 100}, {50, 101}, {0, 100}};  /* by 2° */
    const mt_point steep[] = {{0, 0}, {100, 0}, {100, 100}, {50, 140}, {0, 100}}; /* by 77° */
    const mt_point small[] = {{0, 0}, {100, 0}, {100, 100}, {3, 101}, {0, 100}};  /* one side is short */
    mt_report_drawing drawing = corners_of(square, 4);
    assert_int_equal(drawing.corners, 4);
    assert_int_equal(drawing.slight, 0);
    drawing = corners_of(roof, 5);
    assert_int_equal(drawing.corners, 5);
    assert_int_equal(drawing.slight, 1);
    drawing = corners_of(flat, 5);
    assert_int_equal(drawing.corners, 4);
    drawing = corners_of(steep, 5);
    assert_int_equal(drawing.corners, 5);
    assert_int_equal(drawing.slight, 0);
    drawing = corners_of(small, 5);
    assert_int_equal(drawing.corners, 3);
}

/* A half circle of two quadratics on a line: smooth in its middle, two corners at its ends. */
static void tangents_are_those_of_curves(void **state) {
    (void)state;
    mt_segment segments[] = {
        {.degree = 2, .control = {{200 * unit, 100 * unit}}, .end = {100 * unit, 100 * unit}},
        {.degree = 2, .control = {{0, 100 * unit}}, .end = {0, 0}},
        {.degree = 1, .end = {200 * unit, 0}},
    };
    mt_contour contour = {3, segments};
    mt_outline outline = {1, &contour};
    mt_report_drawing drawing = {0};
    mt_report_count_corners(&outline, &drawing);
    assert_int_equal(drawing.corners, 2);
    segments[1].control[0].y += 20 * unit; /* the second leaves 11° off */
    mt_report_count_corners(&outline, &drawing);
    assert_int_equal(drawing.corners, 3);
    assert_int_equal(drawing.slight, 1);
}

/* ---- a glyph --------------------------------------------------------------------------------------------- */

static void a_square_that_grows(void **state) {
    (void)state;
    mt_report_glyph glyph = measured(frame(200, 0), frame(600, 0), MT_METHOD_JOINT);
    assert_int_equal(glyph.of.code_point, 'x');
    assert_int_equal(glyph.method, MT_REPORT_ALIGNED);
    assert_int_equal(glyph.flags, 0);
    for (int i = 0; i < MT_REPORT_STEPS; i++) {
        double side = 0.2 + 0.4 * mt_report_t(i);
        assert_int_equal(glyph.ink[i].components, 1);
        assert_true(fabs(glyph.ink[i].area - side * side) < 1e-4);
    }
    assert_int_equal(glyph.drawing_half.points, 4);
    assert_int_equal(glyph.drawing_half.corners, 4);
    /* 0.16 half-way, where the straight line has 0.2, of 0.36 */
    assert_true(fabs(mt_report_ink_bend(&glyph) + 0.04 / 0.36) < 1e-3);
}

static void the_method_is_told(void **state) {
    (void)state;
    assert_int_equal(measured(frame(200, 0), frame(300, 0), MT_METHOD_PAPER).method, MT_REPORT_LINKED);
    assert_int_equal(measured(frame(200, 0), frame(300, 0), MT_METHOD_JOINT).method, MT_REPORT_ALIGNED);
}

/* A hole that closes is in the range of the ends at every place. */
static void a_hole_without_a_counterpart(void **state) {
    (void)state;
    mt_report_glyph glyph = measured(frame(400, 200), frame(400, 0), MT_METHOD_JOINT);
    assert_int_equal(glyph.ink_a.holes, 1);
    assert_int_equal(glyph.ink_b.holes, 0);
    assert_int_equal(glyph.ink[MT_REPORT_HALF].holes, 1);
    assert_false(glyph.flags & (MT_FLAG_HOLES | MT_FLAG_COMPONENTS));
}

static void blanks_are_well(void **state) {
    (void)state;
    mt_report_glyph glyph = measured((mt_shape){0}, (mt_shape){0}, MT_METHOD_JOINT);
    assert_int_equal(glyph.flags, 0);
    assert_true(mt_report_ink_bend(&glyph) == 0);
}

/* ---- the judgement --------------------------------------------------------------------------------------- */

/* Nothing to complain of: one component, one hole, 0.1 em², 40 points, 20 corners of which 4 are slight. */
static mt_report_glyph sound(void) {
    mt_topology ink = {1, 1, 0, 0.1};
    mt_report_drawing drawing = {40, 20, 4};
    mt_report_glyph glyph = {
        .ink_a = ink, .ink_b = ink, .drawing_a = drawing, .drawing_b = drawing, .drawing_half = drawing};
    for (int i = 0; i < MT_REPORT_STEPS; i++) {
        glyph.ink[i] = ink;
        glyph.seen[i] = MT_NOTHING_SEEN;
    }
    return glyph;
}

/* That the glyph has this flag, this severity and this reason. */
static void judged(mt_report_glyph glyph, mt_report_flag flag, double severity, const char *reason) {
    char text[MT_REPORT_REASON_ROOM];
    mt_report_judge(&glyph);
    assert_true(glyph.flags & flag);
    assert_true(fabs(glyph.severity - severity) < 1e-9);
    mt_report_reason(&glyph, flag, text);
    assert_string_equal(text, reason);
}

static void passes(mt_report_glyph glyph, double severity) {
    mt_report_judge(&glyph);
    assert_int_equal(glyph.flags, 0);
    assert_true(fabs(glyph.severity - severity) < 1e-9);
}

static void counts_are_held_against_the_ends(void **state) {
    (void)state;
    mt_report_glyph glyph = sound();
    passes(glyph, 0);
    glyph.ink[6].components = 2;
    assert_true(mt_report_is_off(&glyph, 6));
    assert_false(mt_report_is_off(&glyph, 7));
    assert_false(mt_report_counts_in_range(&glyph));
    passes(glyph, 0.03);
    glyph.ink[7].components = 35;
    judged(glyph, MT_FLAG_COMPONENTS, 0.03 * 35, "35 components at T = 0.4375, the ends have 1 and 1");
    glyph.ink_b.components = 35;
    passes(glyph, 0);
    assert_true(mt_report_counts_in_range(&glyph));
    glyph.ink[2].holes = 0;
    glyph.seen[8].strays = 0.98 * MT_STRAYS_MOST;
    judged(glyph, MT_FLAG_HOLES, 1.01, "0 holes at T = 0.125, the ends have 1 and 1");
    glyph.ink_a.holes = 0;
    passes(glyph, 0.98);
}

static void what_an_eye_minds_has_limits(void **state) {
    (void)state;
    mt_report_glyph glyph = sound();
    glyph.ink_a.area = 0.2;
    glyph.seen[8].ink = 0.029;
    passes(glyph, 0.24);
    assert_true(mt_report_ink_in_range(&glyph));
    glyph.seen[8].ink = 0.18;
    assert_false(mt_report_ink_in_range(&glyph));
    judged(glyph, MT_FLAG_INK, 1.5, "ink 18.0 % under the ends' at T = 0.5");
    glyph.ink[8].area = 0.3;
    judged(glyph, MT_FLAG_INK, 1.5, "ink 18.0 % over the ends' at T = 0.5");
    glyph.seen[1].strays = 24;
    judged(glyph, MT_FLAG_STRAYS, 2, "ink strays by 24.0 thousandths of the em from its way at T = 0.0625");
    glyph.seen[12].clots = 1.375;
    judged(glyph, MT_FLAG_CLOTS, 2.5, "a stroke is 37.5 % thicker than any of the ends' at T = 0.75");
    assert_true(mt_report_is_off(&glyph, 1) && mt_report_is_off(&glyph, 12));
}

static void kinks_are_counted(void **state) {
    (void)state;
    mt_report_glyph glyph = sound();
    glyph.drawing_half = (mt_report_drawing){40, 30, 10};
    assert_int_equal(mt_report_kinks(&glyph), 6);
    glyph.drawing_b.corners = 30; /* slight ones that B has as corners */
    assert_int_equal(mt_report_kinks(&glyph), 0);
}

static void failures_come_first(void **state) {
    (void)state;
    mt_report_glyph glyph = {.of.code_point = 'x', .status = MT_NO_COUNTERPART};
    judged(glyph, MT_FLAG_FAILED, 1000, mt_status_text(MT_NO_COUNTERPART));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_and_crumbs_are_told_apart),
        cmocka_unit_test(seams_are_nothing),
        cmocka_unit_test(corners_are_counted_by_angle),
        cmocka_unit_test(tangents_are_those_of_curves),
        cmocka_unit_test(a_square_that_grows),
        cmocka_unit_test(the_method_is_told),
        cmocka_unit_test(a_hole_without_a_counterpart),
        cmocka_unit_test(blanks_are_well),
        cmocka_unit_test(counts_are_held_against_the_ends),
        cmocka_unit_test(what_an_eye_minds_has_limits),
        cmocka_unit_test(kinks_are_counted),
        cmocka_unit_test(failures_come_first),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
