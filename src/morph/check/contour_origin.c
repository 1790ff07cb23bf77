/* The components of both ends that a contour belongs to, and displacements half-way.
 *
 *     displacement(T) = 2 · min(T, 1 − T) · d:     A ●╌╌╌╌╲        d is tried in 8 directions, at 2, 4, 8, 16, 32 and 48/1000 em
 *                                                         ╱ d      the first in this order that helps is the least one
 *                                                  B ●╌╌╌╱
 * Invariant: both ends stay as they are. O(n) for n contours, but for finding components. */
#include "morph/check/contour_origin.h"

#include <math.h>

#include "arithmetic/angles.h"
#include "geometry/inside.h"
#include "geometry/limits.h"

static int origin_of(const mt_side *side, const mt_contour *contour) {
    return mt_component_at(&side->whole, contour->segments[0].end);
}

mt_status mt_contour_origins_of(const mt_morph *morph, mt_arena *arena, mt_contour_origins *origins) {
    size_t count = (size_t)morph->contour_count;
    *origins = (mt_contour_origins){mt_arena_new(arena, count, sizeof(int)),
                                    mt_arena_new(arena, count, sizeof(int))};
    if (!origins->in_a || !origins->in_b) return MT_NO_MEMORY;
    for (int i = 0; i < morph->contour_count; i++) {
        origins->in_a[i] = origin_of(&morph->a, &morph->contours[i].a);
        origins->in_b[i] = origin_of(&morph->b, &morph->contours[i].b);
    }
    return MT_OK;
}

bool mt_same_origin(const mt_contour_origins *origins, int contour, int other) {
    return origins->in_a[contour] == origins->in_a[other] || origins->in_b[contour] == origins->in_b[other];
}

mt_point mt_displacement(int number) {
    static const double distances[] = {2, 4, 8, 16, 32, 48};
    enum { DISTANCES = sizeof distances / sizeof *distances, DIRECTIONS = MT_DISPLACEMENTS / DISTANCES };
    double angle = 2 * M_PI * (number % DIRECTIONS) / DIRECTIONS,
           length = mt_grid_units(distances[number / DIRECTIONS]);
    return (mt_point){(int32_t)lround(length * mt_cos(angle)), (int32_t)lround(length * mt_sin(angle))};
}

void mt_shift_contour(mt_contour_pair *contour, mt_point by) {
    contour->displacement.x += by.x;
    contour->displacement.y += by.y;
}

void mt_shift(const mt_morph *morph, const int *numbers, int number, mt_point by) {
    for (int i = 0; i < morph->contour_count; i++)
        if (numbers[i] == number) mt_shift_contour(&morph->contours[i], by);
}
