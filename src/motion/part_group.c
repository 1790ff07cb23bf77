#include "motion/part_group.h"

#include <math.h>

#include "geometry/limits.h"

/* Adds the rings of a part, moved. */
static mt_status add_rings(const mt_figure_part *part, mt_point by, mt_arena *arena, mt_rings *all) {
    mt_rings own;
    mt_status status = mt_shape_rings(&part->shape, arena, &own);
    for (int i = 0; i < own.count && status == MT_OK; i++) {
        mt_ring *moved = &all->rings[all->count++];
        status = mt_ring_new(arena, own.rings[i].count, moved);
        for (int k = 0; k < own.rings[i].count && status == MT_OK; k++) {
            mt_point p = own.rings[i].points[k];
            double x = (double)p.x + by.x, y = (double)p.y + by.y;
            if (!(fabs(x) <= MT_COORD_MAX && fabs(y) <= MT_COORD_MAX)) return MT_TOO_LARGE;
            moved->points[k] = (mt_point){(int32_t)x, (int32_t)y};
            moved->marks[k] = own.rings[i].marks[k];
        }
    }
    return status;
}

mt_status mt_group_parts(const mt_figure *figure, int first, int count, mt_arena *arena,
                         mt_figure_part *group) {
    const mt_figure_part *parts = &figure->parts[first];
    size_t rings = 0;
    for (int i = 0; i < count; i++) rings += (size_t)mt_shape_ring_count(&parts[i].shape);
    mt_rings all = {0, mt_arena_new(arena, rings, sizeof *all.rings)};
    mt_figure_part made = {.glyph = MT_SEVERAL_GLYPHS, .place = parts[0].place};
    if (!all.rings) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        double x = parts[i].place.x - made.place.x, y = parts[i].place.y - made.place.y;
        if (!(fabs(x) <= MT_COORD_MAX && fabs(y) <= MT_COORD_MAX)) return MT_TOO_LARGE;
        mt_status status =
            add_rings(&parts[i], (mt_point){(int32_t)lround(x), (int32_t)lround(y)}, arena, &all);
        if (status != MT_OK) return status;
    }
    mt_status status = mt_union(&all, MT_NONZERO, arena, &made.shape);
    if (status == MT_OK) *group = made;
    return status;
}
