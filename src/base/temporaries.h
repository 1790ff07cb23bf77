/* What a process has made beside its outputs and will rename or remove: known, so that it can go when the process is told to end. */
#pragma once

#include <stdbool.h>

/* Begins and ends a temporary, a file or a folder. Of more than TEMPORARIES_MOST at once, or under a longer path, the rest is not known. */
void mt_temporary_begin(const char *path);
void mt_temporary_end(const char *path);

/* Several outputs change places: until it is over, nothing is removed. */
void mt_temporaries_hold(void);
void mt_temporaries_let_go(void);

/* Removes all of this process, for good: what else is made waits. For a process about to end. */
void mt_temporaries_remove(void);

/* Removes what dead processes of this user and machine have left in the directory of `path`. */
void mt_temporaries_clear(const char *path);
