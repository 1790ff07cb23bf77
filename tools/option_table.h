/* Every option of every command, in one table: what reads them, what shows them in --help and in the manual, and what
 * completes them in a shell. */
#pragma once

#include <stdbool.h>

typedef struct cli_command cli_command;

/* Where an option has no short name of its own on the command line, its letter here is only its name in this
 * program. */
typedef struct option_row {
    char letter;
    bool is_short; /* -x too */
    const char *name;
    const char
        *argument; /* NULL where it takes none; words in small letters stand for themselves: joint|paper */
    const char *words; /* more that may stand for the argument, with blanks between; or NULL */
    const char *help;
} option_row;

enum { OPTION_ROOM = 80 }; /* the table has fewer rows */

/* The rows in the order of the help; the last has no name. */
extern const option_row option_rows[];

bool option_is_common(const option_row *row); /* every command takes it, unless it leaves it */
bool option_is_taken(const option_row *row, const cli_command *command);
