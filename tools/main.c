/* morphotype COMMAND …: finds the subcommand and lets it run. */
#include "commands.h"
#include "help.h"
#include "base/temporaries.h"
#include "messages.h"
#include "signals.h"
#include "sources.h"
#include "standard_output.h"
#include "suggest.h"

#include <stdio.h>
#include <string.h>

static int obey(const cli_command *command, cli_options *options) {
    standard_output printed;
    signals_watch();
    int outcome = standard_output_begin(command, options, &printed);
    if (outcome == DONE && options->output) outcome = sources_spare(options, options->output);
    if (outcome == DONE && options->output) mt_temporaries_clear(options->output);
    if (outcome == DONE) outcome = command->run(options);
    return standard_output_end(&printed, outcome);
}

static int run(const cli_command *command, int argc, char **argv) {
    cli_options options;
    int outcome = options_read(command, argc, argv, &options);
    if (outcome < 0) outcome = obey(command, &options);
    options_free(&options);
    return outcome;
}

static int refuse(const char *name) {
    char hint[SUGGEST_ROOM];
    suggestion nearest = suggest_for(name);
    for (int i = 0; commands[i]; i++) suggest(&nearest, commands[i]->name);
    return misuse(NULL, "%s is no command%s", name, suggest_text(&nearest, "", hint));
}

/* help [COMMAND] */
static int help(int argc, char **argv) {
    if (argc < 2) return help_program();
    if (argc > 2) return misuse(NULL, "%s is one argument too many", argv[2]);
    const cli_command *command = command_find(argv[1]);
    return command ? help_command(command) : refuse(argv[1]);
}

static bool is_either(const char *argument, const char *a, const char *b) {
    return strcmp(argument, a) == 0 || strcmp(argument, b) == 0;
}

static int dispatch(int argc, char **argv) {
    if (argc < 2) return misuse(NULL, "a command is wanted");
    if (strcmp(argv[1], "help") == 0) return help(argc - 1, argv + 1);
    if (is_either(argv[1], "--help", "-h")) return help_program();
    if (is_either(argv[1], "--version", "-V")) return help_version();
    if (argv[1][0] == '-') return misuse(NULL, "%s: a command comes first", argv[1]);
    const cli_command *command = command_find(argv[1]);
    return command ? run(command, argc - 1, argv + 1) : refuse(argv[1]);
}

int main(int argc, char **argv) {
    int outcome = dispatch(argc, argv);
    if (fflush(stdout) != 0 || ferror(stdout)) return fail("stdout: %s", mt_status_text(MT_CANNOT_WRITE));
    return outcome;
}
