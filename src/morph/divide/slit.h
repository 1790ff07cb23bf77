/* Slits: cuts without width through the ink, that open a hole into another ring of its component. */
#pragma once

#include "morph/align/pairing.h"

/* A component with a partner, and the partner's ring for each of its rings. */
typedef struct mt_slit_case {
    const mt_component *component;
    mt_frame frame;
    const mt_ring **counterpart; /* of each ring of the component; NULL: none */
    mt_frame other_frame;
} mt_slit_case;

/* Slits the component open between hole `hole`, which has no counterpart, and a ring that has one, where the joined ring aligns with
 * that counterpart at less cost than the ring alone: the other side has the hole open there. *done: there is such a place, and
 * *opened is the component with one ring less. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_slit(const mt_slit_case *slit, int hole, const mt_settings *settings, mt_arena *arena,
                  mt_component *opened, bool *done);
