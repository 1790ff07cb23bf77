#include "glyphset/match.h"

#include <hb-ot.h>
#include <string.h>

#include "layout/feature_tags.h"
#include "sfnt/layout_face.h"

/* What a reach goes by: all features but 'aalt', or of them those that shaping turns on by itself. */
typedef struct mt_reach {
    const mt_gsub *gsub;
    bool asked_for, fractions;
} mt_reach;

static bool is_required(const mt_layout *layout, int feature) {
    for (int i = 0; i < layout->system_count; i++)
        if (layout->systems[i].required == feature) return true;
    return false;
}

/* Whether text has the feature without asking for it. */
static bool is_automatic(const mt_gsub *gsub, int feature, bool fractions) {
    return mt_feature_is_automatic(mt_feature_tag(&gsub->layout, feature), fractions) ||
           is_required(&gsub->layout, feature);
}

/* The lookups that features apply; those that contexts call are followed by HarfBuzz. */
static void list_lookups(const mt_reach *reach, hb_set_t *lookups) {
    const mt_layout *layout = &reach->gsub->layout;
    for (int i = 0; i < layout->feature_count; i++) {
        if (mt_feature_tag(layout, i) == MT_TAG('a', 'a', 'l', 't')) continue;
        if (!reach->asked_for && !is_automatic(reach->gsub, i, reach->fractions)) continue;
        for (int k = 0; k < mt_feature_lookup_count(layout, i); k++) {
            int lookup = mt_feature_lookup(layout, i, k);
            if (lookup >= 0) hb_set_add(lookups, (hb_codepoint_t)lookup);
        }
    }
}

static mt_status close_over(hb_face_t *face, const mt_reach *reach, bool *kept) {
    const mt_gsub *gsub = reach->gsub;
    hb_set_t *lookups = hb_set_create(), *glyphs = hb_set_create();
    list_lookups(reach, lookups);
    for (int i = 0; i < gsub->glyph_count; i++)
        if (kept[i]) hb_set_add(glyphs, (hb_codepoint_t)i);
    hb_ot_layout_lookups_substitute_closure(face, lookups, glyphs);
    bool whole = hb_set_allocation_successful(lookups) && hb_set_allocation_successful(glyphs);
    for (hb_codepoint_t glyph = HB_SET_VALUE_INVALID; whole && hb_set_next(glyphs, &glyph);)
        if (glyph < (hb_codepoint_t)gsub->glyph_count) kept[glyph] = true;
    hb_set_destroy(lookups);
    hb_set_destroy(glyphs);
    return whole ? MT_OK : MT_NO_MEMORY;
}

static mt_status extend(const mt_reach *reach, bool *kept) {
    const mt_gsub *gsub = reach->gsub;
    mt_face_tables tables = {.gsub = gsub->table, .glyph_count = gsub->glyph_count};
    if (gsub->layout.lookup_count == 0) return MT_OK;
    hb_face_t *face = mt_face_make(&tables);
    if (!face) return MT_NO_MEMORY;
    mt_status status = close_over(face, reach, kept);
    hb_face_destroy(face);
    return status;
}

mt_status mt_match_reach(const mt_gsub *gsub, bool *kept) {
    return extend(&(mt_reach){.gsub = gsub, .asked_for = true}, kept);
}

mt_status mt_match_reach_automatic(const mt_gsub *gsub, bool fractions, bool *kept) {
    return extend(&(mt_reach){.gsub = gsub, .fractions = fractions}, kept);
}

/* ---- what is left out ---------------------------------------------------------------------------------- */

/* Whether a lookup makes glyphs that are not kept of those that are reached. */
static bool leads_out(const mt_gsub_lookup *lookup, const bool *kept, const bool *reached) {
    for (int i = 0; i < lookup->subtable_count; i++)
        for (int k = 0; k < lookup->subtables[i].count; k++) {
            const mt_substitution *substitution = &lookup->subtables[i].list[k];
            bool made = true, out = false;
            for (int n = 0; n < substitution->inputs; n++) made = made && reached[substitution->glyphs[n]];
            for (int n = 0; n < substitution->outputs; n++)
                out = out || !kept[substitution->glyphs[substitution->inputs + n]];
            if (made && out) return true;
        }
    return false;
}

static bool feature_leads_out(const mt_gsub *gsub, int feature, const bool *kept, const bool *reached,
                              bool *marked) {
    bool found = false;
    memset(marked, 0, (size_t)gsub->layout.lookup_count * sizeof *marked);
    mt_gsub_mark(gsub, feature, marked);
    for (int i = 0; i < gsub->layout.lookup_count && !found; i++)
        found = marked[i] && leads_out(&gsub->lookups[i], kept, reached);
    return found;
}

static bool is_listed(const mt_left_out *left, uint32_t tag) {
    for (int i = 0; i < left->tag_count; i++)
        if (left->tags[i] == tag) return true;
    return false;
}

mt_status mt_match_left_out(const mt_gsub *gsub, const bool *kept, bool fractions, mt_arena *arena,
                            mt_left_out *left) {
    const mt_layout *layout = &gsub->layout;
    size_t count = (size_t)gsub->glyph_count;
    mt_left_out made = {.glyphs = mt_arena_new(arena, count + 1, sizeof *made.glyphs),
                        .tags = mt_arena_new(arena, (size_t)layout->feature_count + 1, sizeof *made.tags)};
    bool *marked = mt_arena_new(arena, (size_t)layout->lookup_count + 1, sizeof *marked);
    if (!made.glyphs || !made.tags || !marked) return MT_NO_MEMORY;
    memcpy(made.glyphs, kept, count * sizeof *kept);
    mt_status status = mt_match_reach(gsub, made.glyphs);
    for (int i = 0; i < layout->feature_count && status == MT_OK; i++) {
        uint32_t tag = mt_feature_tag(layout, i);
        if (tag == MT_TAG('a', 'a', 'l', 't') || is_automatic(gsub, i, fractions) || is_listed(&made, tag))
            continue;
        if (feature_leads_out(gsub, i, kept, made.glyphs, marked)) made.tags[made.tag_count++] = tag;
    }
    for (size_t i = 0; i < count; i++) made.glyphs[i] = made.glyphs[i] && !kept[i];
    if (status == MT_OK) *left = made;
    return status;
}
