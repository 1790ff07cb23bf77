/* Joining two matched components, or parts of components: one moving contour for each pair of rings. */
#ifndef MT_MORPH_JOIN_JOIN_H
#define MT_MORPH_JOIN_JOIN_H

#include "morph/model/join_context.h"
#include "morph/model/morph.h"

/* A component, or a part of one, in its glyph's box. */
typedef struct mt_part {
    const mt_component *component;
    mt_box box;
} mt_part;

/* Two parts on their way to each other, and what it takes. */
typedef struct mt_joining {
    mt_part a, b;
    const mt_join_context *context;
    mt_arena *arena;
    double costliest; /* of the alignments so far (align.h) */
} mt_joining;

/* Joins two parts: their outer rings and those holes that have a counterpart are aligned, and a contour is fitted to each pair.
 * A hole without a counterpart is slit open, or closes to a point inside the other part's ink. Appends to contours[*count]
 * at most as many contours as both have rings; none when aligning a pair of rings costs more than `most`, or the half-way
 * contours would lie too much over themselves or each other. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_GEOMETRY. */
mt_status mt_join(mt_part a, mt_part b, double most, const mt_join_context *context, mt_arena *arena,
                  mt_contour_pair *contours, int *count);

#endif
