#include "layout/value.h"

#include <math.h>

size_t mt_value_size(unsigned format) {
    size_t size = 0;
    for (unsigned bit = 1; bit < 0x10000; bit <<= 1) size += format & bit ? 2 : 0;
    return size;
}

void mt_value_read(mt_bytes parent, size_t at, unsigned format, const mt_gdef_deltas *variations,
                   double values[MT_VALUE_PARTS]) {
    for (int i = 0; i < MT_VALUE_PARTS; i++) {
        values[i] = 0;
        if (!(format >> i & 1)) continue;
        values[i] = mt_ot_i16(parent, at);
        at += 2;
    }
    for (int i = 0; i < MT_VALUE_PARTS; i++) {
        if (!(format >> (MT_VALUE_PARTS + i) & 1)) continue;
        values[i] += mt_gdef_delta(variations, mt_ot_follow(parent, at));
        at += 2;
    }
}

unsigned mt_value_parts(unsigned format) {
    return (format | format >> MT_VALUE_PARTS) & ((1u << MT_VALUE_PARTS) - 1);
}

int mt_value_rounded(double value) {
    return (int)fmin(fmax(floor(value + 0.5), INT16_MIN), INT16_MAX);
}
