/* A progress bar on stderr, where that is a terminal. */
#pragma once

#include <stdbool.h>

typedef struct progress {
    bool shown; /* whether to draw at all */
    int drawn;  /* percent that stand on the screen; -1: no bar does */
} progress;

progress progress_begin(bool quiet);
/* `done` of `all` glyphs; an mt_progress, with a progress as its user data. */
void progress_draw(int done, int all, void *user);
void progress_erase(progress *bar);
