#include "layout/open.h"

#include "layout/calls.h"

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
