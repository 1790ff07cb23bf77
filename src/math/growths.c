/* MathVariants of all fonts, for each of the new font's glyphs. */
#include "math/job.h"

/* A glyph that grows, and what stands for it in each font. */
typedef struct mt_math_grower {
    int glyph, direction;
    const mt_math_construction *in_fonts[MT_STOPS_MAX]; /* NULL where a font has none for it */
} mt_math_grower;

/* The new font's glyph for a larger one of the first font's, which may be the grower itself; -1 where it is not there. */
static int new_glyph(const mt_math_job *job, const mt_math_grower *grower, uint16_t glyph) {
    return glyph == job->glyphs.of[0][grower->glyph] ? grower->glyph : job->numbers[glyph];
}

/* How much longer the glyph's outline is in a font than in the first. */
static mt_status find_growth(mt_math_job *job, const mt_math_grower *grower, int font, int glyph,
                             double *longer) {
    const mt_anchor_point low = {-1e6, -1e6}, high = {1e6, 1e6}; /* outside of every outline: 32 em at most */
    mt_anchor_point from = low, to = high;
    mt_outline_moves *moves = &job->sources[font].moves;
    mt_status status = mt_outline_move(moves, glyph, low, &from);
    if (status == MT_OK) status = mt_outline_move(moves, glyph, high, &to);
    bool vertical = grower->direction == MT_MATH_VERTICAL;
    *longer = vertical ? (to.y - from.y) - (high.y - low.y) : (to.x - from.x) - (high.x - low.x);
    return status;
}

/* The first font's measure as it is in a font that has none: it goes with the outline. */
static mt_status moved_measure(mt_math_job *job, const mt_math_grower *grower, int font, int glyph,
                               double first, double *measure) {
    double longer = 0;
    mt_status status = find_growth(job, grower, font, glyph, &longer);
    *measure = first + longer > 0 ? first + longer : first;
    return status;
}

/* ---- larger glyphs ------------------------------------------------------------------------------------- */

static const mt_math_variant *find_variant(const mt_math_construction *own, uint32_t glyph) {
    for (int i = 0; own && i < own->variant_count; i++)
        if (own->variants[i].glyph == glyph) return &own->variants[i];
    return NULL;
}

static mt_status fill_measure(mt_math_job *job, const mt_math_grower *grower, int glyph, double first,
                              double *row) {
    mt_status status = MT_OK;
    row[0] = first * job->sources[0].scale;
    for (int k = 1; k < job->font_count && status == MT_OK; k++) {
        uint32_t own = job->glyphs.of[k][glyph];
        const mt_math_variant *found = find_variant(grower->in_fonts[k], own);
        row[k] = found ? found->measure * job->sources[k].scale : row[0];
        if (!found && own != MT_NO_PARTNER) status = moved_measure(job, grower, k, glyph, row[0], &row[k]);
    }
    return status;
}

static mt_status add_variants(mt_math_job *job, const mt_math_grower *grower, mt_math_growth *growth) {
    const mt_math_construction *first = grower->in_fonts[0];
    mt_status status = MT_OK;
    growth->variants = mt_arena_new(job->arena, (size_t)first->variant_count + 1, sizeof *growth->variants);
    if (!growth->variants) return MT_NO_MEMORY;
    for (int i = 0; i < first->variant_count && status == MT_OK; i++) {
        int glyph = new_glyph(job, grower, first->variants[i].glyph);
        if (glyph < 0) continue;
        double *row = mt_math_new_row(job);
        if (!row) return MT_NO_MEMORY;
        growth->variants[growth->variant_count++] = (mt_math_variant_row){(uint16_t)glyph, row};
        status = fill_measure(job, grower, glyph, first->variants[i].measure, row);
    }
    return status;
}

/* ---- assemblies ---------------------------------------------------------------------------------------- */

/* A part in a font that has not the same assembly: its lengths are to one another as in the first font. */
static mt_status move_part(mt_math_job *job, const mt_math_grower *grower, int font, int glyph, double *start,
                           double *end, double *full) {
    mt_status status = moved_measure(job, grower, font, glyph, full[0], &full[font]);
    double ratio = full[0] > 0 ? full[font] / full[0] : 1;
    start[font] = start[0] * ratio;
    end[font] = end[0] * ratio;
    return status;
}

static mt_status add_part(mt_math_job *job, const mt_math_grower *grower, int index, int glyph,
                          mt_math_growth *growth) {
    double *start = mt_math_new_row(job), *end = mt_math_new_row(job), *full = mt_math_new_row(job);
    const mt_math_construction *first = grower->in_fonts[0];
    mt_status status = MT_OK;
    if (!start || !end || !full) return MT_NO_MEMORY;
    for (int k = 0; k < job->font_count && status == MT_OK; k++) {
        const mt_math_construction *own = grower->in_fonts[k];
        uint32_t in_font = job->glyphs.of[k][glyph];
        bool same = own && mt_math_same_assembly(first, own) && own->parts[index].glyph == in_font;
        const mt_math_source *source = &job->sources[same ? k : 0];
        const mt_math_part *part = same ? &own->parts[index] : &first->parts[index];
        start[k] = part->start * source->scale;
        end[k] = part->end * source->scale;
        full[k] = part->full * source->scale;
        if (!same && in_font != MT_NO_PARTNER) status = move_part(job, grower, k, glyph, start, end, full);
    }
    growth->parts[index] = (mt_math_part_row){(uint16_t)glyph, first->parts[index].flags, start, end, full};
    return status;
}

static mt_status add_italics(const mt_math_job *job, const mt_math_grower *grower, mt_math_growth *growth) {
    double *row = mt_math_new_row(job);
    if (!row) return MT_NO_MEMORY;
    for (int k = 0; k < job->font_count; k++) {
        const mt_math_construction *own = grower->in_fonts[k];
        int from = own && own->has_assembly ? k : 0;
        row[k] = grower->in_fonts[from]->italics * job->sources[from].scale;
    }
    growth->italics = row;
    return MT_OK;
}

/* No assembly where a part of it is not there. */
static mt_status add_assembly(mt_math_job *job, const mt_math_grower *grower, mt_math_growth *growth) {
    const mt_math_construction *first = grower->in_fonts[0];
    for (int i = 0; i < first->part_count; i++)
        if (job->numbers[first->parts[i].glyph] < 0) return MT_OK;
    growth->parts = mt_arena_new(job->arena, (size_t)first->part_count + 1, sizeof *growth->parts);
    mt_status status = growth->parts ? add_italics(job, grower, growth) : MT_NO_MEMORY;
    for (int i = 0; i < first->part_count && status == MT_OK; i++)
        status = add_part(job, grower, i, job->numbers[first->parts[i].glyph], growth);
    growth->part_count = first->part_count;
    return status;
}

/* ---- all of them --------------------------------------------------------------------------------------- */

/* Whether the first font has it grow. */
static bool find_grower(mt_math_job *job, int glyph, int direction, mt_math_grower *grower) {
    grower->glyph = glyph;
    grower->direction = direction;
    for (int k = 0; k < job->font_count; k++) {
        uint32_t own = job->glyphs.of[k][glyph];
        const mt_math_constructions *all = &job->sources[k].table.constructions[direction];
        grower->in_fonts[k] = own == MT_NO_PARTNER ? NULL : mt_math_construction_find(all, own);
    }
    const mt_math_construction *first = grower->in_fonts[0];
    return first && mt_math_spend(job, first->variant_count + first->part_count);
}

static mt_status prepare_direction(mt_math_job *job, int direction, mt_math_growths *growths) {
    mt_status status = MT_OK;
    growths->list = mt_arena_new(job->arena, (size_t)job->glyphs.glyph_count, sizeof *growths->list);
    if (!growths->list) return MT_NO_MEMORY;
    for (int i = 0; i < job->glyphs.glyph_count && status == MT_OK; i++) {
        mt_math_grower grower;
        if (!find_grower(job, i, direction, &grower)) continue;
        mt_math_growth *growth = &growths->list[growths->count];
        growth->glyph = (uint16_t)i;
        status = add_variants(job, &grower, growth);
        if (status == MT_OK) status = add_assembly(job, &grower, growth);
        growths->count += growth->variant_count || growth->part_count;
    }
    return status;
}

mt_status mt_math_prepare_growths(mt_math_job *job) {
    mt_status status = MT_OK;
    for (int i = 0; i < MT_MATH_DIRECTIONS && status == MT_OK; i++)
        status = prepare_direction(job, i, &job->math->growths[i]);
    return status;
}
