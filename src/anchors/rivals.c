#include "anchors/rivals.h"

enum { SUBTABLE_STEPS = 16 }; /* what one that is listed counts for */

/* Notes the lookups that the font's system applies for the feature. */
static void note_feature(mt_anchor_job *job, int font, int own, uint32_t tag, bool *wanted) {
    const mt_layout *layout = job->sources[font].layout;
    const mt_system *system = &layout->systems[own];
    for (int i = 0; i <= system->feature_count && mt_anchor_spend(job, 1); i++) {
        int feature = mt_system_feature(layout, system, i);
        if (feature < 0 || mt_feature_tag(layout, feature) != tag) continue;
        int count = mt_feature_lookup_count(layout, feature);
        for (int j = 0; j < count && mt_anchor_spend(job, 1); j++) {
            int lookup = mt_feature_lookup(layout, feature, j);
            if (lookup >= 0) wanted[lookup] = true;
        }
    }
}

/* Keeps only the lookups of the type; returns how many subtables they have. */
static int count_subtables(mt_anchor_job *job, int font, int type, bool *wanted) {
    const mt_layout *layout = job->sources[font].layout;
    int count = 0;
    for (int i = 0; i < layout->lookup_count; i++) {
        if (!wanted[i]) continue;
        mt_lookup lookup = mt_layout_lookup(layout, i);
        wanted[i] =
            lookup.type == type && mt_anchor_spend(job, SUBTABLE_STEPS * (int64_t)lookup.subtable_count);
        if (wanted[i]) count += lookup.subtable_count;
    }
    return count;
}

/* The subtables of the wanted lookups, of later lookups first. */
static mt_status list_subtables(mt_anchor_job *job, int font, int type, bool *wanted, mt_rivals *rivals) {
    const mt_layout *layout = job->sources[font].layout;
    int count = 0;
    bool can = mt_anchor_spend(job, layout->lookup_count);
    int all = can ? count_subtables(job, font, type, wanted) : 0;
    mt_bytes *subtables = mt_arena_new(&job->scratch, (size_t)all + 1, sizeof *subtables);
    if (!subtables) return MT_NO_MEMORY;
    for (int i = layout->lookup_count - 1; i >= 0 && count < all; i--) {
        if (!wanted[i]) continue;
        mt_lookup rival = mt_layout_lookup(layout, i);
        for (int j = 0; j < rival.subtable_count; j++) subtables[count++] = mt_lookup_subtable(&rival, j);
    }
    *rivals = (mt_rivals){count, subtables};
    return MT_OK;
}

mt_status mt_rivals_find(mt_anchor_job *job, int font, const mt_lookup_builder *lookup, mt_rivals *rivals) {
    int lookup_count = job->sources[font].layout->lookup_count;
    bool *wanted = mt_arena_new(&job->scratch, (size_t)lookup_count + 1, sizeof *wanted);
    if (!wanted) return MT_NO_MEMORY;
    for (int i = 0; i < lookup->member_count && mt_anchor_spend(job, 1); i++) {
        int system = job->systems->list[lookup->members[i].system].own[font];
        if (system >= 0) note_feature(job, font, system, lookup->members[i].feature, wanted);
    }
    return list_subtables(job, font, lookup->type, wanted, rivals);
}

mt_status mt_rivals_of(mt_anchor_job *job, int font, int lookup, mt_rivals *rivals) {
    const mt_layout *layout = job->sources[font].layout;
    bool *wanted = mt_arena_new(&job->scratch, (size_t)layout->lookup_count + 1, sizeof *wanted);
    if (!wanted) return MT_NO_MEMORY;
    wanted[lookup] = true;
    return list_subtables(job, font, mt_layout_lookup(layout, lookup).type, wanted, rivals);
}
