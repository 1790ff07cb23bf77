/* The hints, parameters and settings by which two glyphs are joined. */
#pragma once

#include "geometry/white.h"
#include "morph/model/hints.h"
#include "morph/model/settings.h"

typedef struct mt_join_context {
    const mt_hints *hints; /* not NULL */
    const mt_params *params;
    mt_settings settings;
    const mt_white *white; /* A's and B's, both filled, and opened again; NULL: none */
} mt_join_context;
