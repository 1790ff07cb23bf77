/* Fonts of a row in the making: the glyphs that they have, and the one way that each of them goes.
 *
 * A glyph is the unit of work, on each step from a font to the next. It is read and prepared once (pair.h), however many
 * sinks take what comes of it: instances, moving contours, a report's figures. A glyph that is built from others waits until
 * these are made: glyphs are made depth by depth.
 *
 * Threads: workers take the next glyph from a counter (base/workers.h). Each has an arena for the glyph at hand, emptied
 * after it, and one for the results. Sinks keep their results by step and glyph, so that they do not depend on who made
 * them or when; what they read besides is written before the work begins, or belongs to glyphs of a lower depth. Reading
 * from the fonts and calling the caller are under the row's lock. */
#pragma once

#include "base/workers.h"
#include "blend/composite.h"
#include "blend/pair.h"
#include "gpos/positions.h"
#include "gsub/subset.h"
#include "math/math.h"

typedef struct mt_making mt_making;

/* The glyph that a worker has at hand. */
typedef struct mt_glyph_task {
    mt_making *making;
    int step, glyph;
    uint32_t a,
        b; /* its glyphs in fonts number `step` and step + 1; b is MT_NO_PARTNER where it stays as it is */
    mt_arena *scratch, *kept; /* for the glyph alone; until the making ends */
    mt_glyph_pair pair;       /* `begin` finds the rooms in it */
} mt_glyph_task;

/* What takes the glyphs. Only what ends everything is returned. */
typedef struct mt_sink {
    mt_status (*start)(mt_making *making, void *user); /* before the first glyph, on one thread */
    /* *wanted: the pair is to be prepared. Each glyph that stays as it is comes once, on step 0. */
    mt_status (*begin)(mt_glyph_task *task, void *user, bool *wanted);
    /* Takes the prepared pair; with a status other than MT_OK it could not be prepared. */
    mt_status (*take)(mt_glyph_task *task, mt_status prepared, void *user);
    void *user;
} mt_sink;

enum { MT_SINKS_MAX = 2 };

struct mt_making {
    mt_row *row;
    bool varies; /* one font that varies is made, not fonts at single places */
    int units, glyph_count, step_count;
    mt_row_glyphs set;
    mt_composite *composites; /* of each glyph; NULL: none are looked for */
    int *order;               /* the glyphs by depth */
    mt_origin *origins;       /* of each glyph */
    mt_layout_tables layout;  /* the first font's substitutions, for the glyphs that are kept */
    const char **glyph_names; /* NULL: none */
    mt_positions *positions;
    mt_math *math; /* NULL: none */
    mt_sink sinks[MT_SINKS_MAX];
    int sink_count;
    int first, batch; /* the glyphs at hand are order[first … first + batch - 1] */
    mt_arena arena;   /* of all that is not a worker's */
    mt_thread_arenas kept;
};

/* Starts with the glyphs: those of `request`. The making is all zero but for its sinks and `varies`; it is to be ended whatever comes. As
 * mt_row_glyphs_make. */
mt_status mt_making_begin(mt_making *making, mt_row *row, const mt_charset_request *request);
/* The same with what a whole font has besides: the row's characters, composites, substitutions, names and positions.
 * MT_TOO_LARGE too. */
mt_status mt_making_begin_font(mt_making *making, mt_row *row);
/* Makes all glyphs. What the sinks give. */
mt_status mt_making_run(mt_making *making);
void mt_making_end(mt_making *making);

/* Tells the caller that a glyph could not be made, but for .notdef, which nobody asks for. `font` is the number of the one that
 * is the reason, -1 where there is none. */
void mt_making_report(mt_making *making, int glyph, int font, mt_status why);
/* The same of a task, whose pair knows the font. */
void mt_task_report(const mt_glyph_task *task, mt_status why);
/* Tells the caller that a task's glyph stays at a place, short of another one. */
void mt_task_report_held(const mt_glyph_task *task, mt_at at, mt_at asked);

/* Called with each font once all glyphs are made: an instance's number, a master's place on the axis (axis.h), 0 for a
 * variable font. A status other than MT_OK ends the making. */
typedef mt_status (*mt_font_ready)(const mt_font_data *data, int index, void *user);

/* Fills in what all fonts of the making have alike: glyph count, characters, glyph names, GSUB; for the sinks' `glyphs`. */
mt_font_data mt_making_font(const mt_making *making, mt_glyf *glyphs);
void mt_add_extra(mt_font_data *data, uint32_t tag, mt_bytes table); /* unless it is empty */
