/* ItemVariationStores and DeltaSetIndexMaps that are written, against what mt_gdef_deltas reads of them. */
#include "sfnt/var_store.h"

#include <math.h>
#include <string.h>

#include "layout/gdef_deltas.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/random.h"

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* ---- reading ------------------------------------------------------------------------------------------- */

/* A GDEF table with nothing but the store. */
static mt_bytes gdef_of(const mt_var_store *store) {
    mt_table table = {0};
    mt_table_32(&table, 0x00010003);
    mt_table_zeros(&table, 10);
    mt_table_32(&table, 18);
    mt_assert_ok(mt_var_store_write(store, &table));
    assert_false(table.failed);
    uint8_t *bytes = mt_arena_new(&arena, table.length, 1);
    memcpy(bytes, table.bytes, table.length);
    mt_bytes gdef = {bytes, table.length};
    mt_table_free(&table);
    return gdef;
}

/* What a row adds at a place, 0 … 1, to the value of the first stop. */
static double delta_at(mt_bytes gdef, uint32_t index, double place) {
    mt_gdef_deltas variations;
    int32_t normalized = (int32_t)lround(place * 0x10000);
    uint8_t device[] = {
        (uint8_t)(index >> 24), (uint8_t)(index >> 16), (uint8_t)(index >> 8), (uint8_t)index, 0x80, 0};
    mt_assert_ok(mt_gdef_deltas_open(gdef, &normalized, 1, &arena, &variations));
    return mt_gdef_delta(&variations, (mt_bytes){device, sizeof device});
}

static mt_var_store even_store(int stop_count) {
    const mt_stops stops = mt_stops_even(stop_count);
    return mt_var_store_make(&stops);
}

/* Where a stop is, as 2.14 has it. */
static double stop_at(int stop, int stop_count) {
    return round(0x4000 * (double)stop / (stop_count - 1)) / 0x4000;
}

/* The value between two stops, on the straight line. */
static double value_at(const int32_t *values, int stop_count, double place) {
    int stop = 0;
    while (stop < stop_count - 2 && place > stop_at(stop + 1, stop_count)) stop++;
    double from = stop_at(stop, stop_count), to = stop_at(stop + 1, stop_count);
    return values[stop] + (place - from) / (to - from) * ((double)values[stop + 1] - values[stop]);
}

static void assert_near(double got, double wanted, double within) {
    if (!(fabs(got - wanted) <= within)) fail_msg("%g, not %g within %g", got, wanted, within);
}

static uint32_t add(mt_var_store *store, const int32_t *values) {
    uint32_t index;
    mt_assert_ok(mt_var_store_add(store, values, &index));
    return index;
}

/* ---- rows ---------------------------------------------------------------------------------------------- */

/* Values of each size at up to seven stops, often the same as at the first. */
static void rows_are_read_back(void **state) {
    (void)state;
    enum { ROWS = 300, PLACES = 32 };
    static const int32_t spans[] = {100, 10000, 60000};
    mt_random random = mt_random_case(0);
    for (int stops = 2; stops <= 7; stops++) {
        mt_var_store store = even_store(stops);
        int32_t values[ROWS][7];
        uint32_t indices[ROWS];
        for (int i = 0; i < ROWS; i++) {
            for (int k = 0; k < stops; k++) {
                int32_t span = spans[mt_random_between(&random, 0, 2)];
                bool same = k && mt_random_one_in(&random, 3);
                values[i][k] = same ? values[i][0] : mt_random_between(&random, -span, span);
            }
            indices[i] = add(&store, values[i]);
        }
        mt_bytes gdef = gdef_of(&store);
        mt_arena_place mark = mt_arena_mark(&arena);
        for (int i = 0; i < ROWS; i++) {
            for (int p = 0; p <= PLACES; p++) {
                double place = (double)p / PLACES, wanted = value_at(values[i], stops, place);
                assert_near(values[i][0] + delta_at(gdef, indices[i], place), wanted, 1e-6);
            }
            mt_arena_rewind(&arena, mark);
        }
        mt_var_store_free(&store);
    }
}

static void rows_that_differ_by_a_constant_are_one(void **state) {
    (void)state;
    mt_var_store store = even_store(3);
    uint32_t first = add(&store, (int32_t[]){5, 10, 0});
    assert_int_equal(add(&store, (int32_t[]){-20, -15, -25}), first);
    assert_int_not_equal(add(&store, (int32_t[]){5, 10, 1}), first);
    assert_int_equal(store.data_count, 1);
    assert_int_equal(store.data[0].count, 2);
    mt_var_store_free(&store);
}

static void what_does_not_vary_needs_no_row(void **state) {
    (void)state;
    mt_var_store store = even_store(3);
    uint32_t index;
    assert_int_equal(add(&store, (int32_t[]){7, 7, 7}), MT_NO_VARIATION);
    assert_int_equal(store.data_count, 0);
    mt_assert_ok(mt_var_store_add_row(&store, (int32_t[]){7, 7, 7}, &index));
    assert_int_equal(index, 0);
    assert_near(delta_at(gdef_of(&store), index, 0.75), 0, 0);
    mt_var_store_free(&store);
}

/* Bytes up to 127, words up to 32767, more only beyond; and regions only where something changes. */
static void deltas_take_what_they_need(void **state) {
    (void)state;
    static const struct {
        int32_t values[3];
        int size;
        uint64_t regions;
    } cases[] = {
        {{0, 127, -128}, 1, 3},      {{0, 128, 0}, 2, 1},   {{0, 0, -129}, 2, 2},
        {{-1, 32766, -32769}, 2, 3}, {{0, 32768, 1}, 4, 3}, {{32767, 32767, -32768}, 4, 2},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mt_var_store store = even_store(3);
        uint32_t index = add(&store, cases[i].values);
        assert_int_equal(store.data[0].size, cases[i].size);
        assert_int_equal(store.data[0].regions, cases[i].regions);
        mt_bytes gdef = gdef_of(&store);
        for (int k = 0; k < 3; k++)
            assert_near(delta_at(gdef, index, k / 2.0), cases[i].values[k] - cases[i].values[0], 0);
        mt_var_store_free(&store);
    }
}

/* More rows of a kind than an ItemVariationData holds. */
static void rows_go_on_in_another_subtable(void **state) {
    (void)state;
    enum { ROWS = 70000 };
    mt_var_store store = even_store(2);
    uint32_t indices[2] = {0, 0};
    for (int i = 0; i < ROWS; i++) indices[i == ROWS - 1] = add(&store, (int32_t[]){0, 40000 + i});
    assert_int_equal(store.data_count, 2);
    assert_int_equal(indices[1] >> 16, 1);
    assert_int_equal(store.data[0].count, 0xFFFF);
    mt_bytes gdef = gdef_of(&store);
    assert_near(delta_at(gdef, indices[0], 1), 40000 + ROWS - 2, 0);
    assert_near(delta_at(gdef, indices[1], 1), 40000 + ROWS - 1, 0);
    mt_var_store_free(&store);
}

static void most_stops_that_can_be(void **state) {
    (void)state;
    mt_var_store store = even_store(MT_STOPS_MAX);
    int32_t values[MT_STOPS_MAX] = {0};
    for (int i = 0; i < MT_STOPS_MAX; i++) values[i] = i * i;
    uint32_t index = add(&store, values);
    mt_bytes gdef = gdef_of(&store);
    for (int i = 0; i < MT_STOPS_MAX; i++) /* within 2.14 */
        assert_near(delta_at(gdef, index, i / (MT_STOPS_MAX - 1.0)), values[i], 1);
    mt_var_store_free(&store);
}

/* ---- maps ---------------------------------------------------------------------------------------------- */

/* The entry of a thing as a reader finds it. */
static uint32_t look_up(const mt_table *map, int thing) {
    int size = (map->bytes[1] >> 4 & 3) + 1, inner_bits = (map->bytes[1] & 15) + 1;
    int count = map->bytes[2] << 8 | map->bytes[3];
    const uint8_t *entry = map->bytes + 4 + size * (thing < count ? thing : count - 1);
    uint32_t value = 0;
    for (int i = 0; i < size; i++) value = value << 8 | entry[i];
    return value >> inner_bits << 16 | (value & ((1u << inner_bits) - 1));
}

static void maps_lead_to_their_rows(void **state) {
    (void)state;
    static const struct {
        uint32_t indices[4];
        int count;
        size_t length;
    } cases[] = {
        {{0, 0, 0, 0}, 4, 4 + 1},
        {{3, 0x10002, 1, 1}, 4, 4 + 3},
        {{0x1FFFE, 0, 5, 0x10000}, 4, 4 + 4 * 3},
        {{0x12345678, 1, 2, 3}, 4, 4 + 4 * 4},
        {{200, 100, 0x10000, 9}, 4, 4 + 4 * 2},
        {{255}, 1, 4 + 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mt_table map = {0};
        mt_table_index_map(&map, cases[i].indices, cases[i].count);
        assert_int_equal(map.bytes[0], 0);
        assert_int_equal(map.length, cases[i].length);
        for (int k = 0; k < cases[i].count; k++) assert_int_equal(look_up(&map, k), cases[i].indices[k]);
        mt_table_free(&map);
    }
}

/* ---- memory -------------------------------------------------------------------------------------------- */

static mt_status fill(mt_var_store *store, mt_table *table) {
    mt_status status = MT_OK;
    for (int32_t i = 0; i < 400 && status == MT_OK; i++) {
        uint32_t index;
        int32_t values[] = {0, i % 7 * i, i % 3 * 200 * i};
        status = mt_var_store_add(store, values, &index);
    }
    if (status == MT_OK) status = mt_var_store_write(store, table);
    return status == MT_OK && table->failed ? MT_NO_MEMORY : status;
}

static void no_memory_is_told(void **state) {
    (void)state;
    bool failed = true;
    for (long first = 0; failed; first++) {
        mt_allocation_watch();
        mt_var_store store = even_store(3);
        mt_table table = {0};
        mt_allocation_fail(first, false);
        mt_status status = fill(&store, &table);
        failed = mt_allocation_requests() > first;
        mt_allocation_succeed();
        mt_table_free(&table);
        mt_var_store_free(&store);
        assert_int_equal(mt_allocation_live(), 0);
        mt_allocation_unwatch();
        assert_int_equal(status, failed ? MT_NO_MEMORY : MT_OK);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_read_back),
        cmocka_unit_test(rows_that_differ_by_a_constant_are_one),
        cmocka_unit_test(what_does_not_vary_needs_no_row),
        cmocka_unit_test(deltas_take_what_they_need),
        cmocka_unit_test(rows_go_on_in_another_subtable),
        cmocka_unit_test(most_stops_that_can_be),
        cmocka_unit_test(maps_lead_to_their_rows),
        cmocka_unit_test(no_memory_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
