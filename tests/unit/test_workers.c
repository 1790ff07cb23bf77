#include "base/workers.h"
#include "support/check.h"

#include <stdatomic.h>

enum { COUNT = 1000, BAD = 500 };

static atomic_int times[COUNT];
static int last_done;

static mt_status count_up(int index, mt_arena *scratch, mt_arena *kept, void *user) {
    int *bad = user;
    (void)kept;
    if (!mt_arena_new(scratch, 64, 1)) return MT_NO_MEMORY;
    atomic_fetch_add(&times[index], 1);
    return index == *bad ? MT_BAD_GEOMETRY : MT_OK;
}

static void note_progress(int done, int all, void *user) {
    (void)user;
    assert_int_equal(all, COUNT);
    assert_int_equal(done, last_done + 1);
    last_done = done;
}

static mt_status run(int threads, int bad) {
    for (int i = 0; i < COUNT; i++) atomic_store(&times[i], 0);
    last_done = 0;
    mt_work work = {
        .count = COUNT, .task = count_up, .user = &bad, .threads = threads, .progress = note_progress};
    return mt_work_run(&work);
}

static void each_number_is_done_once(void **state) {
    (void)state;
    for (int threads = 0; threads <= 4; threads++) {
        mt_assert_ok(run(threads, -1));
        for (int i = 0; i < COUNT; i++) assert_int_equal(atomic_load(&times[i]), 1);
        assert_int_equal(last_done, COUNT);
    }
}

static void a_failure_ends_it(void **state) {
    (void)state;
    assert_int_equal(run(1, BAD), MT_BAD_GEOMETRY);
    assert_int_equal(atomic_load(&times[BAD]), 1);
    assert_int_equal(atomic_load(&times[BAD + 1]), 0);
    assert_int_equal(run(3, BAD), MT_BAD_GEOMETRY);
}

/* A task; leaves its number behind. */
static mt_status leave_number(int index, mt_arena *scratch, mt_arena *kept, void *user) {
    int **numbers = user;
    (void)scratch;
    numbers[index] = mt_arena_new(kept, 1, sizeof(int));
    if (!numbers[index]) return MT_NO_MEMORY;
    *numbers[index] = index;
    return MT_OK;
}

static void what_is_kept_outlives_the_work(void **state) {
    (void)state;
    static int *numbers[COUNT];
    mt_thread_arenas kept = {0};
    mt_work work = {.count = COUNT, .task = leave_number, .user = numbers, .kept = &kept, .threads = 3};
    mt_assert_ok(mt_work_run(&work));
    for (int i = 0; i < COUNT; i++) assert_int_equal(*numbers[i], i);
    mt_thread_arenas_release(&kept);
}

static void nothing_to_do(void **state) {
    (void)state;
    mt_work work = {.task = count_up};
    mt_assert_ok(mt_work_run(&work));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_number_is_done_once),
        cmocka_unit_test(a_failure_ends_it),
        cmocka_unit_test(what_is_kept_outlives_the_work),
        cmocka_unit_test(nothing_to_do),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
