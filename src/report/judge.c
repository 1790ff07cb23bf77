/* Which figures of a glyph are out of their limits: in numbers, to sort by, and in words. */
#include "geometry/limits.h"
#include "report/report.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

/* A glyph that could not be made comes before all others, whatever is wrong with those. */
#define FAILED_SEVERITY 1000.0

/* ---- measures ------------------------------------------------------------------------------------------ */

static double larger_ink(const mt_report_glyph *glyph) {
    return fmax(glyph->ink_a.area, glyph->ink_b.area);
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

/* How much there is of what a flag tells at a place: counts out of the ends' range, or what an eye minds, where 1 is too much. */
static double amount_at(const mt_report_glyph *glyph, mt_report_flag flag, int step) {
    const mt_topology *a = &glyph->ink_a, *b = &glyph->ink_b, *at = &glyph->ink[step];
    const mt_appearance *seen = &glyph->seen[step];
    switch (flag) {
    case MT_FLAG_COMPONENTS: return mt_count_excess(at->components, a->components, b->components);
    case MT_FLAG_HOLES: return mt_count_excess(at->holes, a->holes, b->holes);
    case MT_FLAG_STRAYS: return seen->strays / MT_STRAYS_MOST;
    case MT_FLAG_CLOTS: return (seen->clots - 1) / MT_CLOTS_MOST;
    default: return seen->ink / MT_INK_MOST;
    }
}

/* The place where there is most; of several the first. */
static int worst_step(const mt_report_glyph *glyph, mt_report_flag flag) {
    int worst = 0;
    for (int i = 1; i < MT_REPORT_STEPS; i++)
        if (amount_at(glyph, flag, i) > amount_at(glyph, flag, worst)) worst = i;
    return worst;
}

static int parts_at(const mt_report_glyph *glyph, int step) {
    return (int)amount_at(glyph, MT_FLAG_COMPONENTS, step) + (int)amount_at(glyph, MT_FLAG_HOLES, step);
}

static int parts_of(const mt_report_glyph *glyph) {
    int parts = 0;
    for (int i = 0; i < MT_REPORT_STEPS; i++) parts += parts_at(glyph, i);
    return parts;
}

bool mt_report_is_off(const mt_report_glyph *glyph, int step) {
    return parts_at(glyph, step) > 0 || mt_appearance_score(&glyph->seen[step]) >= MT_REPORT_STUMBLES;
}

bool mt_report_counts_in_range(const mt_report_glyph *glyph) {
    return glyph->status == MT_OK && parts_of(glyph) == 0;
}

bool mt_report_ink_in_range(const mt_report_glyph *glyph) {
    int step = worst_step(glyph, MT_FLAG_INK);
    return glyph->status == MT_OK && glyph->seen[step].ink <= MT_INK_EXCESS;
}

/* ---- the judgement ------------------------------------------------------------------------------------- */

/* To a hundredth, downwards, so that what is flagged has a reason: what is less is nothing to sort by. */
static double severity_of(const mt_report_glyph *glyph) {
    double score = 0;
    if (glyph->status != MT_OK) return FAILED_SEVERITY;
    for (int i = 0; i < MT_REPORT_STEPS; i++) score = fmax(score, mt_appearance_score(&glyph->seen[i]));
    return floor(100 * mt_appearance_loss(score, parts_of(glyph))) / 100;
}

/* Whether a flag tells why. Counts do where they are out of range, and what an eye minds where it is too much by itself. */
static bool tells(const mt_report_glyph *glyph, mt_report_flag flag) {
    if (glyph->status != MT_OK) return flag == MT_FLAG_FAILED;
    if (flag == MT_FLAG_FAILED) return false;
    double most = amount_at(glyph, flag, worst_step(glyph, flag));
    return flag == MT_FLAG_COMPONENTS || flag == MT_FLAG_HOLES ? most > 0 : most >= MT_REPORT_STUMBLES;
}

void mt_report_judge(mt_report_glyph *glyph) {
    glyph->flags = 0;
    glyph->severity = severity_of(glyph);
    if (glyph->severity < MT_REPORT_STUMBLES) return;
    for (unsigned flag = 1; flag <= MT_FLAG_ALL; flag <<= 1)
        if (tells(glyph, (mt_report_flag)flag)) glyph->flags |= flag;
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
    case MT_FLAG_STRAYS: return "strays";
    case MT_FLAG_CLOTS: return "clots";
    default: return "ink";
    }
}

/* "0.0625": digits by hand, since the C library's point is another one in some locales. */
static void step_name(int step, char text[8]) {
    int digits = step * 10000 / (MT_REPORT_STEPS - 1), length = 4;
    if (digits % 10000 == 0) {
        snprintf(text, 8, "%d", digits / 10000);
        return;
    }
    for (; digits % 10 == 0; digits /= 10) length--;
    snprintf(text, 8, "0.%0*d", length, digits);
}

static void say_count(const char *what, int count, const char *at, int a, int b, char *text) {
    snprintf(text, MT_REPORT_REASON_ROOM, "%d %s%s at T = %s, the ends have %d and %d", count, what,
             count == 1 ? "" : "s", at, a, b);
}

/* "12.3", of tenths. */
#define TENTHS "%" PRId64 ".%" PRId64

void mt_report_reason(const mt_report_glyph *glyph, mt_report_flag flag, char text[MT_REPORT_REASON_ROOM]) {
    int step = worst_step(glyph, flag);
    const mt_topology *a = &glyph->ink_a, *b = &glyph->ink_b, *at = &glyph->ink[step];
    const mt_appearance *seen = &glyph->seen[step];
    int64_t strays = llround(10 * seen->strays), clots = llround(1000 * (seen->clots - 1)),
            ink = llround(1000 * seen->ink);
    char place[8];
    step_name(step, place);
    switch (flag) {
    case MT_FLAG_FAILED: snprintf(text, MT_REPORT_REASON_ROOM, "%s", mt_status_text(glyph->status)); break;
    case MT_FLAG_COMPONENTS:
        say_count("component", at->components, place, a->components, b->components, text);
        break;
    case MT_FLAG_HOLES: say_count("hole", at->holes, place, a->holes, b->holes, text); break;
    case MT_FLAG_STRAYS:
        snprintf(text, MT_REPORT_REASON_ROOM,
                 "ink strays by " TENTHS " thousandths of the em from its way at T = %s", strays / 10,
                 strays % 10, place);
        break;
    case MT_FLAG_CLOTS:
        snprintf(text, MT_REPORT_REASON_ROOM,
                 "a stroke is " TENTHS " %% thicker than any of the ends' at T = %s", clots / 10, clots % 10,
                 place);
        break;
    default:
        snprintf(text, MT_REPORT_REASON_ROOM, "ink " TENTHS " %% %s the ends' at T = %s", ink / 10, ink % 10,
                 at->area > larger_ink(glyph) ? "over" : "under", place);
    }
}
