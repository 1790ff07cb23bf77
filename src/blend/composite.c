/* Composites of a row: for each glyph, the references of the first font are matched with those of the second, these with
 * those of the third, and so on. What a part may be is looked up in the new font's glyphs, sorted by what they are in the
 * fonts, by as many fonts as were looked at so far. n references cost n² in each font. */
#include "blend/composite.h"

#include <math.h>
#include <stdlib.h>

#include "arithmetic/angles.h"
#include "write/extent.h"

/* A glyph of the new font, to be found by what it is in each font. */
typedef struct mt_sorted_glyph {
    const uint32_t *of;
    int font_count, glyph;
} mt_sorted_glyph;

typedef struct mt_finder {
    const mt_row *row;
    const mt_font_glyphs *glyphs;
    mt_sorted_glyph *sorted; /* by what they are in the first font, then in the second, and so on */
    mt_composite *composites;
    mt_arena *arena, scratch;
} mt_finder;

/* A part of the glyph at hand, as the fonts have it that were looked at so far. */
typedef struct mt_placed_part {
    uint32_t *of;
    int (*at)[2];
} mt_placed_part;

/* ---- the glyph of several others ----------------------------------------------------------------------- */

/* Compares what they are in as many fonts as the first of them knows. */
static int by_fonts(const void *p, const void *q) {
    const mt_sorted_glyph *x = p, *y = q;
    for (int k = 0; k < x->font_count; k++)
        if (x->of[k] != y->of[k]) return x->of[k] < y->of[k] ? -1 : 1;
    return 0;
}

static mt_status sort_glyphs(mt_finder *finder) {
    size_t count = (size_t)finder->glyphs->glyph_count, fonts = (size_t)finder->glyphs->font_count;
    uint32_t *of = mt_arena_new(&finder->scratch, count, fonts * sizeof *of);
    finder->sorted = mt_arena_new(&finder->scratch, count, sizeof *finder->sorted);
    if (!of || !finder->sorted) return MT_NO_MEMORY;
    for (size_t i = 0; i < count; i++, of += fonts) {
        for (size_t k = 0; k < fonts; k++) of[k] = finder->glyphs->of[k][i];
        finder->sorted[i] = (mt_sorted_glyph){of, (int)fonts, (int)i};
    }
    qsort(finder->sorted, count, sizeof *finder->sorted, by_fonts);
    return MT_OK;
}

/* A glyph of the new font that is `of` in the first `font_count` fonts; -1 where there is none. */
static int find_glyph(const mt_finder *finder, const uint32_t *of, int font_count) {
    const mt_sorted_glyph key = {of, font_count, 0};
    const mt_sorted_glyph *found =
        bsearch(&key, finder->sorted, (size_t)finder->glyphs->glyph_count, sizeof key, by_fonts);
    return found ? found->glyph : -1;
}

/* ---- one glyph ----------------------------------------------------------------------------------------- */

/* How far a part moves from one font to a reference of the next, in em. */
static double distance(const mt_finder *finder, const mt_placed_part *part, const mt_reference *next,
                       int font) {
    double em_a = mt_font_units_per_em(finder->row->fonts[font - 1]),
           em_b = mt_font_units_per_em(finder->row->fonts[font]);
    return mt_hypot(part->at[font - 1][0] / em_a - next->dx / em_b,
                    part->at[font - 1][1] / em_a - next->dy / em_b);
}

/* Matches a part with the font's reference, not used yet, that makes a glyph with it; the nearest of several, such as the
 * two dots of a dieresis. */
static bool match(const mt_finder *finder, mt_placed_part *part, const mt_references *own, bool *used,
                  int font) {
    int best = -1;
    for (int k = 0; k < own->count; k++) {
        const mt_reference *r = &own->list[k];
        part->of[font] = r->glyph;
        if (used[k] || find_glyph(finder, part->of, font + 1) < 0) continue;
        if (best >= 0 && distance(finder, part, r, font) >= distance(finder, part, &own->list[best], font))
            continue;
        best = k;
    }
    if (best < 0) return false;
    used[best] = true;
    part->of[font] = own->list[best].glyph;
    part->at[font][0] = own->list[best].dx;
    part->at[font][1] = own->list[best].dy;
    return true;
}

static mt_status start_parts(mt_finder *finder, const mt_references *first, mt_placed_part **parts) {
    size_t fonts = (size_t)finder->row->font_count;
    *parts = mt_arena_new(&finder->scratch, (size_t)first->count, sizeof **parts);
    if (!*parts) return MT_NO_MEMORY;
    for (int i = 0; i < first->count; i++) {
        mt_placed_part *part = &(*parts)[i];
        part->of = mt_arena_new(&finder->scratch, fonts, sizeof *part->of);
        part->at = mt_arena_new(finder->arena, fonts, sizeof *part->at);
        if (!part->of || !part->at) return MT_NO_MEMORY;
        part->of[0] = first->list[i].glyph;
        part->at[0][0] = first->list[i].dx;
        part->at[0][1] = first->list[i].dy;
    }
    return MT_OK;
}

/* *matched: each part has a counterpart in the font, and the font no more of them. */
static mt_status match_font(mt_finder *finder, int glyph, int font, mt_placed_part *parts, int count,
                            bool *matched) {
    mt_references own;
    mt_status status =
        mt_font_references(finder->row->fonts[font], finder->glyphs->of[font][glyph], &finder->scratch, &own);
    if (status != MT_OK) return status;
    bool *used = mt_arena_new(&finder->scratch, (size_t)own.count, sizeof *used);
    if (!used) return MT_NO_MEMORY;
    *matched = own.count == count;
    for (int i = 0; i < count && *matched; i++) *matched = match(finder, &parts[i], &own, used, font);
    return MT_OK;
}

static mt_status read_composite(mt_finder *finder, int glyph) {
    mt_references first;
    mt_placed_part *parts;
    bool matched = true;
    mt_composite *composite = &finder->composites[glyph];
    mt_status status =
        mt_font_references(finder->row->fonts[0], finder->glyphs->of[0][glyph], &finder->scratch, &first);
    if (status != MT_OK || first.count == 0) return status;
    status = start_parts(finder, &first, &parts);
    for (int k = 1; k < finder->row->font_count && status == MT_OK && matched; k++)
        status = match_font(finder, glyph, k, parts, first.count, &matched);
    if (status != MT_OK || !matched) return status;
    composite->references = mt_arena_new(finder->arena, (size_t)first.count, sizeof *composite->references);
    if (!composite->references) return MT_NO_MEMORY;
    composite->count = first.count;
    for (int i = 0; i < first.count; i++) {
        int part = find_glyph(finder, parts[i].of, finder->row->font_count);
        composite->references[i] = (mt_row_reference){(uint16_t)part, parts[i].at};
    }
    return MT_OK;
}

static bool has_hints(const mt_finder *finder, int glyph) {
    const mt_font_glyphs *glyphs = finder->glyphs;
    for (int k = 0; k + 1 < finder->row->font_count; k++)
        if (mt_hint_index_find(finder->row->hints[k], glyphs->of[k][glyph], glyphs->of[k + 1][glyph]).count)
            return true;
    return false;
}

static mt_status read_all(mt_finder *finder) {
    mt_status status = sort_glyphs(finder);
    for (int i = 1; i < finder->glyphs->glyph_count && status == MT_OK; i++) {
        mt_arena_place before = mt_arena_mark(&finder->scratch);
        if (finder->glyphs->of[1][i] == MT_NO_PARTNER || has_hints(finder, i)) continue;
        status = read_composite(finder, i);
        mt_arena_rewind(&finder->scratch, before);
    }
    return status;
}

/* ---- depths -------------------------------------------------------------------------------------------- */

enum { UNKNOWN = -1 };

/* One more than the deepest part's; UNKNOWN while a part's is not known. */
static int depth_of(const mt_composite *composite, const mt_composite *composites) {
    int depth = 0;
    for (int i = 0; i < composite->count; i++) {
        int part = composites[composite->references[i].glyph].depth;
        if (part == UNKNOWN) return UNKNOWN;
        if (part >= depth) depth = part + 1;
    }
    return depth;
}

/* A round finds all depths that are one more. What is left then is too deep, or part of itself, and no composite. */
static void find_depths(mt_composite *composites, int count) {
    for (int i = 0; i < count; i++) composites[i].depth = composites[i].count ? UNKNOWN : 0;
    for (int round = 0; round < MT_GLYF_DEPTH_MAX; round++)
        for (int i = 0; i < count; i++)
            if (composites[i].depth == UNKNOWN) composites[i].depth = depth_of(&composites[i], composites);
    for (int i = 0; i < count; i++)
        if (composites[i].depth == UNKNOWN || composites[i].depth > MT_GLYF_DEPTH_MAX)
            composites[i] = (mt_composite){0};
}

/* ---- all of them --------------------------------------------------------------------------------------- */

mt_status mt_composites_find(const mt_row *row, const mt_font_glyphs *glyphs, mt_arena *arena,
                             mt_composite **composites) {
    mt_finder finder = {.row = row, .glyphs = glyphs, .arena = arena};
    finder.composites = mt_arena_new(arena, (size_t)glyphs->glyph_count, sizeof *finder.composites);
    if (!finder.composites) return MT_NO_MEMORY;
    mt_status status = row->params.rotation == MT_ROTATION_NONE ? read_all(&finder) : MT_OK;
    mt_arena_release(&finder.scratch);
    if (status != MT_OK) return status;
    find_depths(finder.composites, glyphs->glyph_count);
    *composites = finder.composites;
    return MT_OK;
}

static bool to_units(double value, int16_t *rounded) {
    double whole = floor(value + 0.5);
    if (!(whole >= INT16_MIN && whole <= INT16_MAX)) return false;
    *rounded = (int16_t)whole;
    return true;
}

bool mt_reference_at(const mt_row *row, const mt_row_reference *reference, int first, mt_at at, int units,
                     int16_t *dx, int16_t *dy) {
    const int *a = reference->at[first], *b = reference->at[first + 1];
    double unit_a = (double)units / mt_font_units_per_em(row->fonts[first]);
    double unit_b = (double)units / mt_font_units_per_em(row->fonts[first + 1]);
    return to_units((1 - at.x) * unit_a * a[0] + at.x * unit_b * b[0], dx) &&
           to_units((1 - at.y) * unit_a * a[1] + at.y * unit_b * b[1], dy);
}
