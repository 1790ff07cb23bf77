#include "morph/model/settings.h"

#include "geometry/limits.h"

/* Columns: placing; whether white is filled; whether strokes go on beyond cuts; direction, distance and corner of an alignment, and of a
 * ring match; the step; jumps. The first settings weigh the distance of a ring match more than most, since a match can choose among all
 * rings. The more an alignment weighs the distance, the less it distinguishes corners from sides: strokes keep clear of each other, and
 * are drawn worse. Where white has no counterpart, to fill it comes first. Strokes that go on beyond cuts can meet on the way where
 * others are still apart, so that later settings end them there. Each row was taken because it gave other morphs than those before it,
 * and better ones for some glyphs (docs/joining.md). */
static const mt_settings settings[] = {
    {MT_REGISTERED, true, true, {3, 4, 2}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_REGISTERED, false, true, {3, 4, 2}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_REGISTERED, false, false, {3, 4, 2}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_LAID, false, false, {3, 4, 2}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_LAID, true, false, {3, 4, 2}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_REGISTERED, false, false, {3, 32, 2}, {1, 1, 0}, 20, false, 0, NULL},
    {MT_MAPPED, false, false, {3, 4, 2}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_LEANING, false, false, {3, 1, 3}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_REGISTERED, false, false, {0.2, 8, 0}, {1, 12, 0}, 20, false, 0, NULL},
    {MT_REGISTERED, false, false, {3, 1, 3}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_REGISTERED, true, false, {3, 1, 3}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_LEANING, false, false, {3, 4, 2}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_REGISTERED, false, false, {6, 4, 0}, {1, 4, 0}, 12, true, 0, NULL},
    {MT_LAID, false, false, {3, 4, 2}, {1, 12, 0}, 20, false, 0, NULL},
    {MT_REGISTERED, false, false, {3, 4, 2}, {1, 12, 0}, 20, false, 0, NULL},
    {MT_REGISTERED, false, false, {3, 16, 2}, {1, 1, 0}, 20, false, 0, NULL},
    {MT_REGISTERED, false, false, {3, 4, 2}, {1, 12, 0}, 12, true, 0, NULL},
};

int mt_settings_count(void) {
    return (int)(sizeof settings / sizeof *settings);
}

mt_settings mt_settings_at(int number, const mt_params *params) {
    mt_settings made = settings[number];
    made.flatness = mt_grid_units(params->tolerance);
    return made;
}
