/* GPOS put together (OpenType spec, "GPOS" and "Layout tables", version 1.0). */
#pragma once

#include "layout/systems.h"
#include "sfnt/sfnt.h"

/* Writes the table of all lookups that have members and subtables; no bytes where there is none. Lookups go by extension
 * where 16-bit offsets would not reach. In the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_gpos_write(const mt_systems *systems, const mt_lookup_builders *made, mt_arena *arena,
                        mt_bytes *gpos);

/* ---- its three lists, each written into a table of its own; MT_NO_MEMORY, MT_TOO_LARGE ------------------- */

/* A feature of a language system: its lookups, ascending. */
typedef struct mt_gpos_feature {
    int system;
    uint32_t tag;
    int count;
    const int *lookups;
    int index; /* in the FeatureList: features with the same tag and lookups share one */
} mt_gpos_feature;

/* `features` ascending by index; numbers them. */
mt_status mt_gpos_features(const mt_lookup_builders *lookups, mt_arena *arena, mt_gpos_feature **features,
                           int *count);
mt_status mt_gpos_feature_list(const mt_gpos_feature *features, int count, mt_table *table);
mt_status mt_gpos_script_list(const mt_systems *systems, const mt_gpos_feature *features, int count,
                              mt_arena *scratch, mt_table *table);
mt_status mt_gpos_lookup_list(const mt_lookup_builders *lookups, mt_table *table);
