#include "support/allocation.h"
#include "support/check.h"

#include "base/memory.h"

#include <limits.h>
#include <stdlib.h>

static struct {
    long live, requests;
    long first, last; /* requests that fail, by number */
} count = {.first = LONG_MAX, .last = -1};

static void *resize(void *memory, size_t size) {
    if (size == 0) {
        if (memory) count.live--;
        free(memory);
        return NULL;
    }
    long number = count.requests++;
    if (number >= count.first && number <= count.last) return NULL;
    void *block = realloc(memory, size);
    if (block && !memory) count.live++;
    return block;
}

void mt_allocation_watch(void) {
    count.live = count.requests = 0;
    mt_allocation_succeed();
    mt_memory_replace(resize);
}

void mt_allocation_unwatch(void) {
    mt_memory_replace(NULL);
}

void mt_allocation_fail(long first, bool all_after) {
    count.first = count.requests + first;
    count.last = all_after ? LONG_MAX : count.first;
}

void mt_allocation_succeed(void) {
    count.first = LONG_MAX;
    count.last = -1;
}

long mt_allocation_live(void) {
    return count.live;
}

long mt_allocation_requests(void) {
    return count.requests;
}

void mt_test_want_of_memory(mt_status (*make)(void)) {
    mt_status status = MT_NO_MEMORY;
    for (long fails = 0; status == MT_NO_MEMORY; fails++) {
        mt_allocation_watch();
        mt_allocation_fail(fails, true);
        status = make();
        mt_allocation_succeed();
        assert_int_equal(mt_allocation_live(), 0);
        mt_allocation_unwatch();
        assert_true(fails < 10000);
    }
    mt_assert_ok(status);
}
