/* An allocator under memory.h that counts blocks and fails on demand. */
#pragma once

#include <stdbool.h>

#include "morphotype.h"

/* Puts the counting allocator in place, nothing failing, all counts zero. Call with nothing allocated. */
void mt_allocation_watch(void);
/* Back to the C library's. */
void mt_allocation_unwatch(void);

/* Request number `first` from now (0 is the next) fails, and with `all_after` every later one as well. */
void mt_allocation_fail(long first, bool all_after);
void mt_allocation_succeed(void);

long mt_allocation_live(void);     /* blocks handed out and not given back */
long mt_allocation_requests(void); /* since mt_allocation_watch, failed ones included */

/* Makes something with each allocation from one on failing, the first, the second and so on, until it can be made. Fails the test for a
 * block that is not given back, and for any status but MT_NO_MEMORY before. */
void mt_test_want_of_memory(mt_status (*make)(void));
