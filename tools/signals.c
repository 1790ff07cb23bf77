/* A thread of its own waits for the signals, which are blocked in all others: it may remove files, as no handler may. Then the signal is
 * sent again, and ends the program as it would have. */
#define _GNU_SOURCE
#include "signals.h"

#include "base/temporaries.h"

#include <pthread.h>
#include <signal.h>
#include <stdbool.h>
#include <stddef.h>
#include <unistd.h>

static const int watched[] = {SIGINT, SIGTERM, SIGHUP};
enum { WATCHED = sizeof watched / sizeof *watched };

static void *wait_for(void *set) {
    int number;
    if (sigwait(set, &number) != 0) return NULL;
    mt_temporaries_remove();
    sigset_t one;
    sigemptyset(&one);
    sigaddset(&one, number);
    signal(number, SIG_DFL);
    pthread_sigmask(SIG_UNBLOCK, &one, NULL);
    kill(getpid(), number);
    return NULL;
}

static bool is_ignored(int number) {
    struct sigaction action;
    return sigaction(number, NULL, &action) == 0 && action.sa_handler == SIG_IGN;
}

void signals_watch(void) {
    static sigset_t set;
    pthread_t thread;
    signal(SIGXFSZ, SIG_IGN);
    sigemptyset(&set);
    for (int i = 0; i < WATCHED; i++)
        if (!is_ignored(watched[i])) sigaddset(&set, watched[i]);
    if (pthread_sigmask(SIG_BLOCK, &set, NULL) != 0) return;
    if (pthread_create(&thread, NULL, wait_for, &set) == 0)
        pthread_detach(thread);
    else
        pthread_sigmask(SIG_UNBLOCK, &set, NULL);
}
