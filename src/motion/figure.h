/* A key frame as it is drawn: a text of a font, glyphs by their names, in parts that move one by one; or a drawing, which is one part.
 *
 * A part is what one cluster of the text draws: a letter with its marks, a ligature, a syllable. Parts without ink are left out. */
#pragma once

#include "blend/choice.h"
#include "drawing/svg_drawing.h"
#include "geometry/layers.h"
#include "source/font.h"

/* Where a part has several glyphs, and so none that hints are about. */
#define MT_SEVERAL_GLYPHS UINT32_MAX

typedef struct mt_figure_part {
    uint32_t glyph;       /* its only one, or MT_SEVERAL_GLYPHS */
    const uint32_t *text; /* its characters, NULL for a glyph by its name */
    int text_length;
    mt_layers drawing; /* as its source draws it, about an origin of its own */
    bool apart;        /* layers of a drawing are filled one by one, those of texts all together */
    mt_shape shape;    /* the same, resolved */
    mt_vector place;   /* of the origin, grid units, from the middle of the figure's line */
} mt_figure_part;

typedef struct mt_figure {
    int count;             /* at least one */
    mt_figure_part *parts; /* in the order of the page */
    double advance;        /* grid units */
} mt_figure;

/* Characters, and glyphs of the font by their numbers. */
typedef struct mt_text {
    int count;
    const mt_choice *list;
} mt_text;

/* Reads a text of one line, with chords within `tolerance` (1/1000 em), in the arena. Characters next to one another are shaped by
 * HarfBuzz; a glyph by its name stands as it is. Not for two threads at once with one font. MT_NO_GLYPH, *lacking is then the
 * character's index; MT_BLANK when there is no ink, MT_TOO_LARGE for more than MT_LINE_MAX characters or glyphs, and what
 * mt_shape_line and mt_outline_shape give. */
mt_status mt_figure_read(mt_font *font, const mt_text *text, double tolerance, mt_arena *arena,
                         mt_figure *figure, int *lacking);

/* The same of a drawing: one part, whose layers are the drawing's. MT_NO_MEMORY, and as mt_layers_shape. */
mt_status mt_figure_of_drawing(const mt_svg_drawing *drawing, double tolerance, mt_arena *arena,
                               mt_figure *figure);

/* The parts from `first` on as one, about the origin of the first: their shape alone, in the arena. MT_TOO_LARGE where they lie too far
 * apart, MT_NO_MEMORY, and as mt_union. */
mt_status mt_group_parts(const mt_figure *figure, int first, int count, mt_arena *arena,
                         mt_figure_part *group);
