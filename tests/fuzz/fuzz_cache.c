/* An entry of a cache to a prepared glyph, and to what is between its ends. */
#include "fuzz.h"

#include "cache/prepared.h"
#include "morph/between/instance.h"
#include "morph/between/variable_outline.h"
#include "morph/check/reach.h"

static mt_status draw(const mt_morph *morph, mt_arena *arena) {
    const mt_reach wanted = {-0.5, 1.5};
    mt_params params = mt_params_default();
    mt_reach reach;
    mt_outline outline;
    mt_variable_outline variable;
    mt_status status = mt_morph_outline(morph, mt_weights_at(0.5), &params, arena, &outline);
    if (status == MT_OK) status = mt_morph_reach(morph, wanted, &params, arena, &reach);
    if (status == MT_OK) status = mt_variable_outline_make(morph, &params, arena, &variable);
    return status == MT_OK ? mt_variable_outline_at(morph, &variable, mt_weights_at(0.2), arena, &outline)
                           : status;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    mt_arena arena = {0};
    mt_prepared prepared;
    fuzz_bound(&arena, 0.05);
    mt_status status = mt_prepared_unpack(bytes, length, &arena, &prepared);
    fuzz_require(status == MT_OK || status == MT_BAD_GEOMETRY || status == MT_NO_MEMORY);
    if (status == MT_OK && prepared.status == MT_OK) {
        fuzz_require(mt_morph_is_valid(&prepared.morph));
        (void)draw(&prepared.morph, &arena);
    }
    mt_arena_release(&arena);
    return 0;
}
