/* The glyphs of a new font between two fonts or more: tuples of one glyph of each font. A glyph of the first font has one
 * tuple, its primary, of its partners in all other fonts; characters that lead to it there may lead elsewhere in the others,
 * and have further tuples. */
#include "glyphset/charset.h"

#include <stdlib.h>

#include "geometry/limits.h"
#include "glyphset/font_pair.h"

/* All glyphs but the first are MT_NO_PARTNER where some font has none. */
typedef struct mt_glyph_tuple {
    int count; /* of the fonts */
    uint32_t *of;
    uint32_t code_point; /* the first that leads here */
    bool mapped;
    uint16_t number; /* among the new font's glyphs */
} mt_glyph_tuple;

typedef struct mt_lister {
    int count;           /* of the fonts */
    mt_font_pair *pairs; /* the first font with each of the others */
    mt_arena *arena;
    int room;                  /* for the first font's glyphs */
    mt_glyph_tuple *primaries; /* of each of them; no `of` where it is not kept */
    int char_count;
    mt_glyph_tuple *leads; /* where each character leads */
    int further_count;
    mt_glyph_tuple *further;
    int glyph_count;
    const mt_glyph_tuple **glyphs; /* the new font's */
} mt_lister;

/* ---- tuples -------------------------------------------------------------------------------------------- */

static int by_fonts(const void *p, const void *q) {
    const mt_glyph_tuple *x = p, *y = q;
    for (int i = 0; i < x->count; i++)
        if (x->of[i] != y->of[i]) return x->of[i] < y->of[i] ? -1 : 1;
    return 0;
}

static int by_code_point(const void *p, const void *q) {
    const mt_glyph_tuple *x = p, *y = q;
    return (x->code_point > y->code_point) - (x->code_point < y->code_point);
}

static int by_fonts_and_code_point(const void *p, const void *q) {
    int order = by_fonts(p, q);
    return order ? order : by_code_point(p, q);
}

static mt_status new_tuple(const mt_lister *lister, uint32_t first, uint32_t code_point,
                           mt_glyph_tuple *tuple) {
    *tuple = (mt_glyph_tuple){.count = lister->count, .code_point = code_point};
    tuple->of = mt_arena_new(lister->arena, (size_t)lister->count, sizeof *tuple->of);
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

/* Of a glyph that all pairs keep. */
static mt_status add_primary(mt_lister *lister, int glyph) {
    mt_glyph_tuple *tuple = &lister->primaries[glyph];
    for (int i = 0; i + 1 < lister->count; i++)
        if (!lister->pairs[i].kept[glyph]) return MT_OK;
    mt_status status = new_tuple(lister, (uint32_t)glyph, lister->pairs[0].match.origin[glyph], tuple);
    if (status != MT_OK) return status;
    for (int i = 0; i + 1 < lister->count; i++) tuple->of[i + 1] = lister->pairs[i].match.partner[glyph];
    leave_alone(tuple);
    return MT_OK;
}

static mt_status list_primaries(mt_lister *lister) {
    lister->primaries = mt_arena_new(lister->arena, (size_t)lister->room, sizeof *lister->primaries);
    mt_status status = lister->primaries ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i < lister->room && status == MT_OK; i++) status = add_primary(lister, i);
    return status;
}

/* ---- characters ------------------------------------------------------------------------------------------ */

/* Where a character leads in every font. *shared: all pairs have it. */
static mt_status read_char(const mt_lister *lister, const mt_code *code, mt_glyph_tuple *lead, bool *shared) {
    mt_status status = new_tuple(lister, code->a, code->code_point, lead);
    *shared = true;
    for (int i = 0; i + 1 < lister->count && status == MT_OK; i++) {
        const mt_font_pair *pair = &lister->pairs[i];
        const mt_code *own = i ? mt_font_pair_code(pair, code->code_point) : code;
        *shared = own != NULL;
        if (!*shared) return MT_OK;
        lead->of[i + 1] = own->b ? own->b : pair->match.partner[code->a];
    }
    if (status == MT_OK) leave_alone(lead);
    return status;
}

/* All characters that are shared; those that lead to no primary are listed as further tuples. */
static mt_status list_chars(mt_lister *lister, const mt_charset_request *request) {
    const mt_codes *codes = &lister->pairs[0].codes;
    size_t room = (size_t)codes->count + 1;
    lister->leads = mt_arena_new(lister->arena, room, sizeof *lister->leads);
    lister->further = mt_arena_new(lister->arena, room, sizeof *lister->further);
    if (!lister->leads || !lister->further) return MT_NO_MEMORY;
    for (int i = 0; i < codes->count; i++) {
        mt_glyph_tuple *lead = &lister->leads[lister->char_count];
        mt_glyph_tuple *primary = &lister->primaries[codes->list[i].a];
        bool shared;
        mt_status status = read_char(lister, &codes->list[i], lead, &shared);
        if (status != MT_OK) return status;
        if (!shared || !primary->of) continue;
        lister->char_count++;
        bool leads_to_primary = by_fonts(lead, primary) == 0;
        if (!leads_to_primary) lister->further[lister->further_count++] = *lead;
        if (!leads_to_primary || primary->mapped) continue;
        primary->mapped = true;
        primary->code_point = lead->code_point;
    }
    return lister->char_count || request->glyph_count ? MT_OK : MT_NOTHING_SHARED;
}

/* Each further tuple once, in the order of the characters that lead there, as long as there is room. */
static void settle_further(mt_lister *lister, int room) {
    int once = 0, count = lister->further_count;
    mt_glyph_tuple *list = lister->further;
    if (count) qsort(list, (size_t)count, sizeof *list, by_fonts_and_code_point);
    for (int i = 0; i < count; i++)
        if (once == 0 || by_fonts(&list[i], &list[once - 1]) != 0) list[once++] = list[i];
    if (once) qsort(list, (size_t)once, sizeof *list, by_code_point);
    lister->further_count = once < room ? once : room;
}

/* ---- glyphs ---------------------------------------------------------------------------------------------- */

static mt_status number_glyphs(mt_lister *lister) {
    int primaries = 0;
    for (int i = 0; i < lister->room; i++) primaries += lister->primaries[i].of != NULL;
    settle_further(lister, MT_GLYPHS_MAX - primaries);
    size_t all = (size_t)primaries + (size_t)lister->further_count;
    lister->glyphs = mt_arena_new(lister->arena, all, sizeof *lister->glyphs);
    if (!lister->glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < lister->room; i++) {
        if (!lister->primaries[i].of) continue;
        lister->primaries[i].number = (uint16_t)lister->glyph_count;
        lister->glyphs[lister->glyph_count++] = &lister->primaries[i];
    }
    for (int i = 0; i < lister->further_count; i++) {
        lister->further[i].number = (uint16_t)lister->glyph_count;
        lister->further[i].mapped = true;
        lister->glyphs[lister->glyph_count++] = &lister->further[i];
    }
    return MT_OK;
}

static mt_status take_glyphs(const mt_lister *lister, mt_row_glyphs *glyphs) {
    mt_charset *charset = &glyphs->charset;
    size_t count = (size_t)lister->glyph_count;
    glyphs->fonts = (mt_font_glyphs){.font_count = lister->count, .glyph_count = lister->glyph_count};
    charset->glyph_count = lister->glyph_count;
    charset->primary_count = lister->glyph_count - lister->further_count;
    charset->glyphs = mt_arena_new(lister->arena, count, sizeof *charset->glyphs);
    if (!charset->glyphs) return MT_NO_MEMORY;
    for (size_t i = 0; i < count; i++) {
        const mt_glyph_tuple *tuple = lister->glyphs[i];
        charset->unblended_count += tuple->of[1] == MT_NO_PARTNER;
        charset->glyphs[i] = (mt_pairing){tuple->code_point, tuple->of[0], tuple->of[1], tuple->mapped};
    }
    for (int k = 0; k < lister->count; k++) {
        uint32_t *of = mt_arena_new(lister->arena, count, sizeof *of);
        if (!of) return MT_NO_MEMORY;
        for (size_t i = 0; i < count; i++) of[i] = lister->glyphs[i]->of[k];
        glyphs->fonts.of[k] = of;
    }
    return MT_OK;
}

/* A further tuple that there was no room for is its glyph's primary. */
static mt_status map_chars(const mt_lister *lister, mt_charset *charset) {
    size_t count = (size_t)lister->further_count;
    mt_glyph_tuple *sorted = mt_arena_new(lister->arena, count + 1, sizeof *sorted);
    charset->chars = mt_arena_new(lister->arena, (size_t)lister->char_count + 1, sizeof *charset->chars);
    if (!sorted || !charset->chars) return MT_NO_MEMORY;
    for (size_t i = 0; i < count; i++) sorted[i] = lister->further[i];
    if (count) qsort(sorted, count, sizeof *sorted, by_fonts);
    charset->char_count = lister->char_count;
    for (int i = 0; i < lister->char_count; i++) {
        const mt_glyph_tuple *lead = &lister->leads[i], *primary = &lister->primaries[lead->of[0]];
        const mt_glyph_tuple *found =
            by_fonts(lead, primary) == 0 ? NULL : bsearch(lead, sorted, count, sizeof *sorted, by_fonts);
        charset->chars[i] = (mt_char){lead->code_point, (found ? found : primary)->number};
    }
    return MT_OK;
}

/* The sequences that all pairs have. */
static mt_status list_variants(const mt_lister *lister, mt_charset *charset) {
    const mt_sequences *sequences = &lister->pairs[0].sequences;
    charset->variants = mt_arena_new(lister->arena, (size_t)sequences->count + 1, sizeof *charset->variants);
    if (!charset->variants) return MT_NO_MEMORY;
    for (int i = 0; i < sequences->count; i++) {
        const mt_variation_sequence *a = sequences->list[i].a;
        const mt_glyph_tuple *primary = &lister->primaries[a->glyph];
        bool shared = primary->of != NULL;
        for (int k = 1; k + 1 < lister->count && shared; k++)
            shared = mt_font_pair_sequence(&lister->pairs[k], &sequences->list[i]) != NULL;
        if (shared)
            charset->variants[charset->variant_count++] =
                (mt_char_variation){a->selector, a->code_point, primary->number, a->by_default};
    }
    return MT_OK;
}

/* Forms that no pair keeps for want of being asked for them. */
static void count_left_out(const mt_lister *lister, mt_charset *charset) {
    const mt_left_out *first = &lister->pairs[0].left;
    for (int i = 0; i < lister->room && first->glyphs; i++) {
        bool left = !lister->primaries[i].of;
        for (int k = 0; k + 1 < lister->count; k++)
            left = left && (lister->pairs[k].kept[i] || lister->pairs[k].left.glyphs[i]);
        charset->left_count += left;
    }
    charset->left_tag_count = first->tag_count;
    charset->left_tags = first->tags;
}

/* ---- the whole ------------------------------------------------------------------------------------------- */

/* The first font and another. */
static mt_status make_pair(mt_font *const *fonts, int other, const mt_charset_request *request,
                           mt_arena *arena, mt_font_pair *pair) {
    mt_charset_request own = *request;
    own.other = other;
    return mt_font_pair_make(fonts[0], fonts[other], &own, arena, pair);
}

mt_status mt_row_glyphs_make(mt_font *const *fonts, int count, const mt_charset_request *request,
                             mt_arena *arena, mt_row_glyphs *glyphs) {
    mt_row_glyphs made = {0};
    mt_lister lister = {.count = count, .arena = arena, .room = mt_font_glyph_count(fonts[0])};
    lister.pairs = mt_arena_new(arena, (size_t)count - 1, sizeof *lister.pairs);
    mt_status status = lister.pairs ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i + 1 < count && status == MT_OK; i++)
        status = make_pair(fonts, i + 1, request, arena, &lister.pairs[i]);
    if (status == MT_OK) status = list_primaries(&lister);
    if (status == MT_OK) status = list_chars(&lister, request);
    if (status == MT_OK) status = number_glyphs(&lister);
    if (status == MT_OK) status = take_glyphs(&lister, &made);
    if (status == MT_OK) status = map_chars(&lister, &made.charset);
    if (status == MT_OK) status = list_variants(&lister, &made.charset);
    if (status == MT_OK) count_left_out(&lister, &made.charset);
    if (status == MT_OK) *glyphs = made;
    return status;
}

mt_status mt_row_partners(mt_font *const *fonts, int count, const mt_given_pairs *pairs,
                          const uint32_t *glyphs, int glyph_count, mt_arena *arena, uint32_t **partners) {
    mt_row_glyphs set;
    const mt_charset_request request = {
        .set = MT_GLYPHS_FIRST, .pairs = pairs, .glyphs = glyphs, .glyph_count = glyph_count};
    uint32_t *numbers = mt_arena_new(arena, (size_t)mt_font_glyph_count(fonts[0]) + 1, sizeof *numbers);
    if (!numbers) return MT_NO_MEMORY;
    mt_status status = mt_row_glyphs_make(fonts, count, &request, arena, &set);
    for (int i = 0; status == MT_OK && i < set.charset.primary_count; i++)
        numbers[set.charset.glyphs[i].a] = (uint32_t)i;
    for (int k = 0; status == MT_OK && k < count; k++) {
        partners[k] = mt_arena_new(arena, (size_t)glyph_count + 1, sizeof *partners[k]);
        if (!partners[k]) status = MT_NO_MEMORY;
        for (int i = 0; status == MT_OK && i < glyph_count; i++)
            partners[k][i] = set.fonts.of[k][numbers[glyphs[i]]];
    }
    return status;
}

mt_status mt_charset_make(mt_font *a, mt_font *b, const mt_charset_request *request, mt_arena *arena,
                          mt_charset *charset) {
    mt_row_glyphs glyphs;
    mt_status status = mt_row_glyphs_make((mt_font *[]){a, b}, 2, request, arena, &glyphs);
    if (status == MT_OK) *charset = glyphs.charset;
    return status;
}

mt_status mt_charset_twins(const mt_charset *charset, mt_arena *arena, mt_layout_tables *tables) {
    int count = charset->primary_count, twin_count = charset->glyph_count - count;
    mt_twin *twins = mt_arena_new(arena, (size_t)twin_count + 1, sizeof *twins);
    uint16_t *numbers = mt_arena_new(arena, (size_t)MT_GLYPHS_MAX + 1, sizeof *numbers);
    if (!twins || !numbers) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) numbers[charset->glyphs[i].a] = (uint16_t)i;
    for (int i = 0; i < twin_count; i++)
        twins[i] = (mt_twin){(uint16_t)(count + i), numbers[charset->glyphs[count + i].a]};
    return mt_gsub_twins(tables, count, twins, twin_count, arena);
}
