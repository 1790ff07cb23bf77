/* What a cut would make of a part, without cutting. */
#pragma once

#include "solid/cells.h"

typedef struct mt_trial {
    int n_parts;   /* of what hangs together on either side */
    int n_handles; /* of all their surfaces */
    double excess; /* by how much all their hulls are larger than they are, grid units */
    double behind; /* the volume on the side that the plane's normal does not point to, grid units */
} mt_trial;

/* Floating point: it chooses between planes, and decides nothing. n_parts is 1 when the plane does not cut. MT_NO_MEMORY. */
mt_status mt_trial_of(const mt_part *part, const mt_plane *plane, mt_trial *trial);
