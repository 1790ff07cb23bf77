/* The kerning of blends: HarfBuzz's advances of the blend are the mix of the two fonts' own. */
#include "font/recipe.h"
#include "font/sfnt.h"
#include "layout/kerning.h"
#include "layout/positions.h"
#include "support/check.h"
#include "support/fonts.h"
#include "support/gpos.h"
#include "support/shaping.h"

#include <hb-ot.h>
#include <math.h>
#include <string.h>

#define INTER "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf"
#define NIMBUS "/usr/share/fonts/opentype/urw-base35/NimbusSans-Regular.otf"
#define PALATINO "/usr/share/fonts/opentype/urw-base35/P052-Roman.otf"

enum { LETTERS = 200, WORDS = 1000, WORD_MAX = 12 };

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
} mt_end;

typedef struct mt_blended {
    mt_end ends[2];
    int units;
    mt_charset charset;
    mt_positions *positions;
    uint32_t letters[LETTERS];
    int letter_count;
} mt_blended;

/* Skips the test when the file is not there. `weight` is the place on the weight axis that the spec names; 0 for none. */
static mt_end open_end(const char *path, const char *spec, float weight) {
    mt_end end = {0};
    mt_font_close(mt_test_font(path));
    mt_assert_ok(mt_font_open(spec, &end.font));
    end.shaping = mt_shaping_open(path, weight);
    return end;
}

/* Latin, Greek and Cyrillic that both fonts have, a third of each as far as there are so many. */
static int choose_letters(const mt_end ends[2], uint32_t *letters) {
    static const uint32_t ranges[][2] = {
        {0x21, 0x7E}, {0xC0, 0xFF}, {0x2018, 0x201E}, {0x386, 0x3CE}, {0x410, 0x45F}};
    static const int most[] = {75, 20, 7, 49, 49};
    int count = 0;
    for (int r = 0; r < 5; r++) {
        int taken = 0;
        for (uint32_t c = ranges[r][0]; c <= ranges[r][1] && taken < most[r]; c++) {
            if (!mt_font_glyph(ends[0].font, c) || !mt_font_glyph(ends[1].font, c)) continue;
            letters[count++] = c;
            taken++;
        }
    }
    return count;
}

static mt_blended prepare(mt_end a, mt_end b) {
    mt_blended blended = {.ends = {a, b}, .units = mt_recipe_units(a.font, b.font)};
    blended.letter_count = choose_letters(blended.ends, blended.letters);
    mt_assert_ok(mt_charset_make(a.font, b.font, NULL, 0, &arena, &blended.charset));
    mt_assert_ok(
        mt_positions_prepare(a.font, b.font, &blended.charset, blended.units, &arena, &blended.positions));
    return blended;
}

static void close_blend(mt_blended *blended) {
    for (int s = 0; s < 2; s++) {
        hb_font_destroy(blended->ends[s].shaping);
        mt_font_close(blended->ends[s].font);
    }
}

/* Units of the new font in one of HarfBuzz's for a source. */
static double scale_of(const mt_blended *blended, int s) {
    int x, y;
    hb_font_get_scale(blended->ends[s].shaping, &x, &y);
    return (double)blended->units / x;
}

/* The font at t, of blank glyphs. */
static hb_font_t *font_at(const mt_blended *blended, double t, size_t *gpos_length) {
    int count = blended->charset.glyph_count;
    uint16_t *advances = mt_arena_new(&arena, (size_t)count, sizeof *advances);
    uint16_t *classes = mt_arena_new(&arena, (size_t)count, sizeof *classes);
    hb_face_t *first = hb_font_get_face(blended->ends[0].shaping);
    assert_true(advances && classes);
    for (int i = 0; i < count; i++) {
        mt_pairing glyph = blended->charset.glyphs[i];
        double a = scale_of(blended, 0) * hb_font_get_glyph_h_advance(blended->ends[0].shaping, glyph.a);
        double b = scale_of(blended, 1) * hb_font_get_glyph_h_advance(blended->ends[1].shaping, glyph.b);
        advances[i] = (uint16_t)floor((1 - t) * a + t * b + 0.5);
        classes[i] = (uint16_t)hb_ot_layout_get_glyph_class(first, glyph.a);
    }
    mt_bytes gpos;
    mt_assert_ok(mt_positions_write(blended->positions, t, &arena, &gpos));
    *gpos_length = gpos.length;
    mt_bytes font = mt_test_layout_font(&blended->charset, blended->units, advances, classes, gpos, &arena);
    return mt_shaping_font(font.bytes, font.length);
}

/* ---- comparing ----------------------------------------------------------------------------------------- */

/* The width of a text, in what the font's scale is in. */
static double width_of(hb_font_t *font, hb_buffer_t *buffer, const uint32_t *text, int length) {
    double width = 0;
    unsigned count;
    hb_buffer_clear_contents(buffer);
    hb_buffer_add_codepoints(buffer, text, length, 0, length);
    hb_buffer_guess_segment_properties(buffer);
    hb_shape(font, buffer, NULL, 0);
    const hb_glyph_position_t *positions = hb_buffer_get_glyph_positions(buffer, &count);
    for (unsigned i = 0; i < count; i++) width += positions[i].x_advance;
    return width;
}

/* What is compared at one T, and what was found. */
typedef struct mt_comparison {
    const mt_blended *blended;
    double t;
    hb_font_t *font;
    hb_buffer_t *buffer;
    double worst; /* difference, units a glyph */
    int kerned;   /* texts that are not as wide as their glyphs */
} mt_comparison;

static double plain_width(const mt_comparison *at, const uint32_t *text, int length) {
    double width = 0;
    for (int i = 0; i < length; i++) {
        hb_codepoint_t glyph;
        assert_true(hb_font_get_nominal_glyph(at->font, text[i], &glyph));
        width += hb_font_get_glyph_h_advance(at->font, glyph);
    }
    return width;
}

static void compare(mt_comparison *at, const uint32_t *text, int length) {
    const mt_blended *blended = at->blended;
    double widths[2];
    int scale, y;
    for (int s = 0; s < 2; s++)
        widths[s] = scale_of(blended, s) * width_of(blended->ends[s].shaping, at->buffer, text, length);
    hb_font_get_scale(at->font, &scale, &y);
    double unit = (double)scale / blended->units, width = width_of(at->font, at->buffer, text, length);
    double wanted = (1 - at->t) * widths[0] + at->t * widths[1];
    double off = fabs(width / unit - wanted) / length;
    at->worst = fmax(at->worst, off);
    at->kerned += width != plain_width(at, text, length);
    if (off <= 1) return;
    for (int i = 0; i < length; i++) print_error("U+%04X ", (unsigned)text[i]);
    fail_msg("%g instead of %g", width / unit, wanted);
}

static void compare_pairs(mt_comparison *at) {
    const mt_blended *blended = at->blended;
    for (int i = 0; i < blended->letter_count; i++)
        for (int k = 0; k < blended->letter_count; k++) {
            uint32_t text[] = {blended->letters[i], blended->letters[k]};
            compare(at, text, 2);
        }
}

/* Words of three to twelve letters, by a generator that is always the same. */
static void compare_words(mt_comparison *at) {
    uint32_t state = 20240501, text[WORD_MAX];
    for (int w = 0; w < WORDS; w++) {
        state = state * 1664525u + 1013904223u;
        int length = 3 + (int)((state >> 16) % (WORD_MAX - 2));
        for (int i = 0; i < length; i++) {
            state = state * 1664525u + 1013904223u;
            text[i] = at->blended->letters[(state >> 8) % (uint32_t)at->blended->letter_count];
        }
        compare(at, text, length);
    }
}

static void check(mt_end a, mt_end b, int least_kerned) {
    static const double places[] = {0.25, 0.5};
    mt_blended blended = prepare(a, b);
    hb_buffer_t *buffer = hb_buffer_create();
    assert_in_range(blended.letter_count, 120, LETTERS);
    for (int i = 0; i < 2; i++) {
        size_t length;
        mt_comparison at = {.blended = &blended, .t = places[i], .buffer = buffer};
        at.font = font_at(&blended, places[i], &length);
        compare_pairs(&at);
        int pairs = at.kerned;
        compare_words(&at);
        print_message(
            "t %g: %d letters, %d pairs kerned, at most %.3g units a glyph off; GPOS of %zu bytes\n", at.t,
            blended.letter_count, pairs, at.worst, length);
        assert_true(pairs >= least_kerned);
        hb_font_destroy(at.font);
    }
    hb_buffer_destroy(buffer);
    close_blend(&blended);
}

/* ---- fonts --------------------------------------------------------------------------------------------- */

static mt_end plain(const char *path) {
    return open_end(path, path, 0);
}

static void classes_with_classes(void **state) {
    (void)state;
    check(plain(MT_TEST_SANS), plain(MT_TEST_SERIF), 400);
}

static void lists_with_lists(void **state) {
    (void)state;
    check(plain(NIMBUS), plain(PALATINO), 1000);
}

static void varying_with_classes(void **state) {
    (void)state;
    check(open_end(INTER, INTER "@wght=300", 300), plain(MT_TEST_SERIF), 1000);
    check(open_end(INTER, INTER "@wght=850", 850), plain(MT_TEST_SERIF), 1000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(classes_with_classes),
        cmocka_unit_test(lists_with_lists),
        cmocka_unit_test(varying_with_classes),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
