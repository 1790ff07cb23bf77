#include "progress.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define WIDTH 40

/* A terminal that can go back in its line. */
static bool is_terminal(void) {
    const char *kind = getenv("TERM");
    return kind && *kind && strcmp(kind, "dumb") != 0 && isatty(STDERR_FILENO);
}

progress progress_begin(bool quiet) {
    return (progress){.shown = !quiet && is_terminal(), .drawn = -1};
}

void progress_draw(int done, int all, void *user) {
    progress *bar = user;
    if (!bar->shown || all <= 0) return;
    int percent = (int)(100.0 * done / all);
    if (percent == bar->drawn) return;
    bar->drawn = percent;
    fputs("\r[", stderr);
    for (int i = 0; i < WIDTH; i++) fputc(i * 100 < percent * WIDTH ? '#' : ' ', stderr);
    fprintf(stderr, "] %3d %%", percent);
    fflush(stderr);
}

void progress_erase(progress *bar) {
    if (bar->drawn < 0) return;
    fputs("\r\033[K", stderr);
    bar->drawn = -1;
}
