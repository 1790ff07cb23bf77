#include "drawing/scan.h"

#include <math.h>
#include <string.h>

#include "base/real.h"

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f';
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

int mt_scan_numbers(const char *text, double *numbers, int most) {
    int count = 0;
    for (mt_scan_blanks(&text); *text; mt_scan_comma(&text))
        if (count == most || !mt_real_next(&text, &numbers[count++])) return -1;
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
    if (!mt_real_next(&text, &number)) return false;
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
