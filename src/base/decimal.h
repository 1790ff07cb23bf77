/* Decimal numbers in text, the same in every locale. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* Reads a decimal number without exponent, rounded to 16.16, and moves past it. False, without moving, where
 * there is none or where it is beyond 16.16. */
bool mt_decimal_next(const char **text, int32_t *fixed);

/* Writes the number with at most `decimals` of them, 0 … 9, without zeros at the end; |value| under 10^9. */
enum { MT_DECIMAL_ROOM = 24 };
void mt_decimal_write(double value, int decimals, char text[MT_DECIMAL_ROOM]);
