/* A font's MATH table, opened. */
#pragma once

#include "base/memory.h"
#include "math/table/math_table.h"
#include "source/font.h"

/* Reads it into the arena; a font whose layout is left aside has none. Not for two threads at once. MT_NO_MEMORY. */
mt_status mt_math_table_open(const mt_font *font, mt_arena *arena, mt_math_table *math);
