/* A's GSUB and GDEF for a font of some of its glyphs. */
#pragma once

#include "gsub/gsub.h"
#include "sfnt/sfnt.h"

typedef struct mt_layout_tables {
    mt_bytes gsub, gdef; /* in the arena; empty where there is none */
} mt_layout_tables;

/* Prunes the font's GSUB and GDEF to the `count` glyphs `kept`, ascending, .notdef first, which get the numbers from 0 on.
 * What GDEF says of contour points, of places on axes and of the carets of ligatures is left out. There is no GSUB
 * when the glyphs that it leads to cannot be held apart from the rest. MT_NO_MEMORY. */
mt_status mt_gsub_subset(const mt_font *font, const uint16_t *kept, int count, mt_arena *arena,
                         mt_layout_tables *tables);

/* Adds glyphs behind the `count` ones of these tables, twins of some of them, by ascending numbers from `count` on: they
 * are substituted as these are, except in contexts, and are of their classes. MT_NO_MEMORY. */
mt_status mt_gsub_twins(mt_layout_tables *tables, int count, const mt_twin *twins, int twin_count,
                        mt_arena *arena);
