/* The anchors of blends, shaped by HarfBuzz and compared with what it makes of the sources. */
#include "font/recipe.h"
#include "font/sfnt.h"
#include "layout/anchor.h"
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

static int set_up(void **state) {
    (void)state;
    return 0;
}

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
    mt_layout layout;
    mt_variations variations;
} mt_end;

typedef struct mt_pair {
    mt_end a, b;
    int units;
    mt_charset charset;
    mt_systems systems;
    mt_anchors anchors;
} mt_pair;

/* Skips the test when the file is not there. `spec` names the same place on the weight axis as `weight`; 0 for none. */
static mt_end open_end(const char *path, const char *spec, float weight) {
    mt_end end = {0};
    mt_bytes gpos, gdef;
    const int32_t *place;
    mt_font_close(mt_test_font(path));
    mt_assert_ok(mt_font_open(spec, &end.font));
    end.shaping = mt_shaping_open(path, weight);
    int axes = mt_font_place(end.font, &place);
    mt_assert_ok(mt_font_table(end.font, MT_TAG('G', 'P', 'O', 'S'), &arena, &gpos));
    mt_assert_ok(mt_font_table(end.font, MT_TAG('G', 'D', 'E', 'F'), &arena, &gdef));
    mt_assert_ok(mt_layout_open(gpos, MT_EXTENSION_GPOS, &arena, &end.layout));
    mt_assert_ok(mt_variations_open(gdef, place, axes, &arena, &end.variations));
    return end;
}

static void close_end(mt_end *end) {
    hb_font_destroy(end->shaping);
    mt_font_close(end->font);
}

static mt_pair prepare(mt_end a, mt_end b) {
    mt_pair pair = {.a = a, .b = b, .units = mt_recipe_units(a.font, b.font)};
    pair.a.scale = (double)pair.units / mt_font_units(a.font);
    pair.b.scale = (double)pair.units / mt_font_units(b.font);
    mt_anchor_source in_a = {a.font, &pair.a.layout, &pair.a.variations};
    mt_anchor_source in_b = {b.font, &pair.b.layout, &pair.b.variations};
    mt_assert_ok(mt_charset_make(a.font, b.font, &(mt_charset_request){0}, &arena, &pair.charset));
    mt_assert_ok(mt_systems_make(&pair.a.layout, &pair.b.layout, &arena, &pair.systems));
    mt_assert_ok(
        mt_anchors_prepare(&in_a, &in_b, &pair.systems, &pair.charset, pair.units, &arena, &pair.anchors));
    return pair;
}

static void close_pair(mt_pair *pair) {
    close_end(&pair->a);
    close_end(&pair->b);
}

/* The font at t, of blank glyphs. */
static hb_font_t *font_at(const mt_pair *pair, double t) {
    int count = pair->charset.glyph_count;
    uint16_t *advances = mt_arena_new(&arena, (size_t)count, sizeof *advances);
    uint16_t *classes = mt_arena_new(&arena, (size_t)count, sizeof *classes);
    mt_made_lookups made = {0};
    assert_true(advances && classes);
    for (int i = 0; i < count; i++) {
        uint32_t glyph = pair->charset.glyphs[i].a;
        advances[i] = (uint16_t)(500 + glyph % 7);
        classes[i] =
            (uint16_t)hb_ot_layout_get_glyph_class(hb_font_get_face(pair->a.shaping), (hb_codepoint_t)glyph);
    }
    mt_assert_ok(mt_anchors_write(&pair->anchors, t, &arena, &made));
    mt_bytes font = mt_test_layout_font(&pair->charset, pair->units, advances, classes,
                                        mt_test_gpos(&made, &arena), &arena);
    return mt_shaping_font(font.bytes, font.length);
}

/* ---- comparing ----------------------------------------------------------------------------------------- */

typedef struct mt_tally {
    int both, only_a, neither;
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
    double ax, ay, bx, by, x, y;
    mt_shaped a = mt_shape_text(pair->a.shaping, script, text, count);
    mt_shaped b = mt_shape_text(pair->b.shaping, script, text, count);
    mt_shaped m = mt_shape_text(made, script, text, count);
    assert_int_equal(m.attached_to[last], a.attached_to[last]);
    bool both = a.attached_to[last] >= 0 && a.attached_to[last] == b.attached_to[last];
    tally->both += both;
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
    print_message("both %d only %d neither %d\n", tally.both, tally.only_a, tally.neither);
    close_pair(&pair);
}

static void variable_source(void **state) {
    (void)state;
    mt_pair pair = prepare(open_end(INTER, INTER "@wght=650", 650), open_end(SANS, SANS, 0));
    mt_tally tally = compare_accents(&pair);
    print_message("both %d only %d neither %d\n", tally.both, tally.only_a, tally.neither);
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
                uint32_t text[] = {'a', accents[i], accents[k]};
                compare(&pair, made, places[p], HB_SCRIPT_LATIN, text, 3, &tally);
            }
        hb_font_destroy(made);
    }
    print_message("both %d only %d neither %d\n", tally.both, tally.only_a, tally.neither);
    close_pair(&pair);
}

static void arabic_marks(void **state) {
    (void)state;
    mt_tally tally = {0};
    mt_pair pair = prepare(open_end(SANS, SANS, 0), open_end(MT_TEST_SANS, MT_TEST_SANS, 0));
    for (int p = 0; p < 4; p++) {
        hb_font_t *made = font_at(&pair, places[p]);
        for (uint32_t letter = 0x621; letter <= 0x64A; letter++)
            for (uint32_t mark = 0x64B; mark <= 0x655; mark++) {
                uint32_t text[] = {letter, mark, 0x64E};
                compare(&pair, made, places[p], HB_SCRIPT_ARABIC, text, 2, &tally);
                compare(&pair, made, places[p], HB_SCRIPT_ARABIC, text, 3, &tally);
            }
        hb_font_destroy(made);
    }
    print_message("both %d only %d neither %d\n", tally.both, tally.only_a, tally.neither);
    close_pair(&pair);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(letters_with_accents, set_up, tear_down),
        cmocka_unit_test_setup_teardown(variable_source, set_up, tear_down),
        cmocka_unit_test_setup_teardown(stacked_accents, set_up, tear_down),
        cmocka_unit_test_setup_teardown(arabic_marks, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
