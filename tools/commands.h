/* The subcommands: one file each. */
#pragma once

#include "options.h"

extern const cli_command animate_command;  /* animate.c */
extern const cli_command blend_command;    /* blend.c */
extern const cli_command strip_command;    /* strip.c */
extern const cli_command sheet_command;    /* sheet.c */
extern const cli_command inspect_command;  /* inspect.c */
extern const cli_command report_command;   /* report.c */
extern const cli_command variable_command; /* variable.c */
extern const cli_command specimen_command; /* specimen.c */
extern const cli_command solid_command;    /* solid.c */

/* All of them, in the order of the help; a NULL ends them. */
extern const cli_command *const commands[];

const cli_command *command_find(const char *name); /* NULL where there is none */
