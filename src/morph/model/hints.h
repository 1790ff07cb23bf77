/* What a person has decided for one character: which component goes with which, and which place on the boundary with which. */
#ifndef MT_MORPH_MODEL_HINTS_H
#define MT_MORPH_MODEL_HINTS_H

#include "geometry/point.h"

typedef enum mt_hint_kind {
    MT_HINT_COMPONENT, /* the component of A that a place is in, or nearest to, goes with that of B */
    MT_HINT_POINT,     /* the place on A's boundary that is nearest goes with the one on B's */
} mt_hint_kind;

typedef struct mt_hint {
    mt_hint_kind kind;
    mt_point a, b; /* grid units, in the two glyphs as they were drawn */
} mt_hint;

/* Those of one character; none is { 0, NULL }. */
typedef struct mt_hints {
    int count;
    const mt_hint *hints;
} mt_hints;

#endif
