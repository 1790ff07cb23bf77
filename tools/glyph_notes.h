/* Glyphs that are to be told about when the fonts are made: collected as they come, told by kinds, a line each. */
#pragma once

#include "options.h"

typedef struct glyph_note {
    uint32_t code_point, glyph; /* as mt_glyph_note */
    bool is_form;
    char *name; /* NULL: none */
    int font;
    mt_status why;
    double t, up, asked, asked_up;
} glyph_note;

typedef struct glyph_notes {
    glyph_note *list;
    int count, room;
    bool lost; /* there was no memory to note one */
} glyph_notes; /* all zero is empty */

/* An mt_glyph_noted; the user data is a glyph_notes. Threads report in any order. */
void glyph_notes_add(const mt_glyph_note *note, void *user);
void glyph_notes_free(glyph_notes *notes);

/* Says of the glyphs, sorted, why each could not be blended: those of one reason and one font in one line, with the first few
 * of them, or with --verbose each in a line. */
void glyph_notes_say_failures(glyph_notes *notes, const cli_options *options);
/* Says which glyphs stay as they are in the first font because another one has none for them. */
void glyph_notes_say_unblended(glyph_notes *notes, const cli_options *options);
/* Says which glyphs stay short of a place that was asked for, and where. */
void glyph_notes_say_held(glyph_notes *notes, const cli_options *options);
/* Says which glyphs are blended by the best of what their effort did for. */
void glyph_notes_say_cut_short(glyph_notes *notes, const cli_options *options);
