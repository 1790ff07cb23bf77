/* Positions with each request for memory failed in turn: MT_NO_MEMORY, and nothing is left behind. */
#include "gpos/kerning.h"
#include "gpos/positions.h"
#include "sfnt/sfnt.h"
#include "support/allocation.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/fonts.h"
#include "support/sample.h"
#include "support/varying.h"

#define INTER "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf"

enum { FIRST = 0x21, GLYPHS = 150 };

/* A font of blank glyphs with a table of a real one. */
static char *save_with(const char *name, const char *source, uint32_t tag) {
    mt_bytes table;
    mt_font *font = mt_test_font(source);
    char *path = mt_sample_path(&arena, directory, name);
    mt_assert_ok(mt_font_table(font, tag, &arena, &table));
    mt_test_save_blank(path, 1000, FIRST, GLYPHS, tag, table, &arena);
    mt_font_close(font);
    return path;
}

static mt_status make_positions(mt_font *a, mt_font *b, mt_arena *made) {
    mt_charset charset;
    mt_positions *positions;
    mt_bytes gpos, gdef, none = {0};
    mt_kerning kerning;
    mt_status status = mt_charset_make(a, b, &(mt_charset_request){0}, made, &charset);
    if (status == MT_OK) status = mt_test_positions((mt_font *[]){a, b}, &charset, 2, 1000, made, &positions);
    if (status == MT_OK) status = mt_positions_write(positions, mt_font_at_t(0.5), made, &gpos);
    if (status == MT_OK) assert_true(gpos.length > 0);
    if (status == MT_OK) status = mt_test_write_varying(positions, 2, none, made, &gpos, &gdef);
    if (status == MT_OK) assert_true(gdef.length > 0);
    return status == MT_OK ? mt_positions_kerning(positions, mt_font_at_t(0.5), made, &kerning) : status;
}

/* Request `first` fails, and with `all_after` all later ones. Whether there was such a request. */
static bool run_failing(const char *in_a, const char *in_b, long first, bool all_after) {
    mt_font *a, *b;
    mt_arena made = {0};
    mt_allocation_watch();
    mt_assert_ok(mt_font_open(in_a, &a));
    mt_assert_ok(mt_font_open(in_b, &b));
    long before = mt_allocation_requests();
    mt_allocation_fail(first, all_after);
    mt_status status = make_positions(a, b, &made);
    bool failed = mt_allocation_requests() - before > first;
    mt_allocation_succeed();
    mt_arena_release(&made);
    mt_font_close(a);
    mt_font_close(b);
    long live = mt_allocation_live();
    mt_allocation_unwatch();
    if (status != (failed ? MT_NO_MEMORY : MT_OK)) fail_msg("request %ld: %s", first, mt_status_text(status));
    if (live != 0) fail_msg("request %ld: %ld blocks left", first, live);
    return failed;
}

static void fail_each(const char *a, const char *b) {
    long first = 0;
    for (; run_failing(a, b, first, true); first++) run_failing(a, b, first, false);
    assert_true(first > 20);
}

static void gpos_with_gpos(void **state) {
    (void)state;
    fail_each(save_with("a.ttf", INTER, MT_TAG('G', 'P', 'O', 'S')),
              save_with("b.ttf", MT_TEST_SERIF, MT_TAG('G', 'P', 'O', 'S')));
}

static void gpos_with_an_old_table(void **state) {
    (void)state;
    fail_each(save_with("a.ttf", MT_TEST_SANS, MT_TAG('k', 'e', 'r', 'n')),
              save_with("b.ttf", INTER, MT_TAG('G', 'P', 'O', 'S')));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(gpos_with_gpos),
        cmocka_unit_test(gpos_with_an_old_table),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
