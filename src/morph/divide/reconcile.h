/* Making two glyphs agree: each is cut where the other is apart, so that as many components as can be have one counterpart. */
#ifndef MT_MORPH_DIVIDE_RECONCILE_H
#define MT_MORPH_DIVIDE_RECONCILE_H

#include "morph/divide/division.h"

/* Cuts both sides into parts (parts.h), and what finds no partner then, or none that is like it, once more by itself:
 * what is in order no longer stands in its way. What is left of both sides at last goes together at any cost. `hints` is
 * not NULL. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_reconcile(const mt_side *a, const mt_side *b, const mt_hints *hints, const mt_settings *settings,
                       mt_arena *arena, mt_cut_side *cut_a, mt_cut_side *cut_b);

#endif
