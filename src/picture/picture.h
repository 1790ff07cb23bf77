/* Strips, sheets and inspections: pictures to judge a blend by. Text is shaped by HarfBuzz with the blended
 * fonts themselves, and drawn by Cairo: what a strip shows is what the font gives. The output's format is
 * that of its extension: .png, .svg or .pdf. */
#pragma once

#include "blend/choice.h"

/* What a picture may be asked for; beyond it is MT_BAD_PARAMETER. */
#define MT_STEPS_MAX 1000
#define MT_SIZE_MIN 4.0 /* picture units an em, or a cell */
#define MT_SIZE_MAX 8192.0
#define MT_TEXT_MAX (1 << 20) /* characters */

/* Called once all fonts are made and before anything is drawn, unless it is NULL; what it returns other than
 * MT_OK ends the call, which then returns that. */
typedef mt_status (*mt_fonts_made)(void *user);

typedef struct mt_strip {
    const mt_choice *text; /* of `length`; the character '\n' starts a new line */
    int length;
    const double *at; /* T of each step, as many as step_count */
    int step_count;
    double size; /* pixels (or points, in SVG and PDF) an em */
    bool labels; /* T under each step */
    mt_fonts_made made;
    void *user;
} mt_strip;

/* One row a line of text, one column a step; a text wider than three em gives one row a step instead. A named glyph is set at its
 * place as it is, whatever stands beside it. Sets the blend's characters and glyphs to those of the text. MT_NO_GLYPH when one of them is in one font only,
 * MT_UNKNOWN_FORMAT, MT_TOO_LARGE for a picture over the sides that canvas.h gives, MT_CANNOT_WRITE, and what
 * mt_blend_font gives. */
mt_status mt_strip_save(mt_blend *blend, const mt_strip *strip, const char *path);

typedef struct mt_sheet {
    const mt_choice *choices; /* one row each */
    int count;
    const double *at; /* T of each column */
    int step_count;
    double size;                   /* of a cell, pixels or points */
    int rows_per_page;             /* 0: what fits a page of A4's proportions */
    const char *title_a, *title_b; /* names of the two fonts */
    mt_fonts_made made;
    void *user;
} mt_sheet;

/* A grid of characters or glyphs × steps, with code points or names, a heading and page numbers. PDF takes all pages; of PNG and
 * SVG each page is a file of its own, NAME-2.png and so on after the first. Sets the blend's characters and
 * glyphs to those of the sheet; errors as for the strip. */
mt_status mt_sheet_save(mt_blend *blend, const mt_sheet *sheet, const char *path);

typedef struct mt_inspection {
    const mt_choice *choices;
    int count;
    double size; /* pixels or points an em */
} mt_inspection;

/* Per character or glyph: both sides, components by colour, pieces outlined, links drawn between the pieces' centres. Of a row of one
 * font, and of a glyph without a partner, only components and pieces. Where a morph cannot be made, *failed says at which choice;
 * it is -1 for other errors. */
mt_status mt_inspect_save(mt_row *row, const mt_inspection *what, const char *path, int *failed);
/* The same as data, schema in docs/guide.md; bytes for mt_bytes_free. */
mt_status mt_inspect_json(mt_row *row, const mt_inspection *what, uint8_t **bytes, size_t *length,
                          int *failed);
/* The same as a page of HTML on which hints are made by pointing, between the row's two fonts; glyphs without a partner are not on it.
 * MT_NOTHING_SHARED where that leaves none. */
mt_status mt_inspect_page_make(mt_row *row, const mt_inspection *what, uint8_t **bytes, size_t *length,
                               int *failed);

/* Calls with each hint of the row's first two fonts that changes nothing at a choice, by its index, and with the hint's line in its file. */
typedef void (*mt_idle_hint_noted)(int choice, int line, void *user);
mt_status mt_inspect_idle_hints(mt_row *row, const mt_inspection *what, mt_idle_hint_noted call, void *user,
                                int *failed);
