/* How two glyphs are compared: the weights of the costs when boundaries are aligned, and the places where cuts are looked for. No
 * one set is best for all glyphs. */
#pragma once

#include "morphotype.h"

/* The weights in the cost of pairing two samples (align/cost.h). */
typedef struct mt_cost_weights {
    double direction; /* cost of opposite headings, both in and out */
    double distance;  /* cost of places as far apart as the box is wide or high */
    double corner;    /* cost of a corner that turns right back on a straight place */
} mt_cost_weights;

typedef struct mt_alignment_cache mt_alignment_cache;

/* How two glyphs lie as they are compared (align/registration.h). */
typedef enum mt_placing {
    MT_REGISTERED, /* by the map between them, where that explains enough; else as their boxes lie, scaled onto one another */
    MT_MAPPED,  /* by the map however little it explains */
    MT_LAID,    /* one on the other, not scaled: distances are in the em */
    MT_LEANING, /* as their boxes lie once the slant between both fonts is taken off */
} mt_placing;
enum { MT_PLACINGS = MT_LEANING + 1 };

typedef struct mt_settings {
    mt_placing placing;
    bool fills;                /* white without a counterpart is filled first (geometry/white.h) */
    bool goes_on;              /* strokes go on under the ink beyond a cut (divide/extended_cuts.h) */
    mt_cost_weights align;     /* of two rings (align/align.h) */
    mt_cost_weights match;     /* of a ring with the other side's boundary (divide/ring_matching.h) */
    double step;               /* between neighbouring samples of a boundary at most, 1/1000 em */
    bool jumps;                /* a ring's match may jump over white from one component to another */
    double flatness;           /* grid units: the tolerance that the curves were flattened with */
    mt_alignment_cache *cache; /* alignments found before (align/cache.h); NULL: none are kept */
} mt_settings;

/* The settings that are tried for a glyph, one after the other. The first that apply are best for most. */
int mt_settings_count(void);
mt_settings mt_settings_at(int number, const mt_params *params);
