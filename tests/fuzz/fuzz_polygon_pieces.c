/* Any polygons to convex pieces: a union's components, made plain, can always be cut. */
#include "fuzz.h"

#include "geometry/decompose.h"
#include "geometry/plain.h"
#include "geometry/union.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    fuzz_places places = fuzz_places_of(bytes, length);
    mt_arena arena = {0};
    mt_rings rings = fuzz_rings(&places, 0, 0, &arena);
    mt_shape shape = {0};
    mt_status status = mt_union(&rings, (mt_rule)(length % 3), &arena, &shape);
    if (status == MT_OK) status = mt_shape_make_plain(&shape, &arena, &shape);
    fuzz_require(status == MT_OK);
    for (int k = 0; k < shape.count; k++) {
        mt_pieces pieces;
        fuzz_require(mt_component_is_valid(&shape.components[k]));
        fuzz_require(mt_decompose(&shape.components[k], &arena, &pieces) == MT_OK);
    }
    mt_arena_release(&arena);
    return 0;
}
