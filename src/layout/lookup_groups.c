#include "layout/lookup_groups.h"

#include <string.h>

#include "sfnt/sfnt.h"

enum {
    KERN = MT_TAG('k', 'e', 'r', 'n'),
    VKRN = MT_TAG('v', 'k', 'r', 'n'),
    DIST = MT_TAG('d', 'i', 's', 't')
};

/* ---- one feature of one system ------------------------------------------------------------------------- */

/* What is looked for, and what is found of it in each font. */
typedef struct mt_feature_search {
    const mt_feature_sources *sources;
    const mt_systems *systems;
    int type;
    mt_arena *arena;
    mt_feature_jobs *jobs;
    int lookups[MT_STOPS_MAX][MT_SYSTEM_LOOKUPS_MAX];
    int counts[MT_STOPS_MAX];
    bool kern_table[MT_STOPS_MAX];
} mt_feature_search;

static int own_system(const mt_feature_search *search, int system, int s) {
    return search->systems->list[system].own[s];
}

static void find_lookups(mt_feature_search *search, int system, uint32_t tag) {
    for (int s = 0; s < search->sources->count; s++) {
        const mt_layout *layout = search->sources->layouts[s];
        int own = own_system(search, system, s);
        search->counts[s] =
            mt_system_lookups(layout, own, tag, search->type, search->lookups[s], MT_SYSTEM_LOOKUPS_MAX);
        search->kern_table[s] = tag == KERN && search->type == MT_LOOKUP_PAIR &&
                                search->sources->kern_tables[s] && !mt_system_has_feature(layout, own, tag);
    }
}

/* ---- lookups with the same flags ----------------------------------------------------------------------- */

typedef struct mt_flag_group {
    int flag, mark_set;
} mt_flag_group;

/* What lies in GDEF is the first font's: of others' flags only those stay that do without it. */
static mt_flag_group flags_of(const mt_feature_search *search, int s, int i) {
    mt_lookup lookup = mt_layout_lookup(search->sources->layouts[s], search->lookups[s][i]);
    if (s == 0) return (mt_flag_group){lookup.flag, lookup.mark_set};
    return (mt_flag_group){lookup.flag & 0x000F, -1};
}

static int find_group(const mt_flag_group *groups, int count, mt_flag_group group) {
    for (int i = 0; i < count; i++)
        if (groups[i].flag == group.flag && groups[i].mark_set == group.mark_set) return i;
    return -1;
}

/* The groups of the first font's lookups; of the next font's that has any, where it has none. */
static int list_groups(const mt_feature_search *search, mt_flag_group *groups) {
    int count = 0;
    for (int s = 0; s < search->sources->count && count == 0; s++) {
        for (int i = 0; i < search->counts[s]; i++) {
            mt_flag_group group = flags_of(search, s, i);
            if (find_group(groups, count, group) < 0) groups[count++] = group;
        }
        if (search->kern_table[s]) groups[count++] = (mt_flag_group){MT_LOOKUP_IGNORE_MARKS, -1};
    }
    return count;
}

/* The part of a font in group `g`: lookups with its flags; in the first, those too that are in no other, and the 'kern'
 * table. */
static mt_status find_part(const mt_feature_search *search, int s, const mt_flag_group *groups,
                           int group_count, int g, mt_feature_part *part) {
    int *lookups = mt_arena_new(search->arena, (size_t)search->counts[s] + 1, sizeof *lookups), count = 0;
    if (!lookups) return MT_NO_MEMORY;
    for (int i = 0; i < search->counts[s]; i++) {
        int own = find_group(groups, group_count, flags_of(search, s, i));
        if ((own < 0 ? 0 : own) == g) lookups[count++] = search->lookups[s][i];
    }
    *part = (mt_feature_part){count, lookups, g == 0 && search->kern_table[s]};
    return MT_OK;
}

/* ---- jobs ---------------------------------------------------------------------------------------------- */

static bool same_part(const mt_feature_part *p, const mt_feature_part *q) {
    return p->count == q->count && p->kern_table == q->kern_table &&
           (p->count == 0 || memcmp(p->lookups, q->lookups, (size_t)p->count * sizeof *p->lookups) == 0);
}

static bool same_others(const mt_feature_job *job, const mt_feature_job *other) {
    for (int s = 1; s < MT_STOPS_MAX; s++)
        if (!same_part(&job->parts[s], &other->parts[s])) return false;
    return true;
}

/* Whether the job is the same, or is the first font's same lookups for another feature of the same system: a lookup
 * that is in two features is applied once. */
static bool is_same(const mt_feature_job *job, const mt_feature_job *other, mt_member member) {
    if (job->head.flag != other->head.flag || job->head.mark_set != other->head.mark_set) return false;
    if (!same_part(&job->parts[0], &other->parts[0])) return false;
    if (same_others(job, other)) return true;
    mt_member last = job->head.members[job->head.member_count - 1];
    return job->parts[0].count && last.system == member.system && member.feature != VKRN &&
           last.feature != VKRN;
}

static mt_status add_member(mt_feature_job *job, mt_member member, mt_arena *arena) {
    mt_lookup_builder *head = &job->head;
    mt_member *members = mt_arena_grow_list(arena, (mt_member *)head->members, head->member_count,
                                            &job->member_room, sizeof *members);
    if (!members) return MT_NO_MEMORY;
    members[head->member_count++] = member;
    head->members = members;
    return MT_OK;
}

static mt_status add_job(mt_feature_jobs *jobs, const mt_feature_job *job, mt_member member,
                         mt_arena *arena) {
    int at = 0;
    while (at < jobs->count && !is_same(&jobs->list[at], job, member)) at++;
    if (at == MT_FEATURE_JOBS_MAX) return MT_OK;
    if (at == jobs->count) jobs->list[jobs->count++] = *job;
    return add_member(&jobs->list[at], member, arena);
}

static mt_feature_job make_job(const mt_feature_search *search, mt_flag_group group) {
    return (mt_feature_job){
        .head = {.order = -1, .type = search->type, .flag = group.flag, .mark_set = group.mark_set}};
}

static mt_status add_feature(mt_feature_search *search, int system, uint32_t tag) {
    mt_flag_group groups[MT_SYSTEM_LOOKUPS_MAX + 1];
    find_lookups(search, system, tag);
    int count = list_groups(search, groups);
    for (int g = 0; g < count; g++) {
        mt_feature_job job = make_job(search, groups[g]);
        for (int s = 0; s < search->sources->count; s++) {
            mt_status status = find_part(search, s, groups, count, g, &job.parts[s]);
            if (status != MT_OK) return status;
        }
        if (search->type == MT_LOOKUP_SINGLE && !job.parts[0].count) continue;
        if (job.parts[0].count) job.head.order = job.parts[0].lookups[0];
        mt_status status = add_job(search->jobs, &job, (mt_member){system, tag}, search->arena);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* Whether an earlier feature of the system has that tag. */
static bool is_repeated(const mt_layout *layout, const mt_system *system, int i, uint32_t tag) {
    for (int k = 0; k < i; k++) {
        int feature = mt_system_feature(layout, system, k);
        if (feature >= 0 && mt_feature_tag(layout, feature) == tag) return true;
    }
    return false;
}

/* The features of the first font's, but for those in `apart`. */
static mt_status add_features_of_first(mt_feature_search *search, int system, const uint32_t *apart,
                                       int count) {
    const mt_layout *layout = search->sources->layouts[0];
    int own = own_system(search, system, 0);
    const mt_system *s = own < 0 ? NULL : &layout->systems[own];
    mt_status status = MT_OK;
    for (int i = 0; s && i <= s->feature_count && status == MT_OK; i++) {
        int feature = mt_system_feature(layout, s, i);
        uint32_t tag = feature < 0 ? 0 : mt_feature_tag(layout, feature);
        bool passed = feature < 0;
        for (int k = 0; k < count; k++) passed |= apart[k] == tag;
        if (!passed && !is_repeated(layout, s, i, tag)) status = add_feature(search, system, tag);
    }
    return status;
}

mt_status mt_feature_jobs_find(const mt_feature_sources *sources, const mt_systems *systems, int type,
                               mt_arena *arena, mt_feature_jobs *jobs) {
    static const uint32_t of_all[] = {KERN, VKRN, DIST};
    int all_count = type == MT_LOOKUP_PAIR ? 3 : 0;
    mt_feature_jobs made = {0};
    mt_feature_search search = {
        .sources = sources, .systems = systems, .type = type, .arena = arena, .jobs = &made};
    made.list = mt_arena_new(arena, MT_FEATURE_JOBS_MAX, sizeof *made.list);
    if (!made.list) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i < systems->count && status == MT_OK; i++) {
        for (int k = 0; k < all_count && status == MT_OK; k++) status = add_feature(&search, i, of_all[k]);
        if (status == MT_OK) status = add_features_of_first(&search, i, of_all, all_count);
    }
    if (status == MT_OK) *jobs = made;
    return status;
}

mt_status mt_feature_job_whole(const mt_feature_sources *sources, const mt_systems *systems, int system,
                               uint32_t tag, int type, mt_arena *arena, mt_feature_job *job) {
    mt_flag_group any = {0, -1};
    mt_feature_search search = {.sources = sources, .systems = systems, .type = type, .arena = arena};
    find_lookups(&search, system, tag);
    mt_feature_job made = make_job(&search, any);
    for (int s = 0; s < sources->count; s++) {
        mt_status status = find_part(&search, s, NULL, 0, 0, &made.parts[s]);
        if (status != MT_OK) return status;
    }
    *job = made;
    return MT_OK;
}
