/* The rate is that of the last marks, some 16 seconds on a terminal, so that glyphs that came from a cache, or easy ones, are soon forgotten. */
#include "progress.h"

#include "messages.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* Seconds between two marks, and between two lines where nothing can be drawn over. */
#define HALF_SECOND 0.5
#define MINUTE 60.0

enum { TEXT_ROOM = 128 };

/* A terminal that can go back in its line. */
static bool is_terminal(void) {
    const char *kind = getenv("TERM");
    return kind && *kind && strcmp(kind, "dumb") != 0 && isatty(STDERR_FILENO);
}

static double now(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + (double)time.tv_nsec / 1e9;
}

static void mark(progress *bar, double time, int done) {
    if (bar->mark_count < PROGRESS_MARKS) bar->mark_count++;
    memmove(bar->marks + 1, bar->marks, (size_t)(bar->mark_count - 1) * sizeof *bar->marks);
    bar->marks[0] = (progress_mark){time, done};
}

progress progress_begin(bool quiet, const char *what) {
    progress bar = {.quiet = quiet, .what = what, .terminal = is_terminal(), .told = now()};
    return bar;
}

/* "12 s", "3 min" or "2.5 h" */
static void describe_time(double seconds, char *text, size_t room) {
    if (seconds < 100)
        snprintf(text, room, "%.0f s", seconds);
    else if (seconds < 100 * 60)
        snprintf(text, room, "%.0f min", seconds / 60);
    else
        snprintf(text, room, "%.1f h", seconds / 3600);
}

/* "1200 of 4500 glyphs, 35.2 a second, 94 s left" */
static void describe(const progress *bar, int done, int all, char *text, size_t room) {
    const progress_mark *first = &bar->marks[bar->mark_count - 1], *last = &bar->marks[0];
    char left[32];
    double rate = (last->done - first->done) / (last->time - first->time);
    int used = snprintf(text, room, "%d of %d %s", done, all, bar->what);
    if (!(rate > 0)) return;
    describe_time((all - done) / rate, left, sizeof left);
    snprintf(text + used, room - (size_t)used, ", %.1f a second, %s left", rate, left);
}

static void tell(progress *bar, int done, int all) {
    char text[TEXT_ROOM];
    describe(bar, done, all, text, sizeof text);
    if (bar->terminal)
        fprintf(stderr, "\r\033[K%s", text);
    else
        say("%s", text);
    fflush(stderr);
    bar->drawn = bar->terminal;
}

void progress_draw(int done, int all, void *user) {
    progress *bar = user;
    if (bar->quiet || all <= 0) return;
    double time = now();
    if (bar->mark_count == 0) mark(bar, time, done);
    if (time - bar->marks[0].time < HALF_SECOND) return;
    mark(bar, time, done);
    if (time - bar->told < (bar->terminal ? HALF_SECOND : MINUTE)) return;
    bar->told = time;
    tell(bar, done, all);
}

void progress_erase(progress *bar) {
    if (!bar->drawn) return;
    fputs("\r\033[K", stderr);
    bar->drawn = false;
}
