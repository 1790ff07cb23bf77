/* Runs of glyphs of one font that stand where another font has one glyph. */
#pragma once

#include "glyphset/inks.h"
#include "glyphset/shaper.h"
#include "sfnt/intern.h"

enum { MT_RUN_PARTS = 8 }; /* at most: syllables of Indic scripts have five */

/* What runs draw, each drawing once. */
typedef struct mt_runs {
    mt_shaper *shaper;
    mt_inks *inks;
    mt_interned drawings;
} mt_runs;

/* A part of a shaped text: the glyphs from `start` up to `end`. */
typedef struct mt_run {
    unsigned start, end;
} mt_run;

void mt_runs_open(mt_shaper *shaper, mt_inks *inks, mt_runs *runs);
void mt_runs_free(mt_runs *runs); /* all zero is fine */

/* Whether all glyphs of the run are marks. */
bool mt_run_is_mark(const mt_shaper *shaper, const mt_shaped_text *shaped, mt_run run);

/* A number for what the run draws in the room of one of its glyphs, or of all of them with MT_RUN_WHOLE: that of its one inked
 * glyph where this is the same, else one from MT_COMPOSED_FIRST on. Marks are drawn as from the first of them. *number is
 * MT_NO_DRAWING for more glyphs than MT_RUN_PARTS, and where HarfBuzz puts in a dotted circle. MT_NO_MEMORY. */
enum { MT_RUN_WHOLE = -1, MT_NO_DRAWING = 0 };
mt_status mt_runs_add(mt_runs *runs, const mt_shaped_text *shaped, mt_run run, int room, uint32_t *number);

/* The same of a blank in the room of a glyph of a shaped text. */
mt_status mt_runs_add_blank(mt_runs *runs, const mt_shaped_text *shaped, unsigned room, uint32_t *number);

/* Makes of a number that of the font's composed glyph; MT_NO_DRAWING where the font takes no more of them. MT_NO_MEMORY. */
mt_status mt_runs_compose(const mt_runs *runs, uint32_t *number);
