/* Which points of a glyph have to be told how they move: the others' moves are inferred from theirs ('gvar', "Inferred
 * deltas for un-referenced point numbers"). */
#pragma once

#include "base/memory.h"
#include "write/font_data.h"

/* By how far a point moves, font units. */
typedef struct mt_move {
    int16_t x, y;
} mt_move;

/* Sets told[i] for as few points of the glyph's contours as it finds to suffice: every other point's inferred move is within
 * `tolerance` font units of its own, in x and in y. Those of a contour without any stay where they are. There is one `told`
 * and one move for each point. MT_NO_MEMORY. */
mt_status mt_iup_choose(const mt_glyf *glyph, const mt_move *moves, double tolerance, mt_arena *arena,
                        bool *told);
