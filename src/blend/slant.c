/* Stems are what most of the upright border runs along. Of each edge that is nearer to upright than to level, the height is added to a bin for its
 * lean, the way across for each way up; the lean of the font is the middle of the highest bin, after bins are blurred, since no drawing's
 * stems are all alike. GLYPHS characters, evenly taken from all that both fonts have, give the same answer as all of them. */
#include "blend/slant.h"

#include <math.h>
#include <stdlib.h>

#include "arithmetic/angles.h"
#include "geometry/limits.h"

enum { GLYPHS = 120, BINS = 141, BLUR = 5 };
#define LEAN_MOST 0.5 /* across for each way up: what leans more is no stem */
#define FLATNESS 2.0  /* 1/1000 em: chords this far from their curves tell how a stem leans */
#define ALIKE 2.0     /* degrees: fonts that differ by less lean alike */

typedef struct mt_leans {
    double heights[BINS];
} mt_leans;

static void add_edge(mt_leans *leans, mt_point p, mt_point q) {
    double up = fabs((double)q.y - p.y), across = ((double)q.x - p.x) * (q.y > p.y ? 1 : -1);
    if (up == 0 || fabs(across) > LEAN_MOST * up) return;
    leans->heights[(int)lround((across / up / LEAN_MOST + 1) * (BINS - 1) / 2)] += up;
}

static mt_status add_glyph(mt_leans *leans, mt_font *font, uint32_t glyph, mt_arena *arena) {
    mt_outline outline;
    mt_rings rings;
    double advance;
    mt_status status = mt_font_outline(font, glyph, arena, &outline, &advance);
    if (status == MT_OK) status = mt_flatten(&outline, mt_grid_units(FLATNESS), arena, &rings);
    if (status != MT_OK) return status == MT_NO_MEMORY ? status : MT_OK;
    for (int i = 0; i < rings.count; i++)
        for (int k = 0; k < rings.rings[i].count; k++)
            add_edge(leans, rings.rings[i].points[k], rings.rings[i].points[(k + 1) % rings.rings[i].count]);
    return MT_OK;
}

/* Degrees to the right. */
static double lean_of(const mt_leans *leans) {
    double most = 0;
    int best = BINS / 2;
    for (int i = 0; i < BINS; i++) {
        double sum = 0;
        for (int k = -BLUR; k <= BLUR; k++)
            if (i + k >= 0 && i + k < BINS) sum += leans->heights[i + k] * (BLUR + 1 - abs(k));
        if (sum <= most) continue;
        most = sum;
        best = i;
    }
    return mt_atan2((2.0 * best / (BINS - 1) - 1) * LEAN_MOST, 1) * (180 / M_PI);
}

static bool is_shared(const mt_font *a, const mt_font *b, uint32_t code_point) {
    return mt_font_glyph(a, code_point) && mt_font_glyph(b, code_point);
}

static int count_shared(const mt_font *a, const mt_font *b) {
    int count = 0;
    for (uint32_t c = 0; mt_font_next_char(a, c, &c); c++) count += is_shared(a, b, c);
    return count;
}

mt_status mt_slant_between(mt_font *a, mt_font *b, double *degrees) {
    mt_leans leans_a = {{0}}, leans_b = {{0}};
    mt_arena arena = {0};
    mt_status status = MT_OK;
    int shared = count_shared(a, b), number = 0;
    for (uint32_t c = 0; status == MT_OK && mt_font_next_char(a, c, &c); c++) {
        if (!is_shared(a, b, c)) continue;
        bool taken = (int64_t)number * GLYPHS / shared != (int64_t)(number - 1) * GLYPHS / shared;
        number++;
        if (shared > GLYPHS && !taken) continue;
        status = add_glyph(&leans_a, a, mt_font_glyph(a, c), &arena);
        if (status == MT_OK) status = add_glyph(&leans_b, b, mt_font_glyph(b, c), &arena);
        mt_arena_reset(&arena);
    }
    mt_arena_release(&arena);
    *degrees = lean_of(&leans_b) - lean_of(&leans_a);
    if (fabs(*degrees) < ALIKE) *degrees = 0;
    return status;
}
