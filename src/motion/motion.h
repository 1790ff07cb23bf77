/* An animation: a chain of key frames, what moves between them, when, and on what canvas. Formats take it from here (formats.h). */
#pragma once

#include "base/workers.h"
#include "blend/row.h"
#include "drawing/colour.h"
#include "motion/page.h"
#include "motion/stretch.h"
#include "motion/timeline.h"

/* A text of a font, or a drawing. */
typedef struct mt_key {
    mt_font *font; /* NULL: it is a drawing */
    mt_text text;
    const mt_svg_drawing *drawing;
} mt_key;

typedef struct mt_motion_request {
    int key_count; /* 2 … MT_VARIABLE_FONTS_MAX */
    const mt_key *keys;
    mt_params params;
    const mt_hint_table *hints; /* NULL: none; with a drawing among the keys there can be none */
    mt_timing timing;
    mt_page_request page;
    int colour_count; /* 1, or one for each key frame, or 2: of the first and of the last */
    const mt_colour *colours;
    bool has_background;
    mt_colour background;
    mt_progress progress; /* NULL is fine */
    void *progress_user;
} mt_motion_request;

typedef struct mt_motion {
    mt_motion_request request;
    mt_figure *figures;
    int stretch_count;
    mt_stretch *stretches;
    mt_timeline timeline;
    mt_page page;
    mt_arena arena;
    mt_thread_arenas kept;
} mt_motion;

/* Why a motion could not be opened. */
typedef struct mt_motion_fault {
    int key;            /* the number of the key frame to blame; -1: none */
    int lacking;        /* with MT_NO_GLYPH: the index of its character that the font lacks; else -1 */
    mt_hint_error hint; /* with MT_BAD_HINTS */
} mt_motion_fault;

/* Reads the key frames and prepares what moves, on threads. The request's fonts, texts and drawings have to live as long. MT_BAD_PARAMETER,
 * MT_TOO_LARGE for a canvas over MT_CANVAS_MAX, MT_NO_MEMORY; MT_BAD_HINTS, and what mt_figure_read gives, all with `fault` filled in. The motion is to be closed whatever comes. */
mt_status mt_motion_open(const mt_motion_request *request, mt_motion *motion, mt_motion_fault *fault);
void mt_motion_close(mt_motion *motion);

/* The drawing at a moment: at both ends of a stretch, with `exact`, the source's own, else always the contours that move. MT_NO_MEMORY. */
mt_status mt_motion_draw(const mt_motion *motion, mt_moment moment, bool exact, mt_arena *arena,
                         mt_drawing *drawing);
mt_colour mt_motion_colour(const mt_motion *motion, mt_moment moment);
