/* Point numbers and deltas as 'gvar' packs them (OpenType spec, "Tuple variation store": packed point numbers, packed
 * deltas). */
#pragma once

#include "sfnt/table.h"

/* The numbers of the points that are told, of `count`. All of them take one byte. */
void mt_pack_points(const bool *told, int count, mt_table *table);

void mt_pack_deltas(const int16_t *deltas, int count, mt_table *table);
