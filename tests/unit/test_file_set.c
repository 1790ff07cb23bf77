#include "base/file_set.h"
#include "base/tree.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Each test leaves the directory empty. */
static int tear_down(void **state) {
    (void)state;
    assert_int_equal(rmdir(directory), 0);
    mt_arena_release(&arena);
    return 0;
}

static const char *path_of(int number) {
    static const char *const names[] = {"one", "two", "three"};
    return mt_sample_path(&arena, directory, names[number]);
}

static void assert_holds(int number, const char *text) {
    size_t length;
    uint8_t *bytes = mt_sample_load(&arena, path_of(number), &length);
    assert_int_equal(length, strlen(text));
    assert_memory_equal(bytes, text, length);
}

static bool stands(int number) {
    struct stat about;
    return lstat(path_of(number), &about) == 0;
}

/* Three files of one text. `spoil` is called when all of them are made and none is at its place. */
static mt_status make(const char *text, void (*spoil)(void)) {
    mt_file_set set = {0};
    mt_status status = mt_file_set_begin(path_of(0), &set);
    for (int i = 0; i < 3 && status == MT_OK; i++)
        status = mt_file_set_add(&set, path_of(i), text, strlen(text));
    if (status == MT_OK && spoil) spoil();
    if (status == MT_OK) status = mt_file_set_place(&set, &(int){0});
    mt_file_set_free(&set);
    return status;
}

static void all_are_new(void **state) {
    (void)state;
    assert_int_equal(make("first", NULL), MT_OK);
    for (int i = 0; i < 3; i++) assert_holds(i, "first");
    unlink(path_of(1));
    assert_int_equal(make("second", NULL), MT_OK);
    for (int i = 0; i < 3; i++) assert_holds(i, "second");
    for (int i = 0; i < 3; i++) unlink(path_of(i));
}

/* The folder in which the files are, under the name that base/file.c gives it, loses one. */
static void lose_the_last(void) {
    char name[64];
    snprintf(name, sizeof name, ".morphotype-%ld-0/new-2", (long)getpid());
    assert_int_equal(unlink(mt_sample_path(&arena, directory, name)), 0);
}

static void all_are_old_where_one_cannot_be_placed(void **state) {
    (void)state;
    assert_int_equal(make("first", NULL), MT_OK);
    unlink(path_of(1));
    assert_int_equal(make("second", lose_the_last), MT_CANNOT_WRITE);
    assert_holds(0, "first");
    assert_false(stands(1));
    assert_holds(2, "first");
    for (int i = 0; i < 3; i += 2) unlink(path_of(i));
}

/* A folder with a mark in it, and a file after it; the folder is `path_of(1)`. */
static mt_status make_folder_and_file(const char *text, void (*spoil)(void)) {
    mt_file_set set = {0};
    mt_folder folder = {0};
    mt_status status = mt_file_set_begin(path_of(0), &set);
    if (status == MT_OK) status = mt_folder_begin(path_of(1), &folder);
    if (status == MT_OK) status = mt_folder_add_file(&folder, "mark", text, strlen(text));
    if (status == MT_OK) status = mt_file_set_add_folder(&set, &folder, "mark");
    for (int i = 0; i < 3 && status == MT_OK; i += 2)
        status = mt_file_set_add(&set, path_of(i), text, strlen(text));
    if (status == MT_OK && spoil) spoil();
    int failed = -1;
    if (status == MT_OK) status = mt_file_set_place(&set, &failed);
    assert_int_equal(failed, status == MT_OK ? -1 : 2);
    mt_file_set_free(&set);
    mt_folder_free(&folder);
    return status;
}

static void assert_folder_holds(const char *text) {
    size_t length;
    uint8_t *bytes = mt_sample_load(&arena, mt_sample_path(&arena, path_of(1), "mark"), &length);
    assert_int_equal(length, strlen(text));
    assert_memory_equal(bytes, text, length);
}

static void folders_and_files_go_together(void **state) {
    (void)state;
    assert_int_equal(make_folder_and_file("first", NULL), MT_OK);
    assert_folder_holds("first");
    assert_int_equal(make_folder_and_file("second", lose_the_last), MT_CANNOT_WRITE);
    assert_folder_holds("first");
    assert_holds(0, "first");
    assert_holds(2, "first");
    assert_int_equal(make_folder_and_file("second", NULL), MT_OK);
    assert_folder_holds("second");
    assert_holds(2, "second");
    mt_tree_remove(path_of(1));
    unlink(path_of(0));
    unlink(path_of(2));
}

static void directories_are_left_alone(void **state) {
    (void)state;
    assert_int_equal(mkdir(path_of(2), 0700), 0);
    assert_int_equal(make("text", NULL), MT_CANNOT_WRITE);
    assert_false(stands(0) || stands(1));
    assert_int_equal(rmdir(path_of(2)), 0);
}

static void failing_allocations(void **state) {
    (void)state;
    assert_int_equal(make("first", NULL), MT_OK);
    mt_allocation_watch();
    mt_status status = MT_NO_MEMORY;
    const char *const paths[] = {path_of(0), path_of(1), path_of(2)};
    for (int nth = 0; status == MT_NO_MEMORY; nth++) {
        mt_file_set set = {0};
        mt_allocation_fail(nth, false);
        status = mt_file_set_begin(paths[0], &set);
        for (int i = 0; i < 3 && status == MT_OK; i++) status = mt_file_set_add(&set, paths[i], "second", 6);
        if (status == MT_OK) status = mt_file_set_place(&set, &(int){0});
        mt_file_set_free(&set);
        mt_allocation_succeed();
        for (int i = 0; i < 3; i++) assert_holds(i, status == MT_OK ? "second" : "first");
    }
    assert_int_equal(status, MT_OK);
    mt_allocation_unwatch();
    for (int i = 0; i < 3; i++) unlink(path_of(i));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_are_new),
        cmocka_unit_test(all_are_old_where_one_cannot_be_placed),
        cmocka_unit_test(folders_and_files_go_together),
        cmocka_unit_test(directories_are_left_alone),
        cmocka_unit_test(failing_allocations),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, tear_down);
}
