#include "numbers.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* strtod alone would take blanks, hexadecimals, "nan" and "infinity" too. */
static bool read_one(const char **text, double *value) {
    char *end;
    size_t length = strspn(*text, "+-.0123456789eE");
    if (length == 0) return false;
    *value = strtod(*text, &end);
    if (end != *text + length || !isfinite(*value)) return false;
    *text = end;
    return true;
}

int numbers_read(const char *text, double *values, int most) {
    for (int count = 0; count < most;) {
        if (!read_one(&text, &values[count++])) return -1;
        if (*text == '\0') return count;
        if (*text++ != ',') return -1;
    }
    return -1;
}

int pairs_read(const char *text, double *firsts, double *seconds, int most) {
    for (int count = 0; count < most; count++) {
        if (!read_one(&text, &firsts[count]) || *text++ != ':') return -1;
        if (!read_one(&text, &seconds[count])) return -1;
        if (*text == '\0') return count + 1;
        if (*text++ != ',') return -1;
    }
    return -1;
}

int places_read(const char *text, double *t, double *up, int most) {
    for (int count = 0; count < most; count++) {
        if (!read_one(&text, &t[count])) return -1;
        up[count] = t[count];
        if (strncmp(text, ",y=", 3) == 0) {
            text += 3;
            if (!read_one(&text, &up[count])) return -1;
        }
        if (*text == '\0') return count + 1;
        if (*text++ != ',') return -1;
    }
    return -1;
}

bool number_read(const char *text, double *value) {
    return numbers_read(text, value, 1) == 1;
}

void number_write(double value, char text[32]) {
    for (int digits = 1; digits <= 17; digits++) {
        snprintf(text, 32, "%.*g", digits, value);
        if (strtod(text, NULL) == value) return;
    }
}
