/* An allocator under memory.h that counts blocks and fails on demand. */
#pragma once

#include <stdbool.h>

/* Puts the counting allocator in place, nothing failing, all counts zero. Call with nothing allocated. */
void mt_allocation_watch(void);
/* Back to the C library's. */
void mt_allocation_unwatch(void);

/* Request number `first` from now (0 is the next) fails, and with `all_after` every later one as well. */
void mt_allocation_fail(long first, bool all_after);
void mt_allocation_succeed(void);

long mt_allocation_live(void);     /* blocks handed out and not given back */
long mt_allocation_requests(void); /* since mt_allocation_watch, failed ones included */
