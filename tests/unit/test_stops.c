/* Where fonts stand on an axis, and values that vary between them where the default is in the middle. */
#include "sfnt/stops.h"

#include <math.h>
#include <string.h>

#include "layout/gdef_deltas.h"
#include "layout/lookup_builder.h"
#include "sfnt/var_store.h"
#include "support/check.h"
#include "support/random.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static mt_axis weight(double from, double home, double to) {
    return (mt_axis){MT_TAG('w', 'g', 'h', 't'), from, to, home};
}

static void even_stops_are_even(void **state) {
    (void)state;
    for (int count = 2; count <= MT_STOPS_MAX; count++) {
        mt_stops stops = mt_stops_even(count);
        assert_int_equal(stops.home, 0);
        for (int i = 0; i < count; i++)
            assert_int_equal(stops.at[i], lround((double)MT_PLACE_ONE * i / (count - 1)));
    }
}

static void places_are_normalized_around_the_default(void **state) {
    (void)state;
    const double values[] = {100, 300, 400, 600, 900};
    const mt_axis axis = weight(100, 400, 900);
    mt_stops stops;
    assert_true(mt_stops_make(&axis, values, 5, &stops));
    assert_int_equal(stops.home, 2);
    const int wanted[] = {-16384, -5461, 0, 6554, 16384}; /* -5461.33 and 6553.6, upwards */
    for (int i = 0; i < 5; i++) assert_int_equal(stops.at[i], wanted[i]);
    const int order[] = {2, 0, 1, 3, 4};
    for (int i = 0; i < 5; i++) assert_int_equal(mt_stops_font(&stops, i), order[i]);
}

/* Who does not round is at the place or less than one before it, never past it. */
static void no_value_is_past_its_place(void **state) {
    (void)state;
    for (int n = 0; n < mt_test_cases(2000); n++) {
        mt_random random = mt_random_case(n);
        double home = mt_random_between(&random, 2, 990), inner = mt_random_between(&random, 1, 999);
        if (inner == home) continue;
        double values[4] = {1, fmin(home, inner), fmax(home, inner), 1000};
        if (values[1] == 1) continue;
        const mt_axis axis = weight(1, home, 1000);
        mt_stops stops;
        assert_true(mt_stops_make(&axis, values, 4, &stops));
        for (int i = 0; i < 4; i++) {
            double whole = values[i] < home ? home - 1 : 1000 - home;
            double exact = (values[i] - home) / whole * MT_PLACE_ONE;
            assert_true(exact <= stops.at[i] + 1e-9 && stops.at[i] - exact < 1);
        }
    }
}

static void values_at_one_place_are_refused(void **state) {
    (void)state;
    const double values[] = {1, 500, 500.01, 1000};
    const mt_axis axis = weight(1, 1, 1000);
    mt_stops stops;
    assert_false(mt_stops_make(&axis, values, 4, &stops));
}

/* ---- what varies --------------------------------------------------------------------------------------- */

static mt_bytes gdef_of(const mt_var_store *store) {
    mt_table table = {0};
    mt_bytes gdef;
    mt_table_32(&table, 0x00010003);
    mt_table_zeros(&table, 10);
    mt_table_32(&table, 18);
    mt_assert_ok(mt_var_store_write(store, &table));
    mt_assert_ok(mt_table_keep(&table, &arena, &gdef));
    mt_table_free(&table);
    return gdef;
}

static double delta_at(mt_bytes gdef, uint32_t index, double place) {
    mt_gdef_deltas variations;
    int32_t normalized = (int32_t)lround(place * 4); /* 16.16 of 2.14 */
    uint8_t device[] = {
        (uint8_t)(index >> 24), (uint8_t)(index >> 16), (uint8_t)(index >> 8), (uint8_t)index, 0x80, 0};
    mt_assert_ok(mt_gdef_deltas_open(gdef, &normalized, 1, &arena, &variations));
    return mt_gdef_delta(&variations, (mt_bytes){device, sizeof device});
}

/* Of five fonts, with any of them as the default: at each its own value, in between on the straight line. */
static void rows_are_read_back_on_both_sides(void **state) {
    (void)state;
    enum { FONTS = 5, STEPS = 8 };
    static const double values[FONTS] = {100, 250, 400, 700, 900};
    const int32_t figures[FONTS] = {-30, 12, 500, 700, 90};
    for (int home = 0; home < FONTS; home++) {
        const mt_axis axis = weight(100, values[home], 900);
        mt_stops stops;
        assert_true(mt_stops_make(&axis, values, FONTS, &stops));
        mt_var_store store = mt_var_store_make(&stops);
        int32_t row[FONTS];
        uint32_t index;
        for (int i = 0; i < FONTS; i++) row[i] = figures[mt_stops_font(&stops, i)];
        mt_assert_ok(mt_var_store_add(&store, row, &index));
        mt_bytes gdef = gdef_of(&store);
        for (int i = 0; i + 1 < FONTS; i++)
            for (int k = 0; k <= STEPS; k++) {
                double share = (double)k / STEPS;
                double place = stops.at[i] + share * (stops.at[i + 1] - stops.at[i]);
                double wanted = figures[i] + share * (figures[i + 1] - figures[i]);
                double got = figures[home] + delta_at(gdef, index, place);
                assert_true(fabs(got - wanted) < 0.1); /* a place is a quarter of 2^-14 from there at most */
            }
        mt_var_store_free(&store);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(even_stops_are_even),
        cmocka_unit_test(places_are_normalized_around_the_default),
        cmocka_unit_test(no_value_is_past_its_place),
        cmocka_unit_test(values_at_one_place_are_refused),
        cmocka_unit_test(rows_are_read_back_on_both_sides),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
