/* What an eye minds in the in-betweens of a morph, where there is no truth to hold them against. */
#pragma once

#include "morph/model/morph.h"

typedef struct mt_onlooker mt_onlooker;

/* Looks at both ends of a morph, which all morphs between them are held against, in the frames of its sides. Lives in the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_look_at_ends(const mt_morph *morph, mt_arena *arena, mt_onlooker **onlooker);

/* How far in-betweens are from what they might be, at the worst of the places that were looked at. */
typedef struct mt_appearance {
    double strays;  /* 1/1000 em: of ink, from the shortest way from A to B, faded in part */
    double clots;   /* the largest disc in the ink, over the largest at either end; 1 where it is no larger */
    double ink;     /* how far the ink is out of the range of the ends', relative to the larger */
    double turning; /* of a morph's boundary on its way (check/turning.h); 0 where ink alone was looked at */
} mt_appearance;

#define MT_NOTHING_SEEN ((mt_appearance){.clots = 1})

/* Looks at the ink at T, of a morph that has not been turned (formula (5)), and takes what is worse there. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_look_at_ink(const mt_onlooker *onlooker, const mt_shape *ink, double t, mt_arena *arena,
                         mt_appearance *seen);
/* Looks at three places between the ends. As mt_morph_blend. */
mt_status mt_look_at_morph(const mt_onlooker *onlooker, const mt_morph *morph, const mt_params *params,
                           mt_arena *arena, mt_appearance *seen);

/* What an eye stumbles over, each as 1: found on glyphs that were judged by eye first. */
#define MT_STRAYS_MOST 12.0 /* 1/1000 em */
#define MT_CLOTS_MOST 0.15  /* by how much the disc is larger */
#define MT_INK_MOST 0.12    /* four times what is not seen (MT_INK_EXCESS) */

/* Boundaries of related drawings turn by .005 to .03, a stroke end that is cut by .05. */
#define MT_TURNING_MOST 0.125

/* All as one, the worst of what ink shows and what the boundary turns: from 1 on, an eye stumbles. */
double mt_appearance_score(const mt_appearance *seen);

/* A score, and a little for each of `parts`, components and holes out of the ends' range, summed over all places. */
double mt_appearance_loss(double score, int parts);
