/* Completion for fish 3. */
#include "pages.h"

#include "base/memory.h"

#include <stdio.h>

static const char head[] =
    "# fish completion for morphotype\n"
    "\n"
    "# __morphotype_runs COMMAND: whether this one is being typed.\n"
    "function __morphotype_runs\n"
    "    set -l tokens (commandline -opc)\n"
    "    test (count $tokens) -ge 2; and test $tokens[2] = $argv[1]\n"
    "end\n"
    "\n"
    "function __morphotype_wants_command\n"
    "    set -l tokens (commandline -opc)\n"
    "    test (count $tokens) -eq 1; or test \"$tokens[2..]\" = help\n"
    "end\n"
    "\n"
    "# __morphotype_files EXTENSION...: directories, and files with one of these; without any, all files.\n"
    "function __morphotype_files\n"
    "    set -l token (commandline -ct | string replace -r -- '^--[a-z-]+=' '')\n"
    "    set -l ends (string join '|' -- '/$' '\\.'$argv'$')\n"
    "    test (count $argv) -gt 0; or set ends ''\n"
    "    complete -C \"__fish_command_without_completions $token\" | string match -ri -- \"^.*(?:$ends)\"\n"
    "end\n"
    "\n"
    "complete -c morphotype -f\n"
    "complete -c morphotype -n __morphotype_wants_command -a help -d 'show a command and its options'\n"
    "complete -c morphotype -n __morphotype_wants_command -s h -l help -d 'show the commands'\n"
    "complete -c morphotype -n __morphotype_wants_command -s V -l version -d 'show the version'\n";

static void put_quoted(const char *text) {
    putchar('\'');
    print_escaped(text, "\\'");
    putchar('\'');
}

static void put_argument(const option_row *row, const cli_command *command) {
    char *words = argument_words(row);
    if (row->argument && words) {
        printf(" -x");
        if (argument_is_file(row))
            printf(" -a '(__morphotype_files %s)'", row->letter == 'o' ? command->writes : "");
        else if (*words)
            printf(" -a '%s'", words);
    }
    mt_free(words);
}

static void put_option(const option_row *row, const cli_command *command) {
    printf("complete -c morphotype -n '__morphotype_runs %s'", command->name);
    if (row->is_short) printf(" -s %c", row->letter);
    printf(" -l %s", row->name);
    put_argument(row, command);
    printf(" -d ");
    put_quoted(row->help);
    putchar('\n');
}

static void write_command(const cli_command *command) {
    printf("\ncomplete -c morphotype -n __morphotype_wants_command -a %s -d ", command->name);
    put_quoted(command->summary);
    printf("\ncomplete -c morphotype -n '__morphotype_runs %s' -a '(__morphotype_files %s)'\n", command->name,
           command->reads);
    for (const option_row *row = option_rows; row->name; row++)
        if (option_is_taken(row, command)) put_option(row, command);
}

void write_fish(void) {
    fputs(head, stdout);
    for (int i = 0; commands[i]; i++) write_command(commands[i]);
}
