/* Chains of quadratics through samples of two curves at once, smooth in every mix of the two. */
#pragma once

#include "geometry/spline.h"

/* An end of a chain in one master: the place, the direction along the path there (unit length), and the length of the line beyond it in
 * that direction; 0 where the handle may have any length. */
typedef struct mt_chain_end {
    mt_vec at, along;
    double arm;
} mt_chain_end;

/* Quadratics from start to end. Between the control points of two neighbours lies a node, at the same share of the way in
 * both masters, so that the handles on its sides have the same ratio in both: any mix of them is in line. */
typedef struct mt_chain {
    int count, room;                 /* segments, and room for them */
    mt_vec *control[MT_MASTERS_MAX]; /* of each segment */
    double *share; /* of the way from control k to k + 1, where node k is; count - 1 of them */
    mt_chain_end start[MT_MASTERS_MAX], end[MT_MASTERS_MAX];
} mt_chain;

/* The samples that one master's chain is held to, in order. */
typedef struct mt_run {
    int count;
    const mt_sample *samples;
} mt_run;

/* Moves controls and shares until every sample is within `tolerance` grid units of the chain, measured across its own
 * direction, by least squares (Gauss–Newton). Shares of a half come first: a TrueType font need not store such nodes. Where the
 * chain has too few segments for it, segments are divided, as long as there is room. With arms, the handles at that end have
 * the arms' ratio. *fits: it was possible; otherwise the chain is undefined. MT_NO_MEMORY,
 * MT_TOO_LARGE where the arena's steps do not do. */
mt_status mt_chain_fit(const mt_run runs[MT_MASTERS_MAX], double tolerance, mt_arena *arena, mt_chain *chain,
                       bool *fits);

/* Node k of a chain, the start for k = 0 and the end for k = count. */
mt_vec mt_chain_node(const mt_chain *chain, int master, int k);
