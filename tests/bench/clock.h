/* Time, for benchmarks. */
#pragma once

#include <time.h>

/* Of this process, microseconds: what others do on the machine counts little. */
static inline double mt_clock(void) {
    struct timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e6 * (double)now.tv_sec + 1e-3 * (double)now.tv_nsec;
}
