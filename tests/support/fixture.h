/* What a test program that writes files works in. */
#pragma once

#include "base/memory.h"

extern mt_arena arena;  /* of the program */
extern char *directory; /* a new one, from mt_test_set_up to mt_test_tear_down; in the arena */

/* For cmocka's groups. */
int mt_test_set_up(void **state);
int mt_test_tear_down(void **state);
