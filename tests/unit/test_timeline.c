/* Easing curves and the timeline of a play. */
#include "motion/timeline.h"

#include <math.h>

#include "support/check.h"
#include "support/random.h"

#define CLOSE 1e-9

static const mt_easing linear = {0, 0, 1, 1};

static mt_easing named(const char *name) {
    mt_easing easing;
    assert_true(mt_easing_named(name, &easing));
    return easing;
}

/* ---- easing -------------------------------------------------------------------------------------------- */

/* Half-way, as Chromium and the reference implementation of bezier-easing give it. */
static void names_are_those_of_css(void **state) {
    (void)state;
    static const struct {
        const char *name;
        double half;
    } rows[] = {{"linear", 0.5},
                {"ease", 0.8024033877},
                {"ease-in", 0.3153568126},
                {"ease-out", 0.6846431874},
                {"ease-in-out", 0.5}};
    for (int i = 0; i < 5; i++) {
        mt_easing easing = named(rows[i].name);
        assert_true(fabs(mt_easing_at(&easing, 0.5) - rows[i].half) < 1e-6);
        assert_true(mt_easing_at(&easing, 0) == 0 && mt_easing_at(&easing, 1) == 1);
    }
    mt_easing none;
    assert_false(mt_easing_named("bounce", &none));
    assert_false(mt_easing_named("", &none));
}

static mt_easing random_easing(mt_random *random) {
    double v[4];
    for (int i = 0; i < 4; i++) v[i] = mt_random_between(random, 0, 1000) / 1000.0;
    return (mt_easing){v[0], v[1], v[2], v[3]};
}

/* A part that is cut out goes the way that the whole goes there. */
static void parts_go_the_same_way(void **state) {
    (void)state;
    int cut = 0;
    for (int k = 0; k < mt_test_cases(300); k++) {
        mt_random random = mt_random_case(k);
        mt_easing whole = random_easing(&random);
        double from = mt_random_between(&random, 0, 499) / 1000.0;
        double to = from + (1 + mt_random_between(&random, 0, 499)) / 1000.0;
        mt_easing_part part;
        if (!mt_easing_cut(&whole, from, to, &part)) continue;
        cut++;
        for (int i = 0; i <= 8; i++) {
            double time = part.start + (part.end - part.start) * i / 8;
            double own = from + (to - from) * mt_easing_at(&part.easing, i / 8.0);
            assert_true(fabs(mt_easing_at(&whole, time) - own) < 1e-6);
        }
    }
    assert_true(cut > 100);
}

static void what_overshoots_is_not_cut(void **state) {
    (void)state;
    const mt_easing back = {0.34, 1.56, 0.64, 1};
    mt_easing_part part;
    assert_true(mt_easing_is_valid(&back));
    assert_true(mt_easing_at(&back, 0.7) > 1);
    assert_false(mt_easing_cut(&back, 0, 0.5, &part));
    assert_false(mt_easing_is_valid(&(mt_easing){-0.1, 0, 1, 1}));
    assert_false(mt_easing_is_valid(&(mt_easing){0, 0, NAN, 1}));
    assert_false(mt_easing_is_valid(&(mt_easing){0, 3.1, 1, 1}));
}

static void the_way_back_mirrors(void **state) {
    (void)state;
    mt_easing in = named("ease-in"), back = mt_easing_reversed(in);
    for (int i = 0; i <= 10; i++)
        assert_true(fabs(mt_easing_at(&back, i / 10.0) - (1 - mt_easing_at(&in, 1 - i / 10.0))) < CLOSE);
}

/* ---- timeline ------------------------------------------------------------------------------------------ */

static mt_timing timing_of(double duration, double hold, bool yoyo, bool whole) {
    return (mt_timing){
        .duration = duration, .hold = hold, .easing = linear, .yoyo = yoyo, .whole = whole, .fps = 10};
}

static mt_timeline line_of(const mt_timing *timing, int stretches, mt_arena *arena) {
    mt_timeline line;
    assert_true(mt_timing_is_valid(timing));
    mt_assert_ok(mt_timeline_make(timing, stretches, arena, &line));
    return line;
}

static void assert_place(const mt_timeline *line, double time, double place) {
    mt_moment moment = mt_timeline_at(line, time);
    assert_true(moment.stretch >= 0 && moment.stretch < line->stretch_count);
    assert_true(fabs(moment.stretch + moment.t - place) < CLOSE);
}

static void holds_and_comes_back(void **state) {
    (void)state;
    mt_arena arena = {0};
    mt_timing timing = timing_of(2, 0.5, true, false);
    mt_timeline line = line_of(&timing, 2, &arena);
    assert_true(fabs(line.length - 6) < CLOSE); /* .5 1 .5 1 .5 1 .5 1 */
    static const double at[][2] = {{0, 0},   {0.4, 0}, {1, 0.5}, {1.7, 1},   {2.5, 1.5},
                                   {3.2, 2}, {4, 1.5}, {4.7, 1}, {5.5, 0.5}, {6, 0}};
    for (int i = 0; i < 10; i++) assert_place(&line, at[i][0], at[i][1]);
    timing = timing_of(2, 0.5, false, true);
    line = line_of(&timing, 2, &arena);
    assert_true(fabs(line.length - 3) < CLOSE);
    assert_place(&line, 1.5, 1);
    assert_place(&line, 2.75, 2);
    mt_arena_release(&arena);
}

/* The frames of a play count up without a gap, begin with the first key frame and end with the last. */
static void frames_have_both_ends(void **state) {
    (void)state;
    mt_arena arena = {0};
    mt_timed_frames frames;
    mt_timing timing = timing_of(1, 0.3, false, false);
    mt_timeline line = line_of(&timing, 1, &arena);
    mt_assert_ok(mt_timeline_frames(&line, &timing, &arena, &frames));
    assert_int_equal(frames.all, 17);
    int next = 0;
    for (int i = 0; i < frames.count; i++) {
        assert_int_equal(frames.list[i].number, next);
        next += frames.list[i].length;
    }
    assert_int_equal(next, frames.all);
    assert_true(frames.list[0].moment.t == 0 && frames.list[0].length == 4);
    assert_true(frames.list[frames.count - 1].moment.t == 1 && frames.list[frames.count - 1].length == 4);
    timing = timing_of(1, 0, true, false);
    line = line_of(&timing, 1, &arena);
    mt_assert_ok(mt_timeline_frames(&line, &timing, &arena, &frames));
    assert_int_equal(frames.all, 20); /* the next play has the last one */
    timing = timing_of(600, 0, false, false);
    timing.fps = MT_FPS_MAX;
    line = line_of(&timing, 1, &arena);
    assert_int_equal(mt_timeline_frames(&line, &timing, &arena, &frames), MT_TOO_LARGE);
    mt_arena_release(&arena);
}

/* Spans follow one another, are on one stretch each, end at each bend, and lead where the timeline does. */
static void check_spans(const mt_timeline *line, const int *steps, const mt_spans *spans, double bound) {
    double time = 0;
    for (int i = 0; i < spans->count; i++) {
        const mt_span *span = &spans->list[i];
        assert_true(fabs(span->start - time) < CLOSE && span->end > span->start);
        assert_true(span->stretch >= 0 && span->stretch < line->stretch_count);
        double low = fmin(span->from, span->to) * steps[span->stretch];
        double high = fmax(span->from, span->to) * steps[span->stretch];
        assert_true(bound > CLOSE || floor(low + CLOSE) + 1 >= high - CLOSE);
        for (int k = 1; k < 4; k++) {
            double own = span->from + (span->to - span->from) * mt_easing_at(&span->easing, k / 4.0);
            mt_moment moment = mt_timeline_at(line, span->start + (span->end - span->start) * k / 4);
            assert_true(fabs(span->stretch + own - moment.stretch - moment.t) < bound);
        }
        time = span->end;
    }
    assert_true(fabs(time - line->length) < CLOSE);
}

static void spans_lead_where_the_timeline_does(void **state) {
    (void)state;
    static const int steps[] = {1, 2, 5};
    static const mt_easing easings[] = {{0.42, 0, 0.58, 1}, {0.25, 0.1, 0.25, 1}, {0, 0, 1, 1}};
    for (int i = 0; i < 12; i++) {
        mt_arena arena = {0};
        mt_spans spans;
        mt_timing timing = timing_of(3, i & 1 ? 0.25 : 0, i & 2, i >= 6);
        timing.easing = easings[i % 3];
        mt_timeline line = line_of(&timing, 3, &arena);
        mt_assert_ok(mt_timeline_spans(&line, steps, &arena, &spans));
        check_spans(&line, steps, &spans, 1e-6);
        mt_arena_release(&arena);
    }
}

static void an_overshoot_is_followed_closely(void **state) {
    (void)state;
    static const int steps[] = {1, 2};
    mt_arena arena = {0};
    mt_spans spans;
    mt_timing timing = timing_of(2, 0, true, true);
    timing.easing = (mt_easing){0.34, 1.56, 0.64, 1};
    mt_timeline line = line_of(&timing, 2, &arena);
    mt_assert_ok(mt_timeline_spans(&line, steps, &arena, &spans));
    check_spans(&line, steps, &spans, 0.01);
    double most = 0;
    for (int i = 0; i < spans.count; i++) most = fmax(most, spans.list[i].stretch + spans.list[i].to);
    assert_true(most > 2.1);
    mt_arena_release(&arena);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_are_those_of_css),
        cmocka_unit_test(parts_go_the_same_way),
        cmocka_unit_test(what_overshoots_is_not_cut),
        cmocka_unit_test(the_way_back_mirrors),
        cmocka_unit_test(holds_and_comes_back),
        cmocka_unit_test(frames_have_both_ends),
        cmocka_unit_test(spans_lead_where_the_timeline_does),
        cmocka_unit_test(an_overshoot_is_followed_closely),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
