#include "morph/model/settings.h"

#include "geometry/limits.h"

/* Columns: flatness (set below); direction, distance and corner of an alignment, and of a ring match; the step; jumps; the cache.
 * The first settings weigh the distance of a ring match more than most, since a match can choose among all rings. The more an
 * alignment weighs the distance, the less it distinguishes corners from sides: strokes keep clear of each other, and are drawn
 * worse. Those settings come last. */
static const mt_settings settings[] = {
    {0, {3, 4, 2}, {1, 4, 0}, 12, true, NULL},    {0, {3, 4, 2}, {1, 1, 0}, 12, false, NULL},
    {0, {3, 4, 2}, {1, 12, 0}, 20, false, NULL},  {0, {3, 16, 2}, {1, 1, 0}, 20, false, NULL},
    {0, {3, 4, 2}, {1, 1, 0}, 20, true, NULL},    {0, {3, 4, 2}, {1, 12, 0}, 12, true, NULL},
    {0, {3, 16, 2}, {1, 12, 0}, 20, false, NULL}, {0, {3, 16, 2}, {1, 1, 0}, 20, true, NULL},
    {0, {3, 16, 2}, {1, 4, 0}, 12, true, NULL},   {0, {3, 32, 2}, {1, 1, 0}, 20, false, NULL},
    {0, {3, 32, 2}, {1, 4, 0}, 12, true, NULL},   {0, {3, 2, 2}, {1, 1, 0}, 20, true, NULL},
    {0, {3, 4, 2}, {1, 4, 0}, 30, true, NULL},    {0, {3, 64, 2}, {1, 1, 0}, 20, false, NULL},
};

int mt_settings_count(void) {
    return (int)(sizeof settings / sizeof *settings);
}

mt_settings mt_settings_at(int number, const mt_params *params) {
    mt_settings made = settings[number];
    made.flatness = mt_grid_units(params->tolerance);
    return made;
}
