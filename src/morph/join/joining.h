/* The state of joining two parts. */
#pragma once

#include "morph/model/join_context.h"
#include "morph/model/morph.h"

/* A component, or a part of one, in its glyph's frame. */
typedef struct mt_part {
    const mt_component *component;
    mt_frame frame;
} mt_part;

typedef struct mt_joining {
    mt_part a, b;
    const mt_join_context *context;
    mt_arena *arena;
    double costliest; /* the largest cost of their alignments so far (align/align.h) */
} mt_joining;
