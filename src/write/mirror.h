/* Variations along an axis on which fonts stand from more to less: 700 … 400. What a font has without a setting is its
 * default, so that all places lie below it, from 0 to -1 of the tables' own scale. The tables of var_store.h are made for 0 to
 * 1; here their regions are turned over. */
#pragma once

#include "base/memory.h"
#include "morphotype.h"
#include "sfnt/sfnt.h"

/* The table once more in the arena, with each region of its ItemVariationStore the other way round. Of HVAR, VVAR, MVAR and GDEF, as
 * they are made here; any other table, and one without a store, stays what it is. MT_NO_MEMORY. */
mt_status mt_mirror_table(uint32_t tag, mt_arena *arena, mt_bytes *table);
