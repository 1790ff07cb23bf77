/* Numbers on the command line. */
#pragma once

#include <stdbool.h>

/* Reads decimal numbers with commas between them, and nothing else, into `values`. How many; -1 when the text
 * is malformed or has more than `most`. */
int numbers_read(const char *text, double *values, int most);
bool number_read(const char *text, double *value); /* just one */
/* The same of pairs FIRST:SECOND. */
int pairs_read(const char *text, double *firsts, double *seconds, int most);

/* The same of places: T, or T,y=T where it is another one upwards, which `up` has. */
int places_read(const char *text, double *t, double *up, int most);

/* The shortest decimal that reads back as `value`, which is from -1 to 2. */
void number_write(double value, char text[32]);
