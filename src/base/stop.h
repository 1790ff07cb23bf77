/* A word from outside that work is to end: set by any thread, read by those that work. */
#pragma once

#include <stdatomic.h>

typedef struct mt_stop {
    atomic_bool set;
} mt_stop;
