/* Sets of characters on a test program's command line. */
#pragma once

#include <stdint.h>

/* The code points that arguments name, at most `most`: ranges FIRST-LAST, hexadecimal, and FILE:COUNT, the first COUNT
 * characters from U+0080 on of a UTF-8 file, lines that start with # left out. Returns how many, -1 where an argument is
 * malformed or a file cannot be read. */
int mt_test_code_points(int count, char **arguments, uint32_t *code_points, int most);

/* How many of the code points the fonts FILE[#FACE] both have, as FreeType alone reads them; -1 where one cannot be read. */
int mt_test_count_in_both(const char *a, const char *b, const uint32_t *code_points, int count);
