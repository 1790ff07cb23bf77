/* Strips, sheets and inspections: pictures to judge a blend by. Text is shaped by HarfBuzz with the blended
 * fonts themselves, and drawn by Cairo: what a strip shows is what the font gives. The output's format is
 * that of its extension: .png, .svg or .pdf. morphotype.h has strips and sheets. */
#pragma once

#include "blend/choice.h"

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
