/* What every test includes: cmocka, memory that is simply there, and checks that say what they failed on. */
#pragma once

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "geometry/ring.h"

/* Zeroed, never NULL; give it back with free. */
void *mt_test_new(size_t count, size_t size);

#define mt_assert_ok(status) assert_int_equal((status), MT_OK)

/* What a property is being tested on. A failed check prints it in the format of tests/data/shapes.txt, so
 * that it can be added there, with the seed that made it. */
typedef struct mt_subject {
    const char *name;
    int number; /* of the random case; -1 for a named shape */
    const mt_rings *shapes[4];
} mt_subject;

#define mt_require(condition, subject)                                                                       \
    ((condition) ? (void)0 : mt_test_fail(#condition, (subject), __FILE__, __LINE__))
void mt_test_fail(const char *condition, const mt_subject *subject, const char *file, int line);
