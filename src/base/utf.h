/* UTF-8 and UTF-16, one character at a time (Unicode 15, section 3.9). */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { MT_REPLACEMENT = 0xFFFD }; /* stands for what cannot be decoded */

/* Reads one code point and moves past it; 0 at the terminating NUL, without moving. False for what is not
 * well-formed UTF-8 (overlong forms and surrogates too). */
bool mt_utf8_next(const char **text, uint32_t *code_point);
/* Whether the `length` bytes are well-formed UTF-8 without a NUL; they are followed by one, or by ASCII. */
bool mt_utf8_is_valid(const char *text, size_t length);
/* Writes 1 … 4 bytes, without a NUL; returns how many. */
int mt_utf8_put(uint32_t code_point, char bytes[4]);
/* Reads one code point of big-endian UTF-16 at *at, which is under `length`, and moves past it. A surrogate
 * without its partner, or a single last byte, gives MT_REPLACEMENT. */
uint32_t mt_utf16_next(const uint8_t *bytes, size_t length, size_t *at);
