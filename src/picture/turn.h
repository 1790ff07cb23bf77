/* Formula (5) turns B by -q before it is matched; this turns what is drawn of B back by q. */
#pragma once

#include "blend/pair.h"

/* A rotation about a point, grid units. */
typedef struct mt_turn {
    double cosine, sine, x, y;
} mt_turn;

/* From the morph's B to B as its font draws it: about the middle of B's box. */
mt_turn mt_turn_back(const mt_glyph_pair *pair);
void mt_turn_point(const mt_turn *turn, double *x, double *y);
