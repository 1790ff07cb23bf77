/* Maps from what users set on the axis to how far the font has got. */
#include "sfnt/axis_map.h"

#include <math.h>

#include "base/memory.h"
#include "sfnt/axis.h"

/* ---- making ---------------------------------------------------------------------------------------------- */

/* Whether a point may follow another. */
static bool follows(mt_map_point before, mt_map_point point) {
    bool within = point.value > before.value && point.value <= MT_AXIS_END && point.place <= MT_AXIS_END;
    return within && mt_axis_place(point.value) > mt_axis_place(before.value) && point.place >= before.place;
}

static bool is_at(mt_map_point point, double end) {
    return point.value == end && point.place == end;
}

mt_status mt_axis_map_make(const double *values, const double *places, int count, mt_axis_map *map) {
    const mt_map_point end = {MT_AXIS_END, MT_AXIS_END};
    mt_axis_map made = {0};
    if (count < 0 || count > MT_PLACE_ONE + 1) return MT_BAD_PARAMETER;
    made.points = mt_new((size_t)count + 2, sizeof *made.points);
    if (!made.points) return MT_NO_MEMORY;
    bool good = true;
    made.count = 1; /* 0, 0 */
    for (int i = 0; i < count && good; i++) {
        mt_map_point point = {values[i], places[i]};
        if ((i == 0 && is_at(point, 0)) || (i == count - 1 && is_at(point, MT_AXIS_END))) continue;
        good = follows(made.points[made.count - 1], point);
        made.points[made.count++] = point;
    }
    if (!good || !follows(made.points[made.count - 1], end)) {
        mt_axis_map_free(&made);
        return MT_BAD_PARAMETER;
    }
    made.points[made.count++] = end;
    *map = made;
    return MT_OK;
}

void mt_axis_map_free(mt_axis_map *map) {
    mt_free(map->points);
    *map = (mt_axis_map){0};
}

/* ---- going by it ----------------------------------------------------------------------------------------- */

static double between(double x, double from, double to, double at_from, double at_to) {
    return at_from + (x - from) / (to - from) * (at_to - at_from);
}

double mt_axis_map_place(const mt_axis_map *map, double value) {
    const mt_map_point *p = map->points;
    int i = 0;
    if (map->count == 0) return value;
    while (i + 1 < map->count && p[i].value < value) i++;
    if (p[i].value <= value) return p[i].place;
    return between(value, p[i - 1].value, p[i].value, p[i - 1].place, p[i].place);
}

double mt_axis_map_value(const mt_axis_map *map, int place) {
    const mt_map_point *p = map->points;
    int i = 0;
    if (map->count == 0) return mt_axis_value(place);
    while (i + 1 < map->count && mt_axis_place(p[i].place) < place) i++;
    int from = mt_axis_place(p[i].value), to = mt_axis_place(p[i].place);
    if (to <= place) return fmin(p[i].value, mt_axis_value(from));
    double at = between(place, mt_axis_place(p[i - 1].place), to, mt_axis_place(p[i - 1].value), from);
    return mt_axis_value((int)floor(at));
}
