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

#include "font/composite.h"
#include "font/extent.h"
#include "font/pair.h"
#include "font/save.h"
#include "layout/gsub_subset.h"
#include "layout/kerning.h"

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

typedef struct mt_job {
    mt_blend *blend;
    const mt_charset *charset;
    const double *t;
    int t_count, units;
    mt_font_ready ready;
    void *user;
    mt_layout_tables layout;
    const char **glyph_names; /* NULL: none */
    mt_positions *positions;
    mt_glyf **glyphs;    /* for each T, one for each glyph of the charset */
    mt_extent **extents; /* as many */
    bool *failed;        /* for each glyph: it could not be blended */
    mt_composite *composites;
    int *order; /* the glyphs by depth */
    int end;    /* of the depth at hand, in the order */
    atomic_int next, done;
    atomic_int status;     /* the first that stops everything */
    pthread_mutex_t fonts; /* FreeType's faces are not for two threads at once; neither are the callbacks */
} mt_job;

typedef struct mt_worker {
    mt_job *job;
    mt_arena scratch, kept;
} mt_worker;

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

/* blend_run.c: all glyphs, by the workers, whose results belong to them. `composites` and `order` must be set. */
int mt_job_worker_count(const mt_job *job);
void mt_job_order(mt_job *job); /* sorts the glyphs by depth, and keeps their order otherwise */
mt_status mt_job_run(mt_job *job, mt_worker *workers, int count);

#endif
