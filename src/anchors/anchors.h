/* The anchors of all fonts, lookup by lookup of A's. */
#pragma once

#include "anchors/anchor.h"

/* Reads the anchors of all fonts, one source each, for their glyphs, in `units` per em; of `calls` those that have
 * anchors. Malformed subtables are
 * left out; so is what comes after more work than any font needs (MT_ANCHOR_STEPS_MAX). MT_NO_MEMORY. */
mt_status mt_anchors_prepare(const mt_anchor_source *sources, const mt_systems *systems,
                             const mt_called_lookup *calls, int call_count, const mt_font_glyphs *glyphs,
                             int units, mt_arena *arena, mt_anchors *anchors);
