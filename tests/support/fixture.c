#include "support/fixture.h"

#include "support/sample.h"

mt_arena arena;
char *directory;

int mt_test_set_up(void **state) {
    (void)state;
    directory = mt_sample_directory(&arena);
    return 0;
}

int mt_test_tear_down(void **state) {
    (void)state;
    mt_sample_remove(directory);
    mt_arena_release(&arena);
    return 0;
}
