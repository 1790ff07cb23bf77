/* What --help and --version print. */
#pragma once

#include "options.h"

/* Each prints, and gives DONE. */
int help_program(void);
int help_command(const cli_command *command);
int help_version(void);

/* What is told of the program as a whole, for --help and for its manual page. */
extern const char *const program_summary;
extern const char *const program_paragraphs; /* a line each, as cli_command's text */
typedef struct exit_code {
    int code;
    const char *meaning;
} exit_code;
extern const exit_code exit_codes[]; /* the last has no meaning */

typedef struct environment_row {
    const char *name, *meaning;
} environment_row;
extern const environment_row environment[]; /* the last has no name */
