/* GPOS and GSUB opened. */
#pragma once

#include "layout/layout.h"

/* An empty or malformed table, or one with thousands of systems or lookups, has none at all. `extension` is the type of
 * the table's extension lookups. MT_NO_MEMORY, MT_ENDLESS_LOOKUPS. */
mt_status mt_layout_open(mt_bytes table, int extension, mt_arena *arena, mt_layout *layout);
