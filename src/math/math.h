/* MATH of a blend: what setting formulas needs of two fonts or more (OpenType spec, "MATH").
 *
 * What there is is the first font's: its constants, its corrections and its glyphs that grow. Each value is mixed with those of the
 * other fonts that have it too; where one has not, the first font's stands for it, in the new font's units. Measures and accents
 * move with the outlines then. */
#pragma once

#include "glyphset/places.h"

typedef struct mt_math mt_math;

/* Reads the tables of all fonts for the new font's glyphs. `units` is the new font's per em. The result belongs to the arena and
 * needs the fonts and the glyphs no more; it is NULL where the first font has no table, or a damaged one. Not for two threads at
 * once. MT_NO_MEMORY. */
mt_status mt_math_prepare(mt_font *const *fonts, const mt_font_glyphs *glyphs, int units, mt_arena *arena,
                          mt_math **math);

/* The table at these places. What it has no VariationIndex tables for, measures and percentages, is as at the first place. Where
 * its offsets would not do, the table is of what the first font has, and does not vary; no bytes where they would not do even so,
 * or `math` is NULL. In the arena. MT_NO_MEMORY. */
mt_status mt_math_write(const mt_math *math, const mt_places *places, mt_arena *arena, mt_bytes *table);
