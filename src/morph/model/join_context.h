/* What two glyphs are joined by. */
#ifndef MT_TERMS_H
#define MT_TERMS_H

#include "morph/model/hints.h"
#include "morph/model/settings.h"

typedef struct mt_terms {
    const mt_hints *hints; /* not NULL */
    const mt_params *params;
    mt_manner manner;
} mt_terms;

#endif
