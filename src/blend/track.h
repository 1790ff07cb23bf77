/* A glyph over a part of the axis: contours whose points move on straight lines from place to place. */
#ifndef MT_BLEND_TRACK_H
#define MT_BLEND_TRACK_H

#include "source/font.h"
#include "write/font_data.h"

/* Contours as 'glyf' has them, with their points at each of some places. Before the first place and behind the last they are
 * not there. */
typedef struct mt_span {
    int place_count;   /* at least 2 */
    const int *places; /* as mt_glyph_moves has them; ascending */
    int contour_count;
    int *ends;              /* the last point of each contour */
    mt_glyf_point **points; /* at each place */
    bool overlaps;          /* contours may lie over one another, or themselves */
} mt_span;

/* A glyph between two neighbouring fonts: spans that follow one another, from a place to the next but one. */
typedef struct mt_passage {
    int span_count; /* 0: the glyph is built from others */
    mt_span *spans;
    double advance_a, advance_b; /* grid units */
    mt_vertical vertical_a, vertical_b;
} mt_passage;

/* The span of the same contours as they are drawn at `count` places, with as many segments of the same degrees everywhere, in
 * `units` to the em. Outer contours are clockwise; points are on whole units. What would be left out of a contour or of an
 * outline by itself, such as an implied point, is left out here where it would be at every place. `places` is kept.
 * Points belong to `kept`. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_span_make(const mt_outline *drawn, const int *places, int count, int units, mt_arena *kept,
                       mt_arena *scratch, mt_span *span);

int mt_span_point_count(const mt_span *span);

#endif
