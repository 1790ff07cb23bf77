#include "save/save.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/fonts.h"
#include "support/sample.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/folder.h"
#include "base/tree.h"

typedef struct font_pair {
    mt_font *a, *b;
    mt_blend *blend;
} font_pair;

static const uint32_t letters[] = {'A', 'g'};

static mt_status open_pair(font_pair *pair) {
    mt_params params = mt_params_default();
    params.threads = 1;
    *pair = (font_pair){0};
    mt_status status = mt_font_open(MT_TEST_SANS, &pair->a);
    if (status == MT_OK) status = mt_font_open(MT_TEST_SERIF, &pair->b);
    if (status == MT_OK) status = mt_blend_new(pair->a, pair->b, &params, &pair->blend);
    if (status == MT_OK) status = mt_blend_set_chars(pair->blend, letters, 2);
    return status;
}

static void close_pair(font_pair *pair) {
    mt_blend_free(pair->blend);
    mt_font_close(pair->a);
    mt_font_close(pair->b);
}

/* Skips the test where the fonts are not installed. */
static font_pair open_test_pair(void) {
    font_pair made;
    mt_font_close(mt_test_font(MT_TEST_SANS));
    mt_font_close(mt_test_font(MT_TEST_SERIF));
    mt_assert_ok(open_pair(&made));
    return made;
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

static void assert_starts(const char *path, const char *bytes) {
    size_t length;
    uint8_t *all = mt_sample_load(&arena, path, &length);
    assert_true(length > 4);
    assert_memory_equal(all, bytes, 4);
}

static void format_is_by_extension(void **state) {
    (void)state;
    font_pair pair = open_test_pair();
    mt_assert_ok(mt_blend_save(pair.blend, 0.5, path_of("x.ttf")));
    mt_assert_ok(mt_blend_save(pair.blend, 0.5, path_of("x.WOFF2")));
    mt_assert_ok(mt_blend_save(pair.blend, 0.5, path_of("x.ufo")));
    assert_starts(path_of("x.ttf"), "\0\1\0");
    assert_starts(path_of("x.WOFF2"), "wOF2");
    assert_starts(path_of("x.ufo/metainfo.plist"), "<?xm");
    assert_int_equal(unlink(path_of("x.ttf")), 0);
    assert_int_equal(unlink(path_of("x.WOFF2")), 0);
    mt_tree_remove(path_of("x.ufo"));
    static const char *const others[] = {"x.otf", "x", "x.ttf.gz", "ufo", ""};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        assert_int_equal(mt_blend_save(pair.blend, 0.5, path_of(others[i])), MT_UNKNOWN_FORMAT);
    assert_int_equal(mt_sample_count(directory), 0);
    close_pair(&pair);
}

static void all_are_saved_or_none(void **state) {
    (void)state;
    static const double t[] = {0.25, 0.5, 0.75};
    font_pair pair = open_test_pair();
    const char *paths[] = {path_of("1.ttf"), path_of("2.ufo"), path_of("3.woff2")};
    mt_assert_ok(mt_blend_save_fonts(pair.blend, t, 3, paths));
    assert_int_equal(mt_sample_count(directory), 3);
    assert_int_equal(unlink(paths[0]), 0);
    mt_tree_remove(paths[1]);
    assert_int_equal(unlink(paths[2]), 0);
    paths[2] = path_of("missing/3.woff2"); /* is found out when the others have their places */
    assert_int_equal(mt_blend_save_fonts(pair.blend, t, 3, paths), MT_CANNOT_WRITE);
    assert_int_equal(errno, ENOENT);
    assert_int_equal(mt_sample_count(directory), 0);
    assert_int_equal(mkdir(paths[1], 0777), 0);
    paths[2] = path_of("3.ttf");
    assert_int_equal(mt_blend_save_fonts(pair.blend, t, 3, paths), MT_CANNOT_WRITE);
    assert_int_equal(mt_sample_count(directory), 1);
    assert_int_equal(rmdir(paths[1]), 0);
    close_pair(&pair);
}

static mt_status refuse(void *user) {
    *(int *)user = mt_sample_count(directory);
    return MT_NO_GLYPH;
}

static void nothing_is_in_its_place_before_all_are_made(void **state) {
    (void)state;
    static const double t[] = {0, 1};
    font_pair pair = open_test_pair();
    int entries = -1, failed = 7;
    const char *paths[] = {path_of("1.ttf"), path_of("2.ufo")};
    const mt_saving saving = {.t = t, .count = 2, .paths = paths, .made = refuse, .user = &entries};
    assert_int_equal(mt_blend_save_when(pair.blend, &saving, &failed), MT_NO_GLYPH);
    assert_int_equal(entries, 1); /* the UFO under its other name */
    assert_int_equal(failed, -1);
    assert_int_equal(mt_sample_count(directory), 0);
    close_pair(&pair);
}

/* Every seventh request fails in turn: the whole is long. */
static void survives_want_of_memory(void **state) {
    (void)state;
    font_pair pair = open_test_pair();
    close_pair(&pair);
    static const char *const names[] = {"x.ufo", "x.woff2"};
    for (size_t i = 0; i < 2; i++) {
        const char *path = path_of(names[i]);
        mt_status status = MT_NO_MEMORY;
        for (long first = 0; status == MT_NO_MEMORY; first += 7) {
            mt_allocation_watch();
            status = open_pair(&pair);
            mt_assert_ok(status);
            mt_allocation_fail(first, false);
            status = mt_blend_save(pair.blend, 0.5, path);
            mt_allocation_succeed();
            close_pair(&pair);
            long live = mt_allocation_live();
            mt_allocation_unwatch();
            assert_int_equal(live, 0);
            if (status != MT_OK) assert_int_equal(mt_sample_count(directory), 0);
        }
        mt_assert_ok(status);
        mt_tree_remove(path);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(format_is_by_extension),
        cmocka_unit_test(all_are_saved_or_none),
        cmocka_unit_test(nothing_is_in_its_place_before_all_are_made),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, tear_down);
}
