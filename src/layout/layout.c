#include "layout/layout.h"

#include "sfnt/sfnt.h"

/* More is no font: the largest have some hundred systems and lookups, each system some hundred features. */
enum { SYSTEMS_MAX = 4096, LOOKUPS_MAX = 4096, FEATURES_MAX = 1024, ENTRIES_MAX = 65536 };

/* ---- scripts and language systems ---------------------------------------------------------------------- */

static mt_system read_system(mt_bytes table, uint32_t script, uint32_t language) {
    unsigned required = mt_ot_u16(table, 2), count = mt_ot_u16(table, 4);
    return (mt_system){script, language, required == 0xFFFF ? -1 : (int)required,
                       mt_ot_fit(table, 6, count < FEATURES_MAX ? count : FEATURES_MAX, 2),
                       mt_ot_at(table, 6)};
}

/* Counts only where `systems` is NULL. */
static int list_script(mt_bytes table, uint32_t script, mt_system *systems) {
    int count = 0, languages = mt_ot_fit(table, 4, mt_ot_u16(table, 2), 6);
    mt_bytes by_default = mt_ot_follow(table, 0);
    if (by_default.length) {
        if (systems) systems[count] = read_system(by_default, script, MT_LANGUAGE_DEFAULT);
        count++;
    }
    for (int i = 0; i < languages; i++) {
        size_t at = 4 + 6 * (size_t)i;
        mt_bytes system = mt_ot_follow(table, at + 4);
        if (!system.length) continue;
        if (systems) systems[count] = read_system(system, script, mt_ot_u32(table, at));
        count++;
    }
    return count;
}

static int list_systems(mt_bytes scripts, mt_system *systems) {
    int all = mt_ot_fit(scripts, 2, mt_ot_u16(scripts, 0), 6), count = 0;
    for (int i = 0; i < all; i++) {
        size_t at = 2 + 6 * (size_t)i;
        mt_bytes script = mt_ot_follow(scripts, at + 4);
        count += list_script(script, mt_ot_u32(scripts, at), systems ? systems + count : NULL);
    }
    return count;
}

static int64_t count_entries(const mt_layout *layout) {
    int64_t count = 0;
    for (int i = 0; i < layout->system_count; i++) count += layout->systems[i].feature_count;
    for (int i = 0; i < layout->feature_count; i++) count += mt_feature_lookup_count(layout, i);
    return count;
}

mt_status mt_layout_open(mt_bytes table, int extension, mt_arena *arena, mt_layout *layout) {
    mt_layout made = {.extension = extension};
    mt_bytes scripts = mt_ot_u16(table, 0) == 1 ? mt_ot_follow(table, 4) : (mt_bytes){0};
    int count = list_systems(scripts, NULL);
    if (count > 0 && count <= SYSTEMS_MAX) {
        made.systems = mt_arena_new(arena, (size_t)count, sizeof *made.systems);
        if (!made.systems) return MT_NO_MEMORY;
        made.system_count = list_systems(scripts, made.systems);
        made.features = mt_ot_follow(table, 6);
        made.lookups = mt_ot_follow(table, 8);
        made.feature_count = mt_ot_fit(made.features, 2, mt_ot_u16(made.features, 0), 6);
        made.lookup_count = mt_ot_fit(made.lookups, 2, mt_ot_u16(made.lookups, 0), 2);
        if (made.lookup_count > LOOKUPS_MAX || count_entries(&made) > ENTRIES_MAX)
            made = (mt_layout){.extension = extension};
    }
    mt_status status = mt_calls_read(&made, arena, &made.calls);
    if (status == MT_OK) *layout = made;
    return status;
}

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
