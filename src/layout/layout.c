#include "layout/layout.h"

#include "sfnt/sfnt.h"

/* ---- systems ---------------------------------------------------------------------------------------------- */

static int find_system(const mt_layout *layout, uint32_t script, uint32_t language) {
    for (int i = 0; i < layout->system_count; i++)
        if (layout->systems[i].script == script && layout->systems[i].language == language) return i;
    return -1;
}

int mt_layout_system(const mt_layout *layout, uint32_t script, uint32_t language) {
    uint32_t scripts[] = {script, MT_TAG('D', 'F', 'L', 'T'), MT_TAG('d', 'f', 'l', 't'),
                          MT_TAG('l', 'a', 't', 'n')};
    for (int i = 0; i < 4; i++) {
        int found = find_system(layout, scripts[i], language);
        if (found < 0) found = find_system(layout, scripts[i], MT_LANGUAGE_DEFAULT);
        if (found >= 0) return found;
    }
    return -1;
}

int mt_latin_rank(uint32_t script, uint32_t language) {
    if (language != MT_LANGUAGE_DEFAULT) return 2;
    return script == MT_TAG('l', 'a', 't', 'n') ? 0 : script == MT_TAG('D', 'F', 'L', 'T') ? 1 : 2;
}

/* ---- features ------------------------------------------------------------------------------------------ */

int mt_system_feature(const mt_layout *layout, const mt_system *system, int i) {
    int feature =
        i < system->feature_count ? (int)mt_ot_u16(system->features, 2 * (size_t)i) : system->required;
    return feature < layout->feature_count ? feature : -1;
}

uint32_t mt_feature_tag(const mt_layout *layout, int feature) {
    return mt_ot_u32(layout->features, 2 + 6 * (size_t)feature);
}

static mt_bytes feature_table(const mt_layout *layout, int feature) {
    return mt_ot_follow(layout->features, 6 + 6 * (size_t)feature);
}

int mt_feature_lookup_count(const mt_layout *layout, int feature) {
    mt_bytes table = feature_table(layout, feature);
    return mt_ot_fit(table, 4, mt_ot_u16(table, 2), 2);
}

int mt_feature_lookup(const mt_layout *layout, int feature, int i) {
    int lookup = (int)mt_ot_u16(feature_table(layout, feature), 4 + 2 * (size_t)i);
    return lookup < layout->lookup_count ? lookup : -1;
}

bool mt_feature_has(const mt_layout *layout, int feature, int lookup) {
    int count = mt_feature_lookup_count(layout, feature);
    for (int i = 0; i < count; i++)
        if (mt_feature_lookup(layout, feature, i) == lookup) return true;
    return false;
}

/* ---- lookups ------------------------------------------------------------------------------------------- */

mt_lookup mt_layout_lookup(const mt_layout *layout, int index) {
    mt_bytes table = mt_ot_follow(layout->lookups, 2 + 2 * (size_t)index);
    mt_lookup lookup = {.type = (int)mt_ot_u16(table, 0), .flag = (int)mt_ot_u16(table, 2), .table = table};
    unsigned count = mt_ot_u16(table, 4);
    lookup.subtable_count = mt_ot_fit(table, 6, count, 2);
    lookup.mark_set = lookup.flag & MT_LOOKUP_MARK_SET ? (int)mt_ot_u16(table, 6 + 2 * (size_t)count) : -1;
    if (lookup.type == layout->extension) {
        lookup.extended = true;
        lookup.type = (int)mt_ot_u16(mt_ot_follow(table, 6), 2);
        if (lookup.type == layout->extension) lookup.type = 0;
    }
    return lookup;
}

mt_bytes mt_lookup_subtable(const mt_lookup *lookup, int i) {
    mt_bytes subtable = mt_ot_follow(lookup->table, 6 + 2 * (size_t)i);
    if (!lookup->extended) return subtable;
    if (mt_ot_u16(subtable, 0) != 1 || (int)mt_ot_u16(subtable, 2) != lookup->type) return (mt_bytes){0};
    return mt_ot_follow32(subtable, 4);
}
