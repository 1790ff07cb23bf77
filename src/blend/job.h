/* Inside a blend: shared by the files that make its fonts, and by nothing else.
 *
 * A glyph is the unit of work. Workers take the next one from a counter; each has an arena for the glyph at
 * hand, emptied after it, and one for the results. A glyph is read and prepared once for all values of T.
 * Results stand in the order of the glyphs, whoever made them, so that the fonts do not depend on the number
 * of workers. Composites wait until all of their parts are made: they are made depth by depth.
 */
#ifndef MT_BLEND_JOB_H
#define MT_BLEND_JOB_H

#include <pthread.h>
#include <stdatomic.h>

#include "blend/composite.h"
#include "blend/pair.h"
#include "blend/track.h"
#include "gpos/kerning.h"
#include "gsub/subset.h"
#include "save/save.h"
#include "sfnt/sfnt.h"
#include "write/extent.h"

struct mt_blend {
    mt_font *a, *b;
    mt_params params;
    mt_hint_index *hints; /* NULL: none */
    char *family;         /* NULL: made from the sources' */
    uint32_t *wanted;
    int wanted_count;
    mt_glyph_set set;
    int unblended; /* glyphs of the last fonts */
    mt_glyph_failed failed;
    mt_progress progress;
    void *failed_user, *progress_user;
};

typedef struct mt_worker mt_worker;

typedef struct mt_job {
    mt_blend *blend;
    mt_status (*make)(mt_worker *worker,
                      int glyph); /* makes one glyph; only what ends the whole run is returned */
    const mt_charset *charset;
    const double *t;
    int t_count, units;
    mt_font_ready ready;
    void *user;
    mt_layout_tables layout;
    const char **glyph_names; /* NULL: none */
    mt_positions *positions;
    mt_worker *workers; /* of a variable font, whose passages belong to them */
    int worker_count;
    int from, to;         /* of a variable font: the part of the axis between these two fonts */
    mt_passage *passages; /* of a variable font: one for each glyph; its T are none */
    mt_glyf **glyphs;     /* for each T, one for each glyph of the charset */
    mt_extent **extents;  /* as many */
    bool *failed;         /* for each glyph: it could not be blended */
    mt_composite *composites;
    int *order; /* the glyphs by depth */
    int end;    /* of the depth at hand, in the order */
    atomic_int next, done;
    atomic_int status;     /* the first that stops everything */
    pthread_mutex_t fonts; /* FreeType's faces are not for two threads at once; neither are the callbacks */
} mt_job;

struct mt_worker {
    mt_job *job;
    mt_arena scratch, kept;
};

/* A place between the fonts; false for a NaN. */
static inline bool mt_is_place(double t) {
    return t >= 0 && t <= 1;
}

/* Grid units. */
static inline double mt_mixed_advance(const mt_glyph_pair *pair, double t) {
    return (1 - t) * pair->advance_a + t * pair->advance_b;
}

/* blend_glyph.c: one glyph at every T, its parts made. Only what ends the whole run is returned. */
mt_status mt_job_glyph(mt_worker *worker, int glyph);
/* Its metrics in both fonts, 0 where they cannot be read; where B has it not, A's on both sides. MT_NO_MEMORY. */
mt_status mt_job_read_metrics(mt_worker *worker, mt_pairing p, mt_glyph_pair *pair);
/* Its shapes in both fonts, or in A alone where B has it not; one that cannot be read is empty, and its status is returned. */
mt_status mt_job_read_shapes(mt_worker *worker, mt_pairing p, mt_glyph_pair *pair);
void mt_job_report(mt_job *job, int glyph, mt_status why); /* that it could not be blended */

/* variable_glyph.c: one glyph on its way from A to B, as contours that move. Only what ends the whole run is returned. */
mt_status mt_job_moving_glyph(mt_worker *worker, int glyph);

/* blend_make.c: room for what the glyphs of the charset become, which of them are composites, and their order. */
mt_status mt_job_start(mt_job *job, mt_arena *arena);
/* The first font's substitutions and the names, for the glyphs that are kept. */
mt_status mt_job_layout(mt_job *job, mt_arena *arena);
void mt_add_extra(mt_font_data *data, uint32_t tag, mt_bytes table); /* unless it is empty */

/* blend_run.c: all glyphs, by the workers, whose results belong to them. `composites` and `order` must be set. */
int mt_job_worker_count(const mt_job *job);
void mt_job_order(mt_job *job); /* sorts the glyphs by depth, and keeps their order otherwise */
mt_status mt_job_run(mt_job *job, mt_worker *workers, int count);

#endif
