#include "morph/check/contour_origin.h"

#include <math.h>

#include "geometry/inside.h"
#include "geometry/limits.h"

static int home_of(const mt_side *side, const mt_contour *contour) {
    return mt_component_at(&side->whole, contour->segments[0].end);
}

mt_status mt_homes_of(const mt_morph *morph, mt_arena *arena, mt_homes *homes) {
    size_t count = (size_t)morph->contour_count;
    *homes = (mt_homes){mt_arena_new(arena, count, sizeof(int)), mt_arena_new(arena, count, sizeof(int))};
    if (!homes->in_a || !homes->in_b) return MT_NO_MEMORY;
    for (int i = 0; i < morph->contour_count; i++) {
        homes->in_a[i] = home_of(&morph->a, &morph->contours[i].a);
        homes->in_b[i] = home_of(&morph->b, &morph->contours[i].b);
    }
    return MT_OK;
}

bool mt_share_home(const mt_homes *homes, int contour, int other) {
    return homes->in_a[contour] == homes->in_a[other] || homes->in_b[contour] == homes->in_b[other];
}

mt_point mt_aside_way(int number) {
    static const double distances[] = {2, 4, 8, 16, 32, 48};
    enum { DISTANCES = sizeof distances / sizeof *distances, DIRECTIONS = MT_ASIDE_WAYS / DISTANCES };
    double angle = 2 * M_PI * (number % DIRECTIONS) / DIRECTIONS,
           length = mt_grid_units(distances[number / DIRECTIONS]);
    return (mt_point){(int32_t)lround(length * cos(angle)), (int32_t)lround(length * sin(angle))};
}

void mt_shift_contour(mt_masters *contour, mt_point by) {
    contour->aside.x += by.x;
    contour->aside.y += by.y;
}

void mt_shift(const mt_morph *morph, const int *numbers, int number, mt_point by) {
    for (int i = 0; i < morph->contour_count; i++)
        if (numbers[i] == number) mt_shift_contour(&morph->contours[i], by);
}
