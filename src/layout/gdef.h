/* GDEF with a variation store (OpenType spec, "GDEF header", version 1.3). */
#pragma once

#include "sfnt/sfnt.h"
#include "sfnt/var_store.h"
#include "source/font.h"

/* Puts the store into a GDEF table of version 1.0 or 1.2 without one; into an empty table, which becomes one of nothing
 * else. A store without rows leaves the table as it is. In the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_gdef_vary(mt_bytes plain, const mt_var_store *store, mt_arena *arena, mt_bytes *gdef);
