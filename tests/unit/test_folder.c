#include "base/folder.h"
#include "base/tree.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"

#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define MARK "mark"

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

static void assert_holds(const char *path, const char *text) {
    size_t length;
    uint8_t *bytes = mt_sample_load(&arena, path, &length);
    assert_int_equal(length, strlen(text));
    assert_memory_equal(bytes, text, length);
}

static bool stands(const char *path) {
    struct stat about;
    return lstat(path, &about) == 0;
}

/* A folder with its mark, `text` in it, and `text` below it. */
static mt_status fill(const char *path, const char *text, mt_folder *folder) {
    mt_status status = mt_folder_begin(path, folder);
    if (status != MT_OK) return status;
    status = mt_folder_add_file(folder, MARK, text, strlen(text));
    if (status == MT_OK) status = mt_folder_add_folder(folder, "below");
    if (status == MT_OK) status = mt_folder_add_file(folder, "below/text", text, strlen(text));
    return status;
}

static mt_status make(const char *path, const char *text) {
    mt_folder folder = {0};
    mt_status status = fill(path, text, &folder);
    if (status == MT_OK) status = mt_folder_place(&folder, MARK);
    int why = errno;
    mt_folder_free(&folder);
    errno = why;
    return status;
}

static void appears_whole(void **state) {
    (void)state;
    const char *path = path_of("whole");
    mt_folder folder;
    mt_assert_ok(fill(path, "text", &folder));
    assert_false(stands(path));
    assert_int_equal(mt_sample_count(directory), 1);
    assert_int_equal(folder.length, 8);
    mt_assert_ok(mt_folder_place(&folder, MARK));
    mt_folder_free(&folder);
    assert_holds(path_of("whole/below/text"), "text");
    assert_int_equal(mt_sample_count(directory), 1);
    mt_tree_remove(path);
}

static void goes_when_it_is_given_up(void **state) {
    (void)state;
    mt_folder folder;
    mt_assert_ok(fill(path_of("given-up"), "text", &folder));
    mt_folder_free(&folder);
    assert_int_equal(mt_sample_count(directory), 0);
}

static void replaces_its_own_kind(void **state) {
    (void)state;
    const char *path = path_of("again");
    mt_assert_ok(make(path, "first"));
    mt_sample_save(path_of("again/below/more"), "more", 4);
    mt_assert_ok(make(path, "second"));
    assert_holds(path_of("again/below/text"), "second");
    assert_false(stands(path_of("again/below/more")));
    assert_int_equal(mt_sample_count(directory), 1);
    mt_tree_remove(path);
}

static void replaces_nothing_else(void **state) {
    (void)state;
    const char *path = path_of("other");
    assert_int_equal(mkdir(path, 0777), 0);
    mt_sample_save(path_of("other/work"), "work", 4);
    assert_int_equal(mt_folder_check(path, MARK), MT_CANNOT_WRITE);
    assert_int_equal(make(path, "text"), MT_CANNOT_WRITE);
    assert_int_equal(errno, EEXIST);
    assert_holds(path_of("other/work"), "work");
    mt_tree_remove(path);
    mt_sample_save(path, "file", 4);
    assert_int_equal(make(path, "text"), MT_CANNOT_WRITE);
    assert_holds(path, "file");
    assert_int_equal(mt_sample_count(directory), 1);
    assert_int_equal(unlink(path), 0);
}

static void leaves_what_a_link_leads_to(void **state) {
    (void)state;
    const char *path = path_of("link"), *target = path_of("target");
    mt_assert_ok(make(target, "target"));
    assert_int_equal(symlink("target", path), 0);
    mt_assert_ok(make(path, "text"));
    assert_holds(path_of("link/" MARK), "text");
    assert_holds(path_of("target/" MARK), "target");
    assert_int_equal(mt_sample_count(directory), 2);
    assert_int_equal(symlink("../target", path_of("link/below/up")), 0);
    mt_tree_remove(path);
    assert_holds(path_of("target/" MARK), "target");
    mt_tree_remove(target);
}

static void leaves_nothing_when_it_cannot_write(void **state) {
    (void)state;
    assert_int_equal(make(path_of("missing/folder"), "text"), MT_CANNOT_WRITE);
    assert_int_equal(errno, ENOENT);
    mt_folder folder;
    mt_assert_ok(fill(path_of("twice"), "text", &folder));
    assert_int_equal(mt_folder_add_file(&folder, MARK, "text", 4), MT_CANNOT_WRITE);
    assert_int_equal(errno, EEXIST);
    assert_int_equal(mt_folder_add_folder(&folder, "below"), MT_CANNOT_WRITE);
    assert_int_equal(mt_folder_add_file(&folder, "nowhere/file", "text", 4), MT_CANNOT_WRITE);
    mt_folder_free(&folder);
    assert_int_equal(mt_sample_count(directory), 0);
}

static void survives_want_of_memory(void **state) {
    (void)state;
    const char *path = path_of("memory");
    mt_assert_ok(make(path, "before"));
    mt_status status = MT_NO_MEMORY;
    for (long first = 0; status == MT_NO_MEMORY; first++) {
        mt_allocation_watch();
        mt_allocation_fail(first, false);
        status = make(path, "after");
        mt_allocation_succeed();
        long live = mt_allocation_live();
        mt_allocation_unwatch();
        assert_int_equal(live, 0);
        assert_int_equal(mt_sample_count(directory), 1);
        if (status != MT_OK) assert_holds(path_of("memory/below/text"), "before");
    }
    mt_assert_ok(status);
    assert_holds(path_of("memory/below/text"), "after");
    mt_tree_remove(path);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(appears_whole),
        cmocka_unit_test(goes_when_it_is_given_up),
        cmocka_unit_test(replaces_its_own_kind),
        cmocka_unit_test(replaces_nothing_else),
        cmocka_unit_test(leaves_what_a_link_leads_to),
        cmocka_unit_test(leaves_nothing_when_it_cannot_write),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, tear_down);
}
