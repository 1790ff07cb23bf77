/* morphotype COMMAND …: finds the subcommand and lets it run. */
#include "commands.h"
#include "messages.h"

#include <stdio.h>
#include <string.h>

static const cli_command *const commands[] = {&blend_command,    &variable_command, &strip_command,
                                              &sheet_command,    &inspect_command,  &report_command,
                                              &specimen_command, &animate_command};
#define COMMAND_COUNT ((int)(sizeof commands / sizeof commands[0]))

static const cli_command *find(const char *name) {
    for (int i = 0; i < COMMAND_COUNT; i++)
        if (strcmp(commands[i]->name, name) == 0) return commands[i];
    return NULL;
}

static int print_help(void) {
    puts("usage: morphotype COMMAND FONT FONT [OPTION...]\n\nMakes the fonts between two fonts.\n");
    for (int i = 0; i < COMMAND_COUNT; i++) printf("  %-10s %s\n", commands[i]->name, commands[i]->summary);
    puts("\nA FONT is FILE[#FACE][@AXIS=VALUE,...][:FEATURE,...]: a face of a collection, counted from 0, at "
         "a place of\n"
         "a variable font, its characters in the forms of these features. Places between the fonts are T: 0 "
         "is the\n"
         "first font, 1 the second.\n"
         "\n"
         "  morphotype COMMAND --help    a command's options\n"
         "  morphotype --version         the version\n"
         "\n"
         "Exit codes: 0 done; 1 could not, and nothing was written; 2 wrong usage.");
    return DONE;
}

static int run(const cli_command *command, int argc, char **argv) {
    cli_options options;
    int outcome = options_read(command, argc, argv, &options);
    if (outcome < 0) outcome = command->run(&options);
    options_free(&options);
    return outcome;
}

static int dispatch(int argc, char **argv) {
    if (argc < 2) return misuse(NULL, "a command is wanted");
    if (strcmp(argv[1], "--help") == 0 || strcmp(argv[1], "-h") == 0) return print_help();
    if (strcmp(argv[1], "--version") == 0)
        return puts("morphotype " MORPHOTYPE_VERSION) < 0 ? COULD_NOT : DONE;
    const cli_command *command = find(argv[1]);
    return command ? run(command, argc - 1, argv + 1) : misuse(NULL, "%s is no command", argv[1]);
}

int main(int argc, char **argv) {
    int outcome = dispatch(argc, argv);
    if (fflush(stdout) != 0 || ferror(stdout)) return fail("stdout: %s", mt_status_text(MT_CANNOT_WRITE));
    return outcome;
}
