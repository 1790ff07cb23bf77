/* A person's decisions for one character: which components go together, and which places on the two boundaries. */
#pragma once

#include "geometry/point.h"

typedef enum mt_hint_kind {
    MT_HINT_COMPONENT, /* the components of A and of B that hold the two places, or lie nearest, go together */
    MT_HINT_POINT,     /* the places on both boundaries that lie nearest go together */
} mt_hint_kind;

typedef struct mt_hint {
    mt_hint_kind kind;
    mt_point a, b; /* grid units, in the two glyphs as they were drawn */
} mt_hint;

/* All hints of one character; { 0, NULL } without any. */
typedef struct mt_hints {
    int count;
    const mt_hint *hints;
} mt_hints;
