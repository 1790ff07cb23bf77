/* What mt_positions holds; shared by the files that prepare, write and tell of positions. */
#pragma once

#include "anchors/anchor.h"
#include "gpos/context.h"
#include "gpos/singles.h"
#include "kerning/pairs.h"
#include "layout/lookup_groups.h"

/* Pair adjustment that is to be lookups: mostly one. Where the fonts' classes together would be too many, or more than they save, each font's own
 * is one, and what they give adds up. */
typedef struct mt_pair_position {
    mt_lookup_builder head; /* without subtables */
    int count;
    mt_pairs *pairs;
} mt_pair_position;

typedef struct mt_single_position {
    mt_lookup_builder head;
    mt_singles singles;
} mt_single_position;

typedef struct mt_positions {
    int font_count;
    mt_systems systems;
    int pair_count, single_count;
    mt_pair_position *pairs;
    mt_single_position *singles;
    bool has_plain_kerning;
    mt_pairs plain_kerning; /* all of the kern feature that Latin text is set by, whatever the flags */
    mt_anchors anchors;
    mt_contexts contexts; /* what they call is among the others */
} mt_positions;
