/* The sink for variable fonts. On its step a track has one segment of contours that move, or two of outlines that stay. Points
 * move on straight lines; where a rotation or a displacement bends their way, on several lines one after the other. */
#include "blend/outlines.h"

#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/between/variable_outline.h"
#include "sfnt/axis.h"

/* With rotation, how far a point may be from the way that formula (5) takes it, 1/1000 em. */
#define TURN_WITHIN 1.0

/* ---- places -------------------------------------------------------------------------------------------- */

static mt_status start(mt_making *making, void *user) {
    mt_outlines *outlines = user;
    int steps = making->step_count;
    outlines->tracks = mt_arena_new(&making->arena, (size_t)steps, sizeof *outlines->tracks);
    if (!outlines->tracks) return MT_NO_MEMORY;
    for (int i = 0; i < steps; i++) {
        outlines->tracks[i] =
            mt_arena_new(&making->arena, (size_t)making->glyph_count, sizeof(mt_glyph_track));
        if (!outlines->tracks[i]) return MT_NO_MEMORY;
    }
    return MT_OK;
}

mt_between mt_outlines_between(const mt_outlines *outlines, int place) {
    int step = 0;
    const int *places = outlines->stops.at;
    while (step + 2 < outlines->stops.count && place > places[step + 1]) step++;
    double length = places[step + 1] - places[step];
    return (mt_between){step, (place - places[step]) / length};
}

/* The part of the axis that the step at hand has: a font between two steps belongs to the first of them. */
typedef struct mt_stretch {
    int from, to;
} mt_stretch;

static mt_stretch stretch_of(const mt_glyph_task *task, const mt_outlines *outlines) {
    int step = task->step;
    return (mt_stretch){outlines->stops.at[step] + (step > 0), outlines->stops.at[step + 1]};
}

static int *new_places(const mt_glyph_task *task, int count) {
    return mt_arena_new(task->kept, (size_t)count, sizeof(int));
}

static mt_status new_segments(const mt_glyph_task *task, int count, mt_glyph_track *track) {
    track->segments = mt_arena_new(task->kept, (size_t)count, sizeof *track->segments);
    if (!track->segments) return MT_NO_MEMORY;
    track->segment_count = count;
    return MT_OK;
}

/* ---- outlines that stay -------------------------------------------------------------------------------- */

/* An outline that stays as it is between two places, and where the font stands without a setting, if that is between them. */
static mt_status stay(const mt_glyph_task *task, const mt_outline *outline, mt_stretch stretch,
                      mt_track_segment *segment) {
    enum { PLACES_MOST = 3 };
    int *places = new_places(task, PLACES_MOST), count = 0;
    const mt_outline all[PLACES_MOST] = {*outline, *outline, *outline};
    if (!places) return MT_NO_MEMORY;
    places[count++] = stretch.from;
    if (stretch.from < 0 && stretch.to > 0) places[count++] = 0;
    places[count++] = stretch.to;
    return mt_track_segment_make(all, places, count, task->making->units, task->kept, task->scratch, segment);
}

static mt_status stay_as(const mt_glyph_task *task, const mt_shape *shape, mt_stretch stretch,
                         mt_track_segment *segment) {
    mt_outline outline, blank = {0};
    mt_status status = mt_shape_outline(shape, &task->making->row->params, task->scratch, &outline);
    if (status == MT_OK) status = stay(task, &outline, stretch, segment);
    status = mt_arena_verdict(task->scratch, status);
    bool too_much = status == MT_TOO_LARGE || status == MT_TOO_COSTLY;
    return too_much ? stay(task, &blank, stretch, segment) : status;
}

/* A glyph that some font has not: the first font's own, on the whole axis. */
static mt_status keep_own(const mt_glyph_task *task, const mt_stops *stops, mt_glyph_track *track) {
    mt_status status = new_segments(task, 1, track);
    if (status != MT_OK) return status;
    mt_stretch whole = {stops->at[0], stops->at[stops->count - 1]};
    return stay_as(task, &task->pair.a, whole, &track->segments[0]);
}

/* The nearer font's own outline; half-way, B's. */
static mt_status fall_back(const mt_glyph_task *task, mt_stretch stretch, mt_glyph_track *track) {
    int half = stretch.from + (stretch.to - stretch.from + 1) / 2;
    mt_stretch before = {stretch.from, half - 1}, after = {half, stretch.to};
    mt_status status = new_segments(task, 2, track);
    if (status == MT_OK) status = stay_as(task, &task->pair.a, before, &track->segments[0]);
    if (status == MT_OK) status = stay_as(task, &task->pair.b, after, &track->segments[1]);
    return status;
}

/* ---- contours that move -------------------------------------------------------------------------------- */

/* Whether the contours lie over one another, or themselves, at one of some places on the way. */
static mt_status find_overlap(const mt_glyph_task *task, const mt_variable_outline *moving, bool *overlaps) {
    enum { LOOKS = 4 };
    mt_outline outline;
    mt_shape shape;
    double tolerance = mt_grid_units(task->making->row->params.tolerance) / MT_OVERLAP_CARE;
    bool clean = true;
    for (int i = 0; i <= LOOKS && clean; i++) {
        mt_arena_place before = mt_arena_mark(task->scratch);
        mt_weights weights = mt_weights_at((double)i / LOOKS);
        mt_status status =
            mt_variable_outline_at(&task->pair.morph, moving, weights, task->scratch, &outline);
        if (status == MT_OK) status = mt_outline_resolve(&outline, tolerance, task->scratch, &shape, &clean);
        mt_arena_rewind(task->scratch, before);
        if (status != MT_OK) return status;
    }
    *overlaps = !clean;
    return MT_OK;
}

static mt_status draw_straight(const mt_glyph_task *task, const mt_variable_outline *moving,
                               mt_stretch stretch, int count, mt_track_segment *segment) {
    int *places = new_places(task, count + 1);
    mt_outline *drawn = mt_arena_new(task->scratch, (size_t)count + 1, sizeof *drawn);
    if (!places || !drawn) return MT_NO_MEMORY;
    for (int i = 0; i <= count; i++) {
        mt_weights weights = mt_weights_at((double)i / count);
        mt_status status =
            mt_variable_outline_at(&task->pair.morph, moving, weights, task->scratch, &drawn[i]);
        if (status != MT_OK) return status;
        places[i] = stretch.from + (int)((int64_t)(stretch.to - stretch.from) * i / count);
    }
    return mt_track_segment_make(drawn, places, count + 1, task->making->units, task->kept, task->scratch,
                                 segment);
}

static mt_status move(const mt_glyph_task *task, mt_stretch stretch, mt_glyph_track *track) {
    const mt_morph *morph = &task->pair.morph;
    mt_variable_outline moving;
    mt_status status = mt_variable_outline_make(morph, &task->making->row->params, task->scratch, &moving);
    if (status == MT_OK) status = new_segments(task, 1, track);
    if (status != MT_OK) return status;
    int count = mt_variable_outline_steps(morph, &moving, mt_grid_units(TURN_WITHIN));
    status = draw_straight(task, &moving, stretch, count, &track->segments[0]);
    if (status == MT_OK) status = find_overlap(task, &moving, &track->segments[0].overlaps);
    return status;
}

/* ---- the sink ------------------------------------------------------------------------------------------ */

/* A composite's parts move; it has no contours of its own. */
static mt_status begin(mt_glyph_task *task, void *user, bool *wanted) {
    const mt_outlines *outlines = user;
    mt_glyph_track *track = &outlines->tracks[task->step][task->glyph];
    track->room_a = task->pair.room_a;
    track->room_b = task->pair.room_b;
    *wanted = task->making->composites[task->glyph].count == 0;
    return MT_OK;
}

static mt_status take(mt_glyph_task *task, mt_status prepared, void *user) {
    const mt_outlines *outlines = user;
    mt_glyph_track *track = &outlines->tracks[task->step][task->glyph];
    mt_stretch stretch = stretch_of(task, outlines);
    mt_status status = prepared;
    if (status == MT_OK)
        status =
            task->b == MT_NO_PARTNER ? keep_own(task, &outlines->stops, track) : move(task, stretch, track);
    status = mt_arena_verdict(task->scratch, status);
    if (status == MT_OK || status == MT_NO_MEMORY) return status;
    mt_task_report(task, status);
    mt_pair_allow(task->making->row, task->scratch);
    return fall_back(task, stretch, track);
}

mt_sink mt_outlines_sink(mt_outlines *outlines) {
    return (mt_sink){start, begin, take, outlines};
}
