/* The public variable font: what it takes, what it writes where, and want of memory. */
#include <math.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/folder.h"
#include "base/tree.h"
#include "save/save.h"
#include "sfnt/axis.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/fonts.h"
#include "support/sample.h"

enum { FONTS = 3 };

typedef struct font_row {
    mt_font *fonts[FONTS];
    mt_variable *variable;
} font_row;

static const uint32_t letters[] = {'A', 'g', 0xE9};

static mt_status open_row(font_row *row) {
    static const char *const paths[] = {MT_TEST_SANS, MT_TEST_SERIF, MT_TEST_SANS};
    mt_params params = mt_params_default();
    mt_status status = MT_OK;
    params.threads = 1;
    *row = (font_row){0};
    for (int i = 0; i < FONTS && status == MT_OK; i++) status = mt_font_open(paths[i], &row->fonts[i]);
    if (status == MT_OK) status = mt_variable_new(row->fonts, FONTS, &params, &row->variable);
    return status == MT_OK ? mt_variable_set_chars(row->variable, letters, 3) : status;
}

static void close_row(font_row *row) {
    mt_variable_free(row->variable);
    for (int i = 0; i < FONTS; i++) mt_font_close(row->fonts[i]);
}

/* Skips the test where the fonts are not installed. */
static font_row open_test_row(void) {
    font_row row;
    mt_font_close(mt_test_font(MT_TEST_SANS));
    mt_font_close(mt_test_font(MT_TEST_SERIF));
    mt_assert_ok(open_row(&row));
    return row;
}

/* Each test leaves the directory empty. */
static int tear_down(void **state) {
    (void)state;
    assert_int_equal(rmdir(directory), 0);
    mt_arena_release(&arena);
    return 0;
}

static const char *path_of(const char *name) {
    return mt_sample_path(&arena, directory, name);
}

static void numbers_of_fonts_are_checked(void **state) {
    (void)state;
    mt_font *fonts[MT_VARIABLE_FONTS_MAX + 1] = {0};
    mt_variable *variable;
    mt_params params = mt_params_default();
    assert_int_equal(mt_variable_new(fonts, 1, &params, &variable), MT_BAD_PARAMETER);
    assert_int_equal(mt_variable_new(fonts, MT_VARIABLE_FONTS_MAX + 1, &params, &variable), MT_BAD_PARAMETER);
    params.fit = -1;
    assert_int_equal(mt_variable_new(fonts, 2, &params, &variable), MT_BAD_PARAMETER);
}

/* A map that is refused leaves the one before. */
static void maps_are_checked(void **state) {
    (void)state;
    static const double values[] = {25, 50}, places[] = {10, 40}, falling[] = {40, 10};
    font_row row = open_test_row();
    uint8_t *bytes;
    size_t length, table_length;
    mt_assert_ok(mt_variable_set_map(row.variable, values, places, 2));
    assert_int_equal(mt_variable_set_map(row.variable, values, falling, 2), MT_BAD_PARAMETER);
    assert_int_equal(mt_variable_set_map(row.variable, values, places, -1), MT_BAD_PARAMETER);
    mt_assert_ok(mt_variable_font(row.variable, &bytes, &length));
    const uint8_t *avar = mt_sample_table(bytes, "avar", &table_length);
    assert_non_null(avar);
    assert_int_equal(table_length, 10 + 4 * 5);
    assert_int_equal(mt_read_u16(avar + 8), 5);
    assert_int_equal(mt_read_u16(avar + 22), MT_PLACE_ONE / 2); /* 50 … */
    assert_int_equal(mt_read_u16(avar + 24), 6554);             /* … to 40 */
    mt_bytes_free(bytes);
    mt_assert_ok(mt_variable_set_map(row.variable, NULL, NULL, 0));
    mt_assert_ok(mt_variable_font(row.variable, &bytes, &length));
    assert_null(mt_sample_table(bytes, "avar", &table_length));
    mt_bytes_free(bytes);
    close_row(&row);
}

/* Stops that are refused leave the axis as it was. */
static void stops_are_checked(void **state) {
    (void)state;
    static const double good[] = {100, 400, 900}, same[] = {100, 400, 400}, falling[] = {400, 100, 900},
                        out[] = {0, 400, 900}, none[] = {100, NAN, 900}, near[] = {100, 899.9999, 900},
                        map[] = {50};
    static const double *const bad[] = {same, falling, out, none, near};
    font_row row = open_test_row();
    uint8_t *bytes;
    size_t length, table_length;
    mt_assert_ok(mt_variable_set_stops(row.variable, "wght", good));
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_int_equal(mt_variable_set_stops(row.variable, "wght", bad[i]), MT_BAD_PARAMETER);
    assert_int_equal(mt_variable_set_stops(row.variable, "weight", good), MT_BAD_PARAMETER);
    assert_int_equal(mt_variable_set_stops(row.variable, "foob", good), MT_BAD_PARAMETER);
    assert_int_equal(mt_variable_set_map(row.variable, map, map, 1), MT_BAD_PARAMETER);
    mt_assert_ok(mt_variable_font(row.variable, &bytes, &length));
    const uint8_t *fvar = mt_sample_table(bytes, "fvar", &table_length);
    assert_non_null(fvar);
    const int axis[] = {100, 400, 900};
    for (int i = 0; i < 3; i++) assert_int_equal(mt_read_u16(fvar + 20 + 4 * i), axis[i]);
    mt_bytes_free(bytes);
    mt_assert_ok(mt_variable_set_axis(row.variable, "wght", 400, 900));
    mt_assert_ok(mt_variable_set_map(row.variable, map, map, 1));
    assert_int_equal(mt_variable_set_stops(row.variable, "wght", good), MT_BAD_PARAMETER);
    close_row(&row);
}

/* Every so many requests fail in turn. */
static void families_survive_want_of_memory(void **state) {
    (void)state;
    static const double stops[] = {100, 400, 900};
    mt_status status = MT_NO_MEMORY;
    font_row row = open_test_row();
    close_row(&row);
    for (long first = 0; status == MT_NO_MEMORY; first += first < 8 ? 1 : 83) {
        uint8_t *bytes = NULL;
        size_t length;
        mt_allocation_watch();
        mt_assert_ok(open_row(&row));
        mt_allocation_fail(first, false);
        status = mt_variable_set_stops(row.variable, "wght", stops);
        if (status == MT_OK) status = mt_variable_font(row.variable, &bytes, &length);
        mt_allocation_succeed();
        mt_bytes_free(bytes);
        close_row(&row);
        long live = mt_allocation_live();
        mt_allocation_unwatch();
        assert_int_equal(live, 0);
    }
    mt_assert_ok(status);
}

static void remember(int done, int all, void *user) {
    int *last = user;
    assert_true(done >= last[0] && done <= all);
    last[0] = done;
    last[1] = all;
}

static void progress_goes_through_all_steps(void **state) {
    (void)state;
    font_row row = open_test_row();
    int last[2] = {0, 0};
    uint8_t *bytes;
    size_t length;
    mt_variable_on_progress(row.variable, remember, last);
    mt_assert_ok(mt_variable_font(row.variable, &bytes, &length));
    assert_true(last[1] > 0 && last[0] == last[1]);
    mt_bytes_free(bytes);
    close_row(&row);
}

/* The document and the folder of its masters come together; a blend has none, and a UFO does not vary. */
static void format_is_by_extension(void **state) {
    (void)state;
    font_row row = open_test_row();
    struct stat about;
    mt_assert_ok(mt_variable_save(row.variable, path_of("x.ttf")));
    mt_assert_ok(mt_variable_save(row.variable, path_of("x.designspace")));
    assert_int_equal(mt_sample_count(directory), 3);
    assert_int_equal(stat(path_of("x-masters/Morph-0.ufo/metainfo.plist"), &about), 0);
    assert_int_equal(stat(path_of("x-masters/Morph-100.ufo/metainfo.plist"), &about), 0);
    assert_int_equal(unlink(path_of("x.ttf")), 0);
    assert_int_equal(unlink(path_of("x.designspace")), 0);
    mt_tree_remove(path_of("x-masters"));
    assert_int_equal(mt_variable_save(row.variable, path_of("x.ufo")), MT_UNKNOWN_FORMAT);
    mt_blend *blend;
    mt_params params = mt_params_default();
    mt_assert_ok(mt_blend_new(row.fonts[0], row.fonts[1], &params, &blend));
    assert_int_equal(mt_blend_save(blend, 0.5, path_of("x.designspace")), MT_UNKNOWN_FORMAT);
    mt_blend_free(blend);
    assert_int_equal(mt_sample_count(directory), 0);
    close_row(&row);
}

/* Where the document cannot stand, its masters do not either. */
static void a_document_that_cannot_stand_leaves_nothing(void **state) {
    (void)state;
    font_row row = open_test_row();
    assert_int_equal(mkdir(path_of("x.designspace"), 0777), 0);
    assert_int_equal(mt_variable_save(row.variable, path_of("x.designspace")), MT_CANNOT_WRITE);
    assert_int_equal(mt_sample_count(directory), 1);
    assert_int_equal(rmdir(path_of("x.designspace")), 0);
    close_row(&row);
}

/* Every so many requests fail in turn: the whole is long. */
static void survives_want_of_memory(void **state) {
    (void)state;
    static const char *const names[] = {"x.ttf", "x.designspace"};
    static const double map[] = {30, 60};
    font_row row = open_test_row();
    close_row(&row);
    for (size_t i = 0; i < 2; i++) {
        const char *path = path_of(names[i]);
        mt_status status = MT_NO_MEMORY;
        for (long first = 0; status == MT_NO_MEMORY; first += 41) {
            mt_allocation_watch();
            mt_assert_ok(open_row(&row));
            mt_assert_ok(mt_variable_set_map(row.variable, map, map, 2));
            mt_assert_ok(mt_variable_set_map(row.variable, map, map, 1));
            mt_allocation_fail(first, false);
            status = mt_variable_save(row.variable, path);
            mt_allocation_succeed();
            close_row(&row);
            long live = mt_allocation_live();
            mt_allocation_unwatch();
            assert_int_equal(live, 0);
            if (status != MT_OK) assert_int_equal(mt_sample_count(directory), 0);
        }
        mt_assert_ok(status);
        unlink(path);
        mt_tree_remove(path_of("x-masters"));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(numbers_of_fonts_are_checked),
        cmocka_unit_test(maps_are_checked),
        cmocka_unit_test(stops_are_checked),
        cmocka_unit_test(families_survive_want_of_memory),
        cmocka_unit_test(progress_goes_through_all_steps),
        cmocka_unit_test(format_is_by_extension),
        cmocka_unit_test(a_document_that_cannot_stand_leaves_nothing),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, tear_down);
}
