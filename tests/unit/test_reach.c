/* How far past its ends a morph goes on, against what is seen when every place is looked at. */
#include "morph/check/reach.h"

#include <math.h>

#include "blend/pair.h"
#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/check/topology.h"
#include "support/check.h"
#include "support/fonts.h"
#include "support/moves.h"
#include "support/polygons.h"

enum { PLACES = 200 }; /* looked at past an end */

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_reach reach_of(const mt_morph *morph) {
    const mt_reach farthest = {-MT_REACH_MOST, 1 + MT_REACH_MOST};
    mt_params params = mt_params_default();
    mt_reach reach;
    mt_assert_ok(mt_morph_reach(morph, farthest, &params, &arena, &reach));
    return reach;
}

/* Whether the morph has what an end has at one place: as it is drawn, and as it is meant where contours lie over one another. */
static bool holds_at(const mt_morph *morph, mt_topology end, double t) {
    mt_params params = mt_params_default();
    mt_arena_place before = mt_arena_mark(&arena);
    mt_rings rings;
    mt_shape drawn, meant;
    params.tolerance /= MT_OVERLAP_CARE;
    mt_assert_ok(mt_morph_rings(morph, mt_weights_at(t), &params, &arena, &rings));
    mt_assert_ok(mt_union_unmarked(&rings, MT_NONZERO, &arena, &drawn));
    mt_assert_ok(mt_union_unmarked(&rings, MT_POSITIVE, &arena, &meant));
    mt_topology a = mt_topology_of(&drawn), b = mt_topology_of(&meant);
    mt_arena_rewind(&arena, before);
    return a.components == end.components && a.holes == end.holes && b.components == end.components &&
           b.holes == end.holes;
}

/* Whether it has at all places up to so far past the end. */
static bool holds(const mt_morph *morph, bool past_b, double past) {
    mt_topology end = mt_topology_of(past_b ? &morph->b.whole : &morph->a.whole);
    for (int i = 1; i <= PLACES; i++)
        if (!holds_at(morph, end, past_b ? 1 + past * i / PLACES : -past * i / PLACES)) return false;
    return true;
}

/* ---- squares --------------------------------------------------------------------------------------------- */

/* A square that stands, and one on its right that comes nearer, or goes away. */
static mt_morph nearing(int x, int to_x) {
    mt_ring in_a[] = {mt_test_square(&arena, 0, 0), mt_test_square(&arena, x, 0)},
            in_b[] = {mt_test_square(&arena, 0, 0), mt_test_square(&arena, to_x, 0)};
    return mt_test_morph_of(&arena, in_a, in_b, 2);
}

static void what_would_meet_ends_before(void **state) {
    (void)state;
    mt_morph morph = nearing(400, 220); /* at 100 where T = 5/3 */
    mt_reach reach = reach_of(&morph);
    assert_true(reach.from == -1);
    assert_true(reach.to <= 5 / 3.0 && reach.to > 5 / 3.0 - 0.03);
    morph = nearing(220, 400); /* the other way round */
    reach = reach_of(&morph);
    assert_true(reach.to == 2);
    assert_true(reach.from >= -2 / 3.0 && reach.from < -2 / 3.0 + 0.03);
}

static void what_never_meets_goes_all_the_way(void **state) {
    (void)state;
    mt_morph morph = nearing(400, 380);
    mt_reach reach = reach_of(&morph);
    assert_true(reach.from == -1 && reach.to == 2);
}

/* What is not wanted is not looked for, and what is wanted does not depend on how much more is. */
static void less_may_be_wanted(void **state) {
    (void)state;
    mt_morph morph = nearing(400, 220);
    mt_params params = mt_params_default();
    mt_reach reach;
    mt_assert_ok(mt_morph_reach(&morph, (mt_reach){0, 1}, &params, &arena, &reach));
    assert_true(reach.from == 0 && reach.to == 1);
    mt_assert_ok(mt_morph_reach(&morph, (mt_reach){0, 1.9}, &params, &arena, &reach));
    assert_true(reach.to == reach_of(&morph).to);
}

static mt_ring hole(int x, int width) {
    const int points[][2] = {{x, x}, {x, x + width}, {x + width, x + width}, {x + width, x}};
    return mt_test_ring_of(&arena, points, 4, MT_EM / 1000);
}

static mt_ring frame(void) {
    const int points[][2] = {{0, 0}, {400, 0}, {400, 400}, {0, 400}};
    return mt_test_ring_of(&arena, points, 4, MT_EM / 1000);
}

/* A hole of 200 that is 80 at T = 1, and none at T = 5/3: a crumb before that. */
static void a_hole_does_not_close(void **state) {
    (void)state;
    mt_ring in_a[] = {frame(), hole(100, 200)}, in_b[] = {frame(), hole(160, 80)};
    mt_morph morph = mt_test_morph_of(&arena, in_a, in_b, 2);
    mt_reach reach = reach_of(&morph);
    assert_true(reach.to > 1.5 && reach.to < 5 / 3.0);
    assert_true(holds(&morph, true, reach.to - 1));
    assert_false(holds(&morph, true, reach.to - 1 + 0.1));
}

static void links_end_at_the_ends(void **state) {
    (void)state;
    mt_morph morph = nearing(400, 380);
    mt_link link = {0, 0};
    morph.links = (mt_links){1, &link};
    mt_reach reach = reach_of(&morph);
    assert_true(reach.from == 0 && reach.to == 1);
}

static void a_blank_goes_all_the_way(void **state) {
    (void)state;
    mt_morph morph = {0};
    mt_reach reach = reach_of(&morph);
    assert_true(reach.from == -1 && reach.to == 2);
}

/* ---- aside ----------------------------------------------------------------------------------------------- */

static mt_at aside(const mt_morph *morph, double from, mt_at aim) {
    mt_params params = mt_params_default();
    mt_at reach;
    mt_assert_ok(mt_morph_aside(morph, from, aim, &params, &arena, &reach));
    return reach;
}

/* A square of 100 that goes up the side of another one: from the right of it at T = 0 to above it at T = 1. On the diagonal they are apart;
 * early across and late upwards it would lie over the other. */
static mt_morph going_around(void) {
    mt_ring in_a[] = {mt_test_square(&arena, 0, 0), mt_test_square(&arena, 250, 0)},
            in_b[] = {mt_test_square(&arena, 0, 0), mt_test_square(&arena, 0, 250)};
    return mt_test_morph_of(&arena, in_a, in_b, 2);
}

static void what_would_meet_stays_near_the_diagonal(void **state) {
    (void)state;
    mt_morph morph = going_around();
    mt_at reach = aside(&morph, 0.5, (mt_at){1, 0});
    /* x = 250 (1 - tx) and y = 250 ty, 125 each at the middle: they touch at 100, tx = .6 and ty = .4. */
    assert_true(reach.x < 0.6 && reach.x > 0.58);
    assert_true(fabs(reach.x + reach.y - 1) < 1e-9);
    reach = aside(&morph, 0.5, (mt_at){0, 1});
    assert_true(reach.x == 0 && reach.y == 1);
}

static void what_holds_goes_all_the_way_aside(void **state) {
    (void)state;
    mt_morph morph = nearing(400, 380);
    mt_at reach = aside(&morph, 0.6, (mt_at){0.3, 0.9});
    assert_true(reach.x == 0.3 && reach.y == 0.9);
    reach = aside(&morph, 1.2, (mt_at){1.5, 0.9});
    assert_true(reach.x == 1.5 && reach.y == 0.9);
}

static void links_stay_within_aside(void **state) {
    (void)state;
    mt_morph morph = nearing(400, 380);
    mt_ring piece = mt_test_square(&arena, 0, 400);
    mt_link link = {0, 0};
    morph.links = (mt_links){1, &link};
    morph.a.pieces = morph.b.pieces = (mt_pieces){1, &piece};
    mt_at reach = aside(&morph, 1, (mt_at){1.5, 0.9});
    assert_true(reach.x == 1 && reach.y == 0.9);
}

/* ---- letters --------------------------------------------------------------------------------------------- */

/* All places of the reach hold, and where it ends before the last one, places soon past it do not. */
static void letters_agree_with_every_place(void **state) {
    (void)state;
    static const char letters[] = "EKQghikns;8";
    mt_font *a = mt_test_font(MT_TEST_SANS), *b = mt_test_font(MT_TEST_SERIF);
    mt_params params = mt_params_default();
    mt_row row;
    int limited = 0;
    mt_assert_ok(mt_row_open((mt_font *[]){a, b}, 2, &params, &row));
    for (const char *c = letters; *c; c++) {
        mt_glyph_pair pair;
        mt_assert_ok(mt_pair_prepare_char(&row, (uint32_t)*c, &arena, &pair));
        mt_reach reach = reach_of(&pair.morph);
        const double past[] = {-reach.from, reach.to - 1};
        for (int k = 0; k < 2; k++) {
            if (!holds(&pair.morph, k == 1, past[k])) fail_msg("%c does not hold up to %g", *c, past[k]);
            if (past[k] == MT_REACH_MOST || past[k] == 0) continue;
            limited++;
            if (holds(&pair.morph, k == 1, past[k] + 0.07)) fail_msg("%c holds past %g", *c, past[k]);
        }
        mt_arena_reset(&arena);
    }
    assert_true(limited > 0);
    mt_row_close(&row);
    mt_font_close(a);
    mt_font_close(b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_would_meet_ends_before),
        cmocka_unit_test(what_never_meets_goes_all_the_way),
        cmocka_unit_test(less_may_be_wanted),
        cmocka_unit_test(a_hole_does_not_close),
        cmocka_unit_test(links_end_at_the_ends),
        cmocka_unit_test(a_blank_goes_all_the_way),
        cmocka_unit_test(what_would_meet_stays_near_the_diagonal),
        cmocka_unit_test(what_holds_goes_all_the_way_aside),
        cmocka_unit_test(links_stay_within_aside),
        cmocka_unit_test(letters_agree_with_every_place),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
