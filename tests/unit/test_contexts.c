/* Contextual positioning of fonts made for the test, in each format: kept, with what it calls mixed. */
#include "gpos/gpos.h"
#include "sfnt/sfnt.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"

enum { FIRST = 0xE000, GLYPHS = 12, SINGLE = 1, CONTEXT = 7, CHAINED = 8, KERN = MT_TAG('k', 'e', 'r', 'n') };

/* ---- sources ------------------------------------------------------------------------------------------- */

static mt_bytes kept(mt_table *table) {
    mt_bytes bytes;
    mt_assert_ok(mt_table_keep(table, &arena, &bytes));
    return bytes;
}

static void write_words(mt_table *table, const int *words, int count) {
    for (int i = 0; i < count; i++) mt_table_16(table, words[i]);
}

/* A context, and where the number of the lookup that it calls stands. */
typedef struct mt_test_context {
    mt_bytes table;
    size_t call_at;
} mt_test_context;

static mt_test_context context_of(const int *words, int count, int call_at) {
    mt_table table = {0};
    write_words(&table, words, count);
    return (mt_test_context){kept(&table), 2 * (size_t)call_at};
}

/* The glyphs 2, 3: the second of them is positioned. A chained one wants 1 before them and 4 after. */
static mt_test_context context(int type, int format) {
    static const int glyphs[] = {1, 8, 1, 14, 1, 1, 2, 1, 4, 2, 1, 3, 1, 0};
    static const int classes[] = {2, 14, 20, 3, 0, 0, 30, 1, 1, 2, 1, 2, 2, 2, 1, 1, 4, 2, 1, 1, 1, 0};
    static const int lists[] = {3, 2, 1, 14, 20, 1, 0, 1, 1, 2, 1, 1, 3};
    static const int chained_glyphs[] = {1, 8, 1, 14, 1, 1, 2, 1, 4, 1, 1, 2, 3, 1, 4, 1, 1, 0};
    static const int chained_classes[] = {2, 18, 24, 32, 42, 3, 0, 50, 0,        /* header */
                                          1, 1,  2,                              /* coverage */
                                          1, 1,  1,  1,                          /* before */
                                          1, 2,  2,  1,  2,                      /* input */
                                          1, 4,  1,  3,                          /* after */
                                          1, 4,  1,  1,  2,  2, 1, 3,  1, 1, 0}; /* set and rule */
    static const int chained_lists[] = {
        3, 1, 24, 2, 30, 36, 1, 42, 1, 1, 0, 0, /* header, and a word between */
        1, 1, 1,  1, 1,  2,  1, 1,  3, 1, 1, 4};
    if (type == CONTEXT && format == 1) return context_of(glyphs, 14, 13);
    if (type == CONTEXT && format == 2) return context_of(classes, 22, 21);
    if (type == CONTEXT) return context_of(lists, 13, 6);
    if (format == 1) return context_of(chained_glyphs, 18, 17);
    if (format == 2) return context_of(chained_classes, 36, 35);
    return context_of(chained_lists, 24, 10);
}

/* SinglePosFormat1: `more` advance for the glyphs 2 and 3. */
static mt_bytes single(int more) {
    const int words[] = {1, 8, 4, more, 1, 2, 2, 3};
    mt_table table = {0};
    write_words(&table, words, 8);
    return kept(&table);
}

/* A font whose kern feature has one context, which calls a lookup that is in no feature; without a context, for type 0. */
static mt_test_end end_of(const char *name, int units, int type, int format, int more) {
    char *path = mt_sample_path(&arena, directory, name);
    mt_member member = {0, KERN};
    mt_shared_system system = {MT_TAG('D', 'F', 'L', 'T'), MT_LANGUAGE_DEFAULT, {-1, -1}, 0};
    mt_systems systems = {1, &system};
    mt_bytes gpos = {0}, value = single(more);
    mt_test_context made_context = context(type, format);
    mt_lookup_call call = {0, made_context.call_at, 1};
    mt_lookup_builder lookups[] = {
        {.type = SINGLE, .mark_set = -1, .subtable_count = 1, .subtables = &value, .called_as = 1},
        {.order = 1,
         .type = type,
         .mark_set = -1,
         .member_count = 1,
         .members = &member,
         .subtable_count = 1,
         .subtables = &made_context.table,
         .call_count = 1,
         .calls = &call}};
    mt_lookup_builders made = {2, 2, lookups};
    if (type) mt_assert_ok(mt_gpos_write(&systems, &made, &arena, &gpos));
    mt_test_save_blank(path, units, FIRST, GLYPHS, MT_TAG('G', 'P', 'O', 'S'), gpos, &arena);
    return mt_test_open_end(path, path, 0);
}

/* ---- tests --------------------------------------------------------------------------------------------- */

static double width_at(const mt_test_place *place, const uint32_t *text, int length) {
    int scale, y;
    unsigned count;
    double width = 0;
    hb_font_get_scale(place->font, &scale, &y);
    hb_buffer_clear_contents(place->buffer);
    hb_buffer_add_codepoints(place->buffer, text, length, 0, length);
    hb_buffer_guess_segment_properties(place->buffer);
    hb_shape(place->font, place->buffer, NULL, 0);
    const hb_glyph_position_t *positions = hb_buffer_get_glyph_positions(place->buffer, &count);
    for (unsigned i = 0; i < count; i++) width += positions[i].x_advance;
    return width * place->blend->units / scale;
}

/* The glyphs 1 to 4, as characters, and texts in which not all of the context is there. */
static const uint32_t within[] = {FIRST, FIRST + 1, FIRST + 2, FIRST + 3};
static const uint32_t without[][4] = {{FIRST, FIRST + 2, FIRST + 1, FIRST + 3},
                                      {FIRST + 4, FIRST + 1, FIRST + 4, FIRST + 3},
                                      {FIRST, FIRST + 5, FIRST + 2, FIRST + 3}};

static void assert_widths(const mt_test_place *place, double plain, double more) {
    assert_float_equal((float)width_at(place, within, 4), (float)(plain + more), 0.51F);
    for (int i = 0; i < 3; i++)
        assert_float_equal((float)width_at(place, without[i], 4), (float)plain, 0.01F);
}

static void mixed_in_each_format(void **state) {
    (void)state;
    for (int i = 0; i < 6; i++) {
        int type = i < 3 ? CONTEXT : CHAINED, format = 1 + i % 3;
        mt_test_blend blend = mt_test_blend_of(end_of("a.ttf", 1000, type, format, 120),
                                               end_of("b.ttf", 1000, type, format, -80), &arena);
        for (int k = 0; k <= 4; k++) {
            double t = k / 4.0;
            mt_test_place place = mt_test_place_at(&blend, t), varying = mt_test_varying_place_at(&blend, t);
            assert_widths(&place, 2000, 120 - 200 * t);
            assert_widths(&varying, 2000, 120 - 200 * t);
            mt_test_place_close(&varying);
            mt_test_place_close(&place);
        }
        mt_test_blend_close(&blend);
    }
}

/* Formats 1, 2 and 3 of the two fonts need not be the same: what they call is. */
static void mixed_across_formats(void **state) {
    (void)state;
    mt_test_blend blend = mt_test_blend_of(end_of("a.ttf", 1000, CHAINED, 3, 120),
                                           end_of("b.ttf", 2000, CONTEXT, 2, 400), &arena);
    mt_test_place place = mt_test_place_at(&blend, 0.5);
    assert_widths(&place, 3000, 320);
    mt_test_place_close(&place);
    mt_test_blend_close(&blend);
}

/* Where one font alone has contexts, what they do comes or goes on the way to the other. */
static void one_alone(void **state) {
    (void)state;
    for (int format = 1; format <= 3; format++)
        for (int second = 0; second < 2; second++) {
            mt_test_end a = end_of("a.ttf", 1000, second ? 0 : CHAINED, format, 120);
            mt_test_end b = end_of("b.ttf", 2000, second ? CHAINED : 0, format, 240);
            mt_test_blend blend = mt_test_blend_of(a, b, &arena);
            for (int k = 0; k <= 2; k++) {
                double t = k / 2.0, more = second ? 240 * t : 240 * (1 - t);
                mt_test_place place = mt_test_place_at(&blend, t),
                              varying = mt_test_varying_place_at(&blend, t);
                assert_widths(&place, (1 - t) * 4000 + t * 2000, more);
                assert_widths(&varying, (1 - t) * 4000 + t * 2000, more);
                mt_test_place_close(&varying);
                mt_test_place_close(&place);
            }
            mt_test_blend_close(&blend);
        }
}

/* A place of a rule that no glyph is left for: the rule goes, and all that it called. */
static void without_a_glyph_of_it(void **state) {
    (void)state;
    for (int format = 1; format <= 3; format++) {
        mt_test_blend blend = mt_test_blend_of(end_of("a.ttf", 1000, CHAINED, format, 120),
                                               end_of("b.ttf", 1000, CHAINED, format, 120), &arena);
        int count = 0;
        for (int i = 0; i < blend.charset.char_count; i++)
            if (blend.charset.chars[i].code_point != FIRST + 3)
                blend.charset.chars[count++] = blend.charset.chars[i];
        blend.charset.char_count = count;
        for (int i = 0; i < blend.charset.glyph_count; i++)
            if (blend.charset.glyphs[i].code_point == FIRST + 3) blend.charset.glyphs[i].a = GLYPHS;
        mt_test_blend_prepare(&blend);
        mt_bytes gpos;
        mt_assert_ok(mt_positions_write(blend.positions, mt_font_at_t(0), &arena, &gpos));
        assert_int_equal(gpos.length, 0);
        mt_test_blend_close(&blend);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(mixed_in_each_format),
        cmocka_unit_test(mixed_across_formats),
        cmocka_unit_test(one_alone),
        cmocka_unit_test(without_a_glyph_of_it),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
