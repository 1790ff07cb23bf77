/* Where the contours of a morph come from, and letting some of them stand aside. */
#ifndef MT_HOMES_H
#define MT_HOMES_H

#include "morph/model/morph.h"

/* Of each contour, the component of A as drawn that it is a part of, and the one of B. */
typedef struct mt_homes {
    int *in_a, *in_b;
} mt_homes;

/* MT_NO_MEMORY. */
mt_status mt_homes_of(const mt_morph *morph, mt_arena *arena, mt_homes *homes);

/* Whether two contours are of one component at either end. */
bool mt_share_home(const mt_homes *homes, int contour, int other);

/* The ways to stand aside half-way that are tried, grid units: the least first, 2 … 48/1000 em. More would be seen. */
enum { MT_ASIDE_WAYS = 48 };
mt_point mt_aside_way(int number);

/* Lets a contour stand aside by so much more half-way (mt_masters.aside). */
void mt_shift_contour(mt_masters *contour, mt_point by);

/* The same of all that are numbered so. */
void mt_shift(const mt_morph *morph, const int *numbers, int number, mt_point by);

#endif
