/* Layout tables that are cut short, or in which bytes are changed: nothing crashes, hangs or is read out of bounds (the
 * sanitizers' build sees to the last), and what is made of them can be read again. */
#include "base/file.h"
#include "gpos/gpos.h"
#include "gpos/kerning.h"
#include "gpos/positions.h"
#include "sfnt/sfnt.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/fonts.h"
#include "support/sample.h"
#include "support/varying.h"

#include <string.h>
#include <time.h>

#define INTER "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf"

enum { FIRST = 0x21, GLYPHS = 400, CHANGED = 60, CUTS = 40 };

static uint32_t seed = 99;

static size_t next_random(size_t below) {
    seed = seed * 1664525u + 1013904223u;
    return (seed >> 8) % below;
}

/* ---- one table ----------------------------------------------------------------------------------------- */

static mt_font *open_with(const char *name, uint32_t tag, mt_bytes table) {
    mt_font *font;
    char *path = mt_sample_path(&arena, directory, name);
    mt_test_save_blank(path, 1000, FIRST, GLYPHS, tag, table, &arena);
    mt_assert_ok(mt_font_open(path, &font));
    return font;
}

/* Positions of the two, at one place and varying; none where the lookups have no end. */
static void write_positions(mt_font *a, mt_font *b, mt_arena *scratch) {
    mt_charset charset;
    mt_positions *positions;
    mt_bytes gpos, gdef, none = {0};
    mt_kerning kerning;
    mt_assert_ok(mt_charset_make(a, b, &(mt_charset_request){0}, scratch, &charset));
    mt_status status = mt_test_positions((mt_font *[]){a, b}, &charset, 2, 1000, scratch, &positions);
    if (status == MT_ENDLESS_LOOKUPS) return;
    mt_assert_ok(status);
    status = mt_positions_write(positions, mt_font_at_t(0.5), scratch, &gpos);
    assert_true(status == MT_OK || status == MT_TOO_LARGE);
    status = mt_test_write_varying(positions, 2, none, scratch, &gpos, &gdef);
    assert_true(status == MT_OK || status == MT_TOO_LARGE);
    mt_assert_ok(mt_positions_kerning(positions, mt_font_at_t(0.5), scratch, &kerning));
}

/* Blends a font that has the table with one that has another, both ways round. */
static void blend_with(uint32_t tag, mt_bytes table, mt_font *other) {
    mt_font *font = open_with("malformed.ttf", tag, table);
    for (int k = 0; k < 2; k++) {
        mt_arena scratch = {0};
        write_positions(k ? other : font, k ? font : other, &scratch);
        mt_arena_release(&scratch);
    }
    mt_font_close(font);
}

/* The table cut short at places, and with bytes changed at random: most to what offsets and counts are made of. */
static void torment(uint32_t tag, mt_bytes table, mt_font *other) {
    static const uint8_t values[] = {0, 1, 2, 0x7F, 0x80, 0xFF};
    uint8_t *bytes = mt_test_new(table.length, 1);
    for (int i = 0; i < CUTS; i++) {
        size_t length = i < 16 ? (size_t)i + 1 : next_random(table.length) + 1;
        blend_with(tag, (mt_bytes){table.bytes, length}, other);
    }
    for (int i = 0; i < CHANGED; i++) {
        size_t changes = 1 + next_random(12), within = i % 2                ? table.length
                                                       : table.length < 600 ? table.length
                                                                            : 600;
        memcpy(bytes, table.bytes, table.length);
        for (size_t k = 0; k < changes; k++) bytes[next_random(within)] = values[next_random(sizeof values)];
        blend_with(tag, (mt_bytes){bytes, table.length}, other);
    }
    free(bytes);
}

static void torment_table_of(const char *path, uint32_t tag) {
    mt_bytes table, none = {0};
    mt_font *source = mt_test_font(path), *plain = open_with("plain.ttf", 0, none);
    mt_assert_ok(mt_font_table(source, tag, &arena, &table));
    assert_true(table.length > 0);
    mt_font *whole = open_with("whole.ttf", tag, table);
    torment(tag, table, plain);
    torment(tag, table, whole);
    mt_font_close(source);
    mt_font_close(plain);
    mt_font_close(whole);
}

/* ---- tests --------------------------------------------------------------------------------------------- */

static void positions(void **state) {
    (void)state;
    torment_table_of(MT_TEST_SERIF, MT_TAG('G', 'P', 'O', 'S'));
    torment_table_of(INTER, MT_TAG('G', 'P', 'O', 'S'));
}

static void old_kerning(void **state) {
    (void)state;
    torment_table_of(MT_TEST_SERIF, MT_TAG('k', 'e', 'r', 'n'));
}

/* A table all of whose offsets lead back to places in itself. */
static void loops(void **state) {
    (void)state;
    enum { LENGTH = 60000 };
    mt_bytes none = {0};
    mt_font *plain = open_with("plain.ttf", 0, none);
    uint8_t *bytes = mt_test_new(LENGTH, 1);
    clock_t start = clock();
    for (int step = 1; step <= 12; step++) {
        for (size_t i = 0; i + 1 < LENGTH; i += 2) bytes[i] = 0, bytes[i + 1] = (uint8_t)step;
        blend_with(MT_TAG('G', 'P', 'O', 'S'), (mt_bytes){bytes, LENGTH}, plain);
        bytes[2] = 0, bytes[3] = 0; /* version 1.0 */
        bytes[1] = 1;
        blend_with(MT_TAG('G', 'P', 'O', 'S'), (mt_bytes){bytes, LENGTH}, plain);
        bytes[1] = 0, bytes[2] = 0xFF, bytes[3] = 0xFF;
        blend_with(MT_TAG('k', 'e', 'r', 'n'), (mt_bytes){bytes, LENGTH}, plain);
    }
    assert_true(clock() - start < 60 * CLOCKS_PER_SEC);
    free(bytes);
    mt_font_close(plain);
}

/* A PairPosFormat1 of all pairs of all glyphs, all left ones sharing a set. */
static mt_bytes all_pairs(void) {
    mt_table table = {0};
    uint16_t glyphs[GLYPHS];
    mt_bytes bytes;
    const int head[] = {1, 10 + 2 * GLYPHS, 4, 0, GLYPHS};
    for (int i = 0; i < GLYPHS; i++) glyphs[i] = (uint16_t)(i + 1);
    for (int i = 0; i < 5; i++) mt_table_16(&table, head[i]);
    for (int i = 0; i < GLYPHS; i++) mt_table_16(&table, 10 + 2 * GLYPHS + 10);
    mt_table_coverage(&table, glyphs, GLYPHS);
    mt_table_16(&table, GLYPHS);
    for (int i = 0; i < GLYPHS; i++) {
        mt_table_16(&table, glyphs[i]);
        mt_table_16(&table, i - 50);
    }
    mt_assert_ok(mt_table_keep(&table, &arena, &bytes));
    return bytes;
}

/* Each of many languages has a choice of its own of many lookups that are all that and as costly as can be. */
static void costs_are_bounded(void **state) {
    (void)state;
    enum { LANGUAGES = 80, LOOKUPS = 100, SUBTABLES = 10 };
    mt_shared_system list[LANGUAGES];
    mt_systems systems = {LANGUAGES, list};
    mt_bytes subtables[SUBTABLES], gpos, none = {0};
    mt_lookup_builders made = {0};
    for (int i = 0; i < LANGUAGES; i++)
        list[i] = (mt_shared_system){
            MT_TAG('l', 'a', 't', 'n'), i ? MT_TAG('A', 'A', 'A', 'A') + (uint32_t)i : 0, {0}, 0};
    for (int i = 0; i < SUBTABLES; i++) subtables[i] = all_pairs();
    for (int i = 0; i < LOOKUPS; i++) {
        mt_member *members = mt_arena_new(&arena, LANGUAGES, sizeof *members);
        mt_lookup_builder lookup = {.type = 2,
                                    .mark_set = -1,
                                    .members = members,
                                    .subtable_count = SUBTABLES,
                                    .subtables = subtables};
        assert_non_null(members);
        for (int s = 0; s < LANGUAGES; s++)
            if (next_random(2)) members[lookup.member_count++] = (mt_member){s, MT_TAG('k', 'e', 'r', 'n')};
        mt_assert_ok(mt_lookup_builders_add(&made, &lookup, &arena));
    }
    mt_assert_ok(mt_gpos_write(&systems, &made, &arena, &gpos));
    mt_font *plain = open_with("plain.ttf", 0, none);
    clock_t start = clock();
    blend_with(MT_TAG('G', 'P', 'O', 'S'), gpos, plain);
    assert_true(clock() - start < 60 * CLOCKS_PER_SEC);
    mt_font_close(plain);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(positions),
        cmocka_unit_test(old_kerning),
        cmocka_unit_test(loops),
        cmocka_unit_test(costs_are_bounded),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
