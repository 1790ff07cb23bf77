/* Pairs by text: both fonts shape the same texts, and the glyphs at the same places belong together. */
#include "glyphset/match.h"

#include "glyphset/texts.h"

/* The glyph that a character leads to by itself; 0 where it leads to none or to several. */
static uint32_t shape_one(mt_shaper *shaper, uint32_t code) {
    mt_shaped_text shaped = mt_shaper_shape(shaper, &code, 1);
    return shaped.count == 1 ? shaped.glyphs[0].codepoint : 0;
}

void mt_text_pairs_settle(mt_text_pairs *pairs, const mt_glyph_match *match, mt_code *codes, int count) {
    for (int i = 0; pairs->found && i < count; i++) {
        mt_code *code = &codes[i];
        if (!code->b || match->partner[code->a] != MT_NO_PARTNER) continue;
        if (shape_one(&pairs->a, code->code_point) != code->a) continue;
        uint32_t in_b = shape_one(&pairs->b, code->code_point);
        if (in_b) code->b = in_b;
    }
}

mt_status mt_text_pairs_find(mt_text_pairs *pairs, const mt_glyph_match *match, const mt_gsub *gsub_a,
                             const mt_gsub *gsub_b, const uint32_t *chars, int count, mt_arena *arena) {
    mt_texts texts = {&pairs->votes, &pairs->a, &pairs->b, count, chars};
    *pairs = (mt_text_pairs){.found = gsub_a->layout.lookup_count || gsub_b->layout.lookup_count};
    if (!pairs->found) return MT_OK;
    mt_status status = mt_shaper_open(match->a, gsub_a, arena, &pairs->a);
    if (status == MT_OK) status = mt_shaper_open(match->b, gsub_b, arena, &pairs->b);
    if (status == MT_OK) status = mt_texts_of_scripts(&texts, gsub_a, gsub_b, arena);
    if (status == MT_OK) status = mt_texts_of_rules(&texts, gsub_a, arena);
    if (status == MT_OK && pairs->votes.failed) status = MT_NO_MEMORY;
    if (status == MT_OK && (pairs->a.endless || pairs->b.endless)) status = MT_ENDLESS_LOOKUPS;
    if (status == MT_OK) mt_votes_sort(&pairs->votes);
    return status;
}

void mt_text_pairs_apply(const mt_text_pairs *pairs, mt_glyph_match *match) {
    for (int i = 0; i < pairs->votes.count; i++) {
        const mt_vote *vote = &pairs->votes.list[i];
        mt_match_form(match, vote->a, vote->b, vote->origin);
    }
}

void mt_text_pairs_close(mt_text_pairs *pairs) {
    mt_shaper_close(&pairs->a);
    mt_shaper_close(&pairs->b);
    mt_votes_free(&pairs->votes);
}
