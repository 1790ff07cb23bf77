#include "pages.h"

#include "help.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

/* The day that the pages bear: when their form last changed, so that a build always gives the same bytes. */
#define DAY "November 30, 2026"

#define SECTION "1"

static void section(const char *name) {
    printf(".Sh %s\n", name);
}

/* A page of ours, in .Sy: for .Xr, mandoc asks whether the page is installed already. */
static void put_reference(const char *command, const char *end) {
    const char *dash = *command ? "\\-" : "";
    printf(".Sy morphotype%s%s Ns (" SECTION ")%s\n", dash, command, end);
}

static void print_capitals(const char *text) {
    for (; *text; text++) putchar(toupper((unsigned char)*text));
}

/* `command` is "" for the program. */
static void write_head(const char *command, const char *summary) {
    const char *dash = *command ? "-" : "";
    printf(".Dd %s\n.Dt MORPHOTYPE%s", DAY, dash);
    print_capitals(command);
    printf(" %s\n.Os\n", SECTION);
    section("NAME");
    printf(".Nm morphotype%s%s\n.Nd %s\n", dash, command, summary);
    section("SYNOPSIS");
}

static void write_exit_codes(void) {
    section("EXIT STATUS");
    puts(".Bl -tag -width Ds");
    for (const exit_code *row = exit_codes; row->meaning; row++) {
        printf(".It %d\n", row->code);
        mdoc_text(row->meaning, strlen(row->meaning));
    }
    puts(".El");
}

static void write_environment(void) {
    section("ENVIRONMENT");
    puts(".Bl -tag -width Ds");
    for (const environment_row *row = environment; row->name; row++) {
        printf(".It Ev %s\n", row->name);
        mdoc_text(row->meaning, strlen(row->meaning));
    }
    puts(".El");
}

/* ---- a command --------------------------------------------------------------------------------------------- */

static void put_argument(const option_row *row) {
    if (!row->argument) return;
    printf(" Ar ");
    mdoc_literal(row->argument, strlen(row->argument));
}

static void write_option(const option_row *row) {
    printf(".It ");
    if (row->is_short) {
        printf("Fl %c", row->letter);
        put_argument(row);
        printf(" , ");
    }
    printf("Fl \\-");
    mdoc_literal(row->name, strlen(row->name));
    put_argument(row);
    putchar('\n');
    mdoc_text(row->help, strlen(row->help));
}

static void write_options(const cli_command *command, bool common) {
    puts(".Bl -tag -width Ds");
    for (const option_row *row = option_rows; row->name; row++)
        if (option_is_taken(row, command) && option_is_common(row) == common) write_option(row);
    puts(".El");
}

static void write_examples(const cli_command *command) {
    section("EXAMPLES");
    for (int i = 0; i < CLI_EXAMPLES && command->examples[i].what; i++) {
        const cli_example *example = &command->examples[i];
        if (i > 0) puts(".Pp");
        mdoc_text(example->what, strlen(example->what));
        printf(".Pp\n.Dl ");
        mdoc_literal(example->line, strlen(example->line));
        putchar('\n');
    }
}

static void write_command(const cli_command *command) {
    write_head(command->name, command->summary);
    printf(".Nm morphotype %s\n", command->name);
    mdoc_synopsis(command->synopsis);
    section("DESCRIPTION");
    mdoc_paragraphs(command->text);
    puts(".Pp\nThe options are:");
    write_options(command, false);
    puts(".Pp\nThe options of every command are:");
    write_options(command, true);
    write_environment();
    write_exit_codes();
    write_examples(command);
    section("SEE ALSO");
    put_reference("", "");
}

/* ---- the program ------------------------------------------------------------------------------------------- */

/* References stand in the order of the alphabet: after each name the next one. */
static const cli_command *next_by_name(const char *name) {
    const cli_command *next = NULL;
    for (int i = 0; commands[i]; i++)
        if (strcmp(commands[i]->name, name) > 0 && (!next || strcmp(commands[i]->name, next->name) < 0))
            next = commands[i];
    return next;
}

static void write_references(void) {
    section("SEE ALSO");
    for (const cli_command *at = next_by_name(""), *next; at; at = next) {
        next = next_by_name(at->name);
        put_reference(at->name, next ? " ," : "");
    }
}

static void write_program(void) {
    write_head("", program_summary);
    puts(".Nm\n.Ar COMMAND Ar FONT Ar FONT\n.Op Ar OPTION...");
    puts(".Nm\n.Cm help\n.Op Ar COMMAND\n.Nm\n.Fl \\-version");
    section("DESCRIPTION");
    mdoc_paragraphs(program_paragraphs);
    puts(".Pp\nThe commands are:\n.Bl -tag -width Ds");
    for (int i = 0; commands[i]; i++) printf(".It Cm %s\n%s\n", commands[i]->name, commands[i]->summary);
    puts(".El");
    write_environment();
    write_exit_codes();
    write_references();
}

void write_manual(const cli_command *command) {
    if (command)
        write_command(command);
    else
        write_program();
}
