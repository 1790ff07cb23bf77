/* Holds the proof of topology against dense samples: `proof A B FIRST-LAST|FILE:COUNT …` prepares the glyphs of the characters that both
 * fonts have, asks for each what is proved of its topology, and counts components and holes at 99 places with chords eight times as
 * fine. Prints how many glyphs are proved, how many of these stay in the range of both ends, and what samples say. Fails where a
 * glyph is proved to stay in the range and a sample leaves it, and where no glyph is proved. */
#include <limits.h>
#include <stdio.h>

#include "blend/slant.h"
#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "morph/check/topology.h"
#include "morph/prepare.h"
#include "support/code_points.h"
#include "support/fonts.h"

enum { PLACES = 99, CHARS_MAX = 100000 };

typedef struct mt_tally {
    int glyphs, failed;
    int proved, in_range; /* for every T; of these, in the ends' range */
    int sampled;          /* a sample leaves the range */
    int between;          /* of these, no sample at a twentieth does */
    int proved_only;      /* proved to leave it, between two samples */
    int contradicted;     /* proved to stay in it, and a sample leaves it */
} mt_tally;

static int excess(const mt_shape *shape, const mt_topology ends[2]) {
    mt_topology at = mt_topology_of(shape);
    return mt_count_excess(at.components, ends[0].components, ends[1].components) +
           mt_count_excess(at.holes, ends[0].holes, ends[1].holes);
}

/* Whether the blend leaves the range at a place, as it is drawn or as it is meant. */
static mt_status leaves(const mt_morph *morph, double t, const mt_params *params, mt_arena *arena,
                        bool *out) {
    const mt_topology ends[] = {mt_topology_of(&morph->a.whole), mt_topology_of(&morph->b.whole)};
    mt_arena_place before = mt_arena_mark(arena);
    mt_rings rings;
    mt_shape drawn, meant;
    mt_status status = mt_morph_rings(morph, mt_weights_at(t), params, arena, &rings);
    if (status == MT_OK) status = mt_union_unmarked(&rings, MT_NONZERO, arena, &drawn);
    if (status == MT_OK) status = mt_union_unmarked(&rings, MT_POSITIVE, arena, &meant);
    *out = status == MT_OK && (excess(&drawn, ends) > 0 || excess(&meant, ends) > 0);
    mt_arena_rewind(arena, before);
    return status;
}

static mt_status sample(const mt_morph *morph, const mt_params *params, mt_arena *arena, int *all,
                        int *twentieths) {
    mt_params fine = *params;
    mt_status status = MT_OK;
    fine.tolerance /= MT_OVERLAP_CARE;
    *all = *twentieths = 0;
    for (int i = 1; status == MT_OK && i <= PLACES; i++) {
        bool out;
        status = leaves(morph, (double)i / (PLACES + 1), &fine, arena, &out);
        *all += out;
        *twentieths += out && i % 5 == 0;
    }
    return status;
}

static mt_status look(const mt_morph *morph, const mt_params *params, uint32_t c, mt_arena *arena,
                      mt_tally *sum) {
    mt_topology_error error;
    int all, twentieths;
    mt_status status = mt_morph_topology_error(morph, INT_MAX, params, arena, &error);
    if (status == MT_OK) status = sample(morph, params, arena, &all, &twentieths);
    if (status != MT_OK) return status;
    bool stays = error.proved && error.stays;
    sum->glyphs++;
    sum->proved += error.proved;
    sum->in_range += stays;
    sum->sampled += all > 0;
    sum->between += all > 0 && twentieths == 0;
    sum->proved_only += error.proved && !error.stays && all == 0;
    sum->contradicted += stays && all > 0;
    if (stays && all > 0) printf("U+%04X: proved, and out of range at %d places\n", c, all);
    return MT_OK;
}

static mt_status prepare(mt_font *a, mt_font *b, uint32_t c, const mt_params *params, mt_arena *arena,
                         mt_morph *morph) {
    mt_shape in_a, in_b;
    mt_status status = mt_test_glyph_shape(a, c, params->tolerance, arena, &in_a);
    if (status == MT_OK) status = mt_test_glyph_shape(b, c, params->tolerance, arena, &in_b);
    return status == MT_OK ? mt_morph_prepare(&in_a, &in_b, NULL, params, arena, morph) : status;
}

static mt_tally look_at_all(mt_font *a, mt_font *b, const uint32_t *chars, int count) {
    mt_params params = mt_params_default();
    mt_arena arena = {0};
    mt_tally sum = {0};
    if (mt_slant_between(a, b, &params.lean) != MT_OK) params.lean = 0;
    for (int i = 0; i < count; i++) {
        mt_morph morph;
        if (!mt_font_glyph(a, chars[i]) || !mt_font_glyph(b, chars[i])) continue;
        mt_status status = prepare(a, b, chars[i], &params, &arena, &morph);
        if (status == MT_OK && morph.a.whole.count > 0)
            status = look(&morph, &params, chars[i], &arena, &sum);
        if (status != MT_OK) {
            printf("U+%04X: %s\n", chars[i], mt_status_text(status));
            sum.failed++;
        }
        mt_arena_reset(&arena);
    }
    mt_arena_release(&arena);
    return sum;
}

int main(int argc, char **argv) {
    static uint32_t chars[CHARS_MAX];
    mt_font *a = NULL, *b = NULL;
    if (argc < 4) return 2;
    int count = mt_test_code_points(argc - 3, argv + 3, chars, CHARS_MAX);
    if (count < 0) return 2;
    if (mt_font_open(argv[1], &a) != MT_OK || mt_font_open(argv[2], &b) != MT_OK) return 77; /* skipped */
    mt_tally sum = look_at_all(a, b, chars, count);
    mt_font_close(a);
    mt_font_close(b);
    printf("%d glyphs, %d failed: %d proved for every T, %d of them in range\n", sum.glyphs, sum.failed,
           sum.proved, sum.in_range);
    printf("%d leave the range at one of %d places, %d of them at no twentieth; %d are proved to leave it "
           "between places\n",
           sum.sampled, PLACES, sum.between, sum.proved_only);
    printf("%d contradict the proof\n", sum.contradicted);
    return sum.contradicted > 0 || sum.proved == 0;
}
