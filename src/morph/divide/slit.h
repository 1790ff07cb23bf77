/* Slits: cuts without width through the ink, that open a hole into another ring of its component. */
#ifndef MT_MORPH_DIVIDE_SLIT_H
#define MT_MORPH_DIVIDE_SLIT_H

#include "morph/align/pairing.h"

/* A component on its way to a partner: what each of its rings goes with there. */
typedef struct mt_slit_case {
    const mt_component *component;
    mt_box box;
    const mt_ring **counterpart; /* of each ring of the component; NULL where it has none */
    mt_box other_box;
} mt_slit_case;

/* Slits the component open between hole `hole`, which has no counterpart, and a ring that has one, where what comes of it goes
 * with that counterpart better than the ring alone did: on the other side the hole is open there. *done says whether there
 * is such a place; then *opened is the component with one ring less. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_slit(const mt_slit_case *slit, int hole, const mt_settings *settings, mt_arena *arena,
                  mt_component *opened, bool *done);

#endif
