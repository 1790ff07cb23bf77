#include "source/spec.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static int set_up(void **state) {
    (void)state;
    static const char *const names[] = {"font.ttf", "a#b.ttf", "a@b=1.ttf",
                                        "twin",     "twin#0",  "twin#0@wght=1"};
    directory = mt_sample_directory(&arena);
    for (int i = 0; i < 6; i++) mt_sample_save(mt_sample_path(&arena, directory, names[i]), "x", 1);
    assert_int_equal(mkdir(mt_sample_path(&arena, directory, "font.ttf#7"), 0777), 0);
    return 0;
}

static mt_status parse(const char *text, mt_spec *spec) {
    return mt_spec_parse(mt_sample_path(&arena, directory, text), spec);
}

/* The file's name, the face, the axes as tag=value in 16.16. */
static void assert_reads(const char *text, const char *file, int face, const char *axes) {
    mt_spec spec;
    char read[256] = "";
    mt_assert_ok(parse(text, &spec));
    assert_string_equal(spec.path, mt_sample_path(&arena, directory, file));
    assert_int_equal(spec.face, face);
    for (int i = 0; i < spec.axis_count; i++) {
        uint32_t tag = spec.axes[i].tag;
        size_t length = strlen(read);
        snprintf(read + length, sizeof read - length, "%c%c%c%c=%ld ", (int)(tag >> 24),
                 (int)(tag >> 16 & 255), (int)(tag >> 8 & 255), (int)(tag & 255), (long)spec.axes[i].value);
    }
    assert_string_equal(read, axes);
    mt_spec_clear(&spec);
}

static void whole_specs(void **state) {
    (void)state;
    assert_reads("font.ttf", "font.ttf", 0, "");
    assert_reads("font.ttf#3", "font.ttf", 3, "");
    assert_reads("font.ttf#65535", "font.ttf", 65535, "");
    assert_reads("font.ttf@wght=650", "font.ttf", 0, "wght=42598400 ");
    assert_reads("font.ttf#2@wght=1,slnt=-9.5,XY=+.25,wdth=100.", "font.ttf", 2,
                 "wght=65536 slnt=-622592 XY  =16384 wdth=6553600 ");
}

static void values_are_rounded(void **state) {
    (void)state;
    assert_reads("font.ttf@a=0.1", "font.ttf", 0, "a   =6554 ");
    assert_reads("font.ttf@a=-0.1", "font.ttf", 0, "a   =-6554 ");
    assert_reads("font.ttf@a=0.000000000000000000001", "font.ttf", 0, "a   =0 ");
    assert_reads("font.ttf@a=32767.9999", "font.ttf", 0, "a   =2147483641 ");
    assert_reads("font.ttf@a=0000012", "font.ttf", 0, "a   =786432 ");
}

static void names_with_signs(void **state) {
    (void)state;
    assert_reads("a#b.ttf", "a#b.ttf", 0, "");
    assert_reads("a#b.ttf#1", "a#b.ttf", 1, "");
    assert_reads("a@b=1.ttf", "a@b=1.ttf", 0, "");
    assert_reads("a@b=1.ttf@wght=2", "a@b=1.ttf", 0, "wght=131072 ");
}

static void the_longest_name_wins(void **state) {
    (void)state;
    assert_reads("twin#0@wght=1", "twin#0@wght=1", 0, "");
    assert_reads("twin#0@wght=2", "twin#0", 0, "wght=131072 ");
    assert_reads("twin#1@wght=2", "twin", 1, "wght=131072 ");
    assert_reads("font.ttf#7", "font.ttf", 7, ""); /* that is also a directory's name */
}

static void assert_fails(const char *text, mt_status status) {
    mt_spec spec = {.face = -5};
    assert_int_equal(parse(text, &spec), status);
    assert_int_equal(spec.face, -5);
}

static void bad_faces(void **state) {
    (void)state;
    static const char *const specs[] = {"font.ttf#",   "font.ttf#x",     "font.ttf#-1",
                                        "font.ttf#1x", "font.ttf#65536", "font.ttf#1#2",
                                        "font.ttf# 1", "font.ttf##1",    "font.ttf#99999999999999999999"};
    for (int i = 0; i < 9; i++) assert_fails(specs[i], MT_NO_FACE);
}

static void bad_axes(void **state) {
    (void)state;
    static const char *const specs[] = {
        "font.ttf@",
        "font.ttf@wght",
        "font.ttf@wght=",
        "font.ttf@=5",
        "font.ttf@wght=5,",
        "font.ttf@wght=x",
        "font.ttf@wght=1e3",
        "font.ttf@wght=1 ",
        "font.ttf@weight=5",
        "font.ttf@wght=5;a=1",
        "font.ttf@wght=.",
        "font.ttf@wght=--1",
        "font.ttf@wght=32768",
        "font.ttf@wght=0x10",
        "font.ttf@a=1,,b=2",
        "font.ttf@wght=-",
        "font.ttf@wght=1,5",
        "font.ttf@wght=nan",
        "font.ttf@a=1,b=2,a=3",
        "font.ttf@wght=5#1",
        "font.ttf@ü=1",
        "font.ttf@a=99999999999999999999999",
    };
    for (size_t i = 0; i < sizeof specs / sizeof *specs; i++) assert_fails(specs[i], MT_BAD_AXIS);
}

static void too_many_axes(void **state) {
    (void)state;
    char text[1024] = "font.ttf@";
    for (int i = 0; i < MT_SPEC_AXES + 1; i++) {
        size_t length = strlen(text);
        snprintf(text + length, sizeof text - length, "%sA%d=1", i ? "," : "", i);
    }
    assert_fails(text, MT_BAD_AXIS);
    *strrchr(text, ',') = '\0';
    mt_spec spec;
    mt_assert_ok(parse(text, &spec));
    assert_int_equal(spec.axis_count, MT_SPEC_AXES);
    mt_spec_clear(&spec);
}

/* The features as tag=value, behind the file, the face and the axes. */
static void assert_features(const char *text, int face, int axis_count, const char *features) {
    mt_spec spec;
    char read[256] = "";
    mt_assert_ok(parse(text, &spec));
    assert_string_equal(spec.path, mt_sample_path(&arena, directory, "font.ttf"));
    assert_int_equal(spec.face, face);
    assert_int_equal(spec.axis_count, axis_count);
    for (int i = 0; i < spec.feature_count; i++) {
        uint32_t tag = spec.features[i].tag;
        size_t length = strlen(read);
        snprintf(read + length, sizeof read - length, "%c%c%c%c=%u ", (int)(tag >> 24),
                 (int)(tag >> 16 & 255), (int)(tag >> 8 & 255), (int)(tag & 255),
                 (unsigned)spec.features[i].value);
    }
    assert_string_equal(read, features);
    mt_spec_clear(&spec);
}

static void features(void **state) {
    (void)state;
    assert_features("font.ttf:lnum,ss02", 0, 0, "lnum=1 ss02=1 ");
    assert_features("font.ttf#2:salt=2", 2, 0, "salt=2 ");
    assert_features("font.ttf@wght=1,wdth=-.5:cv01=255,liga=0", 0, 2, "cv01=255 liga=0 ");
    assert_features("font.ttf#1@a=2:x=on,yy=off", 1, 1, "x   =1 yy  =0 ");
}

static void names_with_colons(void **state) {
    (void)state;
    mt_sample_save(mt_sample_path(&arena, directory, "C:font.ttf"), "x", 1);
    mt_sample_save(mt_sample_path(&arena, directory, "twin:lnum"), "x", 1);
    assert_reads("C:font.ttf", "C:font.ttf", 0, "");
    assert_reads("C:font.ttf#1@a=1:lnum", "C:font.ttf", 1, "a   =65536 ");
    assert_reads("twin:lnum", "twin:lnum", 0, "");
    assert_reads("twin:onum", "twin", 0, "");
}

static void bad_features(void **state) {
    (void)state;
    static const char *const specs[] = {
        "font.ttf:",         "font.ttf:lnum,",     "font.ttf:,lnum",     "font.ttf:lnum,,ss01",
        "font.ttf:lnum=",    "font.ttf:lnum=x",    "font.ttf:lnum=1.5",  "font.ttf:lnum=256",
        "font.ttf:lnum=-1",  "font.ttf:lnum ",     "font.ttf:=1",        "font.ttf:lnum=only",
        "font.ttf:ligature", "font.ttf:lnum,lnum", "font.ttf:lnum:ss01", "font.ttf:ünum",
        "font.ttf:lnum#1",   "font.ttf:lnum@a=1",  "font.ttf@a=1:",      "font.ttf#1:a=99999999999",
    };
    for (size_t i = 0; i < sizeof specs / sizeof *specs; i++) assert_fails(specs[i], MT_BAD_FEATURE);
    char text[1024] = "font.ttf:A0";
    for (int i = 1; i < MT_SPEC_FEATURES + 1; i++) {
        size_t length = strlen(text);
        snprintf(text + length, sizeof text - length, ",A%d", i);
    }
    assert_fails(text, MT_BAD_FEATURE);
    *strrchr(text, ',') = '\0';
    mt_spec spec;
    mt_assert_ok(parse(text, &spec));
    assert_int_equal(spec.feature_count, MT_SPEC_FEATURES);
    mt_spec_clear(&spec);
}

static void missing_files(void **state) {
    (void)state;
    mt_spec spec;
    assert_fails("none.ttf#0@wght=1", MT_NO_FILE);
    assert_int_equal(errno, ENOENT);
    assert_fails("", MT_NO_FILE);
    assert_int_equal(errno, EISDIR);
    assert_int_equal(mt_spec_parse("", &spec), MT_NO_FILE);
    assert_int_equal(errno, ENOENT);
    assert_int_equal(mt_spec_parse("#0", &spec), MT_NO_FILE);
    assert_int_equal(mt_spec_parse("@@##", &spec), MT_NO_FILE);
    assert_int_equal(errno, ENOENT);
}

static void no_memory(void **state) {
    (void)state;
    mt_spec spec;
    const char *text = mt_sample_path(&arena, directory, "font.ttf#1");
    mt_allocation_watch();
    mt_allocation_fail(0, true);
    mt_status status = mt_spec_parse(text, &spec);
    mt_allocation_unwatch();
    assert_int_equal(status, MT_NO_MEMORY);
    assert_int_equal(mt_allocation_live(), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_specs),      cmocka_unit_test(values_are_rounded),
        cmocka_unit_test(names_with_signs), cmocka_unit_test(the_longest_name_wins),
        cmocka_unit_test(features),         cmocka_unit_test(names_with_colons),
        cmocka_unit_test(bad_features),     cmocka_unit_test(bad_faces),
        cmocka_unit_test(bad_axes),         cmocka_unit_test(too_many_axes),
        cmocka_unit_test(missing_files),    cmocka_unit_test(no_memory),
    };
    return cmocka_run_group_tests(tests, set_up, mt_test_tear_down);
}
