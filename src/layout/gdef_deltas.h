/* What a variable font adds to a position at its place on the axes (OpenType spec, "Item variation stores"): GDEF's
 * store, which HarfBuzz 6 cannot instance. */
#pragma once

#include "base/memory.h"
#include "layout/ot.h"
#include "sfnt/sfnt.h"

typedef struct mt_gdef_deltas {
    mt_bytes store;
    int region_count;
    double *scalars; /* of each region, at the font's place */
} mt_gdef_deltas;    /* all zero is a font that does not vary */

/* The store of the GDEF table, at the normalized place (mt_font_place). MT_NO_MEMORY. */
mt_status mt_gdef_deltas_open(mt_bytes gdef, const int32_t *place, int axis_count, mt_arena *arena,
                              mt_gdef_deltas *variations);

/* What a Device table or VariationIndex table adds, in font units; 0 for a Device table proper, which is for pixel
 * sizes, and for an empty or malformed table. */
double mt_gdef_delta(const mt_gdef_deltas *variations, mt_bytes device);
