/* Which figures of a glyph are out of their limits: in numbers, to sort by, and in words. */
#include "geometry/limits.h"
#include "report/report.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

/* A glyph that could not be made comes before all others, whatever is wrong with those. */
#define FAILED_SEVERITY 1000.0
/* So many crumbs weigh as much as a component too many. */
#define CRUMBS_PER_PART 4.0

/* ---- excesses ------------------------------------------------------------------------------------------ */

static double larger_ink(const mt_report_glyph *glyph) {
    return fmax(glyph->ink_a.area, glyph->ink_b.area);
}

double mt_report_ink_excess(const mt_report_glyph *glyph, int step) {
    return mt_area_excess(glyph->ink[step].area, glyph->ink_a.area, glyph->ink_b.area);
}

double mt_report_ink_bend(const mt_report_glyph *glyph) {
    double bend = 0, most = larger_ink(glyph);
    for (int i = 0; most > 0 && i < MT_REPORT_STEPS; i++) {
        double t = mt_report_t(i), straight = (1 - t) * glyph->ink_a.area + t * glyph->ink_b.area;
        double off = (glyph->ink[i].area - straight) / most;
        if (fabs(off) > fabs(bend)) bend = off;
    }
    return bend;
}

static int larger(int a, int b) {
    return a > b ? a : b;
}

int mt_report_kinks(const mt_report_glyph *glyph) {
    const mt_report_drawing *a = &glyph->drawing_a, *b = &glyph->drawing_b, *half = &glyph->drawing_half;
    int slight = half->slight - larger(a->slight, b->slight);
    int corners = half->corners - larger(a->corners, b->corners);
    return larger(0, slight < corners ? slight : corners);
}

static int larger_points(const mt_report_glyph *glyph) {
    return larger(glyph->drawing_a.points, glyph->drawing_b.points);
}

int mt_report_kinks_limit(const mt_report_glyph *glyph) {
    return MT_REPORT_KINKS + larger_points(glyph) / MT_REPORT_KINKS_POINTS;
}

int mt_report_points_limit(const mt_report_glyph *glyph) {
    return MT_REPORT_POINTS_TIMES * larger_points(glyph) + MT_REPORT_POINTS_MORE;
}

/* How far one of the counts at a place is out of the ends' range. */
static double excess_at(const mt_report_glyph *glyph, mt_report_flag flag, int step) {
    const mt_topology *a = &glyph->ink_a, *b = &glyph->ink_b, *at = &glyph->ink[step];
    switch (flag) {
    case MT_FLAG_COMPONENTS: return mt_count_excess(at->components, a->components, b->components);
    case MT_FLAG_HOLES: return mt_count_excess(at->holes, a->holes, b->holes);
    case MT_FLAG_CRUMBS: return fmax(0, at->crumbs - fmax(a->crumbs, b->crumbs));
    default: return mt_report_ink_excess(glyph, step);
    }
}

/* The place that is furthest out; of several the first. */
static int worst_step(const mt_report_glyph *glyph, mt_report_flag flag) {
    int worst = 0;
    for (int i = 1; i < MT_REPORT_STEPS; i++)
        if (excess_at(glyph, flag, i) > excess_at(glyph, flag, worst)) worst = i;
    return worst;
}

static double worst_excess(const mt_report_glyph *glyph, mt_report_flag flag) {
    return excess_at(glyph, flag, worst_step(glyph, flag));
}

/* ---- the judgement ------------------------------------------------------------------------------------- */

/* A figure relative to its limit; 0 where it is within. */
static double over(double figure, double limit) {
    return figure > limit ? figure / limit : 0;
}

/* What a flag adds to the severity; 0 where it is not raised. */
static double weigh(const mt_report_glyph *glyph, mt_report_flag flag) {
    switch (flag) {
    case MT_FLAG_FAILED: return glyph->status != MT_OK ? FAILED_SEVERITY : 0;
    case MT_FLAG_COMPONENTS:
    case MT_FLAG_HOLES: return worst_excess(glyph, flag);
    case MT_FLAG_CRUMBS: return worst_excess(glyph, flag) / CRUMBS_PER_PART;
    case MT_FLAG_INK: return over(worst_excess(glyph, flag), MT_INK_EXCESS);
    case MT_FLAG_POINTS: return over(glyph->drawing_half.points, mt_report_points_limit(glyph));
    default: return over(mt_report_kinks(glyph), mt_report_kinks_limit(glyph));
    }
}

void mt_report_judge(mt_report_glyph *glyph) {
    glyph->flags = 0;
    glyph->severity = 0;
    for (unsigned flag = 1; flag <= MT_FLAG_ALL; flag <<= 1) {
        double weight = weigh(glyph, (mt_report_flag)flag);
        if (weight > 0) glyph->flags |= flag;
        glyph->severity += weight;
    }
}

/* ---- words --------------------------------------------------------------------------------------------- */

const char *mt_report_method_name(mt_report_method method) {
    static const char *const names[] = {"aligned", "linked", "both"};
    return names[method];
}

const char *mt_report_flag_name(mt_report_flag flag) {
    switch (flag) {
    case MT_FLAG_FAILED: return "failed";
    case MT_FLAG_COMPONENTS: return "components";
    case MT_FLAG_HOLES: return "holes";
    case MT_FLAG_INK: return "ink";
    case MT_FLAG_POINTS: return "points";
    case MT_FLAG_KINKS: return "kinks";
    default: return "crumbs";
    }
}

static const char *step_name(int step) {
    static const char *const names[MT_REPORT_STEPS] = {"0",     "0.125", "0.25",  "0.375", "0.5",
                                                       "0.625", "0.75",  "0.875", "1"};
    return names[step];
}

static void say_count(char *text, const char *what, int count, int step, int a, int b) {
    snprintf(text, MT_REPORT_REASON_ROOM, "%d %s%s at T = %s, the ends have %d and %d", count, what,
             count == 1 ? "" : "s", step_name(step), a, b);
}

/* Digits by hand: the C library's point is another one in some locales. */
static void say_ink(const mt_report_glyph *glyph, char *text) {
    int step = worst_step(glyph, MT_FLAG_INK);
    int64_t tenths = llround(1000 * mt_report_ink_excess(glyph, step));
    snprintf(text, MT_REPORT_REASON_ROOM, "ink %" PRId64 ".%" PRId64 " %% %s the ends' at T = %s",
             tenths / 10, tenths % 10, glyph->ink[step].area > larger_ink(glyph) ? "over" : "under",
             step_name(step));
}

void mt_report_reason(const mt_report_glyph *glyph, mt_report_flag flag, char text[MT_REPORT_REASON_ROOM]) {
    int step = worst_step(glyph, flag);
    const mt_topology *a = &glyph->ink_a, *b = &glyph->ink_b, *at = &glyph->ink[step];
    const mt_report_drawing *p = &glyph->drawing_a, *q = &glyph->drawing_b, *half = &glyph->drawing_half;
    switch (flag) {
    case MT_FLAG_FAILED: snprintf(text, MT_REPORT_REASON_ROOM, "%s", mt_status_text(glyph->status)); break;
    case MT_FLAG_COMPONENTS:
        say_count(text, "component", at->components, step, a->components, b->components);
        break;
    case MT_FLAG_HOLES: say_count(text, "hole", at->holes, step, a->holes, b->holes); break;
    case MT_FLAG_CRUMBS: say_count(text, "crumb", at->crumbs, step, a->crumbs, b->crumbs); break;
    case MT_FLAG_INK: say_ink(glyph, text); break;
    case MT_FLAG_POINTS: say_count(text, "point", half->points, MT_REPORT_HALF, p->points, q->points); break;
    default:
        snprintf(text, MT_REPORT_REASON_ROOM, "%d kinks half-way, over the %d that are let pass",
                 mt_report_kinks(glyph), mt_report_kinks_limit(glyph));
    }
}
