/* Pairs by text: both fonts shape the same texts, and what stands at the same places belongs together. */
#include "glyphset/match.h"

#include "glyphset/texts.h"

/* Whether a character leads to this glyph by itself. */
static bool leads_to(mt_shaper *shaper, uint32_t code, uint32_t glyph) {
    mt_shaped_text shaped = mt_shaper_shape(shaper, &code, 1);
    return shaped.count == 1 && shaped.glyphs[0].codepoint == glyph;
}

/* What a character leads to in B, which stays as it is where that is nothing. */
static mt_status settle(mt_text_pairs *pairs, mt_code *code) {
    mt_shaped_text shaped = mt_shaper_shape(&pairs->b, &code->code_point, 1);
    uint32_t drawing = MT_NO_DRAWING;
    if (shaped.count == 1 && shaped.glyphs[0].codepoint) code->b = shaped.glyphs[0].codepoint;
    if (shaped.count < 2) return MT_OK;
    for (unsigned i = 0; i < shaped.count; i++)
        if (!shaped.glyphs[i].codepoint) return MT_OK;
    mt_status status = mt_runs_add(&pairs->runs, &shaped, (mt_run){0, shaped.count}, MT_RUN_WHOLE, &drawing);
    if (status == MT_OK && drawing != MT_NO_DRAWING) status = mt_runs_compose(&pairs->runs, &drawing);
    if (status == MT_OK && drawing != MT_NO_DRAWING) code->b = drawing;
    return status;
}

mt_status mt_text_pairs_settle(mt_text_pairs *pairs, const mt_glyph_match *match, mt_code *codes, int count) {
    mt_status status = MT_OK;
    for (int i = 0; pairs->found && i < count && status == MT_OK; i++) {
        mt_code *code = &codes[i];
        if (!code->b || match->partner[code->a] != MT_NO_PARTNER) continue;
        if (leads_to(&pairs->a, code->code_point, code->a)) status = settle(pairs, code);
    }
    return status;
}

static mt_status open(mt_text_pairs *pairs, mt_glyph_match *match, const mt_gsub *gsub_a,
                      const mt_gsub *gsub_b, mt_arena *arena) {
    mt_status status = mt_shaper_open(match->a, gsub_a, arena, &pairs->a);
    if (status == MT_OK) status = mt_shaper_open(match->b, gsub_b, arena, &pairs->b);
    mt_runs_open(&pairs->b, &match->ink_b, &pairs->runs);
    pairs->votes = (mt_votes){
        .a = &pairs->a, .b = &pairs->b, .ink_a = &match->ink_a, .ink_b = &match->ink_b, .runs = &pairs->runs};
    return status;
}

mt_status mt_text_pairs_find(mt_text_pairs *pairs, mt_glyph_match *match, const mt_gsub *gsub_a,
                             const mt_gsub *gsub_b, const uint32_t *chars, int count, mt_arena *arena) {
    mt_texts texts = {&pairs->votes, count, chars};
    *pairs = (mt_text_pairs){.found = gsub_a->layout.lookup_count || gsub_b->layout.lookup_count};
    if (!pairs->found) return MT_OK;
    mt_status status = open(pairs, match, gsub_a, gsub_b, arena);
    if (status == MT_OK) status = mt_texts_of_scripts(&texts, gsub_a, gsub_b, arena);
    if (status == MT_OK) status = mt_texts_of_rules(&texts, gsub_a, arena);
    if (status == MT_OK) status = pairs->a.status;
    if (status == MT_OK) status = pairs->b.status;
    if (status == MT_OK && pairs->votes.failed) status = MT_NO_MEMORY;
    if (status == MT_OK && (pairs->a.endless || pairs->b.endless)) status = MT_ENDLESS_LOOKUPS;
    if (status == MT_OK) mt_votes_sort(&pairs->votes);
    return status;
}

mt_status mt_text_pairs_apply(const mt_text_pairs *pairs, mt_glyph_match *match) {
    for (int i = 0; i < pairs->votes.count; i++) {
        const mt_vote *vote = &pairs->votes.list[i];
        uint32_t b = vote->b;
        if (match->partner[vote->a] != MT_NO_PARTNER) continue;
        mt_status status = mt_runs_compose(&pairs->runs, &b);
        if (status != MT_OK) return status;
        if (b != MT_NO_DRAWING) mt_match_form(match, vote->a, b, vote->origin);
    }
    return MT_OK;
}

void mt_text_pairs_close(mt_text_pairs *pairs) {
    mt_shaper_close(&pairs->a);
    mt_shaper_close(&pairs->b);
    mt_runs_free(&pairs->runs);
    mt_votes_free(&pairs->votes);
}
