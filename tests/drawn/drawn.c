/* Whether what is between two fonts is drawn as a designer would draw it: `drawn A B FIRST-LAST|FILE:COUNT …` joins each
 * character of both fonts and looks at
 *
 *     points     of the half-way glyph, against those of the source that has more: the median of the ratio, over all glyphs
 *     kinks      nodes that turn by more than SMOOTH on the way, at T = 1/4, 1/2 or 3/4, though neither end does there
 *     stubs      segments that are shorter than STUB at both ends
 *     leaning    lines that are upright or level at both ends, but not half-way
 *     bulges     curves that go beyond both their ends by more than BULGE half-way, though they do at neither end: an extremum
 *                without a point. Those are left where only one end has the extremum
 *
 * and fails where there is one of the first four, where the ratio is over POINTS, or the share of bulges over BULGES, and where
 * it did not look at every character that both fonts have, each of which must have ink. Points are those of 'glyf'; of a source
 * with cubics, which 'glyf' cannot hold, all points on and off its curves. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "blend/contours.h"
#include "geometry/limits.h"
#include "morph/between/instance.h"
#include "morph/fit/contour_pair.h"
#include "support/code_points.h"

#define POINTS 1.5
#define SMOOTH 4.0   /* degrees */
#define STUB 2.0     /* 1/1000 em */
#define BULGE 1.0    /* 1/1000 em */
#define BULGES 0.005 /* of all nodes */

enum { CHARS_MAX = 100000, PLACES = 3 };
static const double places[PLACES] = {0.25, 0.5, 0.75};

typedef struct mt_tally {
    int glyphs, nodes, kinks[PLACES], stubs, leaning, bulges;
    double ratios[CHARS_MAX];
} mt_tally;

static void stop(mt_status status, const char *what) {
    printf("%s: %s\n", what, mt_status_text(status));
    exit(2);
}

/* ---- a node ---------------------------------------------------------------------------------------------- */

static const mt_segment *segment_at(const mt_contour *c, int k) {
    return &c->segments[(k + 2 * c->count) % c->count];
}

static mt_vector from_to(mt_point p, mt_point q) {
    return (mt_vector){(double)q.x - p.x, (double)q.y - p.y};
}

static bool is_nothing(mt_vector v) {
    return v.x == 0 && v.y == 0;
}

/* How the contour comes to the end of segment k; where it has waited, how it came before that. */
static mt_vector arriving(const mt_contour *c, int k) {
    mt_vector way = {0};
    for (int i = k; i > k - c->count && is_nothing(way); i--) {
        const mt_segment *s = segment_at(c, i);
        if (s->degree == 2) way = from_to(s->control[0], s->end);
        if (is_nothing(way)) way = from_to(segment_at(c, i - 1)->end, s->end);
    }
    return way;
}

static mt_vector leaving(const mt_contour *c, int k) {
    mt_vector way = {0};
    for (int i = k + 1; i <= k + c->count && is_nothing(way); i++) {
        const mt_segment *s = segment_at(c, i);
        mt_point start = segment_at(c, i - 1)->end;
        if (s->degree == 2) way = from_to(start, s->control[0]);
        if (is_nothing(way)) way = from_to(start, s->end);
    }
    return way;
}

/* By how many degrees the contour turns at the end of segment k. */
static double turn_at(const mt_contour *c, int k) {
    mt_vector in = arriving(c, k), out = leaving(c, k);
    return fabs(atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y)) * (180 / M_PI);
}

/* ---- a segment ------------------------------------------------------------------------------------------- */

/* 1/1000 em. */
static double length_of(const mt_contour *c, int k) {
    mt_vector way = from_to(segment_at(c, k - 1)->end, segment_at(c, k)->end);
    return hypot(way.x, way.y) * 1000 / MT_EM;
}

static bool is_leaning(const mt_contour *const c[3], int k) {
    mt_vector way[3];
    for (int i = 0; i < 3; i++) way[i] = from_to(segment_at(c[i], k - 1)->end, segment_at(c[i], k)->end);
    if (segment_at(c[0], k)->degree != 1) return false;
    return (way[0].x == 0 && way[2].x == 0 && way[1].x != 0) ||
           (way[0].y == 0 && way[2].y == 0 && way[1].y != 0);
}

/* How far a quadratic goes beyond its ends on one axis: from a to b with its control at c, any unit. */
static double beyond(double a, double c, double b) {
    double curve = a - 2 * c + b, t = curve != 0 ? (a - c) / curve : -1;
    if (t <= 0 || t >= 1) return 0;
    double most = (1 - t) * (1 - t) * a + 2 * t * (1 - t) * c + t * t * b;
    return fmin(fabs(most - a), fabs(most - b));
}

/* 1/1000 em. */
static double bulge_of(const mt_contour *c, int k) {
    const mt_segment *s = segment_at(c, k);
    mt_point a = segment_at(c, k - 1)->end, p = s->control[0], b = s->end;
    if (s->degree == 1) return 0;
    return fmax(beyond(a.x, p.x, b.x), beyond(a.y, p.y, b.y)) * 1000 / MT_EM;
}

/* ---- a glyph --------------------------------------------------------------------------------------------- */

static void say(const char *what, uint32_t code_point, double t, mt_point at, double size) {
    printf("U+%04X: %s of %.1f at T = %g, (%d, %d)\n", code_point, what, size, t, at.x / (MT_EM / 1000),
           at.y / (MT_EM / 1000));
}

static void look_at_node(const mt_contour_pair *m, const mt_contour between[PLACES], int k,
                         uint32_t code_point, mt_tally *sum) {
    sum->nodes++;
    if (turn_at(&m->a, k) > SMOOTH || turn_at(&m->b, k) > SMOOTH) return;
    for (int i = 0; i < PLACES; i++) {
        double turn = turn_at(&between[i], k);
        if (turn <= SMOOTH) continue;
        sum->kinks[i]++;
        say("kink", code_point, places[i], segment_at(&between[i], k)->end, turn);
    }
}

static void look_at_segment(const mt_contour_pair *m, const mt_contour *half, int k, uint32_t code_point,
                            mt_tally *sum) {
    const mt_contour *const all[3] = {&m->a, half, &m->b};
    mt_point at = segment_at(half, k)->end;
    double longest = fmax(length_of(&m->a, k), length_of(&m->b, k)), bulge = bulge_of(half, k);
    if (longest < STUB) {
        sum->stubs++;
        say("stub", code_point, 0.5, at, longest);
    }
    if (is_leaning(all, k)) {
        sum->leaning++;
        say("leaning line", code_point, 0.5, at, length_of(half, k));
    }
    if (bulge > BULGE && bulge > fmax(bulge_of(&m->a, k), bulge_of(&m->b, k))) {
        sum->bulges++;
        say("bulge", code_point, 0.5, at, bulge);
    }
}

static void look_at_contour(const mt_contour_pair *m, uint32_t code_point, mt_arena *arena, mt_tally *sum) {
    mt_contour between[PLACES];
    for (int i = 0; i < PLACES; i++) {
        mt_status status = mt_contour_pair_mix(m, mt_weights_at(places[i]), arena, &between[i]);
        if (status != MT_OK) stop(status, "mixing");
    }
    for (int k = 0; k < m->a.count; k++) {
        look_at_node(m, between, k, code_point, sum);
        look_at_segment(m, &between[1], k, code_point, sum);
    }
}

static bool has_cubics(const mt_outline *outline, int *points) {
    bool cubics = false;
    *points = 0;
    for (int i = 0; i < outline->count; i++)
        for (int k = 0; k < outline->contours[i].count; k++) {
            const mt_segment *s = segment_at(&outline->contours[i], k);
            bool closes = s->degree == 1 && length_of(&outline->contours[i], k) == 0;
            *points += closes ? 0 : s->degree;
            cubics |= s->degree == 3;
        }
    return cubics;
}

static int points_of(const mt_outline *outline, int units, mt_arena *arena) {
    mt_glyf glyf;
    int points;
    if (has_cubics(outline, &points)) return points;
    mt_status status = mt_outline_glyf(outline, units, arena, &glyf);
    if (status != MT_OK) stop(status, "counting points");
    return glyf.contour_count ? glyf.ends[glyf.contour_count - 1] + 1 : 0;
}

static int points_in(mt_font *font, uint32_t code_point, mt_arena *arena) {
    mt_outline outline;
    double advance;
    mt_status status = mt_font_outline(font, mt_font_glyph(font, code_point), arena, &outline, &advance);
    if (status != MT_OK) stop(status, "reading");
    return points_of(&outline, mt_font_units_per_em(font), arena);
}

static void look_at_glyph(mt_font *a, mt_font *b, uint32_t code_point, mt_arena *arena, mt_tally *sum) {
    mt_params params = mt_params_default();
    mt_glyph_pair pair;
    mt_outline half;
    if (!mt_font_glyph(a, code_point) || !mt_font_glyph(b, code_point)) return;
    int most = (int)fmax(points_in(a, code_point, arena), points_in(b, code_point, arena));
    if (most == 0) return;
    mt_row row;
    mt_status status = mt_row_open((mt_font *[]){a, b}, 2, &params, &row);
    if (status != MT_OK) stop(status, "opening");
    status = mt_pair_prepare_char(&row, code_point, arena, &pair);
    mt_row_close(&row);
    if (status == MT_OK) status = mt_morph_outline(&pair.morph, mt_weights_at(0.5), &params, arena, &half);
    if (status != MT_OK) stop(status, "joining");
    sum->ratios[sum->glyphs++] = (double)points_of(&half, mt_font_units_per_em(a), arena) / most;
    for (int i = 0; i < pair.morph.contour_count; i++)
        look_at_contour(&pair.morph.contours[i], code_point, arena, sum);
}

/* ---- the font -------------------------------------------------------------------------------------------- */

static int by_size(const void *p, const void *q) {
    double a = *(const double *)p, b = *(const double *)q;
    return (a > b) - (a < b);
}

static bool report(mt_tally *sum, int expected) {
    printf("%d glyphs of %d\n", sum->glyphs, expected);
    if (sum->glyphs == 0) return false;
    qsort(sum->ratios, (size_t)sum->glyphs, sizeof(double), by_size);
    double median = sum->ratios[sum->glyphs / 2];
    int kinks = sum->kinks[0] + sum->kinks[1] + sum->kinks[2];
    printf("points x %.2f (median; %.2f at the 90th percentile), %d nodes: %d, %d, %d kinks, %d stubs, "
           "%d leaning lines, %d bulges\n",
           median, sum->ratios[sum->glyphs * 9 / 10], sum->nodes, sum->kinks[0], sum->kinks[1], sum->kinks[2],
           sum->stubs, sum->leaning, sum->bulges);
    return sum->glyphs == expected && median <= POINTS && kinks == 0 && sum->stubs == 0 &&
           sum->leaning == 0 && sum->bulges <= BULGES * sum->nodes;
}

int main(int argc, char **argv) {
    static uint32_t chars[CHARS_MAX];
    static mt_tally sum;
    mt_font *a, *b;
    mt_arena arena = {0};
    if (argc < 4) return 2;
    int count = mt_test_code_points(argc - 3, argv + 3, chars, CHARS_MAX);
    if (count < 0 || mt_font_open(argv[1], &a) != MT_OK || mt_font_open(argv[2], &b) != MT_OK) return 2;
    for (int i = 0; i < count; i++) {
        look_at_glyph(a, b, chars[i], &arena, &sum);
        mt_arena_reset(&arena);
    }
    mt_arena_release(&arena);
    mt_font_close(a);
    mt_font_close(b);
    return report(&sum, mt_test_count_in_both(argv[1], argv[2], chars, count)) ? 0 : 1;
}
