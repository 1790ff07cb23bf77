/* An SVG drawing to its layers, and to one shape of them. */
#include "fuzz.h"

#include "drawing/svg_drawing.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    mt_svg_drawing drawing;
    mt_shape shape;
    const char *problem = NULL;
    mt_arena arena = {0};
    fuzz_bound(&arena, 0.1);
    mt_status status = mt_svg_read(bytes, length, &arena, &drawing, &problem);
    fuzz_require(status != MT_BAD_DRAWING || problem);
    if (status == MT_OK) status = mt_layers_shape(&drawing.layers, 0.5, &arena, &shape);
    if (status == MT_OK) fuzz_require(mt_shape_is_valid(&shape));
    mt_arena_release(&arena);
    return 0;
}
