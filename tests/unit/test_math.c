/* MATH of fonts made for the test: read, mixed, and written; damaged tables; each allocation failed in turn. */
#include "layout/lookup_builder.h"
#include "math/math.h"
#include "math/table/open.h"
#include "support/allocation.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"

#include <string.h>

enum { FIRST = 0xE000, GLYPHS = 6, MATH = MT_TAG('M', 'A', 'T', 'H') };

/* ---- sources ------------------------------------------------------------------------------------------- */

static void words(mt_table *table, const int *values, size_t count) {
    for (size_t i = 0; i < count; i++) mt_table_16(table, values[i]);
}

#define WORDS(table, ...)                                                                                    \
    words(table, (const int[]){__VA_ARGS__}, sizeof((const int[]){__VA_ARGS__}) / sizeof(int))

/* Constant i is i times `by`, but for percentages, which are `percent`. */
static void add_constants(mt_table *table, int by, int percent) {
    for (int i = 0; i < MT_MATH_CONSTANTS; i++) {
        bool plain = i < MT_MATH_FIRST_VALUE || i == MT_MATH_LAST_PERCENT;
        bool is_percent = plain && i != MT_MATH_PERCENTS && i != MT_MATH_PERCENTS + 1;
        mt_table_16(table, is_percent ? percent : i * by);
        if (!plain) mt_table_16(table, 0);
    }
}

/* Corrections of glyphs 1 and 2; an accent on glyph 1; glyph 3 grows; a kern at the second corner of glyph 1, of `heights`. */
static void add_info(mt_table *table, int by, int heights) {
    WORDS(table, 8, 28, 42, 48);
    WORDS(table, 12, 2, 10 * by, 0, 20 * by, 0, 1, 2, 1, 2);
    WORDS(table, 8, 1, 30 * by, 0, 1, 1, 1);
    WORDS(table, 1, 1, 3);
    WORDS(table, 12, 1, 0, 18, 0, 0, 1, 1, 1);
    mt_table_16(table, heights);
    for (int i = 0; i < 2 * heights + 1; i++) WORDS(table, (i + 1) * by, 0);
}

/* Glyph 1 grows upwards: itself, glyph 4, and glyphs 5 and 6, of which the second repeats. */
static void add_variants(mt_table *table, int by) {
    WORDS(table, 2 * by, 12, 0, 1, 0, 18, 1, 1, 1);
    WORDS(table, 12, 2, 1, 100 * by, 4, 200 * by);
    WORDS(table, 5 * by, 0, 2, 5, 0, 40 * by, 90 * by, 0, 6, 50 * by, 60 * by, 70 * by, 1);
}

static mt_bytes math_of(int by, int percent, int heights) {
    enum { HEADER = 10, CONSTANTS = 214 };
    mt_table table = {0}, info = {0};
    mt_bytes bytes;
    add_info(&info, by, heights);
    WORDS(&table, 1, 0, HEADER, HEADER + CONSTANTS, (int)(HEADER + CONSTANTS + info.length));
    add_constants(&table, by, percent);
    mt_table_bytes(&table, info.bytes, info.length);
    add_variants(&table, by);
    mt_table_free(&info);
    mt_assert_ok(mt_table_keep(&table, &arena, &bytes));
    return bytes;
}

static mt_font *font_with(const char *name, int units, mt_bytes math) {
    mt_font *font;
    char *path = mt_sample_path(&arena, directory, name);
    mt_test_save_blank(path, units, FIRST, GLYPHS, MATH, math, &arena);
    mt_assert_ok(mt_font_open(path, &font));
    return font;
}

/* The table of that many bytes, read. */
static mt_math_table read_back(mt_bytes bytes) {
    mt_math_table read;
    mt_font *font = font_with("read.ttf", 1000, bytes);
    mt_assert_ok(mt_math_table_open(font, &arena, &read));
    mt_font_close(font);
    return read;
}

static mt_status blend(mt_font *a, mt_font *b, const mt_places *places, mt_arena *made, mt_bytes *bytes) {
    mt_charset charset;
    mt_font_glyphs glyphs;
    mt_math *math;
    int units =
        mt_font_units_per_em(a) > mt_font_units_per_em(b) ? mt_font_units_per_em(a) : mt_font_units_per_em(b);
    mt_status status = mt_charset_make(a, b, &(mt_charset_request){0}, made, &charset);
    if (status == MT_OK) status = mt_test_font_glyphs(&charset, 2, made, &glyphs);
    if (status == MT_OK) status = mt_math_prepare((mt_font *[]){a, b}, &glyphs, units, made, &math);
    return status == MT_OK ? mt_math_write(math, places, made, bytes) : status;
}

/* The table of a blend at t, read. */
static mt_math_table blend_of(mt_bytes in_a, int units_a, mt_bytes in_b, int units_b, double t) {
    const mt_font_at place = mt_font_at_t(t);
    const mt_places places = mt_places_of_one(&place, 2);
    mt_bytes bytes;
    mt_font *a = font_with("a.ttf", units_a, in_a), *b = font_with("b.ttf", units_b, in_b);
    mt_assert_ok(blend(a, b, &places, &arena, &bytes));
    mt_font_close(a);
    mt_font_close(b);
    return read_back(bytes);
}

/* ---- what is read -------------------------------------------------------------------------------------- */

static void everything_is_read(void **state) {
    (void)state;
    mt_math_table read = read_back(math_of(3, 70, 2));
    assert_int_equal(read.state, MT_MATH_WHOLE);
    assert_true(read.has_constants);
    for (int i = 0; i < MT_MATH_CONSTANTS; i++)
        assert_int_equal((int)read.constants[i], i < 2 || i == MT_MATH_LAST_PERCENT ? 70 : 3 * i);
    assert_int_equal((int)mt_math_value_find(&read.italics, 2)->value, 60);
    assert_int_equal((int)mt_math_value_find(&read.accents, 1)->value, 90);
    assert_null(mt_math_value_find(&read.accents, 2));
    assert_non_null(mt_math_value_find(&read.extended, 3));
    const mt_math_kern *kern = &mt_math_kerns_find(&read.kerns, 1)->corners[1];
    assert_int_equal(kern->count, 2);
    assert_int_equal((int)kern->heights[1], 6);
    assert_int_equal((int)kern->kerns[2], 15);
    assert_int_equal((int)read.least_overlap, 6);
    assert_int_equal(read.constructions[MT_MATH_HORIZONTAL].count, 0);
    const mt_math_construction *own = mt_math_construction_find(&read.constructions[MT_MATH_VERTICAL], 1);
    assert_int_equal(own->variant_count, 2);
    assert_int_equal((int)own->variants[1].measure, 600);
    assert_int_equal(own->part_count, 2);
    assert_int_equal((int)own->italics, 15);
    assert_int_equal((int)own->parts[1].full, 210);
    assert_int_equal(own->parts[1].flags, 1);
}

static void no_table_is_none(void **state) {
    (void)state;
    assert_int_equal(read_back((mt_bytes){0}).state, MT_MATH_NONE);
}

/* Cut short anywhere: what is not whole is damaged, and empty. */
static void cut_short(void **state) {
    (void)state;
    mt_bytes whole = math_of(3, 70, 2);
    for (size_t length = 1; length < whole.length; length++) {
        mt_math_table read = read_back((mt_bytes){whole.bytes, length});
        assert_int_equal(read.state, MT_MATH_DAMAGED);
        assert_int_equal(read.constructions[0].count, 0);
    }
}

/* Every 16 bits become large, or an offset back to the start: nothing is read out of bounds, and what is made of it is whole. */
static void changed_anywhere(void **state) {
    (void)state;
    static const int values[] = {0xFFFF, 0x7FFF, 0, 1, 4, 200};
    mt_bytes whole = math_of(3, 70, 2);
    uint8_t *bytes = mt_test_new(whole.length, 1);
    int damaged = 0;
    for (size_t at = 0; at + 2 <= whole.length; at += 2)
        for (size_t k = 0; k < sizeof values / sizeof *values; k++) {
            memcpy(bytes, whole.bytes, whole.length);
            bytes[at] = (uint8_t)(values[k] >> 8);
            bytes[at + 1] = (uint8_t)values[k];
            mt_bytes changed = {bytes, whole.length};
            mt_math_table read = read_back(changed), made = blend_of(changed, 1000, whole, 1000, 0.5);
            damaged += read.state == MT_MATH_DAMAGED;
            assert_int_equal(made.state, read.state == MT_MATH_WHOLE ? MT_MATH_WHOLE : MT_MATH_NONE);
        }
    assert_in_range(damaged, 20, 1000);
    free(bytes);
}

/* ---- mixing -------------------------------------------------------------------------------------------- */

static void values_are_mixed_in_the_new_units(void **state) {
    (void)state;
    mt_bytes in_a = math_of(2, 60, 2), in_b = math_of(8, 80, 2);
    for (int i = 0; i <= 2; i++) {
        double t = i / 2.0, by = (1 - t) * 4 + t * 8; /* 2 of 1000 are 4 of 2000 */
        mt_math_table read = blend_of(in_a, 1000, in_b, 2000, t);
        assert_int_equal((int)read.constants[0], (int)(60 + 20 * t));
        assert_int_equal((int)read.constants[MT_MATH_LAST_PERCENT], (int)(60 + 20 * t));
        for (int k = 2; k < MT_MATH_LAST_PERCENT; k++)
            assert_int_equal((int)read.constants[k], (int)(by * k));
        assert_int_equal((int)mt_math_value_find(&read.italics, 2)->value, (int)(20 * by));
        assert_int_equal((int)mt_math_value_find(&read.accents, 1)->value, (int)(30 * by));
        assert_int_equal((int)read.kerns.list[0].corners[1].kerns[2], (int)(5 * by));
        const mt_math_construction *own = &read.constructions[MT_MATH_VERTICAL].list[0];
        assert_int_equal((int)own->variants[1].measure, (int)(200 * by));
        assert_int_equal((int)own->parts[1].start, (int)(50 * by));
    }
}

/* Kerns of another number of heights, and a font without a table. */
static void the_first_stands_for_what_is_not_there(void **state) {
    (void)state;
    mt_bytes in_a = math_of(2, 60, 2);
    mt_math_table read = blend_of(in_a, 1000, math_of(8, 80, 3), 1000, 1);
    assert_int_equal(read.kerns.list[0].corners[1].count, 2);
    assert_int_equal((int)read.kerns.list[0].corners[1].heights[1], 4);
    assert_int_equal((int)read.constants[10], 80);
    read = blend_of(in_a, 1000, (mt_bytes){0}, 2000, 1);
    assert_int_equal((int)read.constants[10], 40);
    assert_int_equal((int)read.constants[0], 60);
    assert_int_equal((int)read.constructions[MT_MATH_VERTICAL].list[0].variants[1].measure, 800);
    assert_int_equal(blend_of((mt_bytes){0}, 1000, in_a, 1000, 0).state, MT_MATH_NONE);
}

/* ---- memory -------------------------------------------------------------------------------------------- */

/* Request `first` fails, and with `all_after` all later ones. Whether there was such a request. */
static bool run_failing(long first, bool all_after) {
    mt_font *a, *b;
    mt_at at[MT_STOPS_MAX];
    mt_arena made = {0};
    mt_bytes bytes;
    char *path_a = mt_sample_path(&arena, directory, "a.ttf"),
         *path_b = mt_sample_path(&arena, directory, "b.ttf");
    mt_allocation_watch();
    mt_assert_ok(mt_font_open(path_a, &a));
    mt_assert_ok(mt_font_open(path_b, &b));
    const mt_stops stops = mt_stops_even(2);
    mt_var_store store = mt_var_store_make(&stops);
    mt_places places = mt_places_of_fonts(at, &store);
    long before = mt_allocation_requests();
    mt_allocation_fail(first, all_after);
    mt_status status = blend(a, b, &places, &made, &bytes);
    bool failed = mt_allocation_requests() - before > first;
    mt_allocation_succeed();
    mt_var_store_free(&store);
    mt_arena_release(&made);
    mt_font_close(a);
    mt_font_close(b);
    long live = mt_allocation_live();
    mt_allocation_unwatch();
    if (status != (failed ? MT_NO_MEMORY : MT_OK)) fail_msg("request %ld: %s", first, mt_status_text(status));
    if (live != 0) fail_msg("request %ld: %ld blocks left", first, live);
    return failed;
}

static void each_request_may_fail(void **state) {
    (void)state;
    long first = 0;
    mt_font_close(font_with("a.ttf", 1000, math_of(2, 60, 2)));
    mt_font_close(font_with("b.ttf", 1000, math_of(8, 80, 2)));
    for (; run_failing(first, true); first++) run_failing(first, false);
    assert_true(first > 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_is_read),
        cmocka_unit_test(no_table_is_none),
        cmocka_unit_test(cut_short),
        cmocka_unit_test(changed_anywhere),
        cmocka_unit_test(values_are_mixed_in_the_new_units),
        cmocka_unit_test(the_first_stands_for_what_is_not_there),
        cmocka_unit_test(each_request_may_fail),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
