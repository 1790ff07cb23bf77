/* Which lookups the contexts of a layout table call (OpenType spec, "Sequence context" and "Chained sequence context"). */
#pragma once

#include "layout/ot.h"

struct mt_layout;

/* The calls of lookup i are those from first[i] up to first[i + 1], ascending, each once. */
typedef struct mt_calls {
    int *first; /* one more than there are lookups; NULL without lookups */
    uint16_t *lookups;
} mt_calls;

/* Reads the calls of all of the table's contexts. MT_NO_MEMORY; MT_ENDLESS_LOOKUPS where they go in a circle, or deeper than
 * HarfBuzz follows them. */
mt_status mt_calls_read(const struct mt_layout *layout, mt_arena *arena, mt_calls *calls);

/* Marks the lookups that a lookup calls, and those that they call, and so on; `marked` has one for each lookup. */
void mt_calls_mark(const mt_calls *calls, int lookup, bool *marked);
