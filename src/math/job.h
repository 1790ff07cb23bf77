/* All fonts' tables at hand: what the files that prepare share. */
#pragma once

#include "anchors/move.h"
#include "math/math_data.h"

typedef struct mt_math_source {
    mt_font *font;
    mt_math_table table;
    double scale;           /* units of the new font in one of this font's */
    mt_outline_moves moves; /* from the first font to this one; not of the first */
} mt_math_source;

typedef struct mt_math_job {
    int font_count;
    mt_math_source *sources;
    mt_font_glyphs glyphs;
    int units;
    int *numbers;  /* among the new font's glyphs, of each of the first font's; -1 where it is not there */
    int rows_left; /* of kerns, larger glyphs and parts: what is beyond is left out */
    mt_arena *arena;
    mt_arena scratch;
    mt_math *math;
} mt_math_job;

/* Whether there are so many rows left: they are fewer then. */
bool mt_math_spend(mt_math_job *job, int count);

/* A row of zeros; NULL without memory. */
double *mt_math_new_row(const mt_math_job *job);

/* info.c: italics, accents, extended shapes, kerns. growths.c: glyphs that grow. MT_NO_MEMORY. */
mt_status mt_math_prepare_info(mt_math_job *job);
mt_status mt_math_prepare_growths(mt_math_job *job);
