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
