#include "base/real.h"

#include <math.h>
#include <stdio.h>

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/* Digits after digits; *places counts those read. */
static void read_digits(const char **at, double *value, int *places) {
    for (; is_digit(**at); (*at)++, (*places)++) *value = *value * 10 + (**at - '0');
}

/* e and a whole number, unless no digit follows: 1em is one em. */
static int read_exponent(const char **at) {
    enum { EXPONENT_MAX = 400 };
    if (**at != 'e' && **at != 'E') return 0;
    const char *p = *at + 1;
    bool negative = *p == '-';
    int exponent = 0;
    if (*p == '-' || *p == '+') p++;
    if (!is_digit(*p)) return 0;
    for (; is_digit(*p); p++)
        if (exponent < EXPONENT_MAX) exponent = exponent * 10 + (*p - '0');
    *at = p;
    return negative ? -exponent : exponent;
}

/* Exact up to 10^22, and the same on every machine beyond: the C library's pow is not. */
static double power_of_ten(int exponent) {
    double power = 1, square = 10;
    for (; exponent > 0; exponent /= 2, square *= square)
        if (exponent % 2) power *= square;
    return power;
}

bool mt_real_next(const char **at, double *number) {
    const char *p = *at;
    double value = 0;
    int whole = 0, decimals = 0;
    bool negative = *p == '-';
    if (*p == '-' || *p == '+') p++;
    read_digits(&p, &value, &whole);
    if (*p == '.' && is_digit(p[1])) {
        p++;
        read_digits(&p, &value, &decimals);
    } else if (*p == '.' && whole > 0) {
        p++;
    }
    if (whole + decimals == 0) return false;
    int exponent = read_exponent(&p) - decimals;
    value = exponent < 0 ? value / power_of_ten(-exponent) : value * power_of_ten(exponent);
    if (!isfinite(value)) return false;
    *number = negative ? -value : value;
    *at = p;
    return true;
}

void mt_real_write(double number, int digits, char text[MT_REAL_ROOM]) {
    char local[MT_REAL_ROOM];
    snprintf(local, sizeof local, "%.*g", digits, number);
    char *to = text;
    for (const char *from = local; *from; from++) {
        bool of_number = is_digit(*from) || *from == '-' || *from == '+' || *from == 'e';
        if (of_number)
            *to++ = *from;
        else if (to == text || to[-1] != '.') /* the locale's point, of one byte or of several */
            *to++ = '.';
    }
    *to = '\0';
}
