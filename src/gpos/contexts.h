/* The fonts' contexts, and the lookups that they call. */
#pragma once

#include "gpos/context.h"
#include "layout/systems.h"

/* The lookups that are called, contexts left out. */
typedef struct mt_called_lookups {
    int count;
    mt_called_lookup *list;
} mt_called_lookups;

/* Reads the contexts of the first font's features, and those that they call. Another font's lookup goes with one that is
 * called when contexts of the same feature call it, it is of the same type, and it is for some of the same glyphs: of
 * several the one in the same place of their list, where the lists are as long, else the one for the most of them.
 * Then those of each other font's features in which the first has none. MT_NO_MEMORY. */
mt_status mt_contexts_prepare(const mt_layout *const *layouts, const mt_systems *systems,
                              const mt_font_glyphs *glyphs, mt_arena *arena, mt_contexts *contexts,
                              mt_called_lookups *called);

/* The head of a lookup of a font's that is a context or that contexts call. */
mt_lookup_builder mt_context_head(const mt_layout *layout, int font, int lookup);
