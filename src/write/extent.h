/* How far the glyphs of a font in writing reach, and how much they hold when their references are followed. */
#pragma once

#include "write/font_data.h"

/* How deep references may lead to glyphs that have references. Fonts need two or three. */
enum { MT_GLYF_DEPTH_MAX = 8 };

/* Font units; all zero for a glyph without points. */
typedef struct mt_bounds {
    int x_min, y_min, x_max, y_max;
} mt_bounds;

typedef struct mt_extent {
    mt_bounds bounds;
    int points, contours;
    int depth; /* 0: the glyph has contours of its own, or is blank */
} mt_extent;

/* A box of nothing: its sides lie the other way round. */
extern const mt_bounds mt_no_bounds;
mt_bounds mt_bounds_join(mt_bounds a, mt_bounds b);
mt_bounds mt_bounds_move(mt_bounds bounds, int dx, int dy);
static inline bool mt_bounds_empty(mt_bounds bounds) {
    return bounds.x_min > bounds.x_max;
}

int mt_glyf_point_count(const mt_glyf *glyph); /* of its own */

/* Of one glyph, from those of the glyphs that it refers to, which must be known. MT_TOO_LARGE for what 'glyf' and 'maxp'
 * have no room for. */
mt_status mt_glyf_extent(const mt_glyf *glyph, const mt_extent *extents, mt_extent *extent);

/* Of all glyphs. MT_TOO_LARGE; MT_BAD_PARAMETER where a reference leads to no glyph, deeper than MT_GLYF_DEPTH_MAX or
 * round in a circle. */
mt_status mt_extents_fill(const mt_glyf *glyphs, int count, mt_extent *extents);
