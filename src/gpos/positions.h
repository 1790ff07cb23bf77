/* The positions of a blend: kerning, single adjustments and anchors of two fonts or more, written as GPOS.
 *
 * Everything is read once into a structure that holds all fonts' values, in the new font's units; it is mixed and
 * rounded when a font is written. A static font is written for one place on the way through the fonts; a varying one has
 * the fonts as stops along its axis (font/var_store.h), the first of them being the default. */
#pragma once

#include "glyphset/places.h"
#include "layout/lookup_builder.h"
#include "sfnt/sfnt.h"

typedef struct mt_positions mt_positions;

/* Reads the layout of 2 … MT_STOPS_MAX fonts for the new font's glyphs. `units` is the new font's per em. The result
 * belongs to the arena and needs the fonts and the glyphs no more. Not for two threads at once. MT_NO_MEMORY. */
mt_status mt_positions_prepare(mt_font *const *fonts, const mt_font_glyphs *glyphs, int units,
                               mt_arena *arena, mt_positions **positions);

/* The GPOS table of the font at a place: 0 is the first font, 1 the second, and so on. In the arena; no bytes where there is
 * nothing to position. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_positions_write(const mt_positions *positions, mt_font_at at, mt_arena *arena, mt_bytes *gpos);

/* The GPOS table of the varying font; the store, which GDEF is to have (layout/gdef.h), takes what varies. In the arena.
 * MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_positions_write_varying(const mt_positions *positions, mt_var_store *store, mt_arena *arena,
                                     mt_bytes *gpos);
