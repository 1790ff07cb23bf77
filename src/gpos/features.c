/* The FeatureList and the ScriptList. */
#include <stdlib.h>
#include <string.h>

#include "gpos/gpos.h"

/* ---- features ------------------------------------------------------------------------------------------ */

/* That a feature of a system has a lookup. */
typedef struct mt_feature_entry {
    int system;
    uint32_t tag;
    int lookup;
} mt_feature_entry;

static int by_system(const void *p, const void *q) {
    const mt_feature_entry *x = p, *y = q;
    if (x->system != y->system) return x->system < y->system ? -1 : 1;
    if (x->tag != y->tag) return x->tag < y->tag ? -1 : 1;
    return (x->lookup > y->lookup) - (x->lookup < y->lookup);
}

/* By tag, then lookups: equal ones are one feature of the list. */
static int compare_content(const mt_gpos_feature *x, const mt_gpos_feature *y) {
    if (x->tag != y->tag) return x->tag < y->tag ? -1 : 1;
    for (int i = 0; i < x->count && i < y->count; i++)
        if (x->lookups[i] != y->lookups[i]) return x->lookups[i] < y->lookups[i] ? -1 : 1;
    return (x->count > y->count) - (x->count < y->count);
}

static int by_content(const void *p, const void *q) {
    const mt_gpos_feature *x = p, *y = q;
    int order = compare_content(x, y);
    return order ? order : (x->system > y->system) - (x->system < y->system);
}

static int list_entries(const mt_lookup_builders *lookups, mt_feature_entry *entries) {
    int count = 0;
    for (int i = 0; i < lookups->count; i++)
        for (int k = 0; k < lookups->lookups[i].member_count; k++) {
            mt_member member = lookups->lookups[i].members[k];
            if (entries) entries[count] = (mt_feature_entry){member.system, member.feature, i};
            count++;
        }
    return count;
}

/* From sorted entries to features with their lists of lookups, each lookup once. */
static int gather(const mt_feature_entry *entries, int entry_count, mt_gpos_feature *features, int *lookups) {
    int count = 0, used = 0;
    for (int i = 0; i < entry_count; i++) {
        mt_gpos_feature *last = count ? &features[count - 1] : NULL;
        if (!last || last->system != entries[i].system || last->tag != entries[i].tag) {
            last = &features[count++];
            *last = (mt_gpos_feature){entries[i].system, entries[i].tag, 0, lookups + used, 0};
        }
        if (last->count && lookups[used - 1] == entries[i].lookup) continue;
        lookups[used++] = entries[i].lookup;
        last->count++;
    }
    return count;
}

mt_status mt_gpos_features(const mt_lookup_builders *lookups, mt_arena *arena, mt_gpos_feature **features,
                           int *count) {
    int all = list_entries(lookups, NULL);
    mt_feature_entry *entries = mt_arena_new(arena, (size_t)all, sizeof *entries);
    mt_gpos_feature *made = mt_arena_new(arena, (size_t)all, sizeof *made);
    int *numbers = mt_arena_new(arena, (size_t)all, sizeof *numbers);
    if (!entries || !made || !numbers) return MT_NO_MEMORY;
    list_entries(lookups, entries);
    qsort(entries, (size_t)all, sizeof *entries, by_system);
    int found = gather(entries, all, made, numbers);
    qsort(made, (size_t)found, sizeof *made, by_content);
    for (int i = 1; i < found; i++)
        made[i].index = made[i - 1].index + (compare_content(&made[i - 1], &made[i]) != 0);
    *features = made;
    *count = found;
    return MT_OK;
}

static bool is_first(const mt_gpos_feature *features, int i) {
    return i == 0 || features[i - 1].index != features[i].index;
}

mt_status mt_gpos_feature_list(const mt_gpos_feature *features, int count, mt_table *table) {
    int distinct = features[count - 1].index + 1;
    size_t at = 2 + 6 * (size_t)distinct;
    mt_table_16(table, distinct);
    for (int i = 0; i < count; i++) {
        if (!is_first(features, i)) continue;
        if (at > UINT16_MAX) return MT_TOO_LARGE;
        mt_table_32(table, features[i].tag);
        mt_table_16(table, (int)at);
        at += 4 + 2 * (size_t)features[i].count;
    }
    for (int i = 0; i < count; i++) {
        if (!is_first(features, i)) continue;
        mt_table_16(table, 0); /* no parameters */
        mt_table_16(table, features[i].count);
        for (int k = 0; k < features[i].count; k++) mt_table_16(table, features[i].lookups[k]);
    }
    return MT_OK;
}

/* ---- scripts ------------------------------------------------------------------------------------------- */

typedef struct mt_sorted_system {
    uint32_t script, language, required; /* required: the tag of a feature, or 0 */
    int number;
} mt_sorted_system;

static int by_script(const void *p, const void *q) {
    const mt_sorted_system *x = p, *y = q;
    if (x->script != y->script) return x->script < y->script ? -1 : 1;
    if (x->language != y->language) return x->language < y->language ? -1 : 1;
    return (x->number > y->number) - (x->number < y->number);
}

/* Ascending, each script and language once. */
static int sort_systems(const mt_systems *systems, mt_sorted_system *sorted) {
    int kept = 0;
    for (int i = 0; i < systems->count; i++)
        sorted[i] = (mt_sorted_system){systems->list[i].script, systems->list[i].language,
                                       systems->list[i].required, i};
    qsort(sorted, (size_t)systems->count, sizeof *sorted, by_script);
    for (int i = 0; i < systems->count; i++)
        if (!kept || sorted[kept - 1].script != sorted[i].script ||
            sorted[kept - 1].language != sorted[i].language)
            sorted[kept++] = sorted[i];
    return kept;
}

static void write_system(const mt_gpos_feature *features, int count, const mt_sorted_system *system,
                         mt_table *table) {
    int own = 0, required = 0xFFFF;
    for (int i = 0; i < count; i++) {
        if (features[i].system != system->number) continue;
        if (features[i].tag == system->required)
            required = features[i].index;
        else
            own++;
    }
    mt_table_16(table, 0);
    mt_table_16(table, required);
    mt_table_16(table, own);
    for (int i = 0; i < count; i++)
        if (features[i].system == system->number && features[i].tag != system->required)
            mt_table_16(table, features[i].index);
}

/* A Script table of the systems, the default first if there is one. */
static mt_status write_script(const mt_sorted_system *systems, int count, const mt_gpos_feature *features,
                              int feature_count, mt_table *table) {
    int defaults = systems[0].language == MT_LANGUAGE_DEFAULT, languages = count - defaults;
    mt_table records = {0}, bodies = {0};
    size_t start = 4 + 6 * (size_t)languages;
    mt_status status = MT_OK;
    for (int i = 0; i < count; i++) {
        size_t at = start + bodies.length;
        if (at > UINT16_MAX) status = MT_TOO_LARGE;
        if (i >= defaults) mt_table_32(&records, systems[i].language);
        if (i >= defaults) mt_table_16(&records, (int)at);
        write_system(features, feature_count, &systems[i], &bodies);
    }
    mt_table_16(table, defaults ? (int)start : 0);
    mt_table_16(table, languages);
    mt_table_bytes(table, records.bytes, records.length);
    mt_table_bytes(table, bodies.bytes, bodies.length);
    table->failed |= records.failed || bodies.failed;
    mt_table_free(&records);
    mt_table_free(&bodies);
    return status;
}

static int end_of_script(const mt_sorted_system *systems, int count, int i) {
    int end = i + 1;
    while (end < count && systems[end].script == systems[i].script) end++;
    return end;
}

mt_status mt_gpos_script_list(const mt_systems *systems, const mt_gpos_feature *features, int count,
                              mt_arena *scratch, mt_table *table) {
    mt_sorted_system *sorted = mt_arena_new(scratch, (size_t)systems->count + 1, sizeof *sorted);
    if (!sorted) return MT_NO_MEMORY;
    int all = sort_systems(systems, sorted), scripts = 0;
    for (int i = 0; i < all; i = end_of_script(sorted, all, i)) scripts++;
    size_t start = 2 + 6 * (size_t)scripts;
    mt_table bodies = {0};
    mt_status status = MT_OK;
    mt_table_16(table, scripts);
    for (int i = 0, end; i < all && status == MT_OK; i = end) {
        end = end_of_script(sorted, all, i);
        mt_table_32(table, sorted[i].script);
        mt_table_16(table, (int)(start + bodies.length));
        if (start + bodies.length > UINT16_MAX) status = MT_TOO_LARGE;
        if (status == MT_OK) status = write_script(sorted + i, end - i, features, count, &bodies);
    }
    mt_table_bytes(table, bodies.bytes, bodies.length);
    table->failed |= bodies.failed;
    mt_table_free(&bodies);
    return status;
}
