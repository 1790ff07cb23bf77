/* The holes of two parts that are joined: paired, divided, or closed. */
#ifndef MT_HOLES_H
#define MT_HOLES_H

#include "morph/join.h"

/* Pairs the holes of both parts by their places and aligns each pair. A hole that holds the places of several holes of the
 * other part is divided among them, by cuts without width; one without any counterpart closes to a point in the other part's
 * ink. Appends one contour for each to contours[*count], at most as many as both parts have holes. MT_NO_MEMORY,
 * MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_join_holes(const mt_joining *j, mt_masters *contours, int *count);

#endif
