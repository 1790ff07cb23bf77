/* How two glyphs are compared: what weighs how much when their boundaries are aligned, and where cuts are looked for. No one manner
 * is best for all glyphs. */
#ifndef MT_MANNER_H
#define MT_MANNER_H

#include "morphotype.h"

/* What it costs that two stops go with each other (align.h). */
typedef struct mt_tariff {
    double direction; /* for headings that are opposite, both in and out */
    double distance;  /* for places as far apart as the box is wide or high */
    double corner;    /* for a corner that turns about one way with one that turns about the other */
} mt_tariff;

typedef struct mt_known mt_known;

typedef struct mt_manner {
    double chord;    /* grid units: within what the curves were flattened */
    mt_tariff align; /* of two rings (align.h) */
    mt_tariff walk;  /* of a ring with the other side's border (walk.h) */
    double step;     /* between the stops of a border at most, 1/1000 em */
    bool leaps;      /* walkers may leap over white */
    mt_known *known; /* alignments that were found before (known.h); NULL: none are kept */
} mt_manner;

/* The manners that are tried for a glyph, one after the other. The first, 0, is best for most. */
int mt_manner_count(void);
mt_manner mt_manner_at(int number, const mt_params *params);

#endif
