#include "drawing/scan.h"

#include <math.h>
#include <string.h>

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f';
}

static bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

void mt_scan_blanks(const char **at) {
    while (is_blank(**at)) (*at)++;
}

void mt_scan_comma(const char **at) {
    mt_scan_blanks(at);
    if (**at != ',') return;
    (*at)++;
    mt_scan_blanks(at);
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

bool mt_scan_number(const char **at, double *number) {
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
    value = exponent < 0 ? value / pow(10, -exponent) : value * pow(10, exponent);
    if (!isfinite(value)) return false;
    *number = negative ? -value : value;
    *at = p;
    return true;
}

int mt_scan_numbers(const char *text, double *numbers, int most) {
    int count = 0;
    for (mt_scan_blanks(&text); *text; mt_scan_comma(&text))
        if (count == most || !mt_scan_number(&text, &numbers[count++])) return -1;
    return count;
}

bool mt_scan_length(const char *text, double whole, double *length) {
    static const struct {
        const char *unit;
        double pixels;
    } units[] = {{"", 1},           {"px", 1},          {"pt", 96.0 / 72}, {"pc", 16}, {"in", 96},
                 {"cm", 96 / 2.54}, {"mm", 9.6 / 2.54}, {"em", 16},        {"ex", 8}};
    double number;
    mt_scan_blanks(&text);
    if (!mt_scan_number(&text, &number)) return false;
    if (mt_scan_is(text, "%")) {
        *length = number * whole / 100;
        return true;
    }
    for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
        if (!mt_scan_is(text, units[i].unit)) continue;
        *length = number * units[i].pixels;
        return isfinite(*length);
    }
    return false;
}

bool mt_scan_is(const char *text, const char *word) {
    size_t length = strlen(word);
    mt_scan_blanks(&text);
    if (strncmp(text, word, length) != 0) return false;
    text += length;
    mt_scan_blanks(&text);
    return *text == '\0';
}
