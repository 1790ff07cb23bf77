/* Relaxation matching on a matrix of similarities: formulas (1) and (2) of section 2.2.1. */
#pragma once

#include "morph/model/morph.h"

/* The relaxation of formula (1) on the similarity matrix s of `rows` × `columns`, row by row, in place:
 *
 *     s'(i, j) = s(i, j) · Σ over h ≠ i of max over r ≠ j of s(h, r) / (rows - 1)
 *
 * `rounds` times, each time scaled so that the largest entry is 1. With one row there is no support, and only
 * the scaling remains; with one column, r has no other choice than j. MT_NO_MEMORY. */
mt_status mt_relax(double *s, int rows, int columns, int rounds, mt_arena *arena);

/* Matches of rows with columns: relaxes s and its transpose (formula 2), takes the best column of each row
 * and the best row of each column, and drops a match that one of the two relaxations puts under `threshold`
 * while both of its ends have a better one. Every row and every column keeps at least one match. s is left as
 * it was. MT_NO_MEMORY. */
mt_status mt_match_components(const double *s, int rows, int columns, int rounds, double threshold,
                              mt_arena *arena, mt_links *matches);
