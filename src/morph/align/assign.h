/* Assigning rows to columns at the least cost in all. */
#pragma once

#include "base/memory.h"
#include "morphotype.h"

/* Assigns min(rows, columns) rows to as many columns, one to one, with the least sum of costs[row × columns + column], which are
 * finite. column_of[row] is -1 for a row that is left over. MT_NO_MEMORY. */
mt_status mt_assign(const double *costs, int rows, int columns, mt_arena *arena, int *column_of);
