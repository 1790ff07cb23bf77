#include "glyphset/row_glyphs.h"

#include <stdlib.h>

#include "geometry/limits.h"

/* A glyph of the new font: one of each font. All but the first are MT_NO_PARTNER where some font has none. */
typedef struct mt_glyph_tuple {
    int count; /* of the fonts */
    uint32_t *of;
    uint32_t code_point; /* the first that leads here */
    bool mapped;
    uint16_t number; /* among the new font's glyphs */
} mt_glyph_tuple;

typedef struct mt_rower {
    int count;         /* of the fonts */
    mt_charset *pairs; /* the first font with each of the others */
    mt_arena *arena;
    int room;                  /* for the first font's glyphs */
    mt_glyph_tuple *primaries; /* of each of them; no `of` where it is not kept */
    int further_count;
    mt_glyph_tuple *further; /* where characters lead elsewhere than to their glyph's primary */
    int glyph_count;
    const mt_glyph_tuple **glyphs; /* the new font's */
    int char_count;
    mt_char *chars;
    int variant_count;
    mt_char_variation *variants;
} mt_rower;

/* ---- tuples -------------------------------------------------------------------------------------------- */

static int compare_tuples(const mt_glyph_tuple *x, const mt_glyph_tuple *y) {
    for (int i = 0; i < x->count; i++)
        if (x->of[i] != y->of[i]) return x->of[i] < y->of[i] ? -1 : 1;
    return 0;
}

static int by_glyphs(const void *p, const void *q) {
    const mt_glyph_tuple *x = p, *y = q;
    int order = compare_tuples(x, y);
    return order ? order : (x->code_point > y->code_point) - (x->code_point < y->code_point);
}

static int by_code_point(const void *p, const void *q) {
    const mt_glyph_tuple *x = p, *y = q;
    return (x->code_point > y->code_point) - (x->code_point < y->code_point);
}

static mt_status new_tuple(const mt_rower *rower, uint32_t first, mt_glyph_tuple *tuple) {
    *tuple = (mt_glyph_tuple){
        rower->count, mt_arena_new(rower->arena, (size_t)rower->count, sizeof(uint32_t)), 0, false, 0};
    if (!tuple->of) return MT_NO_MEMORY;
    tuple->of[0] = first;
    return MT_OK;
}

static void leave_alone(mt_glyph_tuple *tuple) {
    bool whole = true;
    for (int i = 1; i < tuple->count; i++) whole = whole && tuple->of[i] != MT_NO_PARTNER;
    for (int i = 1; i < tuple->count && !whole; i++) tuple->of[i] = MT_NO_PARTNER;
}

/* ---- the first font's glyphs, each once ------------------------------------------------------------------ */

/* Those that all pairs have; `next` is where each pair's list has been read to. */
static mt_status add_primary(mt_rower *rower, const mt_pairing *pairing, int *next) {
    mt_glyph_tuple *tuple = &rower->primaries[pairing->a];
    mt_glyph_tuple made;
    mt_status status = new_tuple(rower, pairing->a, &made);
    for (int i = 0; i + 1 < rower->count && status == MT_OK; i++) {
        const mt_charset *pair = &rower->pairs[i];
        while (next[i] < pair->primary_count && pair->glyphs[next[i]].a < pairing->a) next[i]++;
        if (next[i] == pair->primary_count || pair->glyphs[next[i]].a != pairing->a) return MT_OK;
        made.of[i + 1] = pair->glyphs[next[i]].b;
    }
    if (status != MT_OK) return status;
    leave_alone(&made);
    made.code_point = pairing->code_point;
    *tuple = made;
    return MT_OK;
}

static mt_status list_primaries(mt_rower *rower) {
    const mt_charset *pair = &rower->pairs[0];
    int *next = mt_arena_new(rower->arena, (size_t)rower->count, sizeof *next);
    rower->primaries = mt_arena_new(rower->arena, (size_t)rower->room, sizeof *rower->primaries);
    if (!next || !rower->primaries) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i < pair->primary_count && status == MT_OK; i++)
        status = add_primary(rower, &pair->glyphs[i], next);
    return status;
}

/* ---- characters ------------------------------------------------------------------------------------------ */

/* The pair's glyph for a character; -1 where it has none. */
static int find_char(const mt_charset *pair, uint32_t code_point) {
    int low = 0, high = pair->char_count;
    while (low < high) {
        int middle = (low + high) / 2;
        if (pair->chars[middle].code_point < code_point)
            low = middle + 1;
        else
            high = middle;
    }
    bool found = low < pair->char_count && pair->chars[low].code_point == code_point;
    return found ? pair->chars[low].glyph : -1;
}

/* Where a character leads in every font. *shared: all pairs have it. */
static mt_status read_char(const mt_rower *rower, uint32_t code_point, mt_glyph_tuple *tuple, bool *shared) {
    *shared = true;
    mt_status status = new_tuple(rower, 0, tuple);
    for (int i = 0; i + 1 < rower->count && status == MT_OK && *shared; i++) {
        int glyph = find_char(&rower->pairs[i], code_point);
        *shared = glyph >= 0;
        if (!*shared) return MT_OK;
        tuple->of[0] = rower->pairs[i].glyphs[glyph].a;
        tuple->of[i + 1] = rower->pairs[i].glyphs[glyph].b;
    }
    tuple->code_point = code_point;
    if (status == MT_OK) leave_alone(tuple);
    return status;
}

/* All characters that are shared; those that lead to no primary are listed as further tuples. */
static mt_status list_chars(mt_rower *rower) {
    const mt_charset *pair = &rower->pairs[0];
    size_t room = (size_t)pair->char_count + 1;
    rower->chars = mt_arena_new(rower->arena, room, sizeof *rower->chars);
    rower->further = mt_arena_new(rower->arena, room, sizeof *rower->further);
    if (!rower->chars || !rower->further) return MT_NO_MEMORY;
    for (int i = 0; i < pair->char_count; i++) {
        mt_glyph_tuple tuple;
        bool shared;
        mt_status status = read_char(rower, pair->chars[i].code_point, &tuple, &shared);
        if (status != MT_OK) return status;
        mt_glyph_tuple *primary = &rower->primaries[tuple.of[0]];
        if (!shared || !primary->of) continue;
        rower->chars[rower->char_count++].code_point = tuple.code_point;
        bool leads_to_primary = compare_tuples(&tuple, primary) == 0;
        if (!leads_to_primary) rower->further[rower->further_count++] = tuple;
        if (!leads_to_primary || primary->mapped) continue;
        primary->mapped = true;
        primary->code_point = tuple.code_point;
    }
    return rower->char_count ? MT_OK : MT_NOTHING_SHARED;
}

/* Each further tuple once, in the order of the characters that lead there, as long as there is room. */
static void settle_further(mt_rower *rower, int room) {
    int once = 0, count = rower->further_count;
    mt_glyph_tuple *list = rower->further;
    if (count) qsort(list, (size_t)count, sizeof *list, by_glyphs);
    for (int i = 0; i < count; i++)
        if (once == 0 || compare_tuples(&list[i], &list[once - 1]) != 0) list[once++] = list[i];
    if (once) qsort(list, (size_t)once, sizeof *list, by_code_point);
    rower->further_count = once < room ? once : room;
}

/* ---- glyphs ---------------------------------------------------------------------------------------------- */

static mt_status number_glyphs(mt_rower *rower) {
    int primaries = 0;
    for (int i = 0; i < rower->room; i++) primaries += rower->primaries[i].of != NULL;
    settle_further(rower, MT_GLYPHS_MAX - primaries);
    size_t all = (size_t)primaries + (size_t)rower->further_count;
    rower->glyphs = mt_arena_new(rower->arena, all, sizeof *rower->glyphs);
    if (!rower->glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < rower->room; i++) {
        if (!rower->primaries[i].of) continue;
        rower->primaries[i].number = (uint16_t)rower->glyph_count;
        rower->glyphs[rower->glyph_count++] = &rower->primaries[i];
    }
    for (int i = 0; i < rower->further_count; i++) {
        rower->further[i].number = (uint16_t)rower->glyph_count;
        rower->further[i].mapped = true;
        rower->glyphs[rower->glyph_count++] = &rower->further[i];
    }
    return MT_OK;
}

/* The further tuples are in order of glyphs again, to be looked up. */
static mt_status map_chars(mt_rower *rower) {
    size_t count = (size_t)rower->further_count;
    mt_glyph_tuple *sorted = mt_arena_new(rower->arena, count + 1, sizeof *sorted);
    if (!sorted) return MT_NO_MEMORY;
    for (size_t i = 0; i < count; i++) sorted[i] = rower->further[i];
    if (count) qsort(sorted, count, sizeof *sorted, by_glyphs);
    for (int i = 0; i < rower->char_count; i++) {
        mt_glyph_tuple tuple;
        bool shared;
        mt_status status = read_char(rower, rower->chars[i].code_point, &tuple, &shared);
        if (status != MT_OK) return status;
        const mt_glyph_tuple *found = &rower->primaries[tuple.of[0]];
        size_t low = 0, high = compare_tuples(&tuple, found) == 0 ? 0 : count;
        while (low < high) {
            size_t middle = (low + high) / 2;
            int order = compare_tuples(&sorted[middle], &tuple);
            if (order == 0) found = &sorted[middle];
            if (order < 0)
                low = middle + 1;
            else
                high = middle;
        }
        rower->chars[i].glyph = found->number;
    }
    return MT_OK;
}

static bool has_variant(const mt_charset *pair, const mt_char_variation *variant) {
    for (int low = 0, high = pair->variant_count; low < high;) {
        int middle = (low + high) / 2;
        const mt_char_variation *v = &pair->variants[middle];
        if (v->selector == variant->selector && v->code_point == variant->code_point) return true;
        bool before = v->selector < variant->selector ||
                      (v->selector == variant->selector && v->code_point < variant->code_point);
        if (before)
            low = middle + 1;
        else
            high = middle;
    }
    return false;
}

static mt_status list_variants(mt_rower *rower) {
    const mt_charset *pair = &rower->pairs[0];
    rower->variants = mt_arena_new(rower->arena, (size_t)pair->variant_count + 1, sizeof *rower->variants);
    if (!rower->variants) return MT_NO_MEMORY;
    for (int i = 0; i < pair->variant_count; i++) {
        mt_char_variation variant = pair->variants[i];
        const mt_glyph_tuple *primary = &rower->primaries[pair->glyphs[variant.glyph].a];
        bool shared = primary->of != NULL;
        for (int k = 1; k + 1 < rower->count; k++) shared = shared && has_variant(&rower->pairs[k], &variant);
        if (!shared) continue;
        variant.glyph = primary->number;
        rower->variants[rower->variant_count++] = variant;
    }
    return MT_OK;
}

/* ---- the whole ------------------------------------------------------------------------------------------- */

static mt_status take_font(const mt_rower *rower, int font, mt_row_glyphs *glyphs) {
    uint32_t *of = mt_arena_new(rower->arena, (size_t)rower->glyph_count, sizeof *of);
    if (!of) return MT_NO_MEMORY;
    for (int i = 0; i < rower->glyph_count; i++) of[i] = rower->glyphs[i]->of[font];
    glyphs->fonts.of[font] = of;
    return MT_OK;
}

static mt_status take_charset(const mt_rower *rower, mt_charset *charset) {
    *charset = (mt_charset){.glyph_count = rower->glyph_count,
                            .primary_count = rower->glyph_count - rower->further_count,
                            .char_count = rower->char_count,
                            .chars = rower->chars,
                            .variant_count = rower->variant_count,
                            .variants = rower->variants};
    charset->glyphs = mt_arena_new(rower->arena, (size_t)rower->glyph_count, sizeof *charset->glyphs);
    if (!charset->glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < rower->glyph_count; i++) {
        const mt_glyph_tuple *tuple = rower->glyphs[i];
        charset->unblended_count += tuple->of[1] == MT_NO_PARTNER;
        charset->glyphs[i] = (mt_pairing){tuple->code_point, tuple->of[0], tuple->of[1], tuple->mapped};
    }
    return MT_OK;
}

static mt_status put_together(mt_rower *rower, mt_row_glyphs *glyphs) {
    mt_status status = list_primaries(rower);
    if (status == MT_OK) status = list_chars(rower);
    if (status == MT_OK) status = number_glyphs(rower);
    if (status == MT_OK) status = map_chars(rower);
    if (status == MT_OK) status = list_variants(rower);
    if (status == MT_OK) status = take_charset(rower, &glyphs->charset);
    glyphs->fonts = (mt_font_glyphs){.font_count = rower->count, .glyph_count = rower->glyph_count};
    for (int k = 0; k < rower->count && status == MT_OK; k++) status = take_font(rower, k, glyphs);
    return status;
}

mt_status mt_row_glyphs_make(mt_font *const *fonts, int count, const mt_charset_request *request,
                             mt_arena *arena, mt_row_glyphs *glyphs) {
    mt_row_glyphs made;
    mt_rower rower = {.count = count, .arena = arena, .room = mt_font_glyph_count(fonts[0])};
    rower.pairs = mt_arena_new(arena, (size_t)count - 1, sizeof(mt_charset));
    if (!rower.pairs) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i + 1 < count && status == MT_OK; i++)
        status = mt_charset_make(fonts[0], fonts[i + 1], request, arena, &rower.pairs[i]);
    if (status != MT_OK) return status;
    made.charset = rower.pairs[0];
    status =
        count > 2 ? put_together(&rower, &made) : mt_font_glyphs_make(rower.pairs, 2, arena, &made.fonts);
    if (status == MT_OK) *glyphs = made;
    return status;
}
