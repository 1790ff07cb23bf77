#include "morph/align/assign.h"
#include "support/check.h"
#include "support/random.h"

#include <math.h>

enum { MOST = 6 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* The least sum over all ways to give rows from `row` on a column each that is not yet taken, or none, as many as can be. */
static double least_by_trying(const double *costs, int rows, int columns, int row, unsigned taken,
                              int skips) {
    if (row == rows) return 0;
    double least = skips > 0 ? least_by_trying(costs, rows, columns, row + 1, taken, skips - 1) : INFINITY;
    for (int c = 0; c < columns; c++)
        if (!(taken >> c & 1))
            least = fmin(least, costs[row * columns + c] +
                                    least_by_trying(costs, rows, columns, row + 1, taken | 1u << c, skips));
    return least;
}

static void it_is_the_least_of_all(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(300); n++) {
        mt_random random = mt_random_case(n);
        int rows = mt_random_between(&random, 1, MOST), columns = mt_random_between(&random, 1, MOST);
        double costs[MOST * MOST], sum = 0;
        int column_of[MOST], used = 0;
        unsigned taken = 0;
        for (int i = 0; i < rows * columns; i++) costs[i] = mt_random_between(&random, 0, 49);
        mt_assert_ok(mt_assign(costs, rows, columns, &arena, column_of));
        for (int r = 0; r < rows; r++) {
            if (column_of[r] < 0) continue;
            assert_in_range(column_of[r], 0, columns - 1);
            assert_false(taken >> column_of[r] & 1);
            taken |= 1u << column_of[r];
            sum += costs[r * columns + column_of[r]];
            used++;
        }
        assert_int_equal(used, rows < columns ? rows : columns);
        assert_true(sum == least_by_trying(costs, rows, columns, 0, 0, rows > columns ? rows - columns : 0));
        mt_arena_reset(&arena);
    }
}

/* A row of three that has moved on by one: each goes one step, though two could stay. */
static void what_has_moved_on_moves_on(void **state) {
    (void)state;
    const double costs[] = {1, 4, 9, 0, 1, 4, 1, 0, 1};
    int column_of[3];
    mt_assert_ok(mt_assign(costs, 3, 3, &arena, column_of));
    for (int i = 0; i < 3; i++) assert_int_equal(column_of[i], i);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_the_least_of_all),
        cmocka_unit_test(what_has_moved_on_moves_on),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
