#include "layout/systems.h"

#include <stdlib.h>
#include <string.h>

#include "sfnt/sfnt.h"

/* ---- what a system has --------------------------------------------------------------------------------- */

bool mt_system_has_feature(const mt_layout *layout, int system, uint32_t tag) {
    if (system < 0) return false;
    const mt_system *s = &layout->systems[system];
    for (int i = 0; i <= s->feature_count; i++) {
        int feature = mt_system_feature(layout, s, i);
        if (feature >= 0 && mt_feature_tag(layout, feature) == tag) return true;
    }
    return false;
}

/* Puts a number into its place among ascending ones, unless it is there. */
static int insert(int *numbers, int count, int room, int number) {
    int at = count;
    while (at > 0 && numbers[at - 1] > number) at--;
    if (count == room || (at > 0 && numbers[at - 1] == number)) return count;
    memmove(numbers + at + 1, numbers + at, (size_t)(count - at) * sizeof *numbers);
    numbers[at] = number;
    return count + 1;
}

int mt_system_lookups(const mt_layout *layout, int system, uint32_t tag, int type, int *lookups, int room) {
    int count = 0;
    if (system < 0) return 0;
    const mt_system *s = &layout->systems[system];
    for (int i = 0; i <= s->feature_count; i++) {
        int feature = mt_system_feature(layout, s, i);
        if (feature < 0 || mt_feature_tag(layout, feature) != tag) continue;
        int all = mt_feature_lookup_count(layout, feature);
        for (int k = 0; k < all; k++) {
            int lookup = mt_feature_lookup(layout, feature, k);
            if (lookup < 0 || mt_layout_lookup(layout, lookup).type != type) continue;
            count = insert(lookups, count, room, lookup);
        }
    }
    return count;
}

/* ---- the list ------------------------------------------------------------------------------------------ */

/* Whether two systems of a font have the same pair adjustment. */
static bool kern_alike(const mt_layout *layout, int one, int other) {
    static const uint32_t tags[] = {MT_TAG('k', 'e', 'r', 'n'), MT_TAG('v', 'k', 'r', 'n'),
                                    MT_TAG('d', 'i', 's', 't')};
    int in_one[MT_SYSTEM_LOOKUPS_MAX], in_other[MT_SYSTEM_LOOKUPS_MAX];
    /* Without the feature, the 'kern' table would stand for it. */
    if (mt_system_has_feature(layout, one, tags[0]) != mt_system_has_feature(layout, other, tags[0]))
        return false;
    for (int i = 0; i < 3; i++) {
        int count = mt_system_lookups(layout, one, tags[i], 2, in_one, MT_SYSTEM_LOOKUPS_MAX);
        int others = mt_system_lookups(layout, other, tags[i], 2, in_other, MT_SYSTEM_LOOKUPS_MAX);
        if (count != others || memcmp(in_one, in_other, (size_t)count * sizeof *in_one) != 0) return false;
    }
    return true;
}

static bool is_listed(const mt_systems *systems, uint32_t script, uint32_t language) {
    for (int i = 0; i < systems->count; i++)
        if (systems->list[i].script == script && systems->list[i].language == language) return true;
    return false;
}

/* The systems of all fonts for a script and language. */
static mt_shared_system shared_system(const mt_layout *const *layouts, int font_count, uint32_t script,
                                      uint32_t language) {
    mt_shared_system made = {.script = script, .language = language};
    for (int k = 0; k < font_count; k++) made.own[k] = mt_layout_system(layouts[k], script, language);
    return made;
}

/* The tag of the feature that a system requires; 0 where it does not. */
static uint32_t required_of(const mt_layout *layout, int system) {
    if (system < 0 || layout->systems[system].required < 0) return 0;
    const mt_system *s = &layout->systems[system];
    int feature = mt_system_feature(layout, s, s->feature_count);
    return feature < 0 ? 0 : mt_feature_tag(layout, feature);
}

static void add_those_of(const mt_layout *const *layouts, int font_count, int font, mt_systems *systems) {
    const mt_layout *layout = layouts[font];
    int count = systems->count;
    for (int i = 0; i < layout->system_count; i++) {
        const mt_system *system = &layout->systems[i];
        int stands_in = mt_layout_system(layouts[0], system->script, system->language);
        if (stands_in >= 0 && kern_alike(layout, i, systems->list[stands_in].own[font])) continue;
        if (is_listed(systems, system->script, system->language)) continue;
        systems->list[count] = shared_system(layouts, font_count, system->script, system->language);
        systems->list[count++].own[font] = i;
    }
    systems->count = count;
}

enum { PLAIN_COUNT = 4 };

static void add_plain_ones(int font_count, mt_systems *systems) {
    static const uint32_t scripts[PLAIN_COUNT] = {MT_TAG('D', 'F', 'L', 'T'), MT_TAG('c', 'y', 'r', 'l'),
                                                  MT_TAG('g', 'r', 'e', 'k'), MT_TAG('l', 'a', 't', 'n')};
    for (int i = 0; i < PLAIN_COUNT; i++) {
        systems->list[i] = (mt_shared_system){.script = scripts[i], .language = MT_LANGUAGE_DEFAULT};
        for (int k = 0; k < font_count; k++) systems->list[i].own[k] = -1;
    }
    systems->count = PLAIN_COUNT;
}

mt_status mt_systems_make(const mt_layout *const *layouts, int font_count, mt_arena *arena,
                          mt_systems *systems) {
    size_t room = PLAIN_COUNT;
    for (int k = 0; k < font_count; k++) room += (size_t)layouts[k]->system_count;
    mt_systems made = {.count = layouts[0]->system_count};
    made.list = mt_arena_new(arena, room, sizeof *made.list);
    if (!made.list) return MT_NO_MEMORY;
    for (int i = 0; i < made.count; i++) {
        const mt_system *system = &layouts[0]->systems[i];
        made.list[i] = shared_system(layouts, font_count, system->script, system->language);
        made.list[i].own[0] = i;
    }
    for (int k = 1; k < font_count; k++) add_those_of(layouts, font_count, k, &made);
    for (int i = 0; i < made.count; i++) made.list[i].required = required_of(layouts[0], made.list[i].own[0]);
    if (made.count == 0) add_plain_ones(font_count, &made);
    *systems = made;
    return MT_OK;
}

mt_status mt_systems_spread(const mt_systems *systems, mt_arena *arena, mt_lookup_builder *lookup) {
    int count = lookup->member_count, all = 0, made = 0;
    for (int i = 0; i < count; i++)
        for (int s = 0; s < systems->count; s++) all += systems->list[s].own[0] == lookup->members[i].system;
    mt_member *members = mt_arena_new(arena, (size_t)all + 1, sizeof *members);
    if (!members) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++)
        for (int s = 0; s < systems->count; s++)
            if (systems->list[s].own[0] == lookup->members[i].system)
                members[made++] = (mt_member){s, lookup->members[i].feature};
    lookup->members = members;
    lookup->member_count = made;
    return MT_OK;
}
