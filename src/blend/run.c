/* The glyphs of a blend shared among threads. */
#include "blend/job.h"

#include <unistd.h>

static void report_progress(mt_job *job) {
    int done = atomic_fetch_add(&job->done, 1) + 1, all = job->charset->glyph_count;
    if (!job->blend->progress || (done % 64 != 0 && done != all)) return;
    pthread_mutex_lock(&job->fonts);
    job->blend->progress(done, all, job->blend->progress_user);
    pthread_mutex_unlock(&job->fonts);
}

static void *work(void *argument) {
    mt_worker *worker = argument;
    mt_job *job = worker->job;
    for (;;) {
        int turn = atomic_fetch_add(&job->next, 1);
        if (turn >= job->end || atomic_load(&job->status) != MT_OK) break;
        mt_status status = job->make(worker, job->order[turn]);
        mt_arena_reset(&worker->scratch);
        if (status != MT_OK)
            atomic_store(&job->status, (int)status);
        else
            report_progress(job);
    }
    return NULL;
}

int mt_job_worker_count(const mt_job *job) {
    long cores = job->blend->params.threads ? job->blend->params.threads : sysconf(_SC_NPROCESSORS_ONLN);
    long most = cores < 1 ? 1 : cores > 256 ? 256 : cores;
    return (int)(most < job->charset->glyph_count ? most : job->charset->glyph_count);
}

/* Runs the depth at hand on workers[0 … count); the first works on this thread. A thread that cannot be had is
 * done without. */
static void run_depth(mt_worker *workers, int count) {
    pthread_t threads[256];
    bool started[256] = {false};
    for (int i = 1; i < count; i++) started[i] = pthread_create(&threads[i], NULL, work, &workers[i]) == 0;
    work(&workers[0]);
    for (int i = 1; i < count; i++)
        if (started[i]) pthread_join(threads[i], NULL);
}

mt_status mt_job_run(mt_job *job, mt_worker *workers, int count) {
    pthread_mutex_init(&job->fonts, NULL);
    for (int i = 0; i < count; i++) workers[i].job = job;
    for (int start = 0; start < job->charset->glyph_count; start = job->end) {
        int depth = job->composites[job->order[start]].depth;
        job->end = start;
        while (job->end < job->charset->glyph_count && job->composites[job->order[job->end]].depth == depth)
            job->end++;
        atomic_store(&job->next, start);
        run_depth(workers, count);
    }
    for (int i = 0; i < count; i++) mt_arena_release(&workers[i].scratch);
    pthread_mutex_destroy(&job->fonts);
    return (mt_status)atomic_load(&job->status);
}

void mt_job_order(mt_job *job) {
    int count = job->charset->glyph_count, ordered = 0;
    for (int depth = 0; depth <= MT_GLYF_DEPTH_MAX; depth++)
        for (int i = 0; i < count; i++)
            if (job->composites[i].depth == depth) job->order[ordered++] = i;
}
