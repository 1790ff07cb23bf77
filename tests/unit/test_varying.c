/* HVAR, VVAR and MVAR as HarfBuzz and FreeType read them. */
#include "write/varying.h"

#include <hb-ot.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "geometry/limits.h"
#include "sfnt/sfnt.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/random.h"
#include "support/sample.h"
#include "support/shaping.h"
#include "support/varying.h"
#include "write/write.h"

enum { STOPS_MOST = 4, GLYPHS = 600, UNITS = 1000, FINE = 64 /* of mt_shaping_font */ };

/* ---- a varying font ------------------------------------------------------------------------------------ */

typedef struct varying {
    int stop_count;
    mt_glyf *stops[STOPS_MOST];
    mt_metrics metrics[STOPS_MOST];
    mt_bytes bytes;
    hb_font_t *font;
} varying;

/* Every other glyph is as wide at all stops; the tail of the font is as wide in itself. */
static mt_glyf *random_stop(mt_random *random, const mt_glyf *first) {
    mt_glyf *glyphs = mt_arena_new(&arena, GLYPHS, sizeof *glyphs);
    for (int i = 0; i < GLYPHS; i++) {
        bool same = (i % 2 || i > GLYPHS - 20) && first;
        glyphs[i].advance = same ? first[i].advance : (uint16_t)mt_random_between(random, 0, 1200);
        if (i > GLYPHS - 20) glyphs[i].advance = 700;
        glyphs[i].height = same ? first[i].height : (uint16_t)mt_random_between(random, 800, 1000);
        glyphs[i].origin = 800;
    }
    return glyphs;
}

static double random_figure(mt_random *random) {
    return mt_random_between(random, -900, 1100) + mt_random_unit(random);
}

static mt_metrics random_metrics(mt_random *random) {
    mt_metrics m = {.weight_class = 400, .width_class = 5, .vertical = true};
    double *figures[] = {&m.hhea_ascender,
                         &m.hhea_descender,
                         &m.hhea_line_gap,
                         &m.typo_ascender,
                         &m.typo_descender,
                         &m.typo_line_gap,
                         &m.win_ascent,
                         &m.win_descent,
                         &m.x_height,
                         &m.cap_height,
                         &m.underline_position,
                         &m.underline_thickness,
                         &m.strikeout_position,
                         &m.strikeout_size,
                         &m.subscript_size[0],
                         &m.subscript_size[1],
                         &m.subscript_offset[0],
                         &m.subscript_offset[1],
                         &m.superscript_size[0],
                         &m.superscript_size[1],
                         &m.superscript_offset[0],
                         &m.superscript_offset[1],
                         &m.caret_offset,
                         &m.vhea_ascender,
                         &m.vhea_descender,
                         &m.vhea_line_gap};
    for (size_t i = 0; i < sizeof figures / sizeof *figures; i++) *figures[i] = random_figure(random);
    m.win_ascent = fabs(m.win_ascent);
    m.win_descent = fabs(m.win_descent);
    return m;
}

static void add(mt_font_data *data, uint32_t tag, mt_bytes table) {
    if (table.length) data->extras[data->extra_count++] = (mt_extra_table){tag, table};
}

static void assemble(varying *made) {
    mt_char *chars = mt_arena_new(&arena, GLYPHS, sizeof *chars);
    for (int i = 1; i < GLYPHS; i++) chars[i - 1] = (mt_char){(uint32_t)(0xE000 + i), (uint16_t)i};
    mt_font_data data = {.units = UNITS,
                         .glyph_count = GLYPHS,
                         .glyphs = made->stops[0],
                         .char_count = GLYPHS - 1,
                         .chars = chars,
                         .metrics = made->metrics[0],
                         .family = "Varying",
                         .style = "Regular",
                         .unique_id = "varying"};
    mt_bytes hvar, vvar, mvar;
    const mt_stops stops = mt_stops_even(made->stop_count);
    mt_assert_ok(mt_hvar_write(made->stops, &stops, GLYPHS, &arena, &hvar));
    mt_assert_ok(mt_vvar_write(made->stops, &stops, GLYPHS, &arena, &vvar));
    mt_assert_ok(mt_mvar_write(made->metrics, &stops, &arena, &mvar));
    add(&data, MT_TAG('H', 'V', 'A', 'R'), hvar);
    add(&data, MT_TAG('V', 'V', 'A', 'R'), vvar);
    add(&data, MT_TAG('M', 'V', 'A', 'R'), mvar);
    add(&data, MT_TAG('f', 'v', 'a', 'r'), mt_test_fvar(&arena));
    add(&data, MT_TAG('g', 'v', 'a', 'r'), mt_test_gvar(GLYPHS, &arena));
    uint8_t *bytes;
    mt_assert_ok(mt_font_write(&data, &bytes, &made->bytes.length));
    made->bytes.bytes = bytes;
    made->font = mt_shaping_font(bytes, made->bytes.length);
}

static varying random_font(int stop_count) {
    mt_random random = mt_random_case(stop_count);
    varying made = {.stop_count = stop_count};
    for (int k = 0; k < stop_count; k++) {
        made.stops[k] = random_stop(&random, k ? made.stops[0] : NULL);
        made.metrics[k] = random_metrics(&random);
    }
    mt_varying_lines(made.metrics, stop_count);
    assemble(&made);
    return made;
}

static void close(varying *font) {
    hb_font_destroy(font->font);
    mt_bytes_free((uint8_t *)font->bytes.bytes);
}

/* A value on the straight line between two stops. */
static double between(const double *values, int stop_count, double place) {
    double at = place * (stop_count - 1);
    int stop = at >= stop_count - 1 ? stop_count - 2 : (int)at;
    return values[stop] + (at - stop) * (values[stop + 1] - values[stop]);
}

/* HarfBuzz and FreeType round what varies to whole units; a stop that is no 2.14 number is off by up to half a step,
 * which is worth a tenth of a unit here. */
static void assert_near(double got, double wanted) {
    if (!(fabs(got - wanted) <= 0.6)) fail_msg("%g, not %g", got, wanted);
}

/* ---- advances ------------------------------------------------------------------------------------------ */

static double advance_at(const varying *font, int glyph, bool vertical, double place) {
    double values[STOPS_MOST];
    for (int k = 0; k < font->stop_count; k++)
        values[k] = vertical ? font->stops[k][glyph].height : font->stops[k][glyph].advance;
    return between(values, font->stop_count, place);
}

static void advances_vary(void **state) {
    (void)state;
    for (int stops = 2; stops <= STOPS_MOST; stops++) {
        varying font = random_font(stops);
        for (double place = 0; place <= 1; place += 0.0625) {
            mt_test_place_on_axis(font.font, place);
            for (int i = 0; i < GLYPHS; i++) {
                double across = hb_font_get_glyph_h_advance(font.font, (hb_codepoint_t)i) / (double)FINE;
                double down = hb_font_get_glyph_v_advance(font.font, (hb_codepoint_t)i) / (double)FINE;
                assert_near(across, advance_at(&font, i, false, place));
                assert_near(-down, advance_at(&font, i, true, place));
            }
        }
        close(&font);
    }
}

static void freetype_reads_them_too(void **state) {
    (void)state;
    varying font = random_font(3);
    char *path = mt_sample_path(&arena, directory, "varying.ttf");
    mt_sample_save(path, font.bytes.bytes, font.bytes.length);
    for (int percent = 0; percent <= 100; percent += 25) {
        char spec[400];
        mt_font *opened;
        snprintf(spec, sizeof spec, "%s@MORF=%d", path, percent);
        mt_assert_ok(mt_font_open(spec, &opened));
        for (uint32_t i = 0; i < GLYPHS; i++) {
            double advance;
            mt_assert_ok(mt_font_advance(opened, i, &advance));
            assert_near(advance * UNITS / MT_EM, advance_at(&font, (int)i, false, percent / 100.0));
        }
        mt_font_close(opened);
    }
    close(&font);
}

/* Of a font of 600 glyphs a third or so is shared; one that does not vary has a row and a map of one entry. */
static void tables_are_small(void **state) {
    (void)state;
    mt_random random = mt_random_case(0);
    mt_glyf *same = random_stop(&random, NULL);
    mt_glyf *glyphs[] = {same, same};
    const mt_stops stops = mt_stops_even(2);
    mt_bytes hvar;
    mt_assert_ok(mt_hvar_write(glyphs, &stops, GLYPHS, &arena, &hvar));
    assert_int_equal(hvar.length, 20 + 5 + (8 + 4 + 4 + 6 + 8 + 1));
}

/* ---- figures ------------------------------------------------------------------------------------------- */

static const struct {
    uint32_t tag;
    size_t place;
} figures[] = {
    {HB_TAG('h', 'a', 's', 'c'), offsetof(mt_metrics, typo_ascender)},
    {HB_TAG('h', 'd', 's', 'c'), offsetof(mt_metrics, typo_descender)},
    {HB_TAG('h', 'l', 'g', 'p'), offsetof(mt_metrics, typo_line_gap)},
    {HB_TAG('h', 'c', 'l', 'a'), offsetof(mt_metrics, win_ascent)},
    {HB_TAG('h', 'c', 'l', 'd'), offsetof(mt_metrics, win_descent)},
    {HB_TAG('v', 'a', 's', 'c'), offsetof(mt_metrics, vhea_ascender)},
    {HB_TAG('v', 'd', 's', 'c'), offsetof(mt_metrics, vhea_descender)},
    {HB_TAG('v', 'l', 'g', 'p'), offsetof(mt_metrics, vhea_line_gap)},
    {HB_TAG('h', 'c', 'o', 'f'), offsetof(mt_metrics, caret_offset)},
    {HB_TAG('x', 'h', 'g', 't'), offsetof(mt_metrics, x_height)},
    {HB_TAG('c', 'p', 'h', 't'), offsetof(mt_metrics, cap_height)},
    {HB_TAG('s', 'b', 'x', 's'), offsetof(mt_metrics, subscript_size[0])},
    {HB_TAG('s', 'b', 'y', 's'), offsetof(mt_metrics, subscript_size[1])},
    {HB_TAG('s', 'b', 'x', 'o'), offsetof(mt_metrics, subscript_offset[0])},
    {HB_TAG('s', 'b', 'y', 'o'), offsetof(mt_metrics, subscript_offset[1])},
    {HB_TAG('s', 'p', 'x', 's'), offsetof(mt_metrics, superscript_size[0])},
    {HB_TAG('s', 'p', 'y', 's'), offsetof(mt_metrics, superscript_size[1])},
    {HB_TAG('s', 'p', 'x', 'o'), offsetof(mt_metrics, superscript_offset[0])},
    {HB_TAG('s', 'p', 'y', 'o'), offsetof(mt_metrics, superscript_offset[1])},
    {HB_TAG('s', 't', 'r', 's'), offsetof(mt_metrics, strikeout_size)},
    {HB_TAG('s', 't', 'r', 'o'), offsetof(mt_metrics, strikeout_position)},
    {HB_TAG('u', 'n', 'd', 's'), offsetof(mt_metrics, underline_thickness)},
    {HB_TAG('u', 'n', 'd', 'o'), offsetof(mt_metrics, underline_position)},
};

enum { FIGURE_COUNT = sizeof figures / sizeof *figures };

static double figure_at(const varying *font, int figure, double place) {
    double values[STOPS_MOST];
    for (int k = 0; k < font->stop_count; k++) {
        double value;
        memcpy(&value, (const char *)&font->metrics[k] + figures[figure].place, sizeof value);
        values[k] = floor(value + 0.5);
    }
    return between(values, font->stop_count, place);
}

/* HarfBuzz adds what MVAR has to what it finds in the tables themselves; vhea's descender it makes negative. */
static void figures_vary(void **state) {
    (void)state;
    for (int stops = 2; stops <= STOPS_MOST; stops++) {
        varying font = random_font(stops);
        hb_font_set_scale(font.font, UNITS, UNITS);
        for (double place = 0; place <= 1; place += 0.0625) {
            mt_test_place_on_axis(font.font, place);
            for (int i = 0; i < FIGURE_COUNT; i++) {
                double delta = (double)hb_ot_metrics_get_variation(font.font, figures[i].tag);
                assert_near(figure_at(&font, i, 0) + delta, figure_at(&font, i, place));
            }
        }
        close(&font);
    }
}

/* Whatever lines a reader uses, they are the same: hhea's where a stop used them, OS/2's where it used those. */
static void lines_are_those_in_use(void **state) {
    (void)state;
    mt_metrics stops[] = {
        {.hhea_ascender = 900, .hhea_descender = -300, .hhea_line_gap = 10, .typo_ascender = 700},
        {.hhea_ascender = 950, .typo_ascender = 800, .typo_descender = -200, .use_typo_metrics = true},
    };
    mt_varying_lines(stops, 2);
    static const double wanted[2][3] = {{900, -300, 10}, {800, -200, 0}};
    for (int k = 0; k < 2; k++) {
        assert_true(stops[k].use_typo_metrics);
        assert_true(stops[k].typo_ascender == wanted[k][0] && stops[k].hhea_ascender == wanted[k][0]);
        assert_true(stops[k].typo_descender == wanted[k][1] && stops[k].hhea_descender == wanted[k][1]);
        assert_true(stops[k].typo_line_gap == wanted[k][2] && stops[k].hhea_line_gap == wanted[k][2]);
    }
    varying font = random_font(2);
    hb_font_extents_t extents;
    mt_test_place_on_axis(font.font, 1);
    assert_true(hb_font_get_h_extents(font.font, &extents));
    assert_near(extents.ascender / (double)FINE, fabs(figure_at(&font, 0, 1)));
    close(&font);
}

static void figures_that_stay_are_left_out(void **state) {
    (void)state;
    const mt_stops stops = mt_stops_even(2);
    mt_metrics metrics[2] = {{.x_height = 500, .cap_height = 700}, {.x_height = 500.3, .cap_height = 700}};
    mt_bytes mvar;
    mt_assert_ok(mt_mvar_write(metrics, &stops, &arena, &mvar));
    assert_int_equal(mvar.length, 0);
    metrics[1].vhea_ascender = 400; /* of a font without vertical metrics */
    mt_assert_ok(mt_mvar_write(metrics, &stops, &arena, &mvar));
    assert_int_equal(mvar.length, 0);
    metrics[1].x_height = 501;
    mt_assert_ok(mt_mvar_write(metrics, &stops, &arena, &mvar));
    assert_int_equal(mvar.bytes[9], 1);
    assert_memory_equal(mvar.bytes + 12, "xhgt", 4);
}

/* ---- memory -------------------------------------------------------------------------------------------- */

static void no_memory_is_told(void **state) {
    (void)state;
    varying font = random_font(3);
    const mt_stops stops = mt_stops_even(3);
    bool failed = true;
    for (long first = 0; failed; first++) {
        mt_arena made = {0};
        mt_bytes bytes;
        mt_allocation_watch();
        mt_allocation_fail(first, false);
        mt_status status = mt_hvar_write(font.stops, &stops, GLYPHS, &made, &bytes);
        if (status == MT_OK) status = mt_mvar_write(font.metrics, &stops, &made, &bytes);
        failed = mt_allocation_requests() > first;
        mt_allocation_succeed();
        mt_arena_release(&made);
        assert_int_equal(mt_allocation_live(), 0);
        mt_allocation_unwatch();
        assert_int_equal(status, failed ? MT_NO_MEMORY : MT_OK);
    }
    close(&font);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(advances_vary),          cmocka_unit_test(freetype_reads_them_too),
        cmocka_unit_test(tables_are_small),       cmocka_unit_test(figures_vary),
        cmocka_unit_test(lines_are_those_in_use), cmocka_unit_test(figures_that_stay_are_left_out),
        cmocka_unit_test(no_memory_is_told),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
