/* Every allocation failed in turn: each call says MT_NO_MEMORY, or manages without, and leaves nothing
 * behind.
 *
 * An arena asks for memory in blocks, so that few of its allocations can fail. Here its first block is filled
 * beforehand, more and more of it, and no other is granted: then each allocation in it is the first to fail
 * for some filling.
 *
 * What Clipper itself asks of C++'s operator new is not failed: Clipper 6.4.2 frees twice what it held
 * when an exception passes through it. */
#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "geometry/outline.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/model/morph.h"
#include "morph/prepare.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/curves.h"
#include "support/polygons.h"

typedef mt_status (*run)(mt_arena *arena);

/* Small ones, whose run fits one block, and large ones, which take several. */
typedef struct inputs {
    mt_shape a, b;
    mt_rings drawing, rings;
    mt_outline outline;
} inputs;

static mt_arena arena_of_inputs;
static inputs few, many;
static const inputs *now;

static void make_inputs(mt_random *random, int size, inputs *made) {
    mt_arena *arena = &arena_of_inputs;
    mt_component star = mt_random_polygon(random, arena, MT_POLYGON_STAR, size, MT_EM);
    mt_component comb = mt_random_polygon(random, arena, MT_POLYGON_COMB, size, MT_EM);
    made->a = mt_test_shape_of(arena, &star);
    made->b = mt_test_shape_of(arena, &comb);
    made->drawing = mt_test_rings(arena, 2);
    for (int i = 0; i < 2; i++) made->drawing.rings[i] = mt_random_scrawl(random, arena, size / 8 + 4, MT_EM);
    mt_contour contour = mt_random_contour(random, arena, size / 4, MT_EM);
    made->outline = mt_curves_outline(arena, &contour);
    mt_assert_ok(mt_flatten(&made->outline, 256, arena, &made->rings));
}

static int set_up(void **state) {
    (void)state;
    mt_random random = mt_random_case(0);
    make_inputs(&random, 24, &few);
    make_inputs(&random, 80, &many);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena_of_inputs);
    return 0;
}

/* ---- failing ------------------------------------------------------------------------------------------- */

/* How much an arena's first block holds, bytes, to 16. */
static size_t block_size(void) {
    mt_allocation_watch();
    mt_arena arena = {0};
    size_t size = 0;
    while (mt_arena_new(&arena, 16, 1) && mt_allocation_requests() < 2) size += 16;
    mt_arena_release(&arena);
    mt_allocation_unwatch();
    return size;
}

/* Runs in an arena with `filled` bytes taken, request `first` after that failing and, when told, all later
 * ones too. */
static mt_status run_failing(run call, size_t filled, long first, bool all_after, bool *failed) {
    mt_allocation_watch();
    mt_arena arena = {0};
    if (filled) assert_non_null(mt_arena_new(&arena, filled, 1));
    long before = mt_allocation_requests();
    mt_allocation_fail(first, all_after);
    mt_status status = call(&arena);
    *failed = mt_allocation_requests() - before > first;
    mt_arena_release(&arena);
    mt_allocation_succeed();
    long live = mt_allocation_live();
    mt_allocation_unwatch();
    if (status != (*failed ? MT_NO_MEMORY : MT_OK))
        fail_msg("filled %zu, request %ld: %s", filled, first, mt_status_text(status));
    if (live != 0) fail_msg("filled %zu, request %ld: %ld blocks left", filled, first, live);
    return status;
}

static void fail_each(run call) {
    bool failed = true;
    now = &many;
    for (long first = 0; failed; first++) {
        run_failing(call, 0, first, true, &failed);
        if (failed) run_failing(call, 0, first, false, &failed);
    }
    now = &few;
    int failures = 0;
    for (size_t filled = block_size(); filled > 0; filled -= 16) {
        if (run_failing(call, filled, 0, true, &failed) == MT_OK) break;
        failures++;
    }
    assert_true(failures > 2);
}

/* ---- what is run --------------------------------------------------------------------------------------- */

static mt_status decompose(mt_arena *arena) {
    mt_pieces pieces;
    return mt_decompose(&now->a.components[0], arena, &pieces);
}

static mt_status unite(mt_arena *arena) {
    mt_shape shape;
    return mt_union(&now->drawing, MT_NONZERO, arena, &shape);
}

static mt_status flatten(mt_arena *arena) {
    mt_rings flat;
    return mt_flatten(&now->outline, now == &many ? 1 : 4000, arena, &flat);
}

static mt_status fit(mt_arena *arena) {
    mt_outline fitted;
    return mt_fit(&now->rings, 256, 64, arena, &fitted);
}

static mt_status morph_by(mt_method method, mt_arena *arena) {
    mt_params params = mt_params_default();
    params.method = method;
    params.rotation = MT_ROTATION_FOUND;
    mt_morph made;
    mt_shape blend;
    mt_outline contours;
    mt_status status = mt_morph_prepare(&now->a, &now->b, NULL, &params, arena, &made);
    if (status == MT_OK) status = mt_morph_blend(&made, mt_weights_at(0.5), &params, arena, &blend);
    if (status == MT_OK) status = mt_morph_outline(&made, mt_weights_at(0.5), &params, arena, &contours);
    return status;
}

static mt_status morph_by_paper(mt_arena *arena) {
    return morph_by(MT_METHOD_PAPER, arena);
}

static mt_status morph_jointly(mt_arena *arena) {
    return morph_by(MT_METHOD_JOINT, arena);
}

static void decomposition(void **state) {
    (void)state;
    fail_each(decompose);
}

static void unions(void **state) {
    (void)state;
    fail_each(unite);
}

static void flattening(void **state) {
    (void)state;
    fail_each(flatten);
}

static void fitting(void **state) {
    (void)state;
    fail_each(fit);
}

static void morphs(void **state) {
    (void)state;
    fail_each(morph_by_paper);
    fail_each(morph_jointly);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(decomposition), cmocka_unit_test(unions), cmocka_unit_test(flattening),
        cmocka_unit_test(fitting),       cmocka_unit_test(morphs),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
