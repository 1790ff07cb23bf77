/* Contours of lines and curves to components: what an outline encloses. */
#include "fuzz.h"

#include "geometry/layers.h"
#include "geometry/plain.h"

static mt_outline outline_of(const fuzz_places *places, mt_arena *arena) {
    mt_outline outline = {0, mt_arena_new(arena, (size_t)places->count + 1, sizeof *outline.contours)};
    fuzz_require(outline.contours);
    for (int i = 0; i < places->count;) {
        uint8_t flags = fuzz_flags(places, i);
        int degree = 1 + (flags & FUZZ_DEGREE) / 2 % 3;
        if (i + degree > places->count) break;
        if (outline.count == 0 || flags & FUZZ_STARTS) {
            mt_contour *contour = &outline.contours[outline.count++];
            contour->segments = mt_arena_new(arena, (size_t)(places->count - i), sizeof(mt_segment));
            fuzz_require(contour->segments);
        }
        mt_contour *contour = &outline.contours[outline.count - 1];
        mt_segment *segment = &contour->segments[contour->count++];
        segment->degree = degree;
        for (int k = 0; k + 1 < degree; k++) segment->control[k] = fuzz_place(places, i++);
        segment->end = fuzz_place(places, i++);
    }
    return outline;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    fuzz_places places = fuzz_places_of(bytes, length);
    mt_arena arena = {0};
    mt_outline outline = outline_of(&places, &arena);
    mt_shape shape, plain;
    fuzz_bound(&arena, 0.2);
    mt_status status = mt_outline_shape(&outline, 0.5, &arena, &shape);
    if (status == MT_OK) fuzz_require(mt_shape_is_valid(&shape));
    if (status == MT_OK) status = mt_shape_make_plain(&shape, &arena, &plain);
    if (status == MT_OK) fuzz_require(mt_shape_is_valid(&plain));
    fuzz_require(status == MT_OK || status == MT_TOO_LARGE || status == MT_NO_MEMORY);
    mt_arena_release(&arena);
    return 0;
}
