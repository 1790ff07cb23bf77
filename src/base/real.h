/* Real numbers in text, the same in every locale. */
#pragma once

#include <stdbool.h>

/* Reads a number, 5, -.5, 5. or 1e3, and moves past it; false, without moving, where there is none or it is not finite. */
bool mt_real_next(const char **at, double *number);

/* Writes a finite number with `digits` significant ones, 1 … 17, in the shortest form: 9 bring a float back, 17 a double. */
enum { MT_REAL_ROOM = 40 };
void mt_real_write(double number, int digits, char text[MT_REAL_ROOM]);
