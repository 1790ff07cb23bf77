#include "anchors/subtable.h"

#include <stdlib.h>
#include <string.h>

bool mt_anchor_spend(mt_anchor_job *job, int64_t steps) {
    job->steps = job->steps < steps ? 0 : job->steps - steps;
    return job->steps > 0;
}

static int by_glyph(const void *p, const void *q) {
    const mt_entry *x = p, *y = q;
    return x->glyph - y->glyph;
}

mt_status mt_anchor_entries(mt_anchor_job *job, mt_bytes coverage, mt_entry **entries, int *count) {
    mt_covered *covered;
    int covered_count, all = 0, filled = 0;
    mt_status status = mt_coverage_list(coverage, &job->scratch, &covered, &covered_count);
    if (status != MT_OK) return status;
    for (int i = 0; i < covered_count; i++)
        all += (int)(job->first[covered[i].glyph + 1] - job->first[covered[i].glyph]);
    if (!mt_anchor_spend(job, (int64_t)covered_count + all)) all = 0;
    mt_entry *made = mt_arena_new(&job->scratch, (size_t)all + 1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    for (int i = 0; i < covered_count && filled < all; i++)
        for (uint32_t j = job->first[covered[i].glyph]; j < job->first[covered[i].glyph + 1]; j++)
            made[filled++] = (mt_entry){job->new_of_a[j], covered[i].index};
    qsort(made, (size_t)filled, sizeof *made, by_glyph);
    *entries = made;
    *count = filled;
    return MT_OK;
}

mt_anchor mt_anchor_new(mt_anchor_job *job, mt_anchor from, int known, mt_arena *arena) {
    mt_anchor made = {mt_arena_new(arena, (size_t)job->glyphs->font_count, sizeof *made.in_fonts)};
    if (made.in_fonts && known) memcpy(made.in_fonts, from.in_fonts, (size_t)known * sizeof *made.in_fonts);
    return made;
}

mt_anchor_point mt_anchor_scaled(const mt_anchor_job *job, int font, mt_anchor_point point) {
    return (mt_anchor_point){job->scales[font] * point.x, job->scales[font] * point.y};
}

mt_status mt_anchor_move(mt_anchor_job *job, int font, int glyph, mt_anchor anchor) {
    return mt_outline_move(&job->moves[font], glyph, anchor.in_fonts[0], &anchor.in_fonts[font]);
}
