/* Words and numbers in the attributes of SVG (W3C, "SVG 2", 9.3.9 and CSS Values), the same in every locale. */
#pragma once

#include <stdbool.h>
#include <stddef.h>

/* Moves past blanks; past blanks with at most one comma among them. */
void mt_scan_blanks(const char **at);
void mt_scan_comma(const char **at);

/* Reads a list of numbers up to its end, `most` at the most; how many, or -1 for what is none. */
int mt_scan_numbers(const char *text, double *numbers, int most);

/* A length in pixels: a number with or without a unit, or a share of `whole` in per cent. False for anything else. */
bool mt_scan_length(const char *text, double whole, double *length);

/* Whether the text is the word, blanks around it left out. */
bool mt_scan_is(const char *text, const char *word);
