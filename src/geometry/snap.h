/* Rings that are rounded until their edges meet at their ends alone (J. Hobby, "Practical segment intersection with finite precision
 * output", 1999). */
#pragma once

#include "geometry/ring.h"

/* Cuts the edges of rings where they cross and where they pass points and crossings of others, so that after rounding no edge crosses
 * another and none runs through a point: two edges have no place in common but their ends, or all of it. No point of `rings` moves; no
 * place of an edge by more than a grid unit on either axis. Points that are added have the mark MT_CROSSING; repeated ones are
 * left out, and so are rings of a single place. Coordinates within MT_COORD_MAX. MT_NO_MEMORY, MT_TOO_LARGE. O(n log n) where edges are
 * short, O(n²) at the worst. */
mt_status mt_snap_rings(const mt_rings *rings, mt_arena *arena, mt_rings *snapped);
