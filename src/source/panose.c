#include "source/panose.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

/* The digits up to this say that nothing is known. */
enum { NO_FIT = 1 };

static bool is_scale(uint8_t family, int digit) {
    return family == MT_PANOSE_LATIN_TEXT && (digit == MT_PANOSE_WEIGHT || digit == MT_PANOSE_CONTRAST);
}

static uint8_t mix_digit(const uint8_t *a, const uint8_t *b, double t, int digit) {
    uint8_t in_a = a[digit], in_b = b[digit];
    if (in_a == in_b) return in_a;
    if (!is_scale(a[0], digit) || in_a <= NO_FIT || in_b <= NO_FIT) return 0;
    return (uint8_t)floor((1 - t) * in_a + t * in_b + 0.5);
}

void mt_panose_mix(const uint8_t *a, const uint8_t *b, double t, uint8_t *mix) {
    memset(mix, 0, MT_PANOSE_DIGITS);
    if (t <= 0 || t >= 1) memcpy(mix, t <= 0 ? a : b, MT_PANOSE_DIGITS);
    if (t <= 0 || t >= 1 || a[0] != b[0]) return;
    for (int i = 0; i < MT_PANOSE_DIGITS; i++) mix[i] = mix_digit(a, b, t, i);
}
