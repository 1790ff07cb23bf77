/* What the files that blend anchors share. */
#pragma once

#include "anchors/anchor.h"
#include "anchors/move.h"
#include "sfnt/sfnt.h"

/* The most steps (a glyph looked up, an anchor read) that a pair of fonts may cost, some seconds: a malformed
 * font can have the same tables in it thousands of times. The largest fonts take a hundredth of it. */
#define MT_ANCHOR_STEPS_MAX ((int64_t)1 << 25)

/* What an anchor that is kept counts for, in steps: memory for a million. */
enum { MT_ANCHOR_KEPT_STEPS = 32 };

typedef struct mt_anchor_job {
    const mt_anchor_source *sources;
    double scales[MT_STOPS_MAX]; /* new units in a unit of each */
    const mt_systems *systems;
    const mt_font_glyphs *glyphs;
    mt_arena *arena;    /* of what is kept */
    mt_arena scratch;   /* of one subtable */
    uint16_t *new_of_a; /* the new glyphs by A's glyph, then by number */
    uint32_t *first;    /* where those of an A's glyph start; one more than there are glyphs */
    mt_outline_moves moves[MT_STOPS_MAX]; /* to each font but the first */
    int64_t steps;                        /* that are left */
} mt_anchor_job;

/* A new glyph, and the place of A's in a coverage. */
typedef struct mt_entry {
    uint16_t glyph;
    int index;
} mt_entry;

/* Takes steps; false when there are not so many left: then the rest is left out. */
bool mt_anchor_spend(mt_anchor_job *job, int64_t steps);
/* The new glyphs of A's glyphs in a coverage, ascending, in the scratch. MT_NO_MEMORY. */
mt_status mt_anchor_entries(mt_anchor_job *job, mt_bytes coverage, mt_entry **entries, int *count);
/* An anchor with a place in each font, those of the first `known` fonts as in `from`. Its points are NULL when there is no
 * memory. */
mt_anchor mt_anchor_new(mt_anchor_job *job, mt_anchor from, int known, mt_arena *arena);
/* A place in a font, in the new font's units. */
mt_anchor_point mt_anchor_scaled(const mt_anchor_job *job, int font, mt_anchor_point point);
/* Moves the anchor with the outline of its glyph from A to another font. MT_NO_MEMORY. */
mt_status mt_anchor_move(mt_anchor_job *job, int font, int glyph, mt_anchor anchor);
