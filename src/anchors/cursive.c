/* One cursive attachment subtable of A's, blended. A glyph's anchors are mixed each on its own, because both
 * are places on its outline; what only A has moves with it. */
#include "anchors/cursive.h"

#include <string.h>

static mt_cursive *add_cursive(mt_anchor_job *job, mt_anchor_lookup *lookup, int count) {
    mt_cursive *grown = mt_arena_grow_list(job->arena, lookup->cursives, lookup->cursive_count,
                                           &lookup->cursive_room, sizeof *grown);
    if (!grown) return NULL;
    lookup->cursives = grown;
    mt_cursive *made = &lookup->cursives[lookup->cursive_count];
    *made = (mt_cursive){.glyphs = mt_arena_new(job->arena, (size_t)count, sizeof *made->glyphs)};
    return made->glyphs ? made : NULL;
}

/* Another font's anchor, of the first subtable that has one. */
static bool find_rival(mt_anchor_job *job, int font, int glyph, int side, const mt_rivals *rivals,
                       mt_anchor_point *point) {
    uint32_t own = job->glyphs->of[font][glyph];
    if (own == MT_NO_PARTNER) return false;
    for (int i = 0; i < rivals->count && mt_anchor_spend(job, 1); i++) {
        int index = mt_coverage_find(mt_cursive_coverage(rivals->subtables[i]), own);
        if (mt_cursive_anchor(rivals->subtables[i], index, side, job->sources[font].variations, point))
            return true;
    }
    return false;
}

static mt_status blend_side(mt_anchor_job *job, mt_bytes subtable, const mt_entry *entry, int side,
                            const mt_rivals *rivals, mt_cursive_glyph *made) {
    mt_anchor_point point;
    mt_status status = MT_OK;
    if (!mt_cursive_anchor(subtable, entry->index, side, job->sources[0].variations, &point)) return MT_OK;
    mt_anchor at = mt_anchor_new(job, (mt_anchor){NULL}, 0, job->arena);
    if (!at.in_fonts) return MT_NO_MEMORY;
    at.in_fonts[0] = mt_anchor_scaled(job, 0, point);
    for (int k = 1; k < job->glyphs->font_count && status == MT_OK; k++) {
        if (find_rival(job, k, entry->glyph, side, &rivals[k], &point))
            at.in_fonts[k] = mt_anchor_scaled(job, k, point);
        else
            status = mt_anchor_move(job, k, entry->glyph, at);
    }
    made->has[side] = true;
    made->at[side] = at;
    return status;
}

mt_status mt_cursive_blend(mt_anchor_job *job, mt_bytes subtable, const mt_rivals *rivals,
                           mt_anchor_lookup *lookup) {
    mt_entry *entries;
    int count;
    mt_status status = mt_anchor_entries(job, mt_cursive_coverage(subtable), &entries, &count);
    if (status != MT_OK) return status;
    if (count == 0 || !mt_anchor_spend(job, MT_ANCHOR_KEPT_STEPS * (int64_t)count)) return MT_OK;
    mt_cursive *made = add_cursive(job, lookup, count);
    if (!made) return MT_NO_MEMORY;
    for (int i = 0; i < count && status == MT_OK; i++) {
        mt_cursive_glyph *glyph = &made->glyphs[made->count];
        *glyph = (mt_cursive_glyph){.glyph = entries[i].glyph};
        for (int side = 0; side < 2 && status == MT_OK; side++)
            status = blend_side(job, subtable, &entries[i], side, rivals, glyph);
        made->count += glyph->has[0] || glyph->has[1];
    }
    lookup->cursive_count += made->count > 0;
    return status;
}
