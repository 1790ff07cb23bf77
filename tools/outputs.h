/* The files of a command that writes one for each T. */
#pragma once

#include "options.h"

/* As many as there are T. */
typedef struct outputs {
    int count;
    char **paths;
    size_t *lengths; /* bytes, once they are written */
} outputs;

/* OUT.ttf, or OUT-0.25.ttf and so on where there are several. MT_NO_MEMORY. */
mt_status outputs_name(const cli_options *options, outputs *named);
void outputs_free(outputs *named);

/* DONE or, said, WRONG_USAGE: a T that stands in --at twice. */
int outputs_check_places(const cli_options *options);
