/* Holds a blend's ends against the sources: `ends A B at FIRST-LAST|FILE:COUNT …` blends A with B at 0 or 1, reads the font back and
 * measures, over the characters of the ranges, how far its outlines are from the source's own (both ways, at points no more
 * than 1/1000 em apart, to the nearest segment). Prints the mean and the largest distance in 1/1000 em; fails over 0.25 and 1,
 * the promise of docs/guide.md, and where one of the characters that both sources have was not compared. With `same` for B, A is
 * blended with itself at the place given. MT_TOLERANCE and MT_FIT in the environment are the parameters of these names. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "geometry/limits.h"
#include "support/code_points.h"
#include "support/fonts.h"
#include "support/sample.h"

#define MEAN 0.25 /* the promise, 1/1000 em */
#define LARGEST 1.0
#define FINE 0.1 /* flattening for the comparison, 1/1000 em */

typedef struct mt_distances {
    double total, largest;
    long points;
    uint32_t worst;
    int glyphs;
} mt_distances;

static double to_segment(double x, double y, mt_point a, mt_point b) {
    double dx = (double)b.x - a.x, dy = (double)b.y - a.y, length2 = dx * dx + dy * dy;
    double t = length2 > 0 ? ((x - a.x) * dx + (y - a.y) * dy) / length2 : 0;
    t = fmin(1, fmax(0, t));
    return hypot(x - a.x - t * dx, y - a.y - t * dy);
}

typedef struct mt_nearest {
    double distance;
    mt_point a, b; /* the segment */
} mt_nearest;

/* The nearest segment to a place. The one found for the place before is tried first, so that most are out of reach at once. */
static void find_nearest(double x, double y, const mt_rings *rings, mt_nearest *nearest) {
    nearest->distance = to_segment(x, y, nearest->a, nearest->b);
    for (int i = 0; i < rings->count; i++)
        for (int k = 0, n = rings->rings[i].count; k < n; k++) {
            mt_point a = rings->rings[i].points[k], b = rings->rings[i].points[k + 1 == n ? 0 : k + 1];
            double reach = nearest->distance;
            if ((a.x < x - reach && b.x < x - reach) || (a.x > x + reach && b.x > x + reach)) continue;
            if ((a.y < y - reach && b.y < y - reach) || (a.y > y + reach && b.y > y + reach)) continue;
            double distance = to_segment(x, y, a, b);
            if (distance < nearest->distance) *nearest = (mt_nearest){distance, a, b};
        }
}

/* Every point of `from`, and points along its edges, against `to`. */
static void compare(const mt_rings *from, const mt_rings *to, mt_distances *sum) {
    if (from->count == 0 || to->count == 0) return;
    mt_nearest nearest = {0, to->rings[0].points[0], to->rings[0].points[1]};
    for (int i = 0; i < from->count; i++)
        for (int k = 0; k < from->rings[i].count; k++) {
            mt_point a = from->rings[i].points[k], b = from->rings[i].points[(k + 1) % from->rings[i].count];
            int steps = 1 + (int)(hypot((double)b.x - a.x, (double)b.y - a.y) * 1000 / MT_EM);
            for (int s = 0; s < steps; s++) {
                double t = (double)s / steps;
                find_nearest(a.x + t * ((double)b.x - a.x), a.y + t * ((double)b.y - a.y), to, &nearest);
                double d = nearest.distance * 1000 / MT_EM;
                sum->total += d;
                sum->points++;
                sum->largest = fmax(sum->largest, d);
            }
        }
}

/* Some sources have stray contours of no width to speak of; a blend leaves them out (MT_SEAM_WIDTH). */
static void drop_strays(mt_rings *rings) {
    int kept = 0;
    for (int i = 0; i < rings->count; i++) {
        double area2 = fabs((double)mt_ring_area2(&rings->rings[i]));
        if (area2 >= MT_SEAM_WIDTH * mt_ring_length(&rings->rings[i])) rings->rings[kept++] = rings->rings[i];
    }
    rings->count = kept;
}

/* The ink of a character of a font, as rings. */
static mt_status read_rings(mt_font *font, uint32_t c, mt_arena *arena, mt_rings *rings) {
    mt_shape shape;
    if (!mt_font_glyph(font, c)) return MT_NO_GLYPH;
    mt_status status = mt_test_glyph_shape(font, c, FINE, arena, &shape);
    if (status == MT_OK) status = mt_shape_rings(&shape, arena, rings);
    if (status == MT_OK) drop_strays(rings);
    return status;
}

/* Whether both have the character; where not, says why if the source has it. */
static bool read_both(mt_font *source, mt_font *blend, uint32_t c, mt_arena *arena, mt_rings rings[2]) {
    if (!mt_font_glyph(source, c)) return false;
    mt_status status = read_rings(source, c, arena, &rings[0]);
    if (status == MT_OK) status = read_rings(blend, c, arena, &rings[1]);
    if (status != MT_OK) printf("U+%04X: %s\n", c, mt_status_text(status));
    return status == MT_OK;
}

static void compare_glyph(mt_font *source, mt_font *blend, uint32_t c, mt_arena *arena, mt_distances *sum) {
    mt_rings rings[2];
    if (!read_both(source, blend, c, arena, rings)) return;
    sum->glyphs++;
    if ((rings[0].count == 0) != (rings[1].count == 0)) {
        printf("U+%04X: ink on one side only\n", c);
        sum->largest = INFINITY;
        return;
    }
    mt_distances own = {0};
    compare(&rings[0], &rings[1], &own);
    compare(&rings[1], &rings[0], &own);
    sum->total += own.total;
    sum->points += own.points;
    if (own.largest > LARGEST) printf("U+%04X: %.3f\n", c, own.largest);
    if (own.largest <= sum->largest) return;
    sum->largest = own.largest;
    sum->worst = c;
}

enum { CHARS_MAX = 100000 };

static void say_failure(uint32_t c, mt_status why, void *user) {
    (void)user;
    printf("U+%04X: %s\n", c, mt_status_text(why));
}

static double parameter(const char *name, double otherwise) {
    const char *text = getenv(name);
    return text ? atof(text) : otherwise;
}

/* The blend at t, written and read back. */
static mt_status blend_and_read(mt_font *a, mt_font *b, double t, const uint32_t *chars, int count,
                                mt_font **made) {
    mt_arena arena = {0};
    mt_params params = mt_params_default();
    params.tolerance = parameter("MT_TOLERANCE", params.tolerance);
    params.fit = parameter("MT_FIT", params.fit);
    mt_blend *blend;
    mt_status status = mt_blend_new(a, b, &params, &blend);
    if (status != MT_OK) return status;
    const char *directory = mt_sample_directory(&arena), *path = mt_sample_path(&arena, directory, "x.ttf");
    mt_blend_on_failure(blend, say_failure, NULL);
    status = mt_blend_set_chars(blend, chars, count);
    if (status == MT_OK) status = mt_blend_save(blend, t, path);
    if (status == MT_OK) status = mt_font_open(path, made);
    mt_blend_free(blend);
    mt_sample_remove(directory);
    mt_arena_release(&arena);
    return status;
}

static bool report(const mt_distances *sum, int expected) {
    double mean = sum->points ? sum->total / (double)sum->points : INFINITY;
    printf("%d glyphs of %d: mean %.3f, largest %.3f (U+%04X), 1/1000 em\n", sum->glyphs, expected, mean,
           sum->largest, sum->worst);
    return sum->glyphs == expected && mean <= MEAN && sum->largest <= LARGEST;
}

int main(int argc, char **argv) {
    static uint32_t chars[CHARS_MAX];
    mt_font *a, *b, *made;
    if (argc < 5) return 2;
    double t = atof(argv[3]);
    const char *second = strcmp(argv[2], "same") == 0 ? argv[1] : argv[2];
    int count = mt_test_code_points(argc - 4, argv + 4, chars, CHARS_MAX);
    if (count < 0 || mt_font_open(argv[1], &a) != MT_OK || mt_font_open(second, &b) != MT_OK) return 2;
    mt_status status = blend_and_read(a, b, t, chars, count, &made);
    if (status != MT_OK) {
        printf("%s\n", mt_status_text(status));
        return 1;
    }
    mt_distances sum = {0};
    mt_arena arena = {0};
    for (int i = 0; i < count; i++) {
        compare_glyph(t < 0.5 ? a : b, made, chars[i], &arena, &sum);
        mt_arena_reset(&arena);
    }
    mt_arena_release(&arena);
    mt_font_close(made);
    mt_font_close(b);
    mt_font_close(a);
    return report(&sum, mt_test_count_in_both(argv[1], second, chars, count)) ? 0 : 1;
}
