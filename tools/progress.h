/* Progress on stderr: on a terminal a line that is drawn over, every half second; elsewhere a line a minute. */
#pragma once

#include <stdbool.h>

/* How much was done when. */
typedef struct progress_mark {
    double time; /* seconds, of a clock that only goes on */
    int done;
} progress_mark;

enum { PROGRESS_MARKS = 32 };

typedef struct progress {
    bool quiet, terminal;
    const char *what;
    bool drawn;                          /* a line stands on the screen */
    double told;                         /* when it was told last */
    progress_mark marks[PROGRESS_MARKS]; /* the last ones, a half second or more apart, the latest first */
    int mark_count;
} progress;

/* `what` is done, one by one: "glyphs". */
progress progress_begin(bool quiet, const char *what);
/* `done` of `all`; an mt_progress, with a progress as its user data. */
void progress_draw(int done, int all, void *user);
void progress_erase(progress *bar);
