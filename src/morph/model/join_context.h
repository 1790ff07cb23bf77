/* The hints, parameters and settings by which two glyphs are joined. */
#ifndef MT_MORPH_MODEL_JOIN_CONTEXT_H
#define MT_MORPH_MODEL_JOIN_CONTEXT_H

#include "morph/model/hints.h"
#include "morph/model/settings.h"

typedef struct mt_join_context {
    const mt_hints *hints; /* not NULL */
    const mt_params *params;
    mt_settings settings;
} mt_join_context;

#endif
