/* The positions of a blend: kerning, single adjustments and anchors of two fonts, mixed and written as GPOS.
 *
 * Everything is read once into a structure that holds both fonts' values, in the new font's units; it is mixed and
 * rounded when a font at t is written. */
#ifndef MT_POSITIONS_H
#define MT_POSITIONS_H

#include "font/charset.h"
#include "layout/made.h"

typedef struct mt_positions mt_positions;

/* Reads the layout of both fonts for the glyphs of the charset, which are then the new font's in that order. `units`
 * is the new font's per em. The result belongs to the arena and needs the fonts and the charset no more.
 * Not for two threads at once. MT_NO_MEMORY. */
mt_status mt_positions_prepare(mt_font *a, mt_font *b, const mt_charset *charset, int units, mt_arena *arena,
                               mt_positions **positions);

/* The GPOS table of the font at t (0 … 1), in the arena; no bytes where there is nothing to position. MT_NO_MEMORY,
 * MT_TOO_LARGE. */
mt_status mt_positions_write(const mt_positions *positions, double t, mt_arena *arena, mt_bytes *gpos);

#endif
