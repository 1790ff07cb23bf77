/* Numbered pieces of work shared among threads. Which thread does which is left to chance: whoever takes part
 * keeps its results by number, so that they do not depend on it. */
#ifndef MT_BASE_WORKERS_H
#define MT_BASE_WORKERS_H

#include "base/memory.h"
#include "morphotype.h"

/* Does number `index`. What it makes in the arena is gone when it returns. */
typedef mt_status (*mt_task)(int index, mt_arena *scratch, void *user);

typedef struct mt_work {
    int count; /* of the numbers: 0 … count - 1 */
    mt_task task;
    void *user;
    int threads;          /* 0: as many as the machine has cores */
    mt_progress progress; /* NULL is fine; called from the threads, one at a time */
    void *progress_user;
} mt_work;

/* Runs the task for each number, on this thread and others; a thread that cannot be had is done without. Ends
 * early with the first status that is not MT_OK. */
mt_status mt_work_run(const mt_work *work);

#endif
