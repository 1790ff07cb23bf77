#include "glyphset/match.h"

#include <hb-ot.h>

#include "gsub/face.h"

/* The lookups that features apply; those that contexts call are followed by HarfBuzz. */
static void list_lookups(const mt_gsub *gsub, hb_set_t *lookups) {
    for (int i = 0; i < gsub->layout.feature_count; i++) {
        if (mt_feature_tag(&gsub->layout, i) == MT_TAG('a', 'a', 'l', 't')) continue;
        for (int k = 0; k < mt_feature_lookup_count(&gsub->layout, i); k++) {
            int lookup = mt_feature_lookup(&gsub->layout, i, k);
            if (lookup >= 0) hb_set_add(lookups, (hb_codepoint_t)lookup);
        }
    }
}

static mt_status close_over(hb_face_t *face, const mt_gsub *gsub, bool *kept) {
    hb_set_t *lookups = hb_set_create(), *glyphs = hb_set_create();
    list_lookups(gsub, lookups);
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

mt_status mt_match_reach(const mt_gsub *gsub, bool *kept) {
    mt_face_tables tables = {.gsub = gsub->table, .glyph_count = gsub->glyph_count};
    if (gsub->layout.lookup_count == 0) return MT_OK;
    hb_face_t *face = mt_face_make(&tables);
    if (!face) return MT_NO_MEMORY;
    mt_status status = close_over(face, gsub, kept);
    hb_face_destroy(face);
    return status;
}
