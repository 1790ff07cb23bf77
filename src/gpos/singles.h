/* Single adjustment of fonts (OpenType spec, GPOS lookup type 1): palt, halt, cpsp and their like.
 *
 * Where another font has the feature too, a glyph's value there is its own (0 where it leaves the glyph as it is); where
 * it has not, or has no such glyph, it is the first font's, scaled to the new units. */
#pragma once

#include "glyphset/places.h"
#include "layout/layout.h"
#include "layout/lookup_builder.h"
#include "layout/value.h"
#include "sfnt/sfnt.h"

/* The single adjustment of one font in some lookups. */
typedef struct mt_single_source {
    const mt_layout *layout;
    const mt_gdef_deltas *variations;
    double scale;
    int count;
    const int *lookups;
} mt_single_source;

typedef struct mt_single {
    uint16_t glyph;
    double (*in_fonts)[MT_VALUE_PARTS]; /* one a font */
} mt_single;

typedef struct mt_singles {
    int count;
    mt_single *list; /* ascending by glyph */
} mt_singles;

/* Of lookups that contexts call, the font whose contexts do: only what it adjusts is adjusted, and a font that has nothing for it
 * leaves its glyph as it is. */
enum { MT_NO_CALLER = -1 };

/* From one source a font. MT_NO_MEMORY; MT_TOO_LARGE for lookups that no font has so many subtables in. */
mt_status mt_singles_prepare(const mt_single_source *sources, int caller, const mt_font_glyphs *glyphs,
                             mt_arena *arena, mt_singles *singles);

/* Subtables at these places: SinglePosFormat1 for each value that many glyphs share, SinglePosFormat2 for the rest. In
 * the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_singles_write(const mt_singles *singles, const mt_places *places, mt_arena *arena,
                           mt_bytes **subtables, int *count);
