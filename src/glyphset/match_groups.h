/* What the features of two fonts apply, side by side. */
#pragma once

#include "base/memory.h"
#include "gsub/gsub.h"

/* In this order: a feature of a script and language that both fonts have; a feature wherever it is. 'aalt' is in no group: it
 * numbers what the other features lead to, in each font in its own way. */
enum { MT_GROUP_EXACT, MT_GROUP_ANY, MT_GROUP_STAGES };

typedef struct mt_group {
    int stage;
    bool *a, *b; /* for each lookup of the font: it is applied */
} mt_group;

typedef struct mt_groups {
    int count;
    mt_group *list;
} mt_groups;

/* The groups of all features that both fonts have, each once. MT_NO_MEMORY. */
mt_status mt_match_groups(const mt_gsub *a, const mt_gsub *b, mt_arena *arena, mt_groups *groups);
