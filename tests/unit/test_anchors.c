/* The anchors of blends, shaped by HarfBuzz and compared with what it makes of the sources. */
#include "blend/metadata.h"
#include "gpos/positions.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/fonts.h"
#include "support/gpos.h"
#include "support/shaping.h"

#include <hb-ot.h>
#include <math.h>

#define INTER "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf"
#define SANS "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"

/* Two anchors are rounded, each by half a unit at most; the rest is for what HarfBuzz rounds to 1/64. */
#define WITHIN (1 + 1.0 / 16)

static const uint32_t letters[] = U"aeouAEOUinrszdxyIαεηωουΑΩаеоуиАЕОУ";
static const int letter_count = sizeof letters / sizeof *letters - 1;
static const uint32_t accents[] = {0x300, 0x301, 0x302, 0x303, 0x304, 0x306, 0x307, 0x308, 0x309,
                                   0x30A, 0x30B, 0x30C, 0x323, 0x324, 0x327, 0x328, 0x331};
static const int accent_count = sizeof accents / sizeof *accents;

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* ---- a blend ------------------------------------------------------------------------------------------- */

/* A source: as this program opens it, and as HarfBuzz does. */
typedef struct mt_end {
    mt_font *font;
    hb_font_t *shaping;
    double scale;
} mt_end;

typedef struct mt_pair {
    mt_end a, b;
    int units;
    mt_charset charset;
    mt_positions *positions;
} mt_pair;

/* Skips the test when the file is not there. `spec` names the same place on the weight axis as `weight`; 0
 * for none. */
static mt_end open_end(const char *path, const char *spec, float weight) {
    mt_end end = {0};
    mt_font_close(mt_test_font(path));
    mt_assert_ok(mt_font_open(spec, &end.font));
    end.shaping = mt_shaping_open(path, weight);
    return end;
}

static mt_pair prepare(mt_end a, mt_end b) {
    mt_pair pair = {.a = a, .b = b, .units = mt_metadata_units(a.font, b.font)};
    pair.a.scale = (double)pair.units / mt_font_units_per_em(a.font);
    pair.b.scale = (double)pair.units / mt_font_units_per_em(b.font);
    mt_assert_ok(mt_charset_make(a.font, b.font, &(mt_charset_request){0}, &arena, &pair.charset));
    mt_font *fonts[] = {a.font, b.font};
    mt_assert_ok(mt_test_positions(fonts, &pair.charset, 2, pair.units, &arena, &pair.positions));
    return pair;
}

static void close_pair(mt_pair *pair) {
    mt_end *ends[] = {&pair->a, &pair->b};
    for (int i = 0; i < 2; i++) {
        hb_font_destroy(ends[i]->shaping);
        mt_font_close(ends[i]->font);
    }
}

/* The font at t, of blank glyphs. */
static hb_font_t *font_at(const mt_pair *pair, double t) {
    int count = pair->charset.glyph_count;
    uint16_t *advances = mt_arena_new(&arena, (size_t)count, sizeof *advances);
    uint16_t *classes = mt_arena_new(&arena, (size_t)count, sizeof *classes);
    mt_bytes gpos;
    assert_true(advances && classes);
    for (int i = 0; i < count; i++) {
        uint32_t glyph = pair->charset.glyphs[i].a;
        advances[i] = (uint16_t)(500 + glyph % 7);
        classes[i] =
            (uint16_t)hb_ot_layout_get_glyph_class(hb_font_get_face(pair->a.shaping), (hb_codepoint_t)glyph);
    }
    mt_assert_ok(mt_positions_write(pair->positions, mt_font_at_t(t), &arena, &gpos));
    mt_bytes gdef = mt_test_gdef(classes, count, &arena);
    mt_bytes font =
        mt_test_layout_font(&pair->charset, pair->units, advances, gdef, gpos, (mt_test_varying){0}, &arena);
    return mt_shaping_font(font.bytes, font.length);
}

/* ---- comparing ----------------------------------------------------------------------------------------- */

/* How many glyphs were found attached: to a letter or to another mark by both, by A alone; not by A. */
typedef struct mt_tally {
    int to_letter, to_mark, only_a, neither;
} mt_tally;

static bool all_mapped(const mt_pair *pair, const uint32_t *text, int count) {
    for (int i = 0; i < count; i++)
        if (!mt_font_glyph(pair->a.font, text[i]) || !mt_font_glyph(pair->b.font, text[i])) return false;
    return true;
}

static void assert_near(double got, double wanted, const uint32_t *text, int count) {
    if (fabs(got - wanted) <= WITHIN) return;
    for (int i = 0; i < count; i++) print_error("U+%04X ", (unsigned)text[i]);
    fail_msg("%g instead of %g", got, wanted);
}

/* The last glyph's place, seen from that of the glyph it is attached to. */
static void offset_of(const mt_shaped *shaped, double scale, double *x, double *y) {
    int last = shaped->count - 1, to = shaped->attached_to[last];
    *x = scale * (shaped->x[last] - shaped->x[to]);
    *y = scale * (shaped->y[last] - shaped->y[to]);
}

static void compare(const mt_pair *pair, hb_font_t *made, double t, hb_script_t script, const uint32_t *text,
                    int count, mt_tally *tally) {
    if (!all_mapped(pair, text, count)) return;
    int last = count - 1;
    double ax, ay, bx = 0, by = 0, x, y;
    mt_shaped a = mt_shape_text(pair->a.shaping, script, text, count);
    mt_shaped b = mt_shape_text(pair->b.shaping, script, text, count);
    mt_shaped m = mt_shape_text(made, script, text, count);
    assert_int_equal(m.attached_to[last], a.attached_to[last]);
    bool both = a.attached_to[last] >= 0 && a.attached_to[last] == b.attached_to[last];
    tally->to_letter += both && a.attached_to[last] == 0;
    tally->to_mark += both && a.attached_to[last] > 0;
    tally->only_a += !both && a.attached_to[last] >= 0;
    tally->neither += a.attached_to[last] < 0;
    if (a.attached_to[last] < 0 || (!both && t > 0)) return;
    offset_of(&a, pair->a.scale, &ax, &ay);
    offset_of(&m, 1, &x, &y);
    if (t > 0) offset_of(&b, pair->b.scale, &bx, &by);
    assert_near(x, t > 0 ? (1 - t) * ax + t * bx : ax, text, count);
    assert_near(y, t > 0 ? (1 - t) * ay + t * by : ay, text, count);
}

static const double places[] = {0, 0.25, 0.6, 1};

/* All letters with all accents, at all places. */
static mt_tally compare_accents(const mt_pair *pair) {
    mt_tally tally = {0};
    for (int p = 0; p < 4; p++) {
        hb_font_t *made = font_at(pair, places[p]);
        for (int i = 0; i < letter_count; i++)
            for (int k = 0; k < accent_count; k++) {
                uint32_t text[] = {letters[i], accents[k]};
                compare(pair, made, places[p], HB_SCRIPT_LATIN, text, 2, &tally);
            }
        hb_font_destroy(made);
    }
    return tally;
}

static void letters_with_accents(void **state) {
    (void)state;
    mt_pair pair =
        prepare(open_end(MT_TEST_SANS, MT_TEST_SANS, 0), open_end(MT_TEST_SERIF, MT_TEST_SERIF, 0));
    mt_tally tally = compare_accents(&pair);
    assert_true(tally.to_letter > 1000 && tally.only_a > 100 && tally.neither > 100);
    close_pair(&pair);
}

/* A's marks are of two classes, B's lie in six subtables. */
static void the_other_way_round(void **state) {
    (void)state;
    mt_pair pair =
        prepare(open_end(MT_TEST_SERIF, MT_TEST_SERIF, 0), open_end(MT_TEST_SANS, MT_TEST_SANS, 0));
    mt_tally tally = compare_accents(&pair);
    assert_true(tally.to_letter > 1000 && tally.neither > 100);
    close_pair(&pair);
}

static void variable_source(void **state) {
    (void)state;
    mt_pair pair = prepare(open_end(INTER, INTER "@wght=650", 650), open_end(SANS, SANS, 0));
    mt_tally tally = compare_accents(&pair);
    assert_true(tally.to_letter > 200 && tally.neither > 1000);
    close_pair(&pair);
}

static void stacked_accents(void **state) {
    (void)state;
    mt_tally tally = {0};
    mt_pair pair =
        prepare(open_end(MT_TEST_SANS, MT_TEST_SANS, 0), open_end(MT_TEST_SERIF, MT_TEST_SERIF, 0));
    for (int p = 0; p < 4; p++) {
        hb_font_t *made = font_at(&pair, places[p]);
        for (int i = 0; i < accent_count; i++)
            for (int k = 0; k < accent_count; k++) {
                uint32_t text[] = {' ', accents[i], accents[k]};
                compare(&pair, made, places[p], HB_SCRIPT_LATIN, text, 3, &tally);
            }
        hb_font_destroy(made);
    }
    assert_true(tally.to_mark > 500);
    close_pair(&pair);
}

static void arabic_marks(void **state) {
    (void)state;
    mt_tally tally = {0};
    mt_pair pair = prepare(open_end(SANS, SANS, 0), open_end(MT_TEST_SANS, MT_TEST_SANS, 0));
    for (int p = 0; p < 4; p++) {
        hb_font_t *made = font_at(&pair, places[p]);
        for (uint32_t letter = 0x621; letter <= 0x655; letter++) /* and marks */
            for (uint32_t mark = 0x64B; mark <= 0x655; mark++) {
                uint32_t text[] = {letter, mark}, stacked[] = {' ', letter, mark};
                compare(&pair, made, places[p], HB_SCRIPT_ARABIC, text, 2, &tally);
                compare(&pair, made, places[p], HB_SCRIPT_ARABIC, stacked, 3, &tally);
            }
        hb_font_destroy(made);
    }
    assert_true(tally.to_letter > 1000 && tally.to_mark > 100);
    close_pair(&pair);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_teardown(letters_with_accents, tear_down),
        cmocka_unit_test_teardown(the_other_way_round, tear_down),
        cmocka_unit_test_teardown(variable_source, tear_down),
        cmocka_unit_test_teardown(stacked_accents, tear_down),
        cmocka_unit_test_teardown(arabic_marks, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
