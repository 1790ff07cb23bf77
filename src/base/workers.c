#include "base/workers.h"

#include <pthread.h>
#include <stdatomic.h>
#include <unistd.h>

typedef struct mt_crew {
    const mt_work *work;
    atomic_int next;
    atomic_int status; /* the first that stops everything */
    pthread_mutex_t progress;
    int done; /* under the lock `progress` */
} mt_crew;

typedef struct mt_crew_member {
    mt_crew *crew;
    mt_arena *kept;
} mt_crew_member;

static void report_progress(mt_crew *crew) {
    const mt_work *work = crew->work;
    if (!work->progress) return;
    pthread_mutex_lock(&crew->progress);
    work->progress(++crew->done, work->count, work->progress_user);
    pthread_mutex_unlock(&crew->progress);
}

static void *take_part(void *argument) {
    const mt_crew_member *member = argument;
    mt_crew *crew = member->crew;
    mt_arena scratch = {0};
    for (;;) {
        int index = atomic_fetch_add(&crew->next, 1);
        if (index >= crew->work->count || atomic_load(&crew->status) != MT_OK) break;
        mt_status status = crew->work->task(index, &scratch, member->kept, crew->work->user);
        mt_arena_reset(&scratch);
        if (status != MT_OK)
            atomic_store(&crew->status, (int)status);
        else
            report_progress(crew);
    }
    mt_arena_release(&scratch);
    return NULL;
}

static int thread_count(const mt_work *work) {
    long cores = work->threads ? work->threads : sysconf(_SC_NPROCESSORS_ONLN);
    long most = cores < 1 ? 1 : cores > MT_THREADS_MAX ? MT_THREADS_MAX : cores;
    return (int)(most < work->count ? most : work->count);
}

mt_status mt_work_run(const mt_work *work) {
    pthread_t threads[MT_THREADS_MAX];
    bool started[MT_THREADS_MAX] = {false};
    mt_crew_member members[MT_THREADS_MAX];
    mt_crew crew = {.work = work};
    int count = thread_count(work);
    pthread_mutex_init(&crew.progress, NULL);
    for (int i = 0; i < count; i++)
        members[i] = (mt_crew_member){&crew, work->kept ? &work->kept->of[i] : NULL};
    for (int i = 1; i < count; i++)
        started[i] = pthread_create(&threads[i], NULL, take_part, &members[i]) == 0;
    if (count > 0) take_part(&members[0]);
    for (int i = 1; i < count; i++)
        if (started[i]) pthread_join(threads[i], NULL);
    pthread_mutex_destroy(&crew.progress);
    return (mt_status)atomic_load(&crew.status);
}

void mt_thread_arenas_release(mt_thread_arenas *arenas) {
    for (int i = 0; i < MT_THREADS_MAX; i++) mt_arena_release(&arenas->of[i]);
}
