#include "morph/paper/relax.h"
#include "support/check.h"
#include "support/random.h"

#include <math.h>
#include <string.h>

enum { MOST = 7 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* Formula (1) as it is printed, one round, then scaled. */
static void relax_plainly(double *s, int rows, int columns) {
    double next[MOST * MOST], largest = 0;
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++) {
            double sum = 0;
            for (int h = 0; h < rows; h++) {
                double most = columns > 1 ? 0 : s[h];
                for (int r = 0; r < columns; r++)
                    if (r != j) most = fmax(most, s[h * columns + r]);
                if (h != i) sum += most;
            }
            next[i * columns + j] = s[i * columns + j] * (rows > 1 ? sum / (rows - 1) : 1);
            largest = fmax(largest, next[i * columns + j]);
        }
    for (int k = 0; k < rows * columns; k++) s[k] = largest > 0 ? next[k] / largest : 0;
}

static void random_matrix(mt_random *random, double *s, int rows, int columns) {
    for (int k = 0; k < rows * columns; k++)
        s[k] = mt_random_one_in(random, 5) ? 0.5 : mt_random_unit(random);
}

static void formula_one(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(300); n++) {
        mt_random random = mt_random_case(n);
        int rows = mt_random_between(&random, 1, MOST), columns = mt_random_between(&random, 1, MOST);
        int rounds = mt_random_between(&random, 0, 12);
        double s[MOST * MOST], plain[MOST * MOST];
        random_matrix(&random, s, rows, columns);
        memcpy(plain, s, sizeof s);
        mt_assert_ok(mt_relax(s, rows, columns, rounds, &arena));
        double largest = 0;
        for (int k = 0; k < rows * columns; k++) largest = fmax(largest, plain[k]);
        for (int k = 0; k < rows * columns; k++) plain[k] /= largest;
        for (int round = 0; round < rounds; round++) relax_plainly(plain, rows, columns);
        for (int k = 0; k < rows * columns; k++) assert_true(fabs(s[k] - plain[k]) < 1e-9);
        mt_arena_reset(&arena);
    }
}

static bool has(const mt_links *links, int a, int b) {
    for (int i = 0; i < links->count; i++)
        if (links->links[i].a == a && links->links[i].b == b) return true;
    return false;
}

static mt_links matched(const double *s, int rows, int columns) {
    mt_links links;
    mt_assert_ok(mt_match_components(s, rows, columns, 10, 0.3, &arena, &links));
    return links;
}

static void one_to_one(void **state) {
    (void)state;
    const double s[] = {0.2, 0.9, 0.1, 0.8, 0.3, 0.2, 0.1, 0.2, 0.7};
    mt_links links = matched(s, 3, 3);
    assert_int_equal(links.count, 3);
    assert_true(has(&links, 0, 1) && has(&links, 1, 0) && has(&links, 2, 2));
}

/* The paper's figure 2: three strokes against two, of which the first two go with one. */
static void three_against_two(void **state) {
    (void)state;
    const double s[] = {0.9, 0.2, 0.7, 0.4, 0.2, 0.9};
    mt_links links = matched(s, 3, 2), back;
    assert_int_equal(links.count, 3);
    assert_true(has(&links, 0, 0) && has(&links, 1, 0) && has(&links, 2, 1));
    const double turned[] = {0.9, 0.7, 0.2, 0.2, 0.4, 0.9};
    back = matched(turned, 2, 3);
    assert_int_equal(back.count, 3);
    for (int i = 0; i < 3; i++) assert_true(has(&back, links.links[i].b, links.links[i].a));
}

static void one_against_many(void **state) {
    (void)state;
    const double s[] = {0.9, 0.01, 0.4, 0};
    mt_links links = matched(s, 1, 4);
    assert_int_equal(links.count, 4);
    links = matched(s, 4, 1);
    assert_int_equal(links.count, 4);
    links = matched(s, 1, 1);
    assert_int_equal(links.count, 1);
}

/* Every row and column has a match, in order, none twice; s is left as it was; the transpose gives the
 * same, turned. */
static void matches_of_random_matrices(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(300); n++) {
        mt_random random = mt_random_case(n);
        int rows = mt_random_between(&random, 1, MOST), columns = mt_random_between(&random, 1, MOST);
        double s[MOST * MOST], before[MOST * MOST], turned[MOST * MOST];
        for (int k = 0; k < rows * columns; k++) s[k] = mt_random_unit(&random);
        for (int i = 0; i < rows; i++)
            for (int j = 0; j < columns; j++) turned[j * rows + i] = s[i * columns + j];
        memcpy(before, s, sizeof s[0] * (size_t)(rows * columns));
        int rounds = mt_random_between(&random, 0, 20);
        mt_links links, back;
        mt_assert_ok(mt_match_components(s, rows, columns, rounds, 0.3, &arena, &links));
        assert_memory_equal(before, s, sizeof s[0] * (size_t)(rows * columns));
        bool row[MOST] = {false}, column[MOST] = {false};
        for (int i = 0; i < links.count; i++) {
            mt_link link = links.links[i], last = i > 0 ? links.links[i - 1] : (mt_link){-1, 0};
            assert_true(link.a > last.a || (link.a == last.a && link.b > last.b));
            row[link.a] = column[link.b] = true;
        }
        for (int i = 0; i < rows; i++) assert_true(row[i]);
        for (int j = 0; j < columns; j++) assert_true(column[j]);
        mt_assert_ok(mt_match_components(turned, columns, rows, rounds, 0.3, &arena, &back));
        assert_int_equal(back.count, links.count);
        for (int i = 0; i < links.count; i++) assert_true(has(&back, links.links[i].b, links.links[i].a));
        mt_arena_reset(&arena);
    }
}

/* Nothing alike at all still gives everybody a match. */
static void all_zero(void **state) {
    (void)state;
    const double s[6] = {0};
    mt_links links = matched(s, 2, 3);
    assert_true(links.count >= 3);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formula_one),       cmocka_unit_test(one_to_one),
        cmocka_unit_test(three_against_two), cmocka_unit_test(one_against_many),
        cmocka_unit_test(all_zero),          cmocka_unit_test(matches_of_random_matrices),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
