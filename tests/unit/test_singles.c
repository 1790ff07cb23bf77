/* Single adjustment of fonts made for the test: mixed where both have the feature, A's own where only A has. */
#include "gpos/gpos.h"
#include "layout/value.h"
#include "sfnt/sfnt.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"

enum { FIRST = 0xE000, GLYPHS = 60, X_ADVANCE = 4, X_BOTH = 5, CPSP = MT_TAG('c', 'p', 's', 'p') };

/* ---- sources ------------------------------------------------------------------------------------------- */

static void write_glyphs(mt_table *table, int from, int end) {
    uint16_t glyphs[GLYPHS];
    for (int g = from; g < end; g++) glyphs[g - from] = (uint16_t)g;
    mt_table_coverage(table, glyphs, end - from);
}

static mt_bytes kept(mt_table *table) {
    mt_bytes bytes;
    mt_assert_ok(mt_table_keep(table, &arena, &bytes));
    return bytes;
}

/* SinglePosFormat1: the glyphs from … end - 1 get `more` advance, and half of it as placement. */
static mt_bytes shared_value(int from, int end, int more) {
    const int head[] = {1, 10, X_BOTH, more / 2, more};
    mt_table table = {0};
    for (int i = 0; i < 5; i++) mt_table_16(&table, head[i]);
    write_glyphs(&table, from, end);
    return kept(&table);
}

/* SinglePosFormat2: each glyph gets `step` more than the one before. */
static mt_bytes own_values(int from, int end, int step) {
    const int head[] = {2, 8 + 2 * (end - from), X_ADVANCE, end - from};
    mt_table table = {0};
    for (int i = 0; i < 4; i++) mt_table_16(&table, head[i]);
    for (int g = from; g < end; g++) mt_table_16(&table, step * (g - from + 1));
    write_glyphs(&table, from, end);
    return kept(&table);
}

static mt_test_end end_of(const char *name, int units, uint32_t feature, const mt_bytes *subtables,
                          int count) {
    char *path = mt_sample_path(&arena, directory, name);
    mt_bytes gpos = {0};
    if (count) gpos = mt_test_one_lookup(MT_TAG('D', 'F', 'L', 'T'), feature, 1, subtables, count, &arena);
    mt_test_save_blank(path, units, FIRST, GLYPHS, MT_TAG('G', 'P', 'O', 'S'), gpos, &arena);
    return mt_test_open_end(path, path, 0);
}

static mt_test_end first_source(void) {
    mt_bytes subtables[] = {shared_value(1, 21, 120), own_values(15, 31, -7)};
    return end_of("a.ttf", 1000, CPSP, subtables, 2);
}

/* ---- tests --------------------------------------------------------------------------------------------- */

static void switch_on(mt_test_place *place, uint32_t feature) {
    place->feature = (hb_feature_t){feature, 1, HB_FEATURE_GLOBAL_START, HB_FEATURE_GLOBAL_END};
}

static void mixed_where_both_have_it(void **state) {
    (void)state;
    mt_bytes in_b[] = {own_values(5, 25, 11), shared_value(1, 51, -60)};
    mt_test_blend blend = mt_test_blend_of(first_source(), end_of("b.ttf", 2048, CPSP, in_b, 2), &arena);
    for (int i = 0; i <= 4; i++) {
        mt_test_place place = mt_test_place_at(&blend, i / 4.0);
        switch_on(&place, CPSP);
        for (uint32_t g = 0; g < GLYPHS; g++) {
            uint32_t text[] = {FIRST + g};
            mt_test_compare(&place, text, 1);
        }
        assert_in_range(place.kerned, i == 0 ? 30 : 45, 50);
        mt_test_place_close(&place);
    }
    mt_test_blend_close(&blend);
}

/* The width of one glyph of the blend, in its units. */
static double width_at(const mt_test_place *place, uint32_t character) {
    int scale, y;
    hb_font_get_scale(place->font, &scale, &y);
    hb_buffer_clear_contents(place->buffer);
    hb_buffer_add_codepoints(place->buffer, &character, 1, 0, 1);
    hb_buffer_guess_segment_properties(place->buffer);
    hb_shape(place->font, place->buffer, &place->feature, 1);
    unsigned count;
    const hb_glyph_position_t *positions = hb_buffer_get_glyph_positions(place->buffer, &count);
    return positions[0].x_advance * (double)place->blend->units / scale;
}

static void a_alone_keeps_its_own(void **state) {
    (void)state;
    mt_test_blend blend = mt_test_blend_of(first_source(), end_of("b.ttf", 2000, CPSP, NULL, 0), &arena);
    assert_int_equal(blend.units, 2000);
    mt_test_place place = mt_test_place_at(&blend, 0.75);
    switch_on(&place, CPSP);
    double plain = (0.25 * 2 + 0.75) * 500;
    assert_float_equal(width_at(&place, FIRST), plain + 240, 0.01);
    assert_float_equal(width_at(&place, FIRST + 29), plain - 2 * 7 * 16, 0.01);
    assert_float_equal(width_at(&place, FIRST + 31), plain, 0.01);
    mt_test_place_close(&place);
    mt_test_blend_close(&blend);
}

static void what_only_b_has_is_left_out(void **state) {
    (void)state;
    mt_test_blend blend = mt_test_blend_of(end_of("b.ttf", 2000, CPSP, NULL, 0), first_source(), &arena);
    mt_test_place place = mt_test_place_at(&blend, 0.75);
    assert_int_equal(place.gpos_length, 0);
    mt_test_place_close(&place);
    mt_test_blend_close(&blend);
}

/* cpsp, which no text has by default, but where it is required. */
static void required_as_in_the_first(void **state) {
    (void)state;
    mt_bytes gpos, own = shared_value(1, 21, 120);
    mt_member member = {0, CPSP};
    mt_shared_system system = {MT_TAG('D', 'F', 'L', 'T'), MT_LANGUAGE_DEFAULT, {-1, -1}, CPSP};
    mt_systems systems = {1, &system};
    mt_lookup_builder lookup = {.type = 1,
                                .mark_set = -1,
                                .member_count = 1,
                                .members = &member,
                                .subtable_count = 1,
                                .subtables = &own};
    mt_lookup_builders made = {1, 1, &lookup};
    char *path = mt_sample_path(&arena, directory, "required.ttf");
    mt_assert_ok(mt_gpos_write(&systems, &made, &arena, &gpos));
    mt_test_save_blank(path, 1000, FIRST, GLYPHS, MT_TAG('G', 'P', 'O', 'S'), gpos, &arena);
    mt_test_blend blend =
        mt_test_blend_of(mt_test_open_end(path, path, 0), end_of("b.ttf", 1000, CPSP, NULL, 0), &arena);
    mt_test_place place = mt_test_place_at(&blend, 0.5);
    place.feature = (hb_feature_t){MT_TAG('k', 'e', 'r', 'n'), 1, 0, 1};
    assert_float_equal(width_at(&place, FIRST), 500 + 120, 0.01);
    assert_float_equal(width_at(&place, FIRST + 31), 500, 0.01);
    mt_test_place_close(&place);
    mt_test_blend_close(&blend);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mixed_where_both_have_it),
        cmocka_unit_test(a_alone_keeps_its_own),
        cmocka_unit_test(what_only_b_has_is_left_out),
        cmocka_unit_test(required_as_in_the_first),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
