#include "motion/timeline.h"

#include <math.h>

/* Linear spans a second, in place of an easing that cannot be cut. */
#define SPANS_A_SECOND 60

/* Seconds. Times are sums of decimals: what is nearer than this to a leg's start or end is there. */
#define SAME_TIME 1e-9

bool mt_timing_is_valid(const mt_timing *t) {
    return t->duration >= MT_DURATION_MIN && t->duration <= MT_DURATION_MAX && t->hold >= 0 &&
           t->hold <= MT_HOLD_MAX && mt_easing_is_valid(&t->easing) && t->plays >= 0 && t->fps >= 1 &&
           t->fps <= MT_FPS_MAX;
}

/* ---- legs ---------------------------------------------------------------------------------------------- */

static void add_leg(mt_timeline *line, double seconds, double from, double to, mt_easing easing) {
    if (seconds <= 0) return;
    line->legs[line->count++] = (mt_leg){line->length, line->length + seconds, from, to, easing};
    line->length += seconds;
}

static void stay(mt_timeline *line, const mt_timing *timing, double place) {
    add_leg(line, timing->hold, place, place, (mt_easing){0, 0, 1, 1});
}

mt_status mt_timeline_make(const mt_timing *timing, int stretch_count, mt_arena *arena,
                           mt_timeline *timeline) {
    int parts = timing->whole ? 1 : stretch_count;
    double stride = (double)stretch_count / parts, seconds = timing->duration / parts;
    mt_timeline made = {.stretch_count = stretch_count,
                        .legs = mt_arena_new(arena, 4 * (size_t)parts + 2, sizeof *made.legs)};
    if (!made.legs) return MT_NO_MEMORY;
    stay(&made, timing, 0);
    for (int i = 0; i < parts; i++) {
        add_leg(&made, seconds, i * stride, (i + 1) * stride, timing->easing);
        stay(&made, timing, (i + 1) * stride);
    }
    for (int i = parts; timing->yoyo && i > 0; i--) {
        add_leg(&made, seconds, i * stride, (i - 1) * stride, mt_easing_reversed(timing->easing));
        if (i > 1) stay(&made, timing, (i - 1) * stride);
    }
    *timeline = made;
    return MT_OK;
}

mt_moment mt_moment_of(double place, int stretch_count) {
    double stretch = fmin(fmax(floor(place), 0), stretch_count - 1);
    return (mt_moment){(int)stretch, place - stretch};
}

static double place_on(const mt_leg *leg, double time) {
    if (time < leg->start + SAME_TIME) return leg->from;
    if (time > leg->end - SAME_TIME) return leg->to;
    double progress = mt_easing_at(&leg->easing, (time - leg->start) / (leg->end - leg->start));
    return leg->from + (leg->to - leg->from) * progress;
}

mt_moment mt_timeline_at(const mt_timeline *timeline, double time) {
    int i = 0;
    while (i + 1 < timeline->count && time > timeline->legs[i].end - SAME_TIME) i++;
    return mt_moment_of(place_on(&timeline->legs[i], time), timeline->stretch_count);
}

/* ---- frames -------------------------------------------------------------------------------------------- */

/* The end of one stretch is the start of the next. */
static bool show_the_same(mt_moment a, mt_moment b) {
    return a.stretch + a.t == b.stretch + b.t;
}

mt_status mt_timeline_frames(const mt_timeline *timeline, const mt_timing *timing, mt_arena *arena,
                             mt_timed_frames *frames) {
    bool runs_on = timing->yoyo && timing->plays != 1;
    double count = fmax(round(timeline->length * timing->fps), 1);
    if (count > MT_FRAMES_MAX - 1) return MT_TOO_LARGE;
    int last = (int)count, all = runs_on ? last : last + 1;
    mt_timed_frames made = {0, mt_arena_new(arena, (size_t)all, sizeof *made.list), all};
    if (!made.list) return MT_NO_MEMORY;
    for (int i = 0; i < all; i++) {
        mt_moment moment = mt_timeline_at(timeline, timeline->length * i / last);
        if (made.count > 0 && show_the_same(made.list[made.count - 1].moment, moment))
            made.list[made.count - 1].length++;
        else
            made.list[made.count++] = (mt_timed_frame){moment, i, 1};
    }
    *frames = made;
    return MT_OK;
}

/* ---- spans --------------------------------------------------------------------------------------------- */

typedef struct mt_span_list {
    mt_spans spans;
    int room;
    mt_arena *arena;
} mt_span_list;

/* From one place to another, both on one stretch or its ends. */
static mt_status add_span(mt_span_list *list, double start, double end, double from, double to,
                          mt_easing easing, int stretch_count) {
    mt_span *grown =
        mt_arena_grow_list(list->arena, list->spans.list, list->spans.count, &list->room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    list->spans.list = grown;
    int stretch = mt_moment_of((from + to) / 2, stretch_count).stretch;
    /* What stays at a key frame stays on the stretch that led there. */
    if (from == to && list->spans.count > 0) stretch = grown[list->spans.count - 1].stretch;
    grown[list->spans.count++] = (mt_span){start, end, stretch, from - stretch, to - stretch, easing};
    return MT_OK;
}

/* The next place after `place` in the direction of `to` at which contours bend or a stretch ends; `to` at the most. */
static double next_bend(const int *steps, int stretch_count, double place, double to) {
    bool back = to < place;
    int stretch = mt_moment_of(place, stretch_count).stretch;
    if (back && place == stretch && stretch > 0) stretch--;
    double step = round((place - stretch) * steps[stretch]) + (back ? -1 : 1);
    double next = stretch + step / steps[stretch];
    return back ? fmax(next, to) : fmin(next, to);
}

/* The leg cut exactly at its bends; *fits tells whether its easing could be. */
static mt_status cut_leg(const mt_timeline *line, const mt_leg *leg, const int *steps, mt_span_list *list,
                         bool *fits) {
    double way = leg->to - leg->from, seconds = leg->end - leg->start;
    int before = list->spans.count;
    *fits = true;
    for (double place = leg->from, next; place != leg->to; place = next) {
        mt_easing_part part;
        next = next_bend(steps, line->stretch_count, place, leg->to);
        *fits = mt_easing_cut(&leg->easing, (place - leg->from) / way, (next - leg->from) / way, &part);
        if (!*fits) {
            list->spans.count = before;
            return MT_OK;
        }
        double start = leg->start + seconds * part.start, end = leg->start + seconds * part.end;
        mt_status status = add_span(list, start, end, place, next, part.easing, line->stretch_count);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* A straight way within a leg, cut where a stretch ends. */
static mt_status add_straight(const mt_timeline *line, double start, double end, double from, double to,
                              mt_span_list *list) {
    const mt_easing linear = {0, 0, 1, 1};
    double low = fmin(from, to), high = fmax(from, to), seam = floor(low) + 1;
    bool crosses = seam > low && seam < high && seam > 0 && seam < line->stretch_count;
    if (!crosses) return add_span(list, start, end, from, to, linear, line->stretch_count);
    double at = start + (end - start) * (seam - from) / (to - from);
    mt_status status = add_span(list, start, at, from, seam, linear, line->stretch_count);
    return status == MT_OK ? add_straight(line, at, end, seam, to, list) : status;
}

static mt_status sample_leg(const mt_timeline *line, const mt_leg *leg, mt_span_list *list) {
    int count = (int)ceil((leg->end - leg->start) * SPANS_A_SECOND);
    mt_status status = MT_OK;
    for (int i = 0; i < count && status == MT_OK; i++) {
        double start = leg->start + (leg->end - leg->start) * i / count;
        double end = leg->start + (leg->end - leg->start) * (i + 1) / count;
        status = add_straight(line, start, end, place_on(leg, start), place_on(leg, end), list);
    }
    return status;
}

mt_status mt_timeline_spans(const mt_timeline *timeline, const int *steps, mt_arena *arena, mt_spans *spans) {
    mt_span_list list = {.arena = arena};
    for (int i = 0; i < timeline->count; i++) {
        const mt_leg *leg = &timeline->legs[i];
        bool fits = true;
        mt_status status = leg->from == leg->to ? add_span(&list, leg->start, leg->end, leg->from, leg->to,
                                                           leg->easing, timeline->stretch_count)
                                                : cut_leg(timeline, leg, steps, &list, &fits);
        if (status == MT_OK && !fits) status = sample_leg(timeline, leg, &list);
        if (status != MT_OK) return status;
    }
    *spans = list.spans;
    return MT_OK;
}
