/* Fonts at single places between two fonts. */
#pragma once

#include "blend/making.h"

/* Makes fonts at `count` places and hands them to `ready`, in the order of t. MT_BAD_PARAMETER, MT_NOTHING_SHARED,
 * MT_NO_MEMORY, MT_TOO_LARGE, and what `ready` gives. */
mt_status mt_blend_make(mt_blend *blend, const double *t, int count, mt_font_ready ready, void *user);
