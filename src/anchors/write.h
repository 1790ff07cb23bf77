/* Anchors, static or varying, as GPOS lookups. */
#pragma once

#include "anchors/anchor.h"

/* Adds the lookups at these places to GPOS in the making. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_anchors_write(const mt_anchors *anchors, const mt_places *places, mt_arena *arena,
                           mt_lookup_builders *made);
