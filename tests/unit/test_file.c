#include "base/file.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static char *path_of(const char *name) {
    return mt_sample_path(&arena, directory, name);
}

static void assert_holds(const char *path, const char *text) {
    uint8_t *bytes;
    size_t length;
    mt_assert_ok(mt_file_read(path, 1 << 20, &bytes, &length));
    assert_int_equal(length, strlen(text));
    assert_memory_equal(bytes, text, length);
    mt_free(bytes);
}

static void writes_and_replaces(void **state) {
    (void)state;
    const char *path = path_of("out.ttf");
    mt_assert_ok(mt_file_write(path, "first", 5));
    assert_holds(path, "first");
    mt_assert_ok(mt_file_write(path, "second one", 10));
    assert_holds(path, "second one");
    mt_assert_ok(mt_file_write(path, "", 0));
    assert_holds(path, "");
    assert_int_equal(mt_sample_count(directory), 1);
}

static void honours_the_umask(void **state) {
    (void)state;
    struct stat about;
    const char *path = path_of("mode.ttf");
    mode_t before = umask(027);
    mt_assert_ok(mt_file_write(path, "x", 1));
    umask(before);
    assert_int_equal(stat(path, &about), 0);
    assert_int_equal(about.st_mode & 0777, 0640);
}

static void writes_to_a_name_as_long_as_can_be(void **state) {
    (void)state;
    char name[256];
    memset(name, 'n', 255);
    name[255] = '\0';
    mt_assert_ok(mt_file_write(path_of(name), "long", 4));
    assert_holds(path_of(name), "long");
}

static void writes_to_the_working_directory(void **state) {
    (void)state;
    char *before = getcwd(NULL, 0);
    assert_non_null(before);
    assert_int_equal(chdir(directory), 0);
    mt_assert_ok(mt_file_write("here.ttf", "here", 4));
    assert_int_equal(chdir(before), 0);
    free(before);
    assert_holds(path_of("here.ttf"), "here");
}

static void leaves_nothing_when_it_cannot_write(void **state) {
    (void)state;
    const char *taken = path_of("taken");
    assert_int_equal(mkdir(taken, 0777), 0);
    int before = mt_sample_count(directory);
    assert_int_equal(mt_file_write(taken, "x", 1), MT_CANNOT_WRITE);
    assert_int_equal(errno, EISDIR);
    assert_int_equal(mt_file_write(path_of("missing/out.ttf"), "x", 1), MT_CANNOT_WRITE);
    assert_int_equal(errno, ENOENT);
    assert_int_equal(mt_file_write("", "x", 1), MT_CANNOT_WRITE);
    assert_int_equal(mt_file_write(path_of("taken/"), "x", 1), MT_CANNOT_WRITE);
    assert_int_equal(mt_file_write(path_of("new/"), "x", 1), MT_CANNOT_WRITE);
    assert_int_equal(mt_file_write("/dev/null", "x", 1), MT_CANNOT_WRITE);
    assert_int_equal(mt_sample_count(directory), before);
}

static void steps_over_a_name_in_use(void **state) {
    (void)state;
    char name[64];
    snprintf(name, sizeof name, ".morphotype-%ld-0", (long)getpid());
    mt_sample_save(path_of(name), "left", 4);
    mt_assert_ok(mt_file_write(path_of("beside.ttf"), "right", 5));
    assert_holds(path_of(name), "left");
    assert_holds(path_of("beside.ttf"), "right");
}

static void reads_only_files(void **state) {
    (void)state;
    uint8_t *bytes;
    size_t length;
    assert_int_equal(mt_file_read(path_of("nothing"), 10, &bytes, &length), MT_NO_FILE);
    assert_int_equal(errno, ENOENT);
    assert_int_equal(mt_file_read(directory, 10, &bytes, &length), MT_NO_FILE);
    assert_int_equal(errno, EISDIR);
    assert_int_equal(mt_file_read("/dev/zero", 10, &bytes, &length), MT_NO_FILE);
}

static void reads_up_to_its_limit(void **state) {
    (void)state;
    uint8_t *bytes;
    size_t length;
    const char *path = path_of("ten");
    mt_sample_save(path, "0123456789", 10);
    assert_int_equal(mt_file_read(path, 9, &bytes, &length), MT_TOO_LARGE);
    mt_assert_ok(mt_file_read(path, 10, &bytes, &length));
    assert_int_equal(length, 10);
    mt_free(bytes);
}

static void reads_a_pipe(void **state) {
    (void)state;
    enum { LENGTH = 60000 }; /* what a pipe holds without a reader */
    static char sent[LENGTH];
    uint8_t *bytes;
    size_t length;
    int ends[2];
    char name[32];
    for (int i = 0; i < LENGTH; i++) sent[i] = (char)(i % 251);
    assert_int_equal(pipe(ends), 0);
    assert_int_equal(write(ends[1], sent, LENGTH), LENGTH);
    close(ends[1]);
    snprintf(name, sizeof name, "/dev/fd/%d", ends[0]);
    mt_assert_ok(mt_file_read(name, 1 << 20, &bytes, &length));
    close(ends[0]);
    assert_int_equal(length, LENGTH);
    assert_memory_equal(bytes, sent, LENGTH);
    mt_free(bytes);
}

static void survives_want_of_memory(void **state) {
    (void)state;
    uint8_t *bytes;
    size_t length;
    const char *path = path_of("memory.ttf");
    mt_assert_ok(mt_file_write(path, "before", 6));
    int before = mt_sample_count(directory);
    mt_allocation_watch();
    mt_allocation_fail(0, true);
    mt_status wrote = mt_file_write(path, "after", 5), read = mt_file_read(path, 100, &bytes, &length);
    mt_allocation_unwatch();
    assert_int_equal(wrote, MT_NO_MEMORY);
    assert_int_equal(read, MT_NO_MEMORY);
    assert_int_equal(mt_allocation_live(), 0);
    assert_holds(path, "before");
    assert_int_equal(mt_sample_count(directory), before);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(writes_and_replaces),
        cmocka_unit_test(honours_the_umask),
        cmocka_unit_test(writes_to_a_name_as_long_as_can_be),
        cmocka_unit_test(writes_to_the_working_directory),
        cmocka_unit_test(leaves_nothing_when_it_cannot_write),
        cmocka_unit_test(steps_over_a_name_in_use),
        cmocka_unit_test(reads_only_files),
        cmocka_unit_test(reads_up_to_its_limit),
        cmocka_unit_test(reads_a_pipe),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
