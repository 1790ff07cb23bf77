#include "geometry/limits.h"
#include "morph/check/appearance.h"
#include "morph/check/projection.h"
#include "morph/model/frame.h"
#include "support/check.h"
#include "support/polygons.h"

#include <math.h>

enum { UNIT = MT_EM / 1000 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_ring box(int left, int bottom, int width, int height) {
    const int points[][2] = {
        {left, bottom}, {left + width, bottom}, {left + width, bottom + height}, {left, bottom + height}};
    return mt_test_ring_of(&arena, points, 4, UNIT);
}

/* Of a box, half of the ink is left of its middle, and a tenth below a tenth of its height. */
static void ink_is_projected(void **state) {
    (void)state;
    mt_ring ring = box(100, 0, 400, 700);
    mt_projection_frame frame = {300 * UNIT, 0, 800 * UNIT};
    mt_projection *made = mt_arena_new(&arena, 1, sizeof *made);
    mt_project(&(mt_rings){1, &ring}, &frame, made);
    assert_true(fabs(made->area - 400.0 * 700 * UNIT * UNIT) < 1);
    assert_true(fabs(made->share[0][MT_BINS / 2 - 1] - 0.5) < 1e-9);
    int half_up = MT_DIRECTIONS / 2, at_tenth = (int)((70.0 + 800) / 1600 * MT_BINS);
    double bin_end = (at_tenth + 1) * 1600.0 / MT_BINS - 800;
    assert_true(fabs(made->share[half_up][at_tenth] - bin_end / 700) < 1e-9);
    assert_true(fabs(made->place[0][0] + 0.99 * 200 * UNIT) < UNIT);
}

/* A hole takes ink away. */
static void holes_are_no_ink(void **state) {
    (void)state;
    mt_ring rings[] = {box(0, 0, 400, 400), box(0, 100, 200, 200)};
    for (int i = 0; i < 2; i++) {
        mt_point swap = rings[1].points[i];
        rings[1].points[i] = rings[1].points[3 - i];
        rings[1].points[3 - i] = swap;
    }
    mt_projection_frame frame = {200 * UNIT, 0, 800 * UNIT};
    mt_projection *made = mt_arena_new(&arena, 1, sizeof *made);
    mt_project(&(mt_rings){2, rings}, &frame, made);
    assert_true(fabs(made->share[0][MT_BINS / 2 - 1] - 1.0 / 3) < 1e-9);
}

/* A morph of boxes, each to one of the other side. */
static mt_morph morph_of(const mt_ring *a, const mt_ring *b, int count) {
    mt_morph morph = {.contour_count = count,
                      .contours = mt_arena_new(&arena, (size_t)count, sizeof(mt_contour_pair))};
    for (int s = 0; s < 2; s++) {
        mt_side *side = s ? &morph.b : &morph.a;
        side->whole = (mt_shape){count, mt_arena_new(&arena, (size_t)count, sizeof(mt_component))};
        for (int i = 0; i < count; i++) {
            mt_ring *ring = mt_arena_new(&arena, 1, sizeof *ring);
            *ring = s ? b[i] : a[i];
            side->whole.components[i] = (mt_component){1, ring};
            mt_contour contour = {4, mt_arena_new(&arena, 4, sizeof(mt_segment))};
            for (int k = 0; k < 4; k++)
                contour.segments[k] = (mt_segment){.degree = 1, .end = ring->points[k]};
            *(s ? &morph.contours[i].b : &morph.contours[i].a) = contour;
        }
        side->shape = side->whole;
        side->box = mt_shape_box(&side->whole);
        side->frame = mt_frame_of_box(side->box);
    }
    return morph;
}

static mt_appearance look(const mt_morph *morph) {
    mt_params params = mt_params_default();
    mt_onlooker *onlooker;
    mt_appearance seen;
    mt_assert_ok(mt_look_at_ends(morph, &arena, &onlooker));
    mt_assert_ok(mt_look_at_morph(onlooker, morph, &params, &arena, &seen));
    return seen;
}

/* Two bars that stay where they are stray nowhere; if they change places they do, and clot where they meet. */
static void what_travels_strays(void **state) {
    (void)state;
    mt_ring at_first[] = {box(0, 0, 60, 700), box(300, 0, 60, 700)}, other[] = {at_first[1], at_first[0]};
    mt_morph stays = morph_of(at_first, at_first, 2), travels = morph_of(at_first, other, 2);
    mt_appearance good = look(&stays), bad = look(&travels);
    assert_true(good.strays < 0.5 && good.clots == 1 && good.ink == 0);
    assert_true(bad.strays > 50 && bad.ink > 0.3);
    assert_true(mt_appearance_score(&good) < 0.1 && mt_appearance_score(&bad) > 1);
}

/* Bars that meet half-way make a blob of twice the thickness. */
static void blobs_are_clots(void **state) {
    (void)state;
    mt_ring a[] = {box(0, 0, 600, 60), box(0, 300, 600, 60)},
            b[] = {box(0, 120, 600, 60), box(0, 180, 600, 60)};
    mt_morph meets = morph_of(a, b, 2);
    assert_true(look(&meets).clots == 1); /* the other end has the blob itself */
    mt_ring low[] = {box(0, 0, 600, 60), box(0, 240, 600, 60)}, high[] = {low[1], box(0, 120, 600, 60)};
    mt_morph passes = morph_of(low, high, 2);
    assert_true(look(&passes).clots > 1.4);
}

/* A bar that moves and grows keeps its headings; one whose corners go with the next ones turns by a right angle, which is a half. */
static void corners_beside_corners_turn(void **state) {
    (void)state;
    mt_ring a = box(0, 0, 60, 700), b = box(100, 50, 200, 650), turned = box(100, 50, 200, 650);
    for (int i = 0; i < 4; i++) turned.points[i] = b.points[(i + 1) % 4];
    mt_morph keeps = morph_of(&a, &b, 1), turns = morph_of(&a, &turned, 1);
    assert_true(look(&keeps).turning < 1e-12);
    assert_true(fabs(look(&turns).turning - 0.5) < 1e-12);
    mt_appearance seen = MT_NOTHING_SEEN;
    seen.turning = MT_TURNING_MOST;
    assert_true(fabs(mt_appearance_score(&seen) - 1) < 1e-12);
}

/* Headings are compared as the frames carry them: what slants as a whole does not turn. */
static void frames_carry_headings(void **state) {
    (void)state;
    mt_ring a = box(0, 0, 60, 700), b = box(0, 0, 60, 700);
    b.points[2].x += 700 * UNIT / 4;
    b.points[3].x += 700 * UNIT / 4;
    mt_morph slants = morph_of(&a, &b, 1);
    assert_true(look(&slants).turning > 0.01);
    slants.a.frame.heading[1] = 0.25;
    assert_true(look(&slants).turning < 1e-12);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ink_is_projected),
        cmocka_unit_test(holes_are_no_ink),
        cmocka_unit_test(what_travels_strays),
        cmocka_unit_test(blobs_are_clots),
        cmocka_unit_test(corners_beside_corners_turn),
        cmocka_unit_test(frames_carry_headings),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
