/* Single adjustment of two fonts (OpenType spec, GPOS lookup type 1): palt, halt, cpsp and their like.
 *
 * Where B has the feature too, a glyph's value lies between both fonts' (0 where one leaves the glyph as it is); where
 * B has not, or has no such glyph, it is A's, scaled to the new units. */
#ifndef MT_SINGLES_H
#define MT_SINGLES_H

#include "font/charset.h"
#include "layout/layout.h"
#include "layout/made.h"
#include "layout/value.h"

/* The single adjustment of one font in some lookups. */
typedef struct mt_single_source {
    const mt_layout *layout;
    const mt_variations *variations;
    double scale;
    int count;
    const int *lookups;
} mt_single_source;

typedef struct mt_single {
    uint16_t glyph;
    double ends[2][MT_VALUE_PARTS];
} mt_single;

typedef struct mt_singles {
    int count;
    mt_single *list; /* ascending by glyph */
} mt_singles;

/* MT_NO_MEMORY; MT_TOO_LARGE for lookups that no font has so many subtables in. */
mt_status mt_singles_prepare(const mt_single_source *a, const mt_single_source *b, const mt_charset *charset,
                             mt_arena *arena, mt_singles *singles);

/* Subtables at t: SinglePosFormat1 for each value that many glyphs share, SinglePosFormat2 for the rest. In the arena.
 * MT_NO_MEMORY. */
mt_status mt_singles_write(const mt_singles *singles, double t, mt_arena *arena, mt_bytes **subtables,
                           int *count);

#endif
