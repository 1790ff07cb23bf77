#include "commands.h"

#include <string.h>

const cli_command *const commands[] = {
    &blend_command,  &variable_command, &strip_command,   &sheet_command, &inspect_command,
    &report_command, &specimen_command, &animate_command, &solid_command, NULL,
};

const cli_command *command_find(const char *name) {
    for (int i = 0; commands[i]; i++)
        if (strcmp(commands[i]->name, name) == 0) return commands[i];
    return NULL;
}
