/* The components that the contours of a morph belong to, and displacing contours half-way. */
#pragma once

#include "morph/model/morph.h"

/* Of each contour, the component of A, and of B, as drawn that it belongs to. */
typedef struct mt_contour_origins {
    int *in_a, *in_b;
} mt_contour_origins;

/* MT_NO_MEMORY. */
mt_status mt_contour_origins_of(const mt_morph *morph, mt_arena *arena, mt_contour_origins *origins);

/* Whether two contours belong to one component at either end. */
bool mt_same_origin(const mt_contour_origins *origins, int contour, int other);

/* The displacements that are tried, grid units: the shortest first, 2 … 48/1000 em. Longer ones would be seen. */
enum { MT_DISPLACEMENTS = 48 };
mt_point mt_displacement(int number);

/* Adds to a contour's displacement. */
void mt_shift_contour(mt_contour_pair *contour, mt_point by);

/* The same for all contours i with numbers[i] == number. */
void mt_shift(const mt_morph *morph, const int *numbers, int number, mt_point by);
