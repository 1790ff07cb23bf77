/* MathGlyphInfo of all fonts, for each of the new font's glyphs. */
#include "geometry/limits.h"
#include "math/job.h"

/* ---- italics corrections and accents ------------------------------------------------------------------- */

/* One of the two kinds of values. What a font has for a glyph that its table leaves out: no correction; half the advance. */
typedef struct mt_math_kind {
    bool is_accent;
    const mt_math_values *of[MT_STOPS_MAX];
} mt_math_kind;

/* The glyph's advance in the new font's units; 0 where it cannot be read. */
static mt_status read_advance(const mt_math_job *job, int font, uint32_t glyph, double *advance) {
    double on_grid = 0;
    mt_status status = mt_font_advance(job->sources[font].font, glyph, &on_grid);
    *advance = status == MT_OK ? on_grid * job->units / MT_EM : 0;
    return status == MT_NO_MEMORY ? status : MT_OK;
}

static mt_status own_value(const mt_math_job *job, const mt_math_kind *kind, int font, uint32_t glyph,
                           double *value) {
    const mt_math_value *found = mt_math_value_find(kind->of[font], glyph);
    double advance = 0;
    mt_status status = found || !kind->is_accent ? MT_OK : read_advance(job, font, glyph, &advance);
    *value = found ? found->value * job->sources[font].scale : advance / 2;
    return status;
}

/* In a font that has no such table: the first font's; an accent goes with the outline. */
static mt_status moved_value(mt_math_job *job, const mt_math_kind *kind, int font, int glyph, double first,
                             double *value) {
    mt_anchor_point at = {first, 0}, to = at;
    mt_status status = kind->is_accent ? mt_outline_move(&job->sources[font].moves, glyph, at, &to) : MT_OK;
    *value = to.x;
    return status;
}

static mt_status fill_row(mt_math_job *job, const mt_math_kind *kind, int glyph, double *row) {
    mt_status status = own_value(job, kind, 0, job->glyphs.of[0][glyph], &row[0]);
    for (int k = 1; k < job->font_count && status == MT_OK; k++) {
        uint32_t other = job->glyphs.of[k][glyph];
        row[k] = row[0];
        if (other == MT_NO_PARTNER) continue;
        status = kind->of[k]->present ? own_value(job, kind, k, other, &row[k])
                                      : moved_value(job, kind, k, glyph, row[0], &row[k]);
    }
    return status;
}

static bool has_value(const mt_math_job *job, const mt_math_kind *kind, int glyph) {
    for (int k = 0; k < job->font_count; k++) {
        uint32_t own = job->glyphs.of[k][glyph];
        if (own != MT_NO_PARTNER && mt_math_value_find(kind->of[k], own)) return true;
    }
    return false;
}

static mt_status prepare_values(mt_math_job *job, const mt_math_kind *kind, mt_math_rows *rows) {
    mt_status status = MT_OK;
    if (!kind->of[0]->present) return MT_OK;
    rows->list = mt_arena_new(job->arena, (size_t)job->glyphs.glyph_count, sizeof *rows->list);
    if (!rows->list) return MT_NO_MEMORY;
    for (int i = 0; i < job->glyphs.glyph_count && status == MT_OK; i++) {
        if (!has_value(job, kind, i)) continue;
        double *row = mt_math_new_row(job);
        if (!row) return MT_NO_MEMORY;
        bool in_first = mt_math_value_find(kind->of[0], job->glyphs.of[0][i]) != NULL;
        rows->list[rows->count++] = (mt_math_row){(uint16_t)i, in_first, row};
        status = fill_row(job, kind, i, row);
    }
    return status;
}

static mt_status prepare_corrections(mt_math_job *job) {
    mt_math_kind italics = {.is_accent = false}, accents = {.is_accent = true};
    for (int k = 0; k < job->font_count; k++) {
        italics.of[k] = &job->sources[k].table.italics;
        accents.of[k] = &job->sources[k].table.accents;
    }
    mt_status status = prepare_values(job, &italics, &job->math->italics);
    return status == MT_OK ? prepare_values(job, &accents, &job->math->accents) : status;
}

/* ---- extended shapes ----------------------------------------------------------------------------------- */

static mt_status prepare_extended(mt_math_job *job) {
    mt_math *math = job->math;
    const mt_math_values *first = &job->sources[0].table.extended;
    math->extended = mt_arena_new(job->arena, (size_t)job->glyphs.glyph_count, sizeof *math->extended);
    if (!math->extended) return MT_NO_MEMORY;
    for (int i = 0; i < job->glyphs.glyph_count; i++)
        if (mt_math_value_find(first, job->glyphs.of[0][i]))
            math->extended[math->extended_count++] = (uint16_t)i;
    return MT_OK;
}

/* ---- kerns at corners ---------------------------------------------------------------------------------- */

/* A font's kern and what its units are in the new font's. */
typedef struct mt_math_scaled_kern {
    const mt_math_kern *kern;
    double scale;
} mt_math_scaled_kern;

/* The font's own where it has as many heights as the first font's; else the first font's. */
static mt_math_scaled_kern choose_kern(const mt_math_job *job, int font, int glyph, int corner,
                                       const mt_math_kern *first) {
    const mt_math_source *source = &job->sources[font];
    uint32_t own = job->glyphs.of[font][glyph];
    const mt_math_glyph_kerns *kerns =
        own == MT_NO_PARTNER ? NULL : mt_math_kerns_find(&source->table.kerns, own);
    const mt_math_kern *kern = kerns ? &kerns->corners[corner] : NULL;
    bool alike = kern && kern->present && kern->count == first->count;
    return alike ? (mt_math_scaled_kern){kern, source->scale}
                 : (mt_math_scaled_kern){first, job->sources[0].scale};
}

static mt_status prepare_corner(const mt_math_job *job, int glyph, int corner, const mt_math_kern *first,
                                mt_math_kern_rows *rows) {
    size_t count = (size_t)first->count, fonts = (size_t)job->font_count;
    double *heights = mt_arena_new(job->arena, count * fonts + 1, sizeof *heights);
    double *kerns = mt_arena_new(job->arena, (count + 1) * fonts, sizeof *kerns);
    *rows = (mt_math_kern_rows){first->present, first->count, heights, kerns};
    if (!heights || !kerns) return MT_NO_MEMORY;
    for (size_t k = 0; k < fonts && first->present; k++) {
        mt_math_scaled_kern own = choose_kern(job, (int)k, glyph, corner, first);
        for (size_t i = 0; i < count; i++) heights[i * fonts + k] = own.kern->heights[i] * own.scale;
        for (size_t i = 0; i <= count; i++) kerns[i * fonts + k] = own.kern->kerns[i] * own.scale;
    }
    return MT_OK;
}

static int count_kerns(const mt_math_glyph_kerns *kerns) {
    int count = 0;
    for (int c = 0; c < MT_MATH_CORNERS; c++) count += 2 * kerns->corners[c].count + 1;
    return count;
}

static mt_status prepare_kerns(mt_math_job *job) {
    mt_math *math = job->math;
    mt_status status = MT_OK;
    math->kerns = mt_arena_new(job->arena, (size_t)job->glyphs.glyph_count, sizeof *math->kerns);
    if (!math->kerns) return MT_NO_MEMORY;
    for (int i = 0; i < job->glyphs.glyph_count && status == MT_OK; i++) {
        const mt_math_glyph_kerns *first =
            mt_math_kerns_find(&job->sources[0].table.kerns, job->glyphs.of[0][i]);
        if (!first || !mt_math_spend(job, count_kerns(first))) continue;
        mt_math_corner_rows *rows = &math->kerns[math->kern_count++];
        rows->glyph = (uint16_t)i;
        for (int c = 0; c < MT_MATH_CORNERS && status == MT_OK; c++)
            status = prepare_corner(job, i, c, &first->corners[c], &rows->corners[c]);
    }
    return status;
}

mt_status mt_math_prepare_info(mt_math_job *job) {
    mt_status status = prepare_corrections(job);
    if (status == MT_OK) status = prepare_extended(job);
    return status == MT_OK ? prepare_kerns(job) : status;
}
