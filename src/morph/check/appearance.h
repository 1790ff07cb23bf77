/* What an eye minds in the in-betweens of a morph, where there is no truth to hold them against. */
#pragma once

#include "morph/model/morph.h"

typedef struct mt_onlooker mt_onlooker;

/* Looks at both ends, which all morphs between them are held against. Lives in the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_look_at_ends(const mt_morph *morph, mt_arena *arena, mt_onlooker **onlooker);

/* How far in-betweens are from what they might be, at the worst of three places. */
typedef struct mt_appearance {
    double strays; /* 1/1000 em: of ink, from the shortest way from A to B, faded in part */
    double clots;  /* the largest disc in the ink, over the largest at either end; 1 where it is no larger */
    double ink;    /* how far the ink is out of the range of the ends', relative to the larger */
} mt_appearance;

mt_status mt_look_at_morph(const mt_onlooker *onlooker, const mt_morph *morph, const mt_params *params,
                           mt_arena *arena, mt_appearance *seen);

/* All as one, the worst of them: from 1 on, an eye stumbles. */
double mt_appearance_score(const mt_appearance *seen);
