/* From outlines on the grid to 'glyf' contours in font units, at one place or at several at once. */
#pragma once

#include "blend/pair.h"

/* Contours over a part of the axis, with their points at each of some places; in between each point moves on a straight line.
 * Before the first place and behind the last they are not there. */
typedef struct mt_track_segment {
    int place_count;
    const int *places; /* as mt_glyph_path has them; ascending */
    int contour_count;
    int *ends;              /* the last point of each contour */
    mt_glyf_point **points; /* at each place */
    bool overlaps;          /* contours may lie over one another, or themselves */
} mt_track_segment;

int mt_track_segment_points(const mt_track_segment *segment);

/* The same contours as they are drawn at `count` places, with as many segments of the same degrees everywhere, in `units` to
 * the em. Outer contours are clockwise; points are on whole units. Left out is what may be left out at every place: contours
 * without an area, and points that repeat the one before or lie midway between two off the curve. `places` is kept. Points
 * belong to `kept`. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_track_segment_make(const mt_outline *drawn, const int *places, int count, int units,
                                mt_arena *kept, mt_arena *scratch, mt_track_segment *segment);

/* An outline's contours as a glyph, which takes no room. As mt_track_segment_make of one place. */
mt_status mt_outline_glyf(const mt_outline *outline, int units, mt_arena *arena, mt_glyf *glyf);

/* Gives the glyph its metrics; vertical ones stop at the end of their range. MT_TOO_LARGE for an advance beyond its range. */
mt_status mt_glyf_take_room(mt_glyph_room room, int units, mt_glyf *glyf);
