/* Where the time of a glyph goes, stage by stage, for Latin and for Han, by the paper's method and at T =
 * 0.5. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "bench/clock.h"
#include "blend/contours.h"
#include "geometry/decompose.h"
#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/prepare.h"
#include "support/fonts.h"
#include "write/write.h"

enum { READ, FLATTEN, RESOLVE, DECOMPOSE, MATCH, BLEND, FIT, WRITE, STAGES };
static const char *const names[STAGES] = {"read",  "flatten", "resolve", "decompose",
                                          "match", "blend",   "fit",     "write"};
enum { GLYPHS_MAX = 512 };

typedef struct tally {
    double time[STAGES];
    int glyphs, failed;
    long points, pieces, links;
} tally;

static mt_arena arena, kept; /* for one glyph, and for the font that is written */

/* Adds the time since *from to a stage, and starts the next. */
static void lap(tally *t, int stage, double *from) {
    double now = mt_clock();
    t->time[stage] += now - *from;
    *from = now;
}

static mt_status read_shape(mt_font *font, uint32_t code_point, const mt_params *params, tally *t,
                            mt_shape *shape) {
    mt_outline outline;
    mt_rings rings;
    double advance, from = mt_clock();
    mt_status status = mt_font_outline(font, mt_font_glyph(font, code_point), &arena, &outline, &advance);
    lap(t, READ, &from);
    if (status == MT_OK) status = mt_flatten(&outline, params->tolerance * MT_EM / 1000, &arena, &rings);
    lap(t, FLATTEN, &from);
    if (status == MT_OK) status = mt_union(&rings, MT_NONZERO, &arena, shape);
    lap(t, RESOLVE, &from);
    for (int i = 0; status == MT_OK && i < rings.count; i++) t->points += rings.rings[i].count;
    return status;
}

/* mt_morph_prepare decomposes, then matches: the decomposition is timed by itself and taken off. */
static mt_status match(const mt_shape *a, const mt_shape *b, const mt_params *params, tally *t,
                       mt_morph *morph) {
    const mt_shape *sides[] = {a, b};
    double from = mt_clock(), before = t->time[DECOMPOSE];
    mt_pieces pieces;
    mt_status status = MT_OK;
    for (int s = 0; s < 2; s++)
        for (int k = 0; status == MT_OK && k < sides[s]->count; k++)
            status = mt_decompose(&sides[s]->components[k], &arena, &pieces);
    lap(t, DECOMPOSE, &from);
    if (status == MT_OK) status = mt_morph_prepare(a, b, NULL, params, &arena, morph);
    lap(t, MATCH, &from);
    t->time[MATCH] -= t->time[DECOMPOSE] - before;
    if (status != MT_OK) return status;
    t->pieces += morph->a.pieces.count + morph->b.pieces.count;
    t->links += morph->links.count;
    return MT_OK;
}

static mt_status make(mt_font *a, mt_font *b, uint32_t code_point, const mt_params *params, tally *t,
                      mt_glyf *glyph) {
    mt_shape in_a, in_b, blend;
    mt_morph morph;
    mt_outline outline;
    mt_status status = read_shape(a, code_point, params, t, &in_a);
    if (status == MT_OK) status = read_shape(b, code_point, params, t, &in_b);
    if (status == MT_OK) status = match(&in_a, &in_b, params, t, &morph);
    double from = mt_clock();
    if (status == MT_OK) status = mt_morph_blend(&morph, mt_weights_at(0.5), params, &arena, &blend);
    lap(t, BLEND, &from);
    if (status == MT_OK) status = mt_shape_outline(&blend, params, &arena, &outline);
    lap(t, FIT, &from);
    if (status == MT_OK) status = mt_outline_glyf(&outline, 1000, &kept, glyph);
    lap(t, WRITE, &from);
    return status;
}

static void write_font(mt_font *a, mt_glyf *glyphs, int count, tally *t) {
    static mt_char chars[GLYPHS_MAX];
    for (int i = 1; i < count; i++) chars[i - 1] = (mt_char){0x4E00u + (uint32_t)i, (uint16_t)i};
    mt_font_data data = {.units = 1000,
                         .glyph_count = count,
                         .glyphs = glyphs,
                         .char_count = count - 1,
                         .chars = chars,
                         .family = "Benchmark",
                         .style = "Regular",
                         .unique_id = "Benchmark"};
    mt_font_metrics(a, &data.metrics);
    uint8_t *bytes;
    size_t length;
    double from = mt_clock();
    mt_status status = mt_font_write(&data, &bytes, &length);
    lap(t, WRITE, &from);
    if (status == MT_OK)
        mt_bytes_free(bytes);
    else
        fprintf(stderr, "writing: %s\n", mt_status_text(status));
}

static tally measure(mt_font *a, mt_font *b, const uint32_t *code_points, int count) {
    static mt_glyf glyphs[GLYPHS_MAX];
    memset(glyphs, 0, sizeof glyphs);
    mt_params params = mt_params_default();
    params.method = MT_METHOD_PAPER;
    tally t = {0};
    for (int i = 0; i < count && t.glyphs + 1 < GLYPHS_MAX; i++) {
        mt_status status = make(a, b, code_points[i], &params, &t, &glyphs[t.glyphs + 1]);
        if (status == MT_OK)
            t.glyphs++;
        else
            t.failed++;
        mt_arena_reset(&arena);
    }
    write_font(a, glyphs, t.glyphs + 1, &t);
    mt_arena_reset(&kept);
    return t;
}

static void print(const char *title, const tally *t) {
    double all = 0, n = fmax(1, t->glyphs);
    printf("\n%s: %d glyphs, %d failed; a glyph has %.0f points, %.0f pieces, %.0f links\n", title, t->glyphs,
           t->failed, (double)t->points / n, (double)t->pieces / n, (double)t->links / n);
    for (int i = 0; i < STAGES; i++) all += t->time[i];
    for (int i = 0; i < STAGES; i++)
        printf("  %-10s %9.1f us a glyph %5.1f %%\n", names[i], t->time[i] / n, 100 * t->time[i] / all);
    printf("  %-10s %9.1f us a glyph\n", "all", all / n);
}

static void run(const char *title, const char *first, const char *second, const uint32_t *code_points,
                int count) {
    mt_font *a = NULL, *b = NULL;
    if (mt_font_open(first, &a) != MT_OK || mt_font_open(second, &b) != MT_OK) {
        printf("\n%s: %s and %s are not both installed\n", title, first, second);
    } else {
        measure(a, b, code_points, count); /* warms up */
        tally t = measure(a, b, code_points, count);
        print(title, &t);
    }
    mt_font_close(a);
    mt_font_close(b);
}

int main(void) {
    run("Latin", MT_TEST_SANS, MT_TEST_SERIF, mt_test_latin, mt_test_latin_count);
    run("Han", MT_TEST_HEI, MT_TEST_KAI, mt_test_han, mt_test_han_count);
    mt_arena_release(&arena);
    mt_arena_release(&kept);
    return 0;
}
