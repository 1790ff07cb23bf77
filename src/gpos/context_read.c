/* Contexts read, for the new font's glyphs. */
#include <string.h>

#include "gpos/context.h"
#include "layout/calls.h"

enum { GLYPH_NUMBERS = 65536, NO_CLASS = -1 };

static bool spend(int64_t *steps, int64_t count) {
    *steps = *steps < count ? 0 : *steps - count;
    return *steps > 0;
}

/* ---- which lookups are called -------------------------------------------------------------------------- */

void mt_context_reach_feature(const mt_layout *layout, int system, uint32_t tag, bool *reached) {
    const mt_system *s = system < 0 ? NULL : &layout->systems[system];
    for (int i = 0; s && i <= s->feature_count; i++) {
        int feature = mt_system_feature(layout, s, i);
        if (feature < 0 || mt_feature_tag(layout, feature) != tag) continue;
        int count = mt_feature_lookup_count(layout, feature);
        for (int k = 0; k < count; k++) {
            int lookup = mt_feature_lookup(layout, feature, k);
            if (lookup >= 0) mt_calls_mark(&layout->calls, lookup, reached);
        }
    }
}

/* ---- classes ------------------------------------------------------------------------------------------- */

/* How the numbers of a rule become classes: in format 1 the font's glyphs are numbered as they come; in format 2
 * they are classes, of which those are left that a new glyph has. */
typedef struct mt_class_map {
    mt_context_reader *reader;
    bool by_glyph;
    mt_bytes class_defs[MT_SEQUENCES]; /* format 2 */
    uint16_t *class_of[MT_SEQUENCES];  /* format 1: of each of the font's glyphs; 0 for none */
    int class_count[MT_SEQUENCES];     /* format 1: in use */
    bool *present[MT_SEQUENCES];       /* format 2: of each class */
} mt_class_map;

static int class_of(mt_class_map *map, int sequence, unsigned number) {
    if (!map->by_glyph) return map->present[sequence][number] ? (int)number : NO_CLASS;
    if (!map->reader->has[number]) return NO_CLASS;
    uint16_t *class = &map->class_of[sequence][number];
    if (*class == 0) *class = (uint16_t)++map->class_count[sequence];
    return *class;
}

/* The class of a new glyph. */
static unsigned class_of_new(const mt_class_map *map, int sequence, int glyph) {
    uint32_t own = map->reader->own[glyph];
    if (!map->by_glyph) return mt_class_find(map->class_defs[sequence], own);
    return own < GLYPH_NUMBERS ? map->class_of[sequence][own] : 0;
}

static mt_status open_map(mt_context_reader *reader, mt_bytes table, bool chained, mt_class_map *map) {
    *map = (mt_class_map){.reader = reader, .by_glyph = mt_ot_u16(table, 0) == 1};
    for (int s = 0; s < MT_SEQUENCES; s++) {
        map->class_of[s] = mt_arena_new(reader->scratch, GLYPH_NUMBERS, sizeof *map->class_of[s]);
        map->present[s] = mt_arena_new(reader->scratch, GLYPH_NUMBERS, sizeof *map->present[s]);
        if (!map->class_of[s] || !map->present[s]) return MT_NO_MEMORY;
        if (map->by_glyph) continue;
        map->class_defs[s] = mt_ot_follow(table, chained ? 4 + 2 * (size_t)s : 4);
        for (int i = 0; i < reader->glyph_count; i++) map->present[s][class_of_new(map, s, i)] = true;
    }
    return MT_OK;
}

static mt_status list_classes(const mt_class_map *map, mt_arena *arena, mt_context_subtable *subtable) {
    int count = map->reader->glyph_count;
    for (int s = 0; s < MT_SEQUENCES; s++) {
        int listed = 0;
        for (int i = 0; i < count; i++) listed += class_of_new(map, s, i) != 0;
        subtable->classes[s] = mt_arena_new(arena, (size_t)listed + 1, sizeof *subtable->classes[s]);
        if (!subtable->classes[s]) return MT_NO_MEMORY;
        listed = 0;
        for (int i = 0; i < count; i++) {
            unsigned class = class_of_new(map, s, i);
            if (class) subtable->classes[s][listed++] = (mt_glyph_class){(uint16_t)i, (uint16_t) class};
        }
        subtable->class_counts[s] = listed;
    }
    return MT_OK;
}

/* ---- rules of classes ---------------------------------------------------------------------------------- */

static mt_status read_calls(const mt_context_reader *reader, mt_bytes table, const mt_rule_layout *found,
                            mt_context_rule *rule) {
    rule->calls = mt_arena_new(reader->arena, (size_t)found->call_count + 1, sizeof *rule->calls);
    if (!rule->calls) return MT_NO_MEMORY;
    rule->call_count = found->call_count;
    for (int i = 0; i < found->call_count; i++) {
        size_t at = found->calls_at + 4 * (size_t)i;
        rule->calls[i] = (mt_context_call){(uint16_t)mt_ot_u16(table, at),
                                           reader->first_call + 1 + (int)mt_ot_u16(table, at + 2)};
    }
    return MT_OK;
}

/* Adds the rule to the set, unless one of its places has no glyph. The first place's class is `first`. */
static mt_status read_rule(mt_class_map *map, mt_bytes table, bool chained, int first, mt_arena *arena,
                           mt_context_set *set) {
    mt_rule_layout found = mt_find_rule(table, chained, 0, 1);
    mt_context_rule rule = {0};
    int64_t numbers = found.counts[MT_BEFORE] + found.counts[MT_INPUT] + found.counts[MT_AFTER];
    if (!found.whole || !spend(&map->reader->steps, 1 + numbers + found.call_count)) return MT_OK;
    for (int s = 0; s < MT_SEQUENCES; s++) {
        rule.counts[s] = found.counts[s];
        rule.classes[s] = mt_arena_new(arena, (size_t)rule.counts[s] + 1, sizeof *rule.classes[s]);
        if (!rule.classes[s]) return MT_NO_MEMORY;
        int told = s == MT_INPUT;
        if (told) rule.classes[s][0] = (uint16_t)first;
        for (int i = told; i < rule.counts[s]; i++) {
            int class = class_of(map, s, mt_ot_u16(table, found.at[s] + 2 * (size_t)(i - told)));
            if (class == NO_CLASS) return MT_OK;
            rule.classes[s][i] = (uint16_t) class;
        }
    }
    mt_status status = read_calls(map->reader, table, &found, &rule);
    if (status == MT_OK) set->rules[set->count++] = rule;
    return status;
}

static mt_status read_set(mt_class_map *map, mt_bytes table, bool chained, int first,
                          mt_context_subtable *subtable) {
    mt_arena *arena = map->reader->arena;
    mt_context_set *set = &subtable->sets[first];
    int count = mt_ot_fit(table, 2, mt_ot_u16(table, 0), 2);
    if (!spend(&map->reader->steps, 1 + count)) return MT_OK;
    set->rules = mt_arena_new(arena, (size_t)count + 1, sizeof *set->rules);
    if (!set->rules) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i < count && status == MT_OK; i++)
        status = read_rule(map, mt_ot_follow(table, 2 + 2 * (size_t)i), chained, first, arena, set);
    return status;
}

/* The sets are by class in format 2, and by the place in the coverage in format 1. */
static mt_status read_sets(mt_class_map *map, mt_bytes table, bool chained, mt_context_subtable *subtable) {
    mt_covered *covered = NULL;
    int covered_count = 0;
    size_t at = mt_rule_sets_at(mt_ot_u16(table, 0), chained);
    int count = mt_ot_fit(table, at + 2, mt_ot_u16(table, at), 2);
    mt_status status = MT_OK;
    subtable->set_count = count + map->by_glyph;
    subtable->sets = mt_arena_new(map->reader->arena, (size_t)count + 1, sizeof *subtable->sets);
    if (!subtable->sets) return MT_NO_MEMORY;
    if (map->by_glyph)
        status = mt_coverage_list(mt_ot_follow(table, 2), map->reader->scratch, &covered, &covered_count);
    for (int i = 0; i < covered_count; i++) /* the first classes are those that have sets */
        if (covered[i].index < count) class_of(map, MT_INPUT, covered[i].glyph);
    int all = map->by_glyph ? covered_count : count;
    for (int i = 0; i < all && status == MT_OK; i++) {
        int index = map->by_glyph ? covered[i].index : i;
        if (index >= count) continue;
        int first = class_of(map, MT_INPUT, map->by_glyph ? covered[i].glyph : (unsigned)i);
        if (first == NO_CLASS || first >= subtable->set_count) continue;
        status = read_set(map, mt_ot_follow(table, at + 2 + 2 * (size_t)index), chained, first, subtable);
    }
    return status;
}

/* ---- lists of glyphs ----------------------------------------------------------------------------------- */

/* The new glyphs of a coverage. */
static mt_status list_covered(mt_context_reader *reader, mt_bytes coverage, mt_glyph_list *list) {
    int count = reader->glyph_count, listed = 0;
    const uint32_t *own = reader->own;
    *list = (mt_glyph_list){0};
    if (!spend(&reader->steps, count)) return MT_OK;
    for (int i = 0; i < count; i++) listed += mt_coverage_find(coverage, own[i]) >= 0;
    list->glyphs = mt_arena_new(reader->arena, (size_t)listed + 1, sizeof *list->glyphs);
    if (!list->glyphs) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++)
        if (mt_coverage_find(coverage, own[i]) >= 0) list->glyphs[list->count++] = (uint16_t)i;
    return MT_OK;
}

static mt_status read_lists(mt_context_reader *reader, mt_bytes table, bool chained,
                            mt_context_subtable *subtable, bool *found) {
    mt_rule_layout layout = mt_find_rule(table, chained, 2, 0);
    mt_context_rule rule = {0};
    if (!layout.whole) return MT_OK;
    for (int s = 0; s < MT_SEQUENCES; s++) {
        rule.counts[s] = layout.counts[s];
        rule.lists[s] = mt_arena_new(reader->arena, (size_t)rule.counts[s] + 1, sizeof *rule.lists[s]);
        if (!rule.lists[s]) return MT_NO_MEMORY;
        for (int i = 0; i < rule.counts[s]; i++) {
            mt_bytes coverage = mt_ot_follow(table, layout.at[s] + 2 * (size_t)i);
            mt_status status = list_covered(reader, coverage, &rule.lists[s][i]);
            if (status != MT_OK || rule.lists[s][i].count == 0) return status;
        }
    }
    subtable->by_lists = true;
    subtable->set_count = 1;
    subtable->sets = mt_arena_new(reader->arena, 1, sizeof *subtable->sets);
    mt_context_rule *kept = mt_arena_new(reader->arena, 1, sizeof *kept);
    if (!subtable->sets || !kept) return MT_NO_MEMORY;
    mt_status status = read_calls(reader, table, &layout, &rule);
    *kept = rule;
    subtable->sets[0] = (mt_context_set){1, kept};
    *found = status == MT_OK;
    return status;
}

/* ---- the whole ----------------------------------------------------------------------------------------- */

static mt_status read_classes(mt_context_reader *reader, mt_bytes table, bool chained,
                              mt_context_subtable *subtable, bool *found) {
    mt_class_map map;
    mt_arena_place place = mt_arena_mark(reader->scratch);
    if (!spend(&reader->steps, GLYPH_NUMBERS / 16 + 4 * (int64_t)reader->glyph_count)) return MT_OK;
    mt_status status = open_map(reader, table, chained, &map);
    if (status == MT_OK) status = list_covered(reader, mt_ot_follow(table, 2), &subtable->first);
    if (status == MT_OK) status = read_sets(&map, table, chained, subtable);
    if (status == MT_OK) status = list_classes(&map, reader->arena, subtable);
    for (int i = 0; i < subtable->set_count && status == MT_OK; i++)
        *found |= subtable->sets[i].count > 0 && subtable->first.count > 0;
    mt_arena_rewind(reader->scratch, place);
    return status;
}

mt_status mt_context_read(mt_context_reader *reader, int type, mt_bytes table, mt_context_subtable *subtable,
                          bool *found) {
    bool chained = type == MT_CHAINED_CONTEXT;
    unsigned format = mt_ot_u16(table, 0);
    *subtable = (mt_context_subtable){0};
    *found = false;
    if (format == 3) return read_lists(reader, table, chained, subtable, found);
    if (format != 1 && format != 2) return MT_OK;
    return read_classes(reader, table, chained, subtable, found);
}
