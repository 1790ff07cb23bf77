/* Numbered pieces of work shared among threads. Which thread does which is left to chance: whoever takes part
 * keeps its results by number, so that they do not depend on it. */
#pragma once

#include "base/memory.h"
#include "morphotype.h"

enum { MT_THREADS_MAX = 256 };

/* For each thread an arena of what its tasks leave behind. All zero is empty; they are the caller's to release. */
typedef struct mt_thread_arenas {
    mt_arena of[MT_THREADS_MAX];
} mt_thread_arenas;

void mt_thread_arenas_release(mt_thread_arenas *arenas);

/* Does number `index`. What it makes in `scratch` is gone when it returns; what it makes in `kept` stays. */
typedef mt_status (*mt_task)(int index, mt_arena *scratch, mt_arena *kept, void *user);

typedef struct mt_work {
    int count; /* of the numbers: 0 … count - 1 */
    mt_task task;
    void *user;
    mt_thread_arenas *kept; /* NULL: the tasks leave nothing, and are given no arena for it */
    int threads;            /* 0: as many as the machine has cores */
    mt_progress progress;   /* NULL is fine; called from the threads after each number, one at a time */
    void *progress_user;
} mt_work;

/* Runs the task for each number, on this thread and others; a thread that cannot be had is done without. Ends
 * early with the first status that is not MT_OK. */
mt_status mt_work_run(const mt_work *work);
