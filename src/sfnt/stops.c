#include "sfnt/stops.h"

#include <stdint.h>

/* As the tables have it, 16.16. */
static int64_t fixed(double value) {
    return (int64_t)floor(value * 65536 + 0.5);
}

/* `part` of `whole`, which is over 0, in places; rounded up. */
static int place_of(int64_t part, int64_t whole) {
    int64_t scaled = part * MT_PLACE_ONE, down = scaled / whole;
    return (int)(scaled > down * whole ? down + 1 : down);
}

bool mt_stops_make(const mt_axis *axis, const double *values, int count, mt_stops *stops) {
    int64_t from = fixed(axis->from), home = fixed(axis->home), to = fixed(axis->to);
    bool apart = true;
    *stops = (mt_stops){.count = count};
    for (int i = 0; i < count; i++) {
        int64_t value = fixed(values[i]);
        if (value == home)
            stops->home = i;
        else
            stops->at[i] = place_of(value - home, value < home ? home - from : to - home);
        apart = apart && (i == 0 || stops->at[i] > stops->at[i - 1]);
    }
    return apart;
}
