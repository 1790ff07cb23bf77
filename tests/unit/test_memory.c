#include "support/allocation.h"
#include "support/check.h"
#include "support/random.h"

#include <stdalign.h>
#include <stdlib.h>
#include <string.h>

static void arrays(void **state) {
    (void)state;
    int *numbers = mt_new(100, sizeof *numbers);
    assert_non_null(numbers);
    for (int i = 0; i < 100; i++) assert_int_equal(numbers[i], 0);
    numbers[99] = 7;
    numbers = mt_grow(numbers, 100000, sizeof *numbers);
    assert_non_null(numbers);
    assert_int_equal(numbers[99], 7);
    mt_free(numbers);
    mt_free(NULL);
}

static void nothing_is_something(void **state) {
    (void)state;
    void *nothing = mt_new(0, 8);
    assert_non_null(nothing);
    mt_free(nothing);
}

static void products_that_overflow(void **state) {
    (void)state;
    mt_arena arena = {0};
    assert_null(mt_new(SIZE_MAX, 2));
    assert_null(mt_new(SIZE_MAX / 2 + 2, 2));
    assert_null(mt_new(2, SIZE_MAX));
    assert_null(mt_arena_new(&arena, SIZE_MAX, 1));
    assert_null(mt_arena_new(&arena, SIZE_MAX / 16 + 2, 16));
    assert_null(mt_arena_new(&arena, PTRDIFF_MAX, 1));
    assert_non_null(mt_arena_new(&arena, 1, 1));
    mt_arena_release(&arena);
}

static void texts(void **state) {
    (void)state;
    char *copy = mt_copy_text("ü形");
    assert_string_equal(copy, "ü形");
    mt_free(copy);
    copy = mt_copy_text("");
    assert_string_equal(copy, "");
    mt_free(copy);
}

static bool all_zero(const unsigned char *bytes, size_t count) {
    for (size_t i = 0; i < count; i++)
        if (bytes[i]) return false;
    return true;
}

enum { HELD = 400 };

/* Everything is aligned and zeroed, even where the arena was used before, and nothing lies over anything
 * else. */
static void fill(mt_arena *arena, mt_random *random) {
    unsigned char *held[HELD];
    size_t sizes[HELD];
    for (int i = 0; i < HELD; i++) {
        sizes[i] = (size_t)mt_random_between(random, 0, mt_random_one_in(random, 20) ? 100000 : 900);
        held[i] = mt_arena_new(arena, sizes[i], 1);
        assert_non_null(held[i]);
        assert_int_equal((uintptr_t)held[i] % alignof(max_align_t), 0);
        assert_true(all_zero(held[i], sizes[i]));
        memset(held[i], i % 255 + 1, sizes[i]);
    }
    for (int i = 0; i < HELD; i++)
        for (size_t k = 0; k < sizes[i]; k++) assert_int_equal(held[i][k], i % 255 + 1);
}

static void arena_of_many(void **state) {
    (void)state;
    mt_arena arena = {0};
    mt_random random = mt_random_case(0);
    for (int round = 0; round < 4; round++) {
        fill(&arena, &random);
        mt_arena_reset(&arena);
    }
    mt_arena_release(&arena);
    assert_null(arena.first);
    fill(&arena, &random);
    mt_arena_release(&arena);
}

static void marks(void **state) {
    (void)state;
    mt_arena arena = {0};
    mt_random random = mt_random_case(1);
    mt_arena_place empty = mt_arena_mark(&arena);
    unsigned char *kept = mt_arena_new(&arena, 5000, 1);
    assert_non_null(kept);
    memset(kept, 0xaa, 5000);
    for (int round = 0; round < 5; round++) {
        mt_arena_place place = mt_arena_mark(&arena);
        fill(&arena, &random);
        mt_arena_rewind(&arena, place);
        for (int i = 0; i < 5000; i++) assert_int_equal(kept[i], 0xaa);
    }
    mt_arena_rewind(&arena, empty);
    fill(&arena, &random);
    mt_arena_release(&arena);
}

/* There each allocation is a block of its own, which goes at once. */
static void skip_where_arenas_are_apart(void) {
#ifdef MT_ARENAS_APART
    skip();
#endif
}

/* After the first glyph the arena has its blocks and asks for no more. */
static void blocks_are_kept(void **state) {
    (void)state;
    skip_where_arenas_are_apart();
    mt_allocation_watch();
    mt_arena arena = {0};
    for (int glyph = 0; glyph < 10; glyph++) {
        for (int i = 0; i < 1000; i++) assert_non_null(mt_arena_new(&arena, 500, 1));
        mt_arena_reset(&arena);
        if (glyph == 0) mt_allocation_fail(0, true);
    }
    mt_allocation_succeed();
    assert_true(mt_allocation_live() > 0);
    mt_arena_release(&arena);
    assert_int_equal(mt_allocation_live(), 0);
    mt_allocation_unwatch();
}

static size_t asked;

static void *count_asked(void *memory, size_t size) {
    asked += size;
    if (size) return realloc(memory, size);
    free(memory);
    return NULL;
}

/* In whatever order large and small come, blocks of earlier glyphs are found again, and new ones stay in proportion: all of them
 * hold less than three times what one glyph needs. */
static void blocks_are_found_again(void **state) {
    (void)state;
    skip_where_arenas_are_apart();
    mt_memory_replace(count_asked);
    mt_arena arena = {0};
    mt_random random = mt_random_case(2);
    size_t most = 0;
    for (int glyph = 0; glyph < 400; glyph++) {
        size_t needed = 0;
        for (int i = mt_random_between(&random, 20, 2000); i > 0; i--) {
            size_t size =
                (size_t)mt_random_between(&random, 16, mt_random_one_in(&random, 50) ? 1 << 20 : 1000);
            assert_non_null(mt_arena_new(&arena, size, 1));
            needed += size;
        }
        mt_arena_reset(&arena);
        if (needed > most) most = needed;
    }
    assert_true(asked <= 3 * most);
    mt_arena_release(&arena);
    mt_memory_replace(NULL);
}

static void failures_change_nothing(void **state) {
    (void)state;
    mt_allocation_watch();
    mt_arena arena = {0};
    int *before = mt_arena_new(&arena, 10, sizeof *before);
    int *array = mt_new(10, sizeof *array);
    assert_non_null(before);
    assert_non_null(array);
    before[9] = array[9] = 3;
    mt_allocation_fail(0, true);
    assert_null(mt_new(1, 1));
    assert_null(mt_copy_text("a"));
    assert_null(mt_grow(array, 1000, sizeof *array));
    assert_null(mt_arena_new(&arena, 1 << 20, 16));
    mt_allocation_succeed();
    assert_int_equal(before[9] + array[9], 6);
    int *more = mt_arena_new(&arena, 10, sizeof *more);
    assert_true(more && more != before && before[9] == 3);
    mt_free(array);
    mt_arena_release(&arena);
    assert_int_equal(mt_allocation_live(), 0);
    mt_allocation_unwatch();
}

/* Work is counted only while it is bounded; what is once spent stays so until there is another bound. */
static void work_is_bounded(void **state) {
    (void)state;
    mt_arena arena = {0};
    assert_true(mt_arena_spend(&arena, INT64_MAX) && !mt_arena_is_spent(&arena));
    mt_arena_bound(&arena, &(mt_allowance){10, 1000, NULL});
    assert_true(mt_arena_spend(&arena, 7) && mt_arena_spend(&arena, 3) && !mt_arena_is_spent(&arena));
    assert_false(mt_arena_spend(&arena, 1));
    assert_false(mt_arena_spend(&arena, 0));
    assert_true(mt_arena_is_spent(&arena));
    mt_arena_bound(&arena, &(mt_allowance){5, 1000, NULL});
    assert_true(mt_arena_spend(&arena, 5));
    assert_false(mt_arena_spend(&arena, INT64_MAX));
    mt_arena_reset(&arena);
    assert_true(mt_arena_spend(&arena, INT64_MAX));
    mt_arena_release(&arena);
}

/* What is asked for counts, whatever blocks there are; what was made after a mark counts no more once it is gone. */
static void memory_is_bounded(void **state) {
    (void)state;
    mt_arena arena = {0};
    assert_non_null(mt_arena_new(&arena, 1 << 20, 1));
    mt_arena_reset(&arena);
    assert_non_null(mt_arena_new(&arena, 500, 1));
    mt_arena_bound(&arena, &(mt_allowance){1000, 1000, NULL});
    mt_arena_place place = mt_arena_mark(&arena);
    assert_non_null(mt_arena_new(&arena, 900, 1));
    mt_arena_rewind(&arena, place);
    assert_non_null(mt_arena_new(&arena, 900, 1));
    assert_false(mt_arena_is_spent(&arena));
    assert_int_equal(mt_arena_verdict(&arena, MT_NO_MEMORY), MT_NO_MEMORY);
    assert_null(mt_arena_new(&arena, 200, 1));
    assert_true(mt_arena_is_spent(&arena) && !mt_arena_spend(&arena, 1));
    assert_int_equal(mt_arena_verdict(&arena, MT_NO_MEMORY), MT_TOO_COSTLY);
    assert_int_equal(mt_arena_verdict(&arena, MT_TOO_LARGE), MT_TOO_COSTLY);
    assert_int_equal(mt_arena_verdict(&arena, MT_BAD_GEOMETRY), MT_BAD_GEOMETRY);
    mt_arena_bound(&arena, NULL);
    assert_non_null(mt_arena_new(&arena, 5000, 1));
    mt_arena_release(&arena);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(arrays),
        cmocka_unit_test(memory_is_bounded),
        cmocka_unit_test(nothing_is_something),
        cmocka_unit_test(texts),
        cmocka_unit_test(products_that_overflow),
        cmocka_unit_test(arena_of_many),
        cmocka_unit_test(marks),
        cmocka_unit_test(blocks_are_kept),
        cmocka_unit_test(blocks_are_found_again),
        cmocka_unit_test(failures_change_nothing),
        cmocka_unit_test(work_is_bounded),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
