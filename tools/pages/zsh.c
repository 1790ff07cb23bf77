/* Completion for zsh, by its own _arguments. */
#include "pages.h"

#include "base/memory.h"

#include <stdio.h>

/* A text between brackets, in single quotes: what is told of an option. */
static void put_help(const char *help) {
    putchar('[');
    for (; *help; help++)
        if (*help == '\'')
            printf("'\\''");
        else
            printf(*help == '[' || *help == ']' || *help == '\\' ? "\\%c" : "%c", *help);
    putchar(']');
}

/* Files with these extensions, in either case; all where there are none. */
static void put_files(const char *extensions) {
    printf("_files");
    if (!*extensions) return;
    printf(" -g \"(#i)*.(");
    print_joined(extensions, "|");
    printf(")\"");
}

/* :MESSAGE:ACTION of an option's argument. */
static void put_argument(const option_row *row, const cli_command *command) {
    char *words = argument_words(row);
    if (row->argument && words) {
        printf(":");
        print_escaped(row->argument, ":[]");
        printf(":");
        if (argument_is_file(row))
            put_files(row->letter == 'o' ? command->writes : "");
        else if (*words)
            printf("(%s)", words);
        else
            printf(" ");
    }
    mt_free(words);
}

/* An option with an argument may stand there again, and the last one counts; the long name takes = too. */
static void put_option(const option_row *row, const cli_command *command) {
    printf("                '%s", row->argument ? "*" : "");
    if (row->is_short && !row->argument) printf("(-%c --%s)", row->letter, row->name);
    if (row->is_short)
        printf("'{-%c%s,--%s%s}'", row->letter, row->argument ? "+" : "", row->name,
               row->argument ? "=" : "");
    else
        printf("--%s%s", row->name, row->argument ? "=" : "");
    put_help(row->help);
    put_argument(row, command);
    printf("' \\\n");
}

static void write_command(const cli_command *command) {
    printf("        (%s)\n            _arguments -s \\\n", command->name);
    for (const option_row *row = option_rows; row->name; row++)
        if (option_is_taken(row, command)) put_option(row, command);
    printf("                '*:file:");
    put_files(command->reads);
    printf("'\n            ;;\n");
}

void write_zsh(void) {
    printf("#compdef morphotype\n\n"
           "_morphotype() {\n"
           "    local curcontext=\"$curcontext\" state line\n"
           "    local -a commands\n"
           "    commands=(\n");
    for (int i = 0; commands[i]; i++) printf("        '%s:%s'\n", commands[i]->name, commands[i]->summary);
    printf("    )\n"
           "    _arguments -C \\\n"
           "        '(- : *)'{-h,--help}'[show the commands]' \\\n"
           "        '(- : *)'{-V,--version}'[show the version]' \\\n"
           "        '1:command:->command' \\\n"
           "        '*::argument:->argument'\n"
           "    case $state in\n"
           "    (command)\n"
           "        _describe command commands -- \"('help:show a command and its options')\"\n"
           "        ;;\n"
           "    (argument)\n"
           "        case $words[1] in\n"
           "        (help)\n"
           "            _describe command commands\n"
           "            ;;\n");
    for (int i = 0; commands[i]; i++) write_command(commands[i]);
    printf("        esac\n"
           "        ;;\n"
           "    esac\n"
           "}\n\n"
           "_morphotype \"$@\"\n");
}
