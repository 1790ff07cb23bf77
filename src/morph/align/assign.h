/* Assignment: which rows go with which columns, so that all of it costs least. */
#ifndef MT_MORPH_ALIGN_ASSIGN_H
#define MT_MORPH_ALIGN_ASSIGN_H

#include "base/memory.h"
#include "morphotype.h"

/* Assigns as many rows to columns as there are of the fewer, each to another, for the least sum of costs[row × columns + column],
 * which are finite. column_of[row] is -1 for a row that is left over. O(n² m) for the fewer n, by shortest augmenting paths
 * (H. W. Kuhn, "The Hungarian method for the assignment problem", 1955; J. Munkres, 1957). MT_NO_MEMORY. */
mt_status mt_assign(const double *costs, int rows, int columns, mt_arena *arena, int *column_of);

#endif
