/* Which lookups the contexts of a layout table call (OpenType spec, "Sequence context" and "Chained sequence context"). */
#pragma once

#include "layout/layout.h"

/* Reads the calls of all of the table's contexts. MT_NO_MEMORY; MT_ENDLESS_LOOKUPS where they go in a circle, or deeper than
 * HarfBuzz follows them. */
mt_status mt_calls_read(const mt_layout *layout, mt_arena *arena, mt_calls *calls);

/* Marks the lookups that a lookup calls, and those that they call, and so on; `marked` has one for each lookup. */
void mt_calls_mark(const mt_calls *calls, int lookup, bool *marked);
