/* Moving contours: a sink that makes of each glyph, on each step of the row, contours whose points move on straight lines along
 * an axis. */
#pragma once

#include "blend/contours.h"
#include "blend/making.h"
#include "sfnt/stops.h"

/* A glyph between two neighbours: segments that follow one another, from a place of the axis to the next but one. */
typedef struct mt_glyph_track {
    int segment_count; /* 0: the glyph is built from others */
    mt_track_segment *segments;
    mt_glyph_room room_a, room_b;
} mt_glyph_track;

typedef struct mt_outlines {
    mt_stops stops;          /* the fonts on the axis; set before the making */
    mt_glyph_track **tracks; /* of each step, all glyphs */
} mt_outlines;

/* The sink's results are in the making's arenas. Where there is no morph a track has both fonts' own outlines, one after the
 * other; a glyph that stays as it is has one on step 0 alone, for the whole axis. Where the font stands without a setting every track has a place. */
mt_sink mt_outlines_sink(mt_outlines *outlines);

/* Which fonts a place is between; that of a font belongs to the step that ends there. */
mt_between mt_outlines_between(const mt_outlines *outlines, int place);
