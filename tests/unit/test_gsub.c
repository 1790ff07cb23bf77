/* Substitutions read, cut down to the glyphs that are kept, and pruned; and what tables that are no such tables do. */
#include "gsub/gsub.h"
#include "gsub/subset.h"

#include <hb.h>
#include <stdio.h>
#include <string.h>

#include "layout/at_place.h"
#include "sfnt/sfnt.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/fonts.h"
#include "support/gsub.h"
#include "support/random.h"
#include "support/sample.h"

static mt_font *open_font(int glyph_count, mt_bytes gsub) {
    return mt_test_gsub_font(mt_sample_path(&arena, directory, "font.ttf"), glyph_count, "a", NULL, gsub,
                             &arena);
}

static const mt_test_lookup lookups[] = {
    {"smcp", NULL, 1, "1 11,2 12,3 13"},  {"ccmp", NULL, 2, "4 1 2,5 3 14"},
    {"salt", NULL, 3, "1 15 16 17,2 18"}, {"liga", NULL, 4, "1 2 3 19,3 1 20"},
    {"calt", NULL, 6, "1 2 3 5"},         {"    ", NULL, 1, "2 21"},
    {"rclt", NULL, 8, "1 6 2 22"},        {"locl", "TRK ", 1, "7 23"},
};
enum { LOOKUPS = sizeof lookups / sizeof *lookups, GLYPHS = 30 };

/* ---- reading ------------------------------------------------------------------------------------------- */

static void assert_glyphs(const mt_gsub *gsub, int lookup, int index, const char *wanted) {
    char text[128] = "";
    const mt_gsub_subtable *subtable = &gsub->lookups[lookup].subtables[0];
    assert_true(index < subtable->count);
    const mt_substitution *s = &subtable->list[index];
    for (int i = 0; i < s->inputs + s->outputs; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "%s%d",
                 i == s->inputs ? " > "
                 : i            ? " "
                                : "",
                 s->glyphs[i]);
    assert_string_equal(text, wanted);
}

static void check_all(const mt_gsub *gsub) {
    assert_int_equal(gsub->layout.lookup_count, LOOKUPS);
    for (int i = 0; i < LOOKUPS; i++) assert_int_equal(gsub->lookups[i].type, lookups[i].type);
    assert_glyphs(gsub, 0, 0, "1 > 11");
    assert_glyphs(gsub, 0, 2, "3 > 13");
    assert_glyphs(gsub, 1, 1, "5 > 3 14");
    assert_glyphs(gsub, 2, 0, "1 > 15 16 17");
    assert_glyphs(gsub, 3, 0, "1 2 3 > 19");
    assert_glyphs(gsub, 3, 1, "3 1 > 20");
    assert_glyphs(gsub, 6, 0, "6 > 22");
    const mt_calls *calls = &gsub->layout.calls;
    assert_int_equal(calls->first[LOOKUPS], 1);
    assert_int_equal(calls->first[4], 0);
    assert_int_equal(calls->first[5], 1);
    assert_int_equal(calls->lookups[0], 5);
    bool marked[LOOKUPS] = {false};
    mt_gsub_mark(gsub, 4, marked);
    for (int i = 0; i < LOOKUPS; i++) assert_int_equal(marked[i], i == 4 || i == 5);
}

static void all_types(void **state) {
    (void)state;
    for (int extended = 0; extended < 2; extended++) {
        mt_gsub gsub;
        mt_font *font = open_font(GLYPHS, mt_test_gsub(lookups, LOOKUPS, extended, &arena));
        mt_assert_ok(mt_gsub_open(font, &arena, &gsub));
        check_all(&gsub);
        mt_font_close(font);
    }
}

/* Substitutions that name glyphs that the font has not. */
static void glyphs_out_of_range(void **state) {
    (void)state;
    mt_gsub gsub;
    mt_font *font = open_font(16, mt_test_gsub(lookups, LOOKUPS, false, &arena));
    mt_assert_ok(mt_gsub_open(font, &arena, &gsub));
    static const int counts[] = {3, 2, 0, 0, 0, 0, 0, 0};
    for (int i = 0; i < LOOKUPS; i++) assert_int_equal(gsub.lookups[i].subtables[0].count, counts[i]);
    mt_font_close(font);
}

/* ---- places on axes ------------------------------------------------------------------------------------ */

/* A table of version 1.1 whose one feature has the lookups 1 and 2 instead of 0 where axis 1 is from 0.5 to 1. */
static mt_bytes varying_table(void) {
    static const uint8_t bytes[] = {
        0, 1, 0,   1,   0,   14,  0, 30, 0, 44, 0,    0,  0,    58,             /* header */
        0, 1, 'l', 'a', 't', 'n', 0, 8,  0, 4,  0,    0,  0,    0,  0xFF, 0xFF, /* scripts: 16 bytes, cut short */
        0, 1, 'r', 'v', 'r', 'n', 0, 8,  0, 99, 0,    1,  0,    0,              /* features */
        0, 3, 0,   8,   0,   8,   0, 8,  0, 1,  0,    0,  0,    0,              /* lookups */
        0, 1, 0,   0,   0,   0,   0, 1,  0, 0,  0,    16, 0,    0,  0,    30, /* feature variations */
        0, 1, 0,   0,   0,   6,   0, 1,  0, 1,  0x20, 0,  0x40, 0,            /* conditions */
        0, 1, 0,   0,   0,   1,   0, 0,  0, 0,  0,    12, 0,    99, 0,    2,    0, 1, 0, 2, /* substitution */
    };
    return (mt_bytes){bytes, sizeof bytes};
}

static void features_at_a_place(void **state) {
    (void)state;
    static const struct {
        int32_t place[2];
        int axes, count, first;
    } cases[] = {{{0, 0}, 2, 1, 0},       {{0, 0x8000}, 2, 2, 1},  {{0, 0x7FF0}, 2, 1, 0},
                 {{0x10000, 0}, 2, 1, 0}, {{0, 0x10000}, 2, 2, 1}, {{0, 0}, 0, 1, 0}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mt_bytes placed;
        mt_assert_ok(mt_layout_place(varying_table(), cases[i].place, cases[i].axes, &arena, &placed));
        mt_bytes features = mt_ot_follow(placed, 6), feature = mt_ot_follow(features, 6);
        assert_int_equal(mt_ot_u32(placed, 0), 0x00010000);
        assert_int_equal(mt_ot_u16(features, 0), 1);
        assert_int_equal(mt_ot_u32(features, 2), MT_TAG('r', 'v', 'r', 'n'));
        assert_int_equal(mt_ot_u16(feature, 0), 0); /* the parameters are gone */
        assert_int_equal(mt_ot_u16(feature, 2), cases[i].count);
        assert_int_equal(mt_ot_u16(feature, 4), cases[i].first);
        assert_int_equal(mt_ot_u16(mt_ot_follow(placed, 8), 0), 3);
        assert_int_equal(mt_ot_u32(mt_ot_follow(placed, 4), 2), MT_TAG('l', 'a', 't', 'n'));
    }
}

/* ---- cutting and pruning ------------------------------------------------------------------------------- */

/* The substitutions of the font pruned to these glyphs, by their old numbers. */
static void prune(const uint16_t *kept, int count, mt_gsub *gsub) {
    mt_layout_tables tables;
    mt_font *font = open_font(GLYPHS, mt_test_gsub(lookups, LOOKUPS, false, &arena));
    mt_assert_ok(mt_gsub_subset(font, kept, count, &arena, &tables));
    mt_font_close(font);
    assert_true(tables.gsub.length > 0);
    assert_int_equal(tables.gdef.length, 0);
    font = open_font(count, tables.gsub);
    mt_assert_ok(mt_gsub_open(font, &arena, gsub));
    mt_font_close(font);
    for (int i = 0; i < gsub->layout.lookup_count; i++)
        for (int k = 0; k < gsub->lookups[i].subtable_count; k++)
            for (int s = 0; s < gsub->lookups[i].subtables[k].count; s++) {
                mt_substitution *one = &gsub->lookups[i].subtables[k].list[s];
                for (int g = 0; g < one->inputs + one->outputs; g++) one->glyphs[g] = kept[one->glyphs[g]];
            }
}

static void all_is_kept(void **state) {
    (void)state;
    uint16_t kept[GLYPHS];
    mt_gsub gsub;
    for (int i = 0; i < GLYPHS; i++) kept[i] = (uint16_t)i;
    prune(kept, GLYPHS, &gsub);
    check_all(&gsub);
}

/* Of 1's alternates 15, 16 and 17 the second is kept: it stays the second, and the third is gone. Of the rest 2 > 12,
 * 4 > 1 2 and 3 1 > 20 have all their glyphs. The context stays, and calls nothing: where it applies, no other does. */
static void what_leads_out_is_struck(void **state) {
    (void)state;
    static const uint16_t kept[] = {0, 1, 2, 3, 4, 5, 6, 12, 16, 20};
    mt_gsub gsub;
    prune(kept, sizeof kept / sizeof *kept, &gsub);
    assert_int_equal(gsub.layout.lookup_count, 5);
    assert_int_equal(gsub.lookups[4].type, MT_GSUB_CHAIN);
    assert_int_equal(gsub.layout.calls.first[5], 0);
    assert_int_equal(gsub.lookups[0].subtables[0].count, 1);
    assert_glyphs(&gsub, 0, 0, "2 > 12");
    assert_int_equal(gsub.lookups[1].subtables[0].count, 1);
    assert_glyphs(&gsub, 1, 0, "4 > 1 2");
    assert_int_equal(gsub.lookups[2].subtables[0].count, 1);
    assert_glyphs(&gsub, 2, 0, "1 > 1 16");
    assert_int_equal(gsub.lookups[3].subtables[0].count, 1);
    assert_glyphs(&gsub, 3, 0, "3 1 > 20");
}

/* A subtable of more than its offsets reach becomes several. */
static void long_tables_are_divided(void **state) {
    (void)state;
    enum { SETS = 2000, LENGTH = 20 };
    static uint16_t glyphs[SETS][LENGTH + 1];
    static mt_substitution list[SETS];
    for (int i = 0; i < SETS; i++) {
        for (int k = 0; k <= LENGTH; k++) glyphs[i][k] = (uint16_t)(k ? i + k : i);
        list[i] = (mt_substitution){glyphs[i], 1, LENGTH};
    }
    mt_gsub_parts parts = {.arena = &arena};
    mt_assert_ok(mt_gsub_write(&parts, MT_GSUB_MULTIPLE, (mt_bytes){0}, list, SETS));
    assert_true(parts.count > 1 && !parts.bytes.failed);
    mt_gsub_reader reader = {&arena, SETS + LENGTH + 1, 1 << 20};
    int read = 0;
    for (int i = 0; i < parts.count; i++) {
        mt_gsub_subtable subtable = {
            .table = {parts.bytes.bytes + parts.list[i].at, parts.bytes.length - parts.list[i].at}};
        mt_assert_ok(mt_gsub_read(&reader, MT_GSUB_MULTIPLE, subtable.table, &subtable));
        for (int k = 0; k < subtable.count; k++, read++) {
            assert_int_equal(subtable.list[k].outputs, LENGTH);
            assert_memory_equal(subtable.list[k].glyphs, glyphs[read], sizeof glyphs[read]);
        }
    }
    assert_int_equal(read, SETS);
    mt_table_free(&parts.bytes);
}

/* ---- damage -------------------------------------------------------------------------------------------- */

/* Bytes of a font's own table changed by chance, and the table cut short: whatever comes of it, nothing is read that is
 * not there, and what comes out is again a table of that many glyphs. */
static void damaged_tables(void **state) {
    (void)state;
    enum { COUNT = 6253, KEPT = 1200 };
    mt_font *font = mt_test_font("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf");
    mt_bytes whole;
    mt_assert_ok(mt_font_table(font, MT_TAG('G', 'S', 'U', 'B'), &arena, &whole));
    mt_font_close(font);
    static uint16_t kept[KEPT];
    for (int i = 0; i < KEPT; i++) kept[i] = (uint16_t)(i * 5);
    int survived = 0;
    for (int number = 0; number < mt_test_cases(60); number++) {
        mt_random random = mt_random_case(number);
        mt_arena own = {0};
        mt_layout_tables tables = {0};
        uint8_t *bytes = mt_arena_new(&own, whole.length, 1);
        assert_non_null(bytes);
        memcpy(bytes, whole.bytes, whole.length);
        size_t length = mt_random_one_in(&random, 4)
                            ? (size_t)mt_random_between(&random, 1, (int)whole.length)
                            : whole.length;
        int changes = mt_random_between(&random, 1, 40), to = (int)length < 4000 ? (int)length : 4000;
        for (int i = 0; i < changes; i++)
            bytes[mt_random_between(&random, 0, i % 2 ? (int)length - 1 : to - 1)] =
                (uint8_t)mt_random_between(&random, 0, 255);
        font = open_font(COUNT, (mt_bytes){bytes, length});
        mt_status status = mt_gsub_subset(font, kept, KEPT, &own, &tables);
        assert_true(status == MT_OK || status == MT_ENDLESS_LOOKUPS);
        mt_font_close(font);
        survived += tables.gsub.length > 0;
        mt_arena_release(&own);
    }
    assert_true(survived > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_types),
        cmocka_unit_test(glyphs_out_of_range),
        cmocka_unit_test(features_at_a_place),
        cmocka_unit_test(all_is_kept),
        cmocka_unit_test(what_leads_out_is_struck),
        cmocka_unit_test(long_tables_are_divided),
        cmocka_unit_test(damaged_tables),
    };
    return cmocka_run_group_tests_name("gsub", tests, mt_test_set_up, mt_test_tear_down);
}
