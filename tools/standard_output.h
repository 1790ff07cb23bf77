/* -o - --format EXT: the output is made as a file, beside no other, and then printed. */
#pragma once

#include "options.h"

#include <limits.h>

typedef struct standard_output {
    char folder[PATH_MAX]; /* made for the file alone; "" where the output goes elsewhere */
    char path[PATH_MAX];
} standard_output;

/* Where -o is -, has the command write into a folder for temporary files instead. DONE or, said, an exit code: no --format or one that the
 * command does not write, a terminal that would get bytes that are no text, --json on stdout too; no folder. */
int standard_output_begin(const cli_command *command, cli_options *options, standard_output *output);

/* Prints what was made, where `outcome` is DONE, and removes it. Gives `outcome` or, said, COULD_NOT for several files, and for a folder. */
int standard_output_end(standard_output *output, int outcome);
