#include "support/moves.h"

#include <limits.h>
#include <math.h>

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "support/check.h"
#include "support/polygons.h"

mt_ring mt_test_square(mt_arena *arena, int x, int y) {
    const int points[][2] = {{x, y}, {x + 100, y}, {x + 100, y + 100}, {x, y + 100}};
    return mt_test_ring_of(arena, points, 4, MT_EM / 1000);
}

static mt_contour contour_of(mt_arena *arena, const mt_ring *ring) {
    mt_contour contour = {ring->count, mt_arena_new(arena, (size_t)ring->count, sizeof(mt_segment))};
    assert_non_null(contour.segments);
    for (int i = 0; i < ring->count; i++)
        contour.segments[i] = (mt_segment){.degree = 1, .end = ring->points[i]};
    return contour;
}

static mt_side side_of(mt_arena *arena, mt_ring *rings, int count) {
    mt_side side = {0};
    mt_assert_ok(mt_union(&(mt_rings){count, rings}, MT_NONZERO, arena, &side.whole));
    side.shape = side.whole;
    side.box = mt_shape_box(&side.whole);
    return side;
}

mt_morph mt_test_morph_of(mt_arena *arena, mt_ring *in_a, mt_ring *in_b, int count) {
    mt_morph morph = {.a = side_of(arena, in_a, count),
                      .b = side_of(arena, in_b, count),
                      .contour_count = count,
                      .contours = mt_arena_new(arena, (size_t)count, sizeof(mt_contour_pair))};
    assert_non_null(morph.contours);
    for (int i = 0; i < count; i++)
        morph.contours[i] =
            (mt_contour_pair){.a = contour_of(arena, &in_a[i]), .b = contour_of(arena, &in_b[i])};
    return morph;
}

mt_topology_error mt_test_topology_error(mt_arena *arena, const mt_morph *morph) {
    mt_params params = mt_params_default();
    mt_topology_error by;
    mt_assert_ok(mt_morph_topology_error(morph, INT_MAX, &params, arena, &by));
    return by;
}

mt_topology_error mt_test_mend(mt_arena *arena, mt_mend mend, mt_morph *morph) {
    mt_params params = mt_params_default();
    mt_mending m = {.morph = morph, .params = &params, .arena = arena, .effort = INT64_MAX};
    mt_assert_ok(mt_mend_begin(&m));
    mt_assert_ok(mend(&m));
    assert_int_equal(m.error.parts, mt_test_topology_error(arena, morph).parts);
    return m.error;
}

double mt_test_displacement(const mt_morph *morph, int contour) {
    mt_point by = morph->contours[contour].displacement;
    return hypot(by.x, by.y) * 1000 / MT_EM;
}

void mt_test_ends_stay(mt_arena *arena, const mt_morph *morph) {
    mt_params params = mt_params_default();
    for (int t = 0; t < 2; t++) {
        const mt_side *side = t ? &morph->b : &morph->a;
        mt_shape blend;
        mt_assert_ok(mt_morph_blend(morph, mt_weights_at(t), &params, arena, &blend));
        assert_int_equal(mt_shape_area2(&blend), mt_shape_area2(&side->whole));
        mt_box box = mt_shape_box(&blend);
        assert_memory_equal(&box, &side->box, sizeof box);
    }
}
