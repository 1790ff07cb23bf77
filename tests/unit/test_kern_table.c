/* The old 'kern' table, with bytes made for the test. */
#include "gpos/kerning.h"
#include "sfnt/sfnt.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"

#include <math.h>

enum { FIRST = 0xE000, KERN = MT_TAG('k', 'e', 'r', 'n') };

static mt_test_end blank_end(const char *name, int units, int count, uint32_t tag, mt_bytes table) {
    char *path = mt_sample_path(&arena, directory, name);
    mt_test_save_blank(path, units, FIRST, count, tag, table, &arena);
    return mt_test_open_end(path, path, 0);
}

/* ---- 'kern' -------------------------------------------------------------------------------------------- */

static void write_words(mt_table *table, const int *words, int count) {
    for (int i = 0; i < count; i++) mt_table_16(table, words[i]);
}

/* Version 0: pairs (1, 2), (1, 3), (4, 1); classes of the glyphs 1 … 4 by two; and subtables that are passed over:
 * vertical, across the line, and, if asked for, of minima. */
static mt_bytes kern_table(bool minima) {
    const int head[] = {0, 4 + minima};
    static const int pairs[] = {0, 6 + 8 + 18, 1, 3, 12, 1, 6, 1, 2, -80, 1, 3, 40, 4, 1, -25};
    static const int classed[] = {0, 6 + 8 + 12 + 12 + 8, 0x0201, 4, 14, 26,
                                  38};                /* values from 38 on, 4 bytes a row */
    static const int left[] = {1, 4, 38, 38, 42, 42}; /* 1, 2 | 3, 4 */
    static const int right[] = {1, 4, 0, 2, 0, 2};    /* 1, 3 | 2, 4 */
    static const int values[] = {10, -30, 50, -70};
    static const int vertical[] = {0, 20, 0, 1, 6, 0, 0, 1, 2, 500};
    static const int across[] = {0, 20, 5, 1, 6, 0, 0, 1, 2, 500};
    static const int minimum[] = {0, 20, 3, 1, 6, 0, 0, 1, 2, 500};
    mt_table table = {0};
    write_words(&table, head, 2);
    write_words(&table, vertical, 10);
    write_words(&table, pairs, 16);
    write_words(&table, classed, 7);
    write_words(&table, left, 6);
    write_words(&table, right, 6);
    write_words(&table, values, 4);
    write_words(&table, across, 10);
    if (minima) write_words(&table, minimum, 10);
    mt_bytes bytes;
    mt_assert_ok(mt_table_keep(&table, &arena, &bytes));
    return bytes;
}

static int kern_value(mt_test_place *place, uint32_t left, uint32_t right) {
    mt_kerning kerning;
    int value = 0;
    mt_assert_ok(mt_positions_kerning(place->blend->positions, mt_font_at_t(place->t), &arena, &kerning));
    for (int i = 0; i < kerning.pair_count; i++) {
        mt_kerning_pair pair = kerning.pairs[i];
        const mt_kerning_group *l = &kerning.left[pair.left], *r = &kerning.right[pair.right];
        bool on_left = pair.left_is_glyph && pair.left == left,
             on_right = pair.right_is_glyph && pair.right == right;
        for (int k = 0; !pair.left_is_glyph && k < l->count; k++) on_left |= l->glyphs[k] == left;
        for (int k = 0; !pair.right_is_glyph && k < r->count; k++) on_right |= r->glyphs[k] == right;
        if (on_left && on_right) value = pair.value; /* glyphs come after groups, and go before them */
    }
    return value;
}

/* By hand: what the list has for a pair and what the classes have. */
static int wanted_value(uint32_t l, uint32_t r) {
    static const int listed[4][4] = {{0, -80, 40, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}, {-25, 0, 0, 0}};
    static const int classed[2][2] = {{10, -30}, {50, -70}};
    if (l >= 4) return 0;
    return r < 4 ? listed[l][r] + classed[l / 2][r % 2] : classed[l / 2][0];
}

/* HarfBuzz takes minima for kerning; without them, its widths are compared too. */
static void check_kern_table(bool minima) {
    mt_bytes none = {0};
    mt_test_blend blend = mt_test_blend_of(blank_end("kern.ttf", 1000, 6, KERN, kern_table(minima)),
                                           blank_end("none.ttf", 1000, 6, 0, none), &arena);
    mt_test_place place = mt_test_place_at(&blend, 0.5);
    for (uint32_t l = 0; l < 6; l++)
        for (uint32_t r = 0; r < 6; r++) {
            uint32_t text[] = {FIRST + l, FIRST + r};
            double half = wanted_value(l, r) / 2.0;
            if (!minima) mt_test_compare(&place, text, 2);
            assert_int_equal(kern_value(&place, l + 1, r + 1), (int)floor(half + 0.5));
        }
    mt_test_place_close(&place);
    mt_test_blend_close(&blend);
}

/* Apple's version 1.0: a vertical subtable, passed over, and a list. */
static void apple_tables_are_read(void **state) {
    (void)state;
    static const int words[] = {1, 0,  0, 2, 0, 22, 0x8000, 0, 1, 6, 0,   0, 1, 2, 500,
                                0, 28, 0, 0, 2, 12, 1,      0, 1, 2, -60, 3, 1, 90};
    mt_bytes bytes, none = {0};
    mt_table table = {0};
    write_words(&table, words, sizeof words / sizeof *words);
    mt_assert_ok(mt_table_keep(&table, &arena, &bytes));
    mt_test_blend blend = mt_test_blend_of(blank_end("kern.ttf", 1000, 6, KERN, bytes),
                                           blank_end("none.ttf", 1000, 6, 0, none), &arena);
    mt_test_place place = mt_test_place_at(&blend, 0.5);
    for (uint32_t l = 0; l < 6; l++)
        for (uint32_t r = 0; r < 6; r++) {
            uint32_t text[] = {FIRST + l, FIRST + r};
            mt_test_compare(&place, text, 2);
        }
    assert_int_equal(kern_value(&place, 1, 2), -30);
    assert_int_equal(kern_value(&place, 3, 1), 45);
    assert_int_equal(place.kerned, 2);
    mt_test_place_close(&place);
    mt_test_blend_close(&blend);
}

/* Glyph 1 is A's alone: so are its pairs, at any T. */
static void without_partner_a_kerns_alone(void **state) {
    (void)state;
    mt_bytes none = {0};
    mt_test_blend blend = mt_test_blend_of(blank_end("kern.ttf", 1000, 6, KERN, kern_table(false)),
                                           blank_end("none.ttf", 1000, 6, 0, none), &arena);
    blend.charset.glyphs[1].b = MT_NO_PARTNER;
    mt_test_blend_prepare(&blend);
    mt_test_place place = {.blend = &blend, .t = 0.5};
    for (uint32_t l = 0; l < 6; l++)
        for (uint32_t r = 0; r < 6; r++) {
            double share = l == 0 || r == 0 ? 1 : 0.5;
            assert_int_equal(kern_value(&place, l + 1, r + 1), (int)floor(share * wanted_value(l, r) + 0.5));
        }
    mt_test_blend_close(&blend);
}

static void old_tables_are_read(void **state) {
    (void)state;
    check_kern_table(false);
    check_kern_table(true);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(old_tables_are_read),
        cmocka_unit_test(apple_tables_are_read),
        cmocka_unit_test(without_partner_a_kerns_alone),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
