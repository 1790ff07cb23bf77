/* How two glyphs are compared: what weighs how much when their boundaries are aligned, and where cuts are looked for. No one set
 * is best for all glyphs. */
#ifndef MT_MORPH_MODEL_SETTINGS_H
#define MT_MORPH_MODEL_SETTINGS_H

#include "morphotype.h"

/* What it costs that two samples go with each other (align.h). */
typedef struct mt_cost_weights {
    double direction; /* for headings that are opposite, both in and out */
    double distance;  /* for places as far apart as the box is wide or high */
    double corner;    /* for a corner that turns about one way with one that turns about the other */
} mt_cost_weights;

typedef struct mt_alignment_cache mt_alignment_cache;

typedef struct mt_settings {
    double flatness;           /* grid units: within what the curves were flattened */
    mt_cost_weights align;     /* of two rings (align.h) */
    mt_cost_weights walk;      /* of a ring with the other side's boundary (walk.h) */
    double step;               /* between the samples of a boundary at most, 1/1000 em */
    bool jumps;                /* walkers may jump over white */
    mt_alignment_cache *known; /* alignments that were found before (known.h); NULL: none are kept */
} mt_settings;

/* The settings that are tried for a glyph, one after the other. The first, 0, is best for most. */
int mt_settings_count(void);
mt_settings mt_settings_at(int number, const mt_params *params);

#endif
