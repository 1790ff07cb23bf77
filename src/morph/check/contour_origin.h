/* Where the contours of a morph come from, and letting some of them stand aside. */
#ifndef MT_MORPH_CHECK_CONTOUR_ORIGIN_H
#define MT_MORPH_CHECK_CONTOUR_ORIGIN_H

#include "morph/model/morph.h"

/* Of each contour, the component of A as drawn that it is a part of, and the one of B. */
typedef struct mt_contour_origins {
    int *in_a, *in_b;
} mt_contour_origins;

/* MT_NO_MEMORY. */
mt_status mt_contour_origins_of(const mt_morph *morph, mt_arena *arena, mt_contour_origins *origins);

/* Whether two contours are of one component at either end. */
bool mt_same_origin(const mt_contour_origins *origins, int contour, int other);

/* The ways to stand aside half-way that are tried, grid units: the least first, 2 … 48/1000 em. More would be seen. */
enum { MT_DISPLACEMENTS = 48 };
mt_point mt_displacement(int number);

/* Lets a contour stand aside by so much more half-way (mt_contour_pair.displacement). */
void mt_shift_contour(mt_contour_pair *contour, mt_point by);

/* The same of all that are numbered so. */
void mt_shift(const mt_morph *morph, const int *numbers, int number, mt_point by);

#endif
