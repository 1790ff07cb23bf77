/* The manual and the shells' completion, written from the tables that read the command line. Only the build runs this
 * program; what it writes is installed. All of it goes to stdout.
 *
 *     pages.c   the program
 *     manual.c  pages of the manual, in mdoc (mandoc's mdoc(7)); one for the program and one for each command
 *     mdoc.c    text as mdoc wants it
 *     words.c   what may stand for an option's argument
 *     bash.c, zsh.c, fish.c   completion
 */
#pragma once

#include "commands.h"

#include <stdbool.h>
#include <stddef.h>

void write_manual(const cli_command *command); /* NULL: of the program */
void write_bash(void);
void write_zsh(void);
void write_fish(void);

/* ---- mdoc.c ---------------------------------------------------------------------------------------------- */

/* Words as running text: options as .Fl, lines short, a sentence to a line. */
void mdoc_text(const char *text, size_t length);
/* The same of paragraphs, a line each, with .Pp between. */
void mdoc_paragraphs(const char *text);
/* A word, or words with blanks, as it is typed. */
void mdoc_literal(const char *text, size_t length);
/* "FONT [FONT] -o OUT [OPTION...]" as lines of .Ar, .Fl and .Op. */
void mdoc_synopsis(const char *synopsis);

/* ---- words.c --------------------------------------------------------------------------------------------- */

/* What may stand for the argument of an option, with blanks between; from mt_new, NULL when out of memory. */
char *argument_words(const option_row *row);
bool argument_is_file(const option_row *row);

/* Prints a text in which each character of `special` has a backslash before it. */
void print_escaped(const char *text, const char *special);
/* Prints words with blanks between so that `between` stands there instead. */
void print_joined(const char *words, const char *between);
