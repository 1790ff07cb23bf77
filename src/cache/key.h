/* What an entry of the cache is found by: a digest of all that the preparing of two glyphs depends on. */
#pragma once

#include "cache/sha256.h"
#include "geometry/outline.h"
#include "morph/model/hints.h"

/* Of two outlines as they are read, the hints for them and the parameters, of which `lean` is the one between these two fonts; and of the
 * engine (cache/engine.h). Parameters that the morph does not depend on do not count: threads. MT_NO_MEMORY. */
mt_status mt_cache_key(const mt_outline outlines[2], const mt_hints *hints, const mt_params *params,
                       mt_digest *key);
