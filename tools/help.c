#include "help.h"

#include "commands.h"
#include "messages.h"

#include <stdio.h>
#include <string.h>

#define WIDTH 106 /* columns */
#define NAMES 30  /* columns of an option's names, with their indent */

const char *const program_summary = "makes the fonts between two fonts";

const char *const program_paragraphs = "A FONT is FILE[#FACE][@AXIS=VALUE,...][:FEATURE,...]: a face of a "
                                       "collection, counted from 0, at a place "
                                       "of a variable font, its characters in the forms of these features.\n"
                                       "Places between the fonts are T: 0 is the first font, 1 the second.";

const exit_code exit_codes[] = {
    {DONE, "done"},
    {COULD_NOT, "could not, and nothing was written; or report --fail-on found flagged glyphs"},
    {WRONG_USAGE, "wrong usage"},
    {0},
};

const environment_row environment[] = {
    {"SOURCE_DATE_EPOCH", "seconds since 1970: the date of what is made, in place of the sources' own"},
    {"TERM", "dumb: progress is a line a minute"},
    {0},
};

/* Prints words, which are ASCII, from `column` on, with the lines that follow indented by `indent`, and ends the line. */
static void print_wrapped(const char *words, size_t length, int column, int indent) {
    for (size_t at = 0; at < length;) {
        size_t word = strcspn(words + at, " ");
        if (word > length - at) word = length - at;
        bool breaks = at > 0 && column + 1 + (int)word > WIDTH;
        if (breaks) {
            printf("\n%*s", indent, "");
            column = indent;
        } else if (at > 0) {
            putchar(' ');
            column++;
        }
        printf("%.*s", (int)word, words + at);
        column += (int)word;
        at += word + 1;
    }
    putchar('\n');
}

static void print_paragraphs(const char *text) {
    for (const char *at = text; *at;) {
        size_t length = strcspn(at, "\n");
        putchar('\n');
        print_wrapped(at, length, 0, 0);
        at += length + (at[length] == '\n');
    }
}

static void print_option(const option_row *row) {
    char names[96];
    char letter[8] = "    ";
    if (row->is_short) snprintf(letter, sizeof letter, "-%c, ", row->letter);
    snprintf(names, sizeof names, "  %s--%s%s%s", letter, row->name, row->argument ? " " : "",
             row->argument ? row->argument : "");
    int length = printf("%-*s  ", NAMES, names);
    print_wrapped(row->help, strlen(row->help), length, NAMES + 2);
}

static void print_options(const cli_command *command, bool common) {
    for (const option_row *row = option_rows; row->name; row++)
        if (option_is_taken(row, command) && option_is_common(row) == common) print_option(row);
}

int help_command(const cli_command *command) {
    printf("usage: morphotype %s %s\n", command->name, command->synopsis);
    print_paragraphs(command->text);
    puts("\nOptions:");
    print_options(command, false);
    puts("\nOptions of every command:");
    print_options(command, true);
    return DONE;
}

int help_program(void) {
    printf("usage: morphotype COMMAND FONT FONT [OPTION...]\n\n%c%s.\n\n", program_summary[0] - 'a' + 'A',
           program_summary + 1);
    for (int i = 0; commands[i]; i++) printf("  %-10s %s\n", commands[i]->name, commands[i]->summary);
    print_paragraphs(program_paragraphs);
    puts("\n  morphotype help COMMAND, COMMAND --help   a command's options\n"
         "  morphotype --version                      the version\n");
    puts("Exit codes:");
    for (const exit_code *row = exit_codes; row->meaning; row++)
        printf("  %d  %s\n", row->code, row->meaning);
    return DONE;
}

int help_version(void) {
    puts("morphotype " MORPHOTYPE_VERSION);
    return DONE;
}
