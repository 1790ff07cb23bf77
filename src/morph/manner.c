#include "morph/manner.h"

#include "geometry/limits.h"

/* A walker minds the distance more than one who only aligns, since it has the choice of all rings. */
static const mt_manner manners[] = {
    {.align = {3, 4, 1}, .walk = {1, 4, 0}, .step = 12, .leaps = true},
    {.align = {3, 16, 1}, .walk = {1, 4, 0}, .step = 12, .leaps = true},
    {.align = {3, 4, 1}, .walk = {1, 1, 0}, .step = 12, .leaps = true},
    {.align = {3, 4, 1}, .walk = {1, 12, 0}, .step = 12, .leaps = true},
    {.align = {3, 4, 1}, .walk = {1, 4, 0}, .step = 12, .leaps = false},
    {.align = {3, 4, 1}, .walk = {1, 4, 0}, .step = 20, .leaps = true},
    {.align = {3, 2, 1}, .walk = {1, 4, 0}, .step = 12, .leaps = true},
};

int mt_manner_count(void) {
    return (int)(sizeof manners / sizeof *manners);
}

mt_manner mt_manner_at(int number, const mt_params *params) {
    mt_manner made = manners[number];
    made.chord = mt_grid_units(params->tolerance);
    return made;
}
