/* Language systems and features: each feature tells for each script and language which lookups it applies. */
#include <string.h>

#include "fea/writer.h"

/* ---- tags ---------------------------------------------------------------------------------------------- */

/* Without the blanks at its end; false for one that text cannot have. */
static bool write_tag(uint32_t tag, char text[5]) {
    int length = 0, end = 4;
    for (int i = 0; i < 4; i++) text[i] = (char)(tag >> (24 - 8 * i) & 0xFF);
    while (end > 0 && text[end - 1] == ' ') end--;
    text[end] = '\0';
    for (; text[length]; length++) {
        char byte = text[length];
        bool letter = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_';
        if (!letter && (length == 0 || byte < '0' || byte > '9')) return false;
    }
    return length > 0;
}

/* The i-th feature's tag, or 0; as mt_system_feature counts. */
static uint32_t tag_of(const mt_layout *layout, const mt_system *system, int i, int *feature) {
    *feature = mt_system_feature(layout, system, i);
    return *feature >= 0 ? mt_feature_tag(layout, *feature) : 0;
}

bool mt_fea_has_tag(const mt_layout *layout, int lookup, uint32_t tag) {
    for (int i = 0; i < layout->feature_count; i++)
        if (mt_feature_tag(layout, i) == tag && mt_feature_has(layout, i, lookup)) return true;
    return false;
}

void mt_fea_mark_applied(mt_fea_writer *writer, mt_fea_table *table) {
    char text[5];
    const mt_layout *layout = &table->layout;
    bool *seen = mt_fea_new(writer, (size_t)layout->feature_count, sizeof *seen);
    for (int s = 0; s < layout->system_count && seen; s++)
        for (int i = 0; i <= layout->systems[s].feature_count; i++) {
            int feature;
            uint32_t tag = tag_of(layout, &layout->systems[s], i, &feature);
            if (feature < 0 || seen[feature]) continue;
            seen[feature] = true;
            bool named = write_tag(tag, text);
            writer->fea->unsaid += !named;
            int count = named ? mt_feature_lookup_count(layout, feature) : 0;
            for (int k = 0; k < count; k++) {
                int lookup = mt_feature_lookup(layout, feature, k);
                if (lookup >= 0) table->applied[lookup] = true;
            }
        }
}

/* ---- systems ------------------------------------------------------------------------------------------- */

static bool write_system(const mt_system *system, char script[5], char language[5]) {
    strcpy(language, "dflt");
    return write_tag(system->script, script) &&
           (system->language == MT_LANGUAGE_DEFAULT || write_tag(system->language, language));
}

/* DFLT comes first, as the specification wants it. */
void mt_fea_systems(mt_fea_writer *writer, const mt_layout *layout) {
    char script[5], language[5];
    for (int turn = 0; turn < 2; turn++)
        for (int i = 0; i < layout->system_count; i++) {
            if (!write_system(&layout->systems[i], script, language)) continue;
            bool first = strcmp(script, "DFLT") == 0 && strcmp(language, "dflt") == 0;
            if (first != (turn == 0)) continue;
            mt_fea_print(writer, &writer->systems, "languagesystem %s %s;\n", script, language);
        }
    if (layout->system_count) mt_fea_put(writer, &writer->systems, "\n");
}

/* ---- features ------------------------------------------------------------------------------------------ */

/* One feature, while it is written. */
typedef struct mt_told_feature {
    const mt_fea_table *table;
    uint32_t tag;
    bool *lookups; /* that a system applies */
} mt_told_feature;

/* What a system applies by the tag, and whether it requires that; false for nothing. */
static bool collect(const mt_told_feature *told, const mt_system *system, bool *required) {
    const mt_layout *layout = &told->table->layout;
    bool any = false;
    memset(told->lookups, 0, (size_t)layout->lookup_count * sizeof *told->lookups);
    *required = false;
    for (int i = 0; i <= system->feature_count; i++) {
        int feature;
        if (tag_of(layout, system, i, &feature) != told->tag || feature < 0) continue;
        if (i == system->feature_count) *required = true;
        for (int k = 0; k < mt_feature_lookup_count(layout, feature); k++) {
            int lookup = mt_feature_lookup(layout, feature, k);
            bool text = lookup >= 0 && told->table->ways[lookup] == MT_FEA_TEXT;
            if (!text || told->table->parts[lookup] == 0) continue;
            told->lookups[lookup] = any = true;
        }
    }
    return any;
}

static void put_lookups(mt_fea_writer *writer, const mt_told_feature *told) {
    const mt_fea_table *table = told->table;
    for (int i = 0; i < table->layout.lookup_count; i++)
        for (int k = 0; told->lookups[i] && k < table->parts[i]; k++) {
            mt_fea_put(writer, &writer->features, "    lookup ");
            mt_fea_name(writer, &writer->features, table, i, k, false);
            mt_fea_put(writer, &writer->features, ";\n");
        }
}

/* Those of one system. A script's default goes before its languages in the table too. */
static void put_system(mt_fea_writer *writer, const mt_told_feature *told, const mt_system *system) {
    char script[5], language[5];
    bool required;
    mt_buffer *to = &writer->features;
    if (!write_system(system, script, language) || !collect(told, system, &required)) return;
    mt_fea_print(writer, to, "  script %s;\n  language %s%s%s;\n", script, language,
                 system->language == MT_LANGUAGE_DEFAULT ? "" : " exclude_dflt", required ? " required" : "");
    put_lookups(writer, told);
}

/* 'aalt' holds for all systems alike, in text. */
static void put_everywhere(mt_fea_writer *writer, const mt_told_feature *told) {
    bool required, *all = mt_fea_new(writer, (size_t)told->table->layout.lookup_count, sizeof *all);
    for (int s = 0; s < told->table->layout.system_count && all; s++) {
        collect(told, &told->table->layout.systems[s], &required);
        for (int i = 0; i < told->table->layout.lookup_count; i++) all[i] = all[i] || told->lookups[i];
    }
    mt_told_feature whole = {told->table, told->tag, all};
    if (all) put_lookups(writer, &whole);
}

static void put_feature(mt_fea_writer *writer, const mt_told_feature *told) {
    char text[5];
    mt_buffer *to = &writer->features;
    const mt_layout *layout = &told->table->layout;
    size_t start = to->length;
    write_tag(told->tag, text);
    mt_fea_print(writer, to, "feature %s {\n", text);
    size_t empty = to->length;
    if (told->tag == MT_TAG('a', 'a', 'l', 't'))
        put_everywhere(writer, told);
    else
        for (int s = 0; s < layout->system_count; s++) put_system(writer, told, &layout->systems[s]);
    bool any = to->length > empty;
    mt_fea_print(writer, to, "} %s;\n\n", text);
    if (!any) to->length = start;
}

/* Each tag once, in the order of the table. */
void mt_fea_features(mt_fea_writer *writer, const mt_fea_table *table) {
    char text[5];
    const mt_layout *layout = &table->layout;
    bool *lookups = mt_fea_new(writer, (size_t)layout->lookup_count, sizeof *lookups);
    for (int i = 0; i < layout->feature_count && lookups; i++) {
        uint32_t tag = mt_feature_tag(layout, i);
        bool first = write_tag(tag, text);
        for (int k = 0; k < i && first; k++) first = mt_feature_tag(layout, k) != tag;
        mt_told_feature told = {table, tag, lookups};
        if (first) put_feature(writer, &told);
    }
}
