/* A row of fonts: two or more sources in their order, and what is asked of the fonts between them.
 *
 * A blend is a row of two, of which fonts at single places are made; a variable font is made of all of a row at once. What
 * one glyph is between two neighbours of the row is read and prepared in one way for both (pair.h), glyph by glyph in one
 * way (making.h), and goes into instances (instances.c) or moving contours (outlines.c).
 *
 * Nothing of a row changes while fonts are made of it. `lock` is held while a font is read, because a FreeType face is not
 * for two threads, and while the caller is called, who is not asked to lock anything. */
#pragma once

#include <pthread.h>

#include "base/stop.h"
#include "glyphset/codes.h"
#include "hints/index.h"
#include "sfnt/axis.h"
#include "sfnt/axis_map.h"
#include "source/font.h"
#include "source/given_pairs.h"
#include "source/given_places.h"

typedef struct mt_row {
    int font_count;
    mt_font **fonts;
    mt_hint_index *
        *hints; /* between each font and the next: font_count - 1 of them; NULL where there are none */
    mt_params params;
    double *
        leans; /* between each font and the next, degrees: the params', or measured once a glyph is prepared */
    bool leans_known;
    char *family; /* NULL: made from the sources' */
    int style_count;
    char **styles; /* of the fonts that are made, in their order; the others' are made from their places */
    int wanted_count;
    uint32_t *wanted;
    int wanted_glyph_count; /* of the first font's; neither characters nor glyphs: all */
    uint32_t *wanted_glyphs;
    int height_count;
    double *heights;        /* T upwards of the fonts that are made, in their order; none: as across */
    mt_given_places places; /* of glyphs by themselves */
    mt_glyph_set set;
    mt_curves curves;     /* of a UFO's outlines */
    mt_given_pairs pairs; /* empty: none are given */
    mt_cache *cache;      /* of prepared glyphs, the caller's; NULL: none */
    bool alternates;      /* of wanted characters, also those that text has to ask for */
    int unblended;        /* glyphs of the last fonts */
    mt_stop stop;         /* no more work is to be done */
    int prepared,
        proved; /* glyphs that were prepared since a font was begun; those with a topology that is proved for every T */
    mt_glyph_failed failed;
    mt_glyph_noted failure, kept; /* of glyphs that could not be blended, and of those without a partner */
    mt_glyph_noted cut_short;     /* of those whose effort was spent early */
    mt_glyph_noted held;          /* of those that stay short of a place that was asked for */
    mt_left_out_noted left_out;
    mt_progress progress;
    void *failed_user, *failure_user, *kept_user, *cut_short_user, *held_user, *left_out_user, *progress_user;
    pthread_mutex_t lock;
} mt_row;

struct mt_blend {
    mt_row row; /* of two fonts */
};

struct mt_variable {
    mt_row row;
    mt_axis axis;
    mt_axis_map map; /* as mt_variable_set_map has it */
    double *values;  /* what users set for each font; NULL: evenly from axis.from to axis.to */
    bool has_italic; /* the family has an italic file to these upright fonts */
};

/* A row of 1 … MT_VARIABLE_FONTS_MAX fonts, which it keeps using. MT_BAD_PARAMETER, MT_NO_MEMORY. */
mt_status mt_row_open(mt_font *const *fonts, int count, const mt_params *params, mt_row *row);
void mt_row_close(mt_row *row); /* all zero is fine */

/* As the calls for a blend (morphotype.h). */
mt_status mt_row_set_hints(mt_row *row, const mt_hint_table *table, mt_hint_error *error);
mt_status mt_row_set_pairs(mt_row *row, const uint32_t *glyphs, int count);
mt_status mt_row_set_chars(mt_row *row, const uint32_t *code_points, int count);
mt_status mt_row_set_glyph_numbers(mt_row *row, const uint32_t *glyphs, int count);

/* What is asked of the row's glyphs. It refers to the row. */
mt_charset_request mt_row_request(const mt_row *row);

/* The new font's units per em: the most that the blend of two neighbours needs (metadata.h). */
int mt_row_units(const mt_row *row);

/* Where font number i of those that are made is, whose T across is t. */
mt_at mt_row_place(const mt_row *row, double t, int i);

/* Whether T upwards that were set, if any were, are for so many fonts, and the row can have them. */
bool mt_row_takes_heights(const mt_row *row, int count);

/* MT_STOPPED where the row's work was stopped; otherwise the status. */
mt_status mt_row_verdict(const mt_row *row, mt_status status);

/* The progress of a part of the work, which has `all` steps of which `before` are done when it begins. */
typedef struct mt_row_progress {
    mt_row *row;
    int before, all;
} mt_row_progress;
/* An mt_progress; `user` is an mt_row_progress. Calls the caller, who may not have asked for it, under the lock. */
void mt_row_pass_progress(int done, int all, void *user);
/* Tells the caller, under the lock, that a glyph could not be blended; nothing once the work was stopped, which is then why. */
void mt_row_report(mt_row *row, const mt_glyph_note *note);
/* The same, that its effort was spent before all ways were tried. */
void mt_row_report_cut_short(mt_row *row, const mt_glyph_note *note);
/* The same, that it stays at note->t. */
void mt_row_report_held(mt_row *row, const mt_glyph_note *note);
