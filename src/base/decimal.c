#include "base/decimal.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>

#include <stddef.h>

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool mt_decimal_next(const char **text, int32_t *fixed) {
    const char *c = *text;
    bool negative = *c == '-';
    if (*c == '-' || *c == '+') c++;
    const char *digits = c;
    int64_t whole = 0, part = 0, scale = 1;
    for (; is_digit(*c); c++)
        if ((whole = 10 * whole + (*c - '0')) > INT16_MAX) return false;
    size_t count = (size_t)(c - digits);
    if (*c == '.') {
        digits = ++c;
        for (; is_digit(*c); c++) {
            if (scale > 1000000000) continue; /* far below half of 1/65536 */
            part = 10 * part + (*c - '0');
            scale *= 10;
        }
        count += (size_t)(c - digits);
    }
    int64_t value = whole * 65536 + (part * 65536 + scale / 2) / scale;
    if (count == 0 || value > INT32_MAX) return false;
    *fixed = (int32_t)(negative ? -value : value);
    *text = c;
    return true;
}

void mt_decimal_write(double value, int decimals, char text[MT_DECIMAL_ROOM]) {
    int64_t one = 1;
    for (int i = 0; i < decimals; i++) one *= 10;
    int64_t parts = llround(fabs(value) * (double)one);
    int length =
        snprintf(text, MT_DECIMAL_ROOM, "%s%" PRId64, value < 0 && parts > 0 ? "-" : "", parts / one);
    if (parts % one == 0) return;
    length += snprintf(text + length, MT_DECIMAL_ROOM - (size_t)length, ".%0*" PRId64, decimals, parts % one);
    while (text[length - 1] == '0') text[--length] = '\0';
}
