#include "motion/runs.h"

static mt_status find_spans(const mt_motion *motion, mt_arena *arena, mt_spans *spans) {
    int *steps = mt_arena_new(arena, (size_t)motion->stretch_count, sizeof *steps);
    if (!steps) return MT_NO_MEMORY;
    for (int i = 0; i < motion->stretch_count; i++) steps[i] = motion->stretches[i].steps;
    return mt_timeline_spans(&motion->timeline, steps, arena, spans);
}

/* The run of spans `first` … end - 1 in a play of `length` seconds. */
static mt_status make_run(const mt_spans *spans, int first, int end, double length, mt_arena *arena,
                          mt_run *run) {
    *run = (mt_run){0, mt_arena_new(arena, (size_t)(end - first) + 1, sizeof *run->times)};
    if (!run->times) return MT_NO_MEMORY;
    for (int i = first; i < end; i++) {
        const mt_span *span = &spans->list[i];
        run->times[run->count++] =
            (mt_key_time){span->start / length, {span->stretch, span->from}, span->easing};
    }
    const mt_span *last = &spans->list[end - 1];
    bool ends = end == spans->count;
    run->times[run->count++] =
        (mt_key_time){ends ? 1 : last->end / length, {last->stretch, last->to}, {0, 0, 1, 1}};
    return MT_OK;
}

static size_t segments_of(const mt_stretch *stretch) {
    size_t count = 0;
    for (int i = 0; i < stretch->pairs.count; i++)
        for (int k = 0; k < stretch->parts[i].contours.count; k++)
            count += (size_t)stretch->parts[i].contours.contours[k].a.count;
    return count;
}

/* A run has a key time more than it has spans. */
static mt_status check_size(const mt_motion *motion, const mt_spans *spans) {
    size_t all = 0;
    for (int i = 0; i < spans->count && all <= MT_KEY_SEGMENTS_MAX; i++) {
        bool ends = i + 1 == spans->count || spans->list[i + 1].stretch != spans->list[i].stretch;
        all += segments_of(&motion->stretches[spans->list[i].stretch]) * (ends ? 2 : 1);
    }
    return all <= MT_KEY_SEGMENTS_MAX ? MT_OK : MT_TOO_LARGE;
}

mt_status mt_runs_make(const mt_motion *motion, mt_arena *arena, mt_runs *runs) {
    mt_spans spans;
    mt_status status = find_spans(motion, arena, &spans);
    if (status == MT_OK) status = check_size(motion, &spans);
    if (status != MT_OK) return status;
    mt_runs made = {0, mt_arena_new(arena, (size_t)spans.count, sizeof *made.list)};
    if (!made.list) return MT_NO_MEMORY;
    for (int i = 0, end; i < spans.count && status == MT_OK; i = end) {
        for (end = i + 1; end < spans.count && spans.list[end].stretch == spans.list[i].stretch;) end++;
        status = make_run(&spans, i, end, motion->timeline.length, arena, &made.list[made.count++]);
    }
    if (status == MT_OK) *runs = made;
    return status;
}
