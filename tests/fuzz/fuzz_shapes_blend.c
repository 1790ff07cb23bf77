/* Two shapes to a morph, and to what is between them: polygons, and moving contours. */
#include "fuzz.h"

#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/between/variable_outline.h"
#include "morph/prepare.h"

static bool is_expected(mt_status status) {
    return status == MT_OK || status == MT_TOO_LARGE || status == MT_NO_MEMORY || status == MT_NO_COUNTERPART;
}

static mt_status blend(const mt_shape *a, const mt_shape *b, const mt_params *params, mt_arena *arena) {
    mt_morph morph;
    mt_outline outline;
    mt_variable_outline variable;
    mt_status status = mt_morph_prepare(a, b, NULL, params, arena, &morph);
    if (status != MT_OK) return status;
    status = mt_morph_outline(&morph, mt_weights_at(0.5), params, arena, &outline);
    if (status != MT_OK) return status;
    fuzz_require(mt_outline_is_valid(&outline));
    return mt_variable_outline_make(&morph, params, arena, &variable);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    fuzz_places places = fuzz_places_of(bytes, length);
    mt_arena arena = {0};
    mt_shape a, b;
    mt_rings of_a = fuzz_rings(&places, FUZZ_SECOND, 0, &arena),
             of_b = fuzz_rings(&places, FUZZ_SECOND, FUZZ_SECOND, &arena);
    mt_params params = mt_params_default();
    if (length % 4 == 1) params.method = MT_METHOD_PAPER;
    if (length % 4 == 2) params.rotation = MT_ROTATION_FOUND;
    fuzz_bound(&arena, 0.05);
    mt_status status = mt_union(&of_a, MT_NONZERO, &arena, &a);
    if (status == MT_OK) status = mt_union(&of_b, MT_NONZERO, &arena, &b);
    if (status == MT_OK) status = blend(&a, &b, &params, &arena);
    fuzz_require(is_expected(status));
    mt_arena_release(&arena);
    return 0;
}
