/* Drawings whose left and right are alike: what moves between two of them stays so. */
#pragma once

#include "geometry/ring.h"
#include "morph/model/hints.h"
#include "morph/model/morph.h"

/* Where both shapes are one ring, alike on the left and the right of an upright axis that it meets twice, gives the two pairs of places
 * where they do: hints that each half goes with its half. None for other shapes. */
typedef struct mt_axis_hints {
    int count; /* 0 or 2 */
    mt_hint list[2];
} mt_axis_hints;

mt_axis_hints mt_axis_hints_of(const mt_shape *a, const mt_shape *b);

/* Makes contours that were found with these hints alike on both sides: one half of them, whose points go the shorter way, and its mirror
 * image. Contours that have no points where both shapes meet their axes stay as they are, and *done is false. In the arena. MT_NO_MEMORY. */
mt_status mt_axis_mirror(const mt_axis_hints *hints, mt_variable_outline *contours, mt_arena *arena,
                         bool *done);

/* The right halves of two shapes that are alike on both sides of upright axes, however many rings they have, and hints that what they meet
 * first and last of their axes goes together. */
typedef struct mt_halves {
    bool alike; /* otherwise there is nothing else */
    mt_shape a, b;
    int32_t axis_a, axis_b; /* x */
    mt_axis_hints hints;
} mt_halves;

/* In the arena. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_halves_of(const mt_shape *a, const mt_shape *b, mt_arena *arena, mt_halves *halves);

/* Adds to the contours that move from half to half their mirror images. In the arena. MT_NO_MEMORY. */
mt_status mt_add_images(const mt_halves *halves, mt_variable_outline *contours, mt_arena *arena);
