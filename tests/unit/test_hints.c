#include "base/memory.h"
#include "blend/row.h"
#include "geometry/limits.h"
#include "hints/index.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/sample.h"
#include "write/write.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static mt_arena arena;
static char *directory;
static mt_font *a, *b; /* of 1000 and of 2000 units an em; A and B are one glyph in both, é is in a only */

/* A font of the sample's glyphs. */
static mt_font *open_font(const char *name, int units, const mt_char *chars, int count) {
    uint8_t *bytes;
    size_t length;
    mt_font *font;
    mt_font_data data = mt_sample_font(&arena);
    const char *path = mt_sample_path(&arena, directory, name);
    data.units = units;
    data.chars = mt_arena_new(&arena, (size_t)count, sizeof *data.chars);
    memcpy(data.chars, chars, (size_t)count * sizeof *chars);
    data.char_count = count;
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    mt_sample_save(path, bytes, length);
    mt_bytes_free(bytes);
    mt_assert_ok(mt_font_open(path, &font));
    return font;
}

static int set_up(void **state) {
    (void)state;
    static const mt_char chars[] = {{'A', 1}, {'B', 1}, {'o', 2}, {0xE9, 3}};
    directory = mt_sample_directory(&arena);
    a = open_font("a.ttf", 1000, chars, 4);
    b = open_font("b.ttf", 2000, chars, 3);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    mt_font_close(a);
    mt_font_close(b);
    mt_sample_remove(directory);
    mt_arena_release(&arena);
    return 0;
}

/* ---- the file ------------------------------------------------------------------------------------------ */

static mt_hint_table *read_bytes(const char *text, size_t length) {
    mt_hint_table *table;
    mt_hint_error error = {-1, NULL};
    mt_status status = mt_hint_table_read(text, length, &table, &error);
    if (status != MT_OK) fail_msg("%s: line %d: %s", mt_status_text(status), error.line, error.reason);
    return table;
}

static mt_hint_table *read_text(const char *text) {
    return read_bytes(text, strlen(text));
}

/* Each hint as "U+0061 5 component 1.5,2 3,4\n". */
static void assert_table(const char *text, const char *expected) {
    char lines[1024] = "";
    mt_hint_table *table = read_text(text);
    for (int i = 0; i < table->count; i++) {
        const mt_hint_line *h = &table->lines[i];
        size_t length = strlen(lines);
        snprintf(lines + length, sizeof lines - length, "U+%04lX %d %s %g,%g %g,%g\n",
                 (unsigned long)h->code_point, h->line, h->kind == MT_HINT_POINT ? "point" : "component",
                 h->a.x / 65536.0, h->a.y / 65536.0, h->b.x / 65536.0, h->b.y / 65536.0);
    }
    assert_string_equal(lines, expected);
    mt_hint_table_free(table);
}

static void hints_of_characters(void **state) {
    (void)state;
    assert_table("glyph a\ncomponent 120,300 140,310\npoint 100,700 90,680\n",
                 "U+0061 2 component 120,300 140,310\nU+0061 3 point 100,700 90,680\n");
    assert_table("glyph 雨\npoint 1,2 3,4", "U+96E8 2 point 1,2 3,4\n");
    assert_table("glyph U+96E8\npoint 1,2 3,4", "U+96E8 2 point 1,2 3,4\n");
    assert_table("glyph u+1f600\npoint 1,2 3,4", "U+1F600 2 point 1,2 3,4\n");
    assert_table("glyph U\npoint 1,2 3,4", "U+0055 2 point 1,2 3,4\n");
    assert_table("glyph U+0023\npoint 1,2 3,4", "U+0023 2 point 1,2 3,4\n");
    assert_table("glyph a\nglyph b\n", "");
    assert_table("", "");
}

static void numbers(void **state) {
    (void)state;
    assert_table("glyph a\npoint -1.5,+2 .25,-0", "U+0061 2 point -1.5,2 0.25,0\n");
    assert_table("glyph a\npoint 32767,-32767 0,0", "U+0061 2 point 32767,-32767 0,0\n");
}

static void blanks_and_comments(void **state) {
    (void)state;
    assert_table("# a word\n\n  glyph \t a # its hints\n\tpoint  1,2\t3,4 #5,6\n#",
                 "U+0061 4 point 1,2 3,4\n");
    assert_table("\xef\xbb\xbfglyph a\r\n\r\npoint 1,2 3,4\r\n", "U+0061 3 point 1,2 3,4\n");
}

static void in_the_order_of_characters(void **state) {
    (void)state;
    assert_table(
        "glyph c\npoint 1,0 0,0\nglyph a\npoint 2,0 0,0\nglyph b\nglyph c\npoint 3,0 0,0\npoint 0,0 0,0",
        "U+0061 4 point 2,0 0,0\nU+0063 2 point 1,0 0,0\nU+0063 7 point 3,0 0,0\nU+0063 8 point 0,0 0,0\n");
}

static void text_without_an_end(void **state) {
    (void)state;
    mt_hint_table *table = read_bytes("glyph a\npoint 1,2 3,456", 22);
    assert_int_equal(table->count, 1);
    assert_int_equal(table->lines[0].b.y, 45 * 65536);
    mt_hint_table_free(table);
    mt_hint_table_free(read_bytes(NULL, 0));
}

static void characters_one_by_one(void **state) {
    (void)state;
    uint32_t found = 7;
    mt_hint_table *table =
        read_text("glyph c\npoint 1,2 3,4\npoint 1,2 3,4\nglyph a\npoint 1,2 3,4\nglyph z");
    assert_true(mt_hint_table_next_char(table, 0, &found));
    assert_int_equal(found, 'a');
    assert_true(mt_hint_table_next_char(table, 'a', &found));
    assert_int_equal(found, 'a');
    assert_true(mt_hint_table_next_char(table, 'b', &found));
    assert_int_equal(found, 'c');
    assert_false(mt_hint_table_next_char(table, 'd', &found));
    assert_int_equal(found, 'c');
    mt_hint_table_free(table);
    mt_hint_table_free(NULL);
}

/* ---- what is wrong with a file ------------------------------------------------------------------------- */

static void assert_bad(const char *text, size_t length, int line, const char *reason) {
    mt_hint_table *table = NULL;
    mt_hint_error error = {-1, ""};
    assert_int_equal(mt_hint_table_read(text, length, &table, NULL), MT_BAD_HINTS);
    assert_int_equal(mt_hint_table_read(text, length, &table, &error), MT_BAD_HINTS);
    assert_null(table);
    if (error.line != line || !strstr(error.reason, reason))
        fail_msg("%s: line %d: %s", text, error.line, error.reason);
}

static void bad_lines(void **state) {
    (void)state;
    static const char *const lines[][2] = {
        {"point", "two places"},
        {"point 1,2", "two places"},
        {"point 1,2 3,4 5,6", "two places"},
        {"component 1,2 # 3,4", "two places"},
        {"points 1,2 3,4", "begins with"},
        {"1,2 3,4", "begins with"},
        {"Glyph b", "begins with"},
        {"glyph", "one character"},
        {"glyph #", "one character"},
        {"glyph ab", "one character"},
        {"glyph a b", "one character"},
        {"glyph U+", "one character"},
        {"glyph U+110000", "one character"},
        {"glyph U+D800", "one character"},
        {"glyph U+0000061", "one character"},
        {"glyph U+61-62", "one character"},
        {"glyph \xff", "UTF-8"},
        {"# \xe9t\xe9", "UTF-8"},
    };
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        char text[80];
        int length = snprintf(text, sizeof text, "# hints\r\nglyph a\n%s\nglyph b\n", lines[i][0]);
        assert_bad(text, (size_t)length, 3, lines[i][1]);
    }
}

static void bad_places(void **state) {
    (void)state;
    static const char *const places[] = {
        "1",       "1,",       ",2",    "1,2,3", "1;2",
        "a,b",     "nan,0",    "inf,0", "1e3,0", "0x1,0",
        "32768,0", "0,-32768", "--1,0", "1,2#",  "99999999999999999999,0",
        "0,1e999", "-,0",      ".,0",   "1,2x",
    };
    for (size_t i = 0; i < sizeof places / sizeof *places; i++)
        for (int side = 0; side < 2; side++) {
            char text[80];
            int length = snprintf(text, sizeof text, side ? "glyph a\npoint 0,0 %s" : "glyph a\npoint %s 0,0",
                                  places[i]);
            assert_bad(text, (size_t)length, 2, "a place is written");
        }
}

static void bad_files(void **state) {
    (void)state;
    assert_bad("\n\npoint 1,2 3,4\n", 15, 3, "before the first glyph");
    assert_bad("glyph a\npoint 1,2\0 3,4\n", 23, 2, "UTF-8");
    assert_bad("\0", 1, 1, "UTF-8");
    assert_bad("\xff\xfeg\0l\0", 6, 1, "UTF-8");
}

static void limits(void **state) {
    (void)state;
    static const char hint[] = "point 1,2 3,4\n";
    size_t length = sizeof hint - 1, all = 8 + (MT_HINTS_MAX + 1) * length;
    char *text = mt_test_new(all + 1, 1);
    memcpy(text, "glyph a\n", 8);
    for (size_t at = 8; at < all; at += length) memcpy(text + at, hint, length);
    assert_bad(text, all, MT_HINTS_MAX + 2, "too many hints");
    mt_hint_table *table = read_bytes(text, all - length);
    assert_int_equal(table->count, MT_HINTS_MAX);
    mt_hint_table_free(table);
    free(text);
    text = mt_test_new(MT_HINT_FILE_MAX + 1, 1);
    memset(text, '\n', MT_HINT_FILE_MAX + 1);
    table = NULL;
    assert_int_equal(mt_hint_table_read(text, MT_HINT_FILE_MAX + 1, &table, NULL), MT_TOO_LARGE);
    assert_null(table);
    mt_hint_table_free(read_bytes(text, MT_HINT_FILE_MAX));
    free(text);
}

static void files(void **state) {
    (void)state;
    mt_hint_table *table = NULL;
    mt_hint_error error = {-1, ""};
    const char *path = mt_sample_path(&arena, directory, "hints.txt");
    assert_int_equal(mt_hint_table_open(path, &table, &error), MT_NO_FILE);
    assert_int_equal(errno, ENOENT);
    assert_int_equal(mt_hint_table_open(directory, &table, &error), MT_NO_FILE);
    assert_int_equal(error.line, -1);
    mt_sample_save(path, "glyph a\npoint", 13);
    assert_int_equal(mt_hint_table_open(path, &table, &error), MT_BAD_HINTS);
    assert_int_equal(error.line, 2);
    assert_null(table);
    mt_sample_save(path, "glyph a\npoint 1,2 3,4", 21);
    mt_assert_ok(mt_hint_table_open(path, &table, &error));
    assert_int_equal(table->count, 1);
    mt_hint_table_free(table);
}

static void hints_of_names(void **state) {
    (void)state;
    mt_hint_table *table =
        read_text("glyph /f_i\npoint 1,2 3,4\nglyph b\npoint 5,6 7,8\nglyph /a.sc # small\n"
                  "component 1,1 2,2\npoint 3,3 4,4\nglyph /\npoint 0,0 0,0\n");
    uint32_t code_point;
    assert_int_equal(table->count, 5);
    assert_int_equal(table->character_count, 2);
    assert_int_equal(table->lines[0].code_point, '/');
    assert_int_equal(table->lines[1].code_point, 'b');
    static const struct {
        const char *name;
        int name_line, line;
    } named[] = {{"f_i", 1, 2}, {"a.sc", 5, 6}, {"a.sc", 5, 7}};
    for (int i = 0; i < 3; i++) {
        const mt_hint_line *line = &table->lines[2 + i];
        assert_string_equal(line->name, named[i].name);
        assert_int_equal(line->name_line, named[i].name_line);
        assert_int_equal(line->line, named[i].line);
    }
    assert_true(mt_hint_table_next_char(table, 'a', &code_point));
    assert_int_equal(code_point, 'b');
    assert_false(mt_hint_table_next_char(table, 'c', &code_point));
    mt_hint_table_free(table);
}

/* ---- the index ----------------------------------------------------------------------------------------- */

static mt_hint_index *index_text(const char *text) {
    mt_hint_index *index;
    mt_hint_table *table = read_text(text);
    mt_assert_ok(mt_hint_index_new(table, NULL, (mt_font *[]){a, b}, 0, NULL, &index, NULL));
    mt_hint_table_free(table);
    return index;
}

static void assert_hint(mt_hint hint, mt_hint_kind kind, int ax, int ay, int bx, int by) {
    assert_int_equal(hint.kind, kind);
    assert_int_equal(hint.a.x, ax);
    assert_int_equal(hint.a.y, ay);
    assert_int_equal(hint.b.x, bx);
    assert_int_equal(hint.b.y, by);
}

static void on_the_grid(void **state) {
    (void)state;
    mt_hint_index *index = index_text("glyph o\npoint 1,-2.5 1,-2.5\ncomponent 0.002,-0.002 1000,2000\n");
    mt_hints hints = mt_hint_index_find(index, 2, 2);
    assert_int_equal(hints.count, 2);
    assert_hint(hints.hints[0], MT_HINT_POINT, 256, -640, 128, -320);
    assert_hint(hints.hints[1], MT_HINT_COMPONENT, 1, -1, 128000, 256000);
    mt_hint_index_free(index);
}

static void by_pairs_of_glyphs(void **state) {
    (void)state;
    mt_hint_index *index =
        index_text("glyph o\npoint 9,0 0,0\nglyph B\npoint 1,0 0,0\nglyph é\npoint 2,0 0,0\n"
                   "glyph A\npoint 3,0 0,0\nglyph z\npoint 4,0 0,0\nglyph B\npoint 5,0 0,0\n");
    mt_hints shared = mt_hint_index_find(index, 1, 1);
    assert_int_equal(shared.count, 3); /* of A and B, in the order of the file */
    for (int i = 0; i < 3; i++) assert_hint(shared.hints[i], MT_HINT_POINT, (1 + 2 * i) * 256, 0, 0, 0);
    assert_int_equal(mt_hint_index_find(index, 2, 2).count, 1);
    assert_int_equal(mt_hint_index_find(index, 3, 0).count, 0); /* b lacks é */
    assert_int_equal(mt_hint_index_find(index, 0, 0).count, 0);
    assert_int_equal(mt_hint_index_find(index, 1, 2).count, 0);
    assert_int_equal(mt_hint_index_find(index, 2, 1).count, 0);
    mt_hint_index_free(index);
}

/* A name's hints are with those of the characters that lead to the same glyphs, in the order of the file. */
static void by_named_glyphs(void **state) {
    (void)state;
    mt_hint_index *index;
    mt_hint_table *table =
        read_text("glyph A\npoint 1,0 0,0\nglyph /x\npoint 2,0 0,0\nglyph /y\npoint 3,0 0,0\n"
                  "glyph /z\npoint 4,0 0,0\nglyph B\npoint 5,0 0,0\n");
    static const mt_hint_glyphs named[] = {{true, 1, 1}, {true, 1, 2}, {.a = 2, .b = 2}};
    mt_assert_ok(mt_hint_index_new(table, named, (mt_font *[]){a, b}, 0, NULL, &index, NULL));
    mt_hints shared = mt_hint_index_find(index, 1, 1);
    assert_int_equal(shared.count, 3);
    static const int x[] = {1, 2, 5};
    for (int i = 0; i < 3; i++) assert_hint(shared.hints[i], MT_HINT_POINT, 256 * x[i], 0, 0, 0);
    assert_int_equal(mt_hint_index_find(index, 1, 2).count, 1);
    assert_int_equal(mt_hint_index_find(index, 2, 2).count, 0); /* not paired */
    mt_hint_index_free(index);
    mt_hint_table_free(table);
}

static void no_hints(void **state) {
    (void)state;
    mt_hint_index *index = index_text("glyph z\npoint 1,2 3,4\n");
    assert_int_equal(mt_hint_index_find(index, 1, 1).count, 0);
    mt_hint_index_free(index);
    index = index_text("");
    assert_int_equal(mt_hint_index_find(index, 1, 1).count, 0);
    mt_hint_index_free(index);
    assert_int_equal(mt_hint_index_find(NULL, 1, 1).count, 0);
    mt_hint_index_free(NULL);
}

static void assert_unfit(const char *text, mt_font *in_a, mt_font *in_b, int line, const char *reason) {
    mt_hint_index *index = NULL;
    mt_hint_error error = {-1, ""};
    mt_hint_table *table = read_text(text);
    assert_int_equal(mt_hint_index_new(table, NULL, (mt_font *[]){in_a, in_b}, 0, NULL, &index, NULL),
                     MT_BAD_HINTS);
    assert_int_equal(mt_hint_index_new(table, NULL, (mt_font *[]){in_a, in_b}, 0, NULL, &index, &error),
                     MT_BAD_HINTS);
    assert_null(index);
    assert_int_equal(error.line, line);
    assert_non_null(strstr(error.reason, reason));
    mt_hint_table_free(table);
}

static void places_off_the_grid(void **state) {
    (void)state;
    static const mt_char chars[] = {{'A', 1}};
    mt_font *coarse = open_font("coarse.ttf", 16, chars, 1);
    assert_unfit("glyph A\npoint 524,0 0,0\npoint 0,525 0,0", coarse, b, 3, "first font");
    assert_unfit("glyph A\npoint 0,0 0,0\npoint 0,0 -525,0", a, coarse, 3, "second font");
    mt_hint_index *index;
    mt_hint_table *table = read_text("glyph o\npoint 525,0 525,0\nglyph A\npoint 524,-524 524,-524");
    mt_assert_ok(mt_hint_index_new(table, NULL, (mt_font *[]){coarse, coarse}, 0, NULL, &index, NULL));
    mt_hint_index_free(index);
    mt_hint_table_free(table);
    mt_font_close(coarse);
}

static void too_many_for_a_glyph(void **state) {
    (void)state;
    static const char hint[] = "point 1,2 3,4\n";
    char text[(MT_GLYPH_HINTS_MAX + 8) * sizeof hint] = "glyph A\n";
    for (int i = 1; i < MT_GLYPH_HINTS_MAX; i++) strcat(text, hint);
    strcat(text, "glyph B\n");
    strcat(text, hint);
    mt_hint_index *index = index_text(text);
    assert_int_equal(mt_hint_index_find(index, 1, 1).count, MT_GLYPH_HINTS_MAX);
    mt_hint_index_free(index);
    strcat(text, hint);
    assert_unfit(text, a, b, MT_GLYPH_HINTS_MAX + 3, "too many");
}

/* ---- the blend ----------------------------------------------------------------------------------------- */

static void blends_take_hints(void **state) {
    (void)state;
    mt_blend *blend;
    mt_hint_error error = {-1, ""};
    mt_params params = mt_params_default();
    static const mt_char chars[] = {{'A', 1}};
    mt_font *coarse = open_font("coarse.ttf", 16, chars, 1);
    mt_hint_table *table = read_text("glyph A\npoint 525,0 0,0\n");
    mt_assert_ok(mt_blend_new(coarse, b, &params, &blend));
    assert_int_equal(mt_blend_set_hints(blend, table, &error), MT_BAD_HINTS);
    assert_int_equal(error.line, 2);
    mt_blend_free(blend);
    mt_assert_ok(mt_blend_new(a, b, &params, &blend));
    mt_assert_ok(mt_blend_set_hints(blend, table, &error));
    mt_assert_ok(mt_blend_set_hints(blend, table, NULL));
    mt_hint_table_free(table);
    mt_assert_ok(mt_blend_set_hints(blend, NULL, NULL));
    mt_blend_free(blend);
    mt_font_close(coarse);
}

/* By numbers: the sample has no names. */
static void blends_take_hints_by_name(void **state) {
    (void)state;
    mt_blend *blend;
    mt_hint_error error = {-1, ""};
    mt_params params = mt_params_default();
    mt_assert_ok(mt_blend_new(a, b, &params, &blend));
    mt_hint_table *table = read_text("glyph A\npoint 1,0 0,0\n\nglyph /gid77\n\npoint 1,0 0,0\n");
    assert_int_equal(mt_blend_set_hints(blend, table, NULL), MT_BAD_HINTS);
    assert_int_equal(mt_blend_set_hints(blend, table, &error), MT_BAD_HINTS);
    assert_int_equal(error.line, 4);
    mt_hint_table_free(table);
    table = read_text("glyph A\npoint 1,0 0,0\nglyph /gid2\npoint 2,0 0,0\nglyph /gid3\npoint 3,0 0,0\n");
    mt_assert_ok(mt_blend_set_hints(blend, table, &error));
    const mt_hint_index *index = blend->row.hints[0];
    assert_int_equal(mt_hint_index_find(index, 1, 1).count, 1);
    assert_hint(mt_hint_index_find(index, 2, 2).hints[0], MT_HINT_POINT, 512, 0, 0, 0);
    assert_int_equal(mt_hint_index_find(index, 3, 3).count, 0); /* b has no é */
    mt_hint_table_free(table);
    mt_blend_free(blend);
}

/* ---- memory -------------------------------------------------------------------------------------------- */

static mt_status read_and_index(void) {
    static const char text[] = "glyph A\npoint 1,2 3,4\nglyph o\npoint 1,2 3,4\n";
    mt_hint_table *table;
    mt_hint_index *index;
    mt_status status = mt_hint_table_read(text, sizeof text - 1, &table, NULL);
    if (status != MT_OK) return status;
    status = mt_hint_index_new(table, NULL, (mt_font *[]){a, b}, 0, NULL, &index, NULL);
    mt_hint_table_free(table);
    if (status == MT_OK) mt_hint_index_free(index);
    return status;
}

static void survives_want_of_memory(void **state) {
    (void)state;
    int failed = 0;
    for (mt_status status = MT_NO_MEMORY; status != MT_OK; failed++) {
        mt_allocation_watch();
        mt_allocation_fail(failed, false);
        status = read_and_index();
        long live = mt_allocation_live(), requests = mt_allocation_requests();
        mt_allocation_unwatch();
        assert_int_equal(status, requests > failed ? MT_NO_MEMORY : MT_OK);
        assert_int_equal(live, 0);
    }
    assert_int_equal(failed, 7); /* the copy, the table, its lines; the index, keys, hints; none */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hints_of_characters),
        cmocka_unit_test(numbers),
        cmocka_unit_test(blanks_and_comments),
        cmocka_unit_test(in_the_order_of_characters),
        cmocka_unit_test(text_without_an_end),
        cmocka_unit_test(characters_one_by_one),
        cmocka_unit_test(bad_lines),
        cmocka_unit_test(bad_places),
        cmocka_unit_test(bad_files),
        cmocka_unit_test(limits),
        cmocka_unit_test(files),
        cmocka_unit_test(hints_of_names),
        cmocka_unit_test(on_the_grid),
        cmocka_unit_test(by_pairs_of_glyphs),
        cmocka_unit_test(by_named_glyphs),
        cmocka_unit_test(no_hints),
        cmocka_unit_test(places_off_the_grid),
        cmocka_unit_test(too_many_for_a_glyph),
        cmocka_unit_test(blends_take_hints),
        cmocka_unit_test(blends_take_hints_by_name),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
