/* Which lookups of the fonts go together: those of the same feature, for the same script and language. */
#pragma once

#include "layout/systems.h"

enum { MT_LOOKUP_SINGLE = 1, MT_LOOKUP_PAIR = 2, MT_LOOKUP_IGNORE_MARKS = 0x0008 };

/* A font's lookups of one feature. */
typedef struct mt_feature_part {
    int count;
    const int *lookups;
    bool kern_table; /* the old 'kern' table stands for the feature */
} mt_feature_part;

/* A lookup of the new font that is to be made of one of the first font's (or several) and the others'. */
typedef struct mt_feature_job {
    mt_feature_part parts[MT_STOPS_MAX];
    mt_lookup_builder head; /* without subtables; its members are of mt_systems */
    int member_room;
} mt_feature_job;

typedef struct mt_feature_jobs {
    int count;
    mt_feature_job *list;
} mt_feature_jobs;

/* The fonts. */
typedef struct mt_feature_sources {
    int count;
    const mt_layout *layouts[MT_STOPS_MAX];
    bool kern_tables[MT_STOPS_MAX]; /* each has one that kerns */
} mt_feature_sources;

enum { MT_FEATURE_JOBS_MAX = 64 }; /* more are left out: fonts have some ten */

/* The jobs for lookups of `type`: of every feature of the first font's that has any; and, of pairs, of the others' kern,
 * vkrn and dist. Where a font has no kern feature for a system, its 'kern' table stands for it. A feature's lookups with
 * other flags are a job of their own; others' go with those of the first font's with the same flags, else with the first
 * such job. MT_NO_MEMORY. */
mt_status mt_feature_jobs_find(const mt_feature_sources *sources, const mt_systems *systems, int type,
                               mt_arena *arena, mt_feature_jobs *jobs);

/* All of one feature's lookups of a system as one job, whatever their flags. MT_NO_MEMORY. */
mt_status mt_feature_job_whole(const mt_feature_sources *sources, const mt_systems *systems, int system,
                               uint32_t tag, int type, mt_arena *arena, mt_feature_job *job);
