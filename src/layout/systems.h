/* The language systems of the new font. */
#pragma once

#include "layout/lookup_builder.h"
#include "sfnt/var_store.h"

/* What text of one script and language is set by: in the new font, and in each of its sources. */
typedef struct mt_shared_system {
    uint32_t script, language;
    int own[MT_STOPS_MAX]; /* indices of the fonts' own systems; -1 where a font has none for such text */
    uint32_t required; /* the tag of the feature that the first font's system requires; 0 where it does not */
} mt_shared_system;

/* The first font's own systems come first, in its order and number. */
typedef struct mt_systems {
    int count;
    mt_shared_system *list;
} mt_systems;

/* All systems of the first font's GPOS; then those of each other that are not there yet and whose pair adjustment is
 * another than that of the system that would stand for it; DFLT, latn, cyrl and grek where no font has any.
 * MT_NO_MEMORY. */
mt_status mt_systems_make(const mt_layout *const *layouts, int font_count, mt_arena *arena,
                          mt_systems *systems);

/* A lookup that belongs to systems of the first font belongs to those of others for which these stand too.
 * MT_NO_MEMORY. */
mt_status mt_systems_spread(const mt_systems *systems, mt_arena *arena, mt_lookup_builder *lookup);

/* The lookups of a type in a system's features of a tag, ascending, each once, `room` at most; returns how many. None
 * for system -1. */
int mt_system_lookups(const mt_layout *layout, int system, uint32_t tag, int type, int *lookups, int room);
/* Whether the system has a feature of that tag, whatever is in it. */
bool mt_system_has_feature(const mt_layout *layout, int system, uint32_t tag);

/* A lookup that contexts call, whatever features it is in. */
typedef struct mt_called_lookup {
    int font; /* whose contexts call it */
    int type;
    int called_as; /* lookup_builder.h */
    int in_fonts
        [MT_STOPS_MAX]; /* the font's lookup, and each other font's that goes with it; -1 where there is none */
    int member_count;
    const mt_member *members; /* where the contexts belong; of mt_systems */
} mt_called_lookup;

enum { MT_SYSTEM_LOOKUPS_MAX = 256 }; /* of one type in one feature */
