#include "glyphset/match_groups.h"

#include <string.h>

#include "geometry/limits.h"
#include "sfnt/sfnt.h"

enum {
    FEATURES_MAX = 512, /* of a language system */
    GROUPS_MAX = 2048,
    MARKING = 16384, /* comparisons that marking lookups counts as */
};

typedef struct mt_grouping {
    const mt_gsub *a, *b;
    mt_arena *arena;
    mt_groups made;
    int64_t left; /* of the comparisons that are made */
} mt_grouping;

/* Marks what features of the tag apply: those of the system, or all of the font's where it is NULL. */
static void mark_tag(const mt_gsub *gsub, const mt_system *system, uint32_t tag, bool *marked) {
    const mt_layout *layout = &gsub->layout;
    int count = system ? system->feature_count + 1 : layout->feature_count;
    for (int i = 0; i < count; i++) {
        int feature = system ? mt_system_feature(layout, system, i) : i;
        if (feature >= 0 && mt_feature_tag(layout, feature) == tag) mt_gsub_mark(gsub, feature, marked);
    }
}

static bool is_known(const mt_grouping *this, const mt_group *group) {
    size_t count_a = (size_t)this->a->layout.lookup_count, count_b = (size_t)this->b->layout.lookup_count;
    for (int i = 0; i < this->made.count; i++) {
        const mt_group *known = &this->made.list[i];
        if (known->stage == group->stage && memcmp(known->a, group->a, count_a) == 0 &&
            memcmp(known->b, group->b, count_b) == 0)
            return true;
    }
    return false;
}

static mt_status add_group(mt_grouping *this, uint32_t tag, const mt_system *in_a, const mt_system *in_b) {
    mt_arena_place before = mt_arena_mark(this->arena);
    size_t count_a = (size_t)this->a->layout.lookup_count, count_b = (size_t)this->b->layout.lookup_count;
    mt_group group = {.stage = in_a ? MT_GROUP_EXACT : MT_GROUP_ANY};
    if (tag == MT_TAG('a', 'a', 'l', 't')) return MT_OK;
    this->left -= MARKING + (int64_t)(count_a + count_b) * (this->made.count + 16) / 16;
    if (this->made.count == GROUPS_MAX || this->left < 0) return MT_OK;
    group.a = mt_arena_new(this->arena, count_a, sizeof *group.a);
    group.b = mt_arena_new(this->arena, count_b, sizeof *group.b);
    if (!group.a || !group.b) return MT_NO_MEMORY;
    mark_tag(this->a, in_a, tag, group.a);
    mark_tag(this->b, in_b, tag, group.b);
    if (is_known(this, &group))
        mt_arena_rewind(this->arena, before);
    else
        this->made.list[this->made.count++] = group;
    return MT_OK;
}

static const mt_system *find_system(const mt_layout *layout, const mt_system *like) {
    for (int i = 0; i < layout->system_count; i++)
        if (layout->systems[i].script == like->script && layout->systems[i].language == like->language)
            return &layout->systems[i];
    return NULL;
}

/* A group for each feature of a system that both fonts have. */
static mt_status group_system(mt_grouping *this, const mt_system *in_a) {
    const mt_system *in_b = find_system(&this->b->layout, in_a);
    mt_status status = MT_OK;
    for (int i = 0; in_b && i <= in_a->feature_count && i < FEATURES_MAX && status == MT_OK; i++) {
        int feature = mt_system_feature(&this->a->layout, in_a, i);
        if (feature >= 0) status = add_group(this, mt_feature_tag(&this->a->layout, feature), in_a, in_b);
    }
    return status;
}

mt_status mt_match_groups(const mt_gsub *a, const mt_gsub *b, mt_arena *arena, mt_groups *groups) {
    mt_grouping this = {.a = a, .b = b, .arena = arena, .left = MT_COMPARISONS_MAX};
    const mt_layout *layout = &a->layout;
    mt_status status = MT_OK;
    this.made.list = mt_arena_new(arena, GROUPS_MAX, sizeof *this.made.list);
    if (!this.made.list) return MT_NO_MEMORY;
    for (int i = 0; i < layout->system_count && status == MT_OK; i++)
        status = group_system(&this, &layout->systems[i]);
    for (int i = 0; i < layout->feature_count && status == MT_OK; i++)
        if (i == 0 || mt_feature_tag(layout, i) != mt_feature_tag(layout, i - 1))
            status = add_group(&this, mt_feature_tag(layout, i), NULL, NULL);
    if (status == MT_OK) *groups = this.made;
    return status;
}
