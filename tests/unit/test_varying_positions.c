/* Positions of varying fonts, shaped by HarfBuzz at places of the axis, against those of static blends there. */
#include <hb-ot.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "blend/metadata.h"
#include "gpos/positions.h"
#include "layout/gdef.h"
#include "sfnt/sfnt.h"
#include "support/allocation.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/fonts.h"
#include "support/gpos.h"
#include "support/shaping.h"
#include "support/varying.h"

#define INTER "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf"
#define NIMBUS "/usr/share/fonts/opentype/urw-base35/NimbusSans-Regular.otf"
#define PALATINO "/usr/share/fonts/opentype/urw-base35/P052-Roman.otf"
#define LIBERTINE "/usr/share/fonts/opentype/linux-libertine/LinLibertine_R.otf"
#define SANS "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"

enum { FONTS_MAX = 3, UNITS = 1000, ADVANCE = 500, FINE = 64 /* of mt_shaping_font */ };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* ---- fonts along an axis ------------------------------------------------------------------------------- */

typedef struct mt_varied {
    int count, units;
    mt_font *fonts[FONTS_MAX];
    mt_charset charsets[FONTS_MAX - 1];
    mt_positions *positions;
    mt_bytes gdef; /* classes alone */
} mt_varied;

static mt_font *open_font(const char *path, const char *spec) {
    mt_font *font;
    mt_font_close(mt_test_font(path));
    mt_assert_ok(mt_font_open(spec, &font));
    return font;
}

/* The glyphs of the first two fonts' charset in another font, by characters. */
static mt_charset charset_with(const mt_charset *first, const mt_font *font) {
    mt_charset made = *first;
    made.glyphs = mt_arena_new(&arena, (size_t)first->glyph_count, sizeof *made.glyphs);
    for (int i = 0; i < first->glyph_count; i++) {
        uint32_t glyph = first->glyphs[i].mapped ? mt_font_glyph(font, first->glyphs[i].code_point) : 0;
        made.glyphs[i] = first->glyphs[i];
        made.glyphs[i].b = glyph ? glyph : MT_NO_PARTNER;
    }
    return made;
}

/* GDEF's classes as the first font has them. */
static mt_bytes classes_of(const mt_varied *axis, const char *path) {
    int count = axis->charsets[0].glyph_count;
    uint16_t *classes = mt_arena_new(&arena, (size_t)count, sizeof *classes);
    hb_blob_t *blob = hb_blob_create_from_file_or_fail(path);
    hb_face_t *face = hb_face_create(blob, 0);
    for (int i = 0; i < count; i++)
        classes[i] = (uint16_t)hb_ot_layout_get_glyph_class(face, axis->charsets[0].glyphs[i].a);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    return mt_test_gdef(classes, count, &arena);
}

/* Each spec is a path, with a place on its axes where there is an '@'. */
static mt_varied axis_of(const char *const *specs, int count) {
    mt_varied axis = {.count = count};
    char path[200];
    for (int k = count - 1; k >= 0; k--) {
        snprintf(path, sizeof path, "%.*s", (int)strcspn(specs[k], "@"), specs[k]);
        axis.fonts[k] = open_font(path, specs[k]);
    }
    axis.units = mt_metadata_units(axis.fonts[0], axis.fonts[1]);
    mt_charset_request all = {0};
    mt_assert_ok(mt_charset_make(axis.fonts[0], axis.fonts[1], &all, &arena, &axis.charsets[0]));
    for (int k = 2; k < count; k++) axis.charsets[k - 1] = charset_with(&axis.charsets[0], axis.fonts[k]);
    mt_assert_ok(mt_test_positions(axis.fonts, axis.charsets, count, axis.units, &arena, &axis.positions));
    axis.gdef = classes_of(&axis, path);
    return axis;
}

static void close_axis(mt_varied *axis) {
    for (int k = 0; k < axis->count; k++) mt_font_close(axis->fonts[k]);
}

static hb_font_t *font_of(const mt_varied *axis, mt_bytes gpos, mt_bytes gdef, mt_test_varying varying) {
    int count = axis->charsets[0].glyph_count;
    uint16_t *advances = mt_arena_new(&arena, (size_t)count, sizeof *advances);
    for (int i = 0; i < count; i++) advances[i] = ADVANCE;
    mt_bytes font =
        mt_test_layout_font(&axis->charsets[0], axis->units, advances, gdef, gpos, varying, &arena);
    return mt_shaping_font(font.bytes, font.length);
}

static hb_font_t *varying_font(const mt_varied *axis, size_t *size) {
    mt_bytes gpos, gdef;
    mt_assert_ok(mt_test_write_varying(axis->positions, axis->count, axis->gdef, &arena, &gpos, &gdef));
    *size = gpos.length + gdef.length - axis->gdef.length;
    return font_of(axis, gpos, gdef, (mt_test_varying){.fvar = mt_test_fvar(&arena)});
}

/* The font at t, where 1 is the second font and so on; between the first two it is their blend. */
static hb_font_t *static_font(const mt_varied *axis, double t, size_t *size) {
    mt_bytes gpos;
    mt_positions *positions = axis->positions;
    if (t < 1)
        mt_assert_ok(mt_test_positions(axis->fonts, axis->charsets, 2, axis->units, &arena, &positions));
    mt_assert_ok(mt_positions_write(positions, mt_font_at_t(t), &arena, &gpos));
    *size = gpos.length;
    return font_of(axis, gpos, axis->gdef, (mt_test_varying){0});
}

/* ---- comparing ----------------------------------------------------------------------------------------- */

/* What was compared: the texts, those with kerning, those with a glyph moved up or down, and the most that a glyph is
 * off, in units for each glyph of the text up to it. */
typedef struct mt_tally {
    int texts, kerned, lifted;
    double worst;
} mt_tally;

static hb_buffer_t *shape(hb_font_t *font, const uint32_t *text, int length) {
    hb_buffer_t *buffer = hb_buffer_create();
    hb_buffer_add_codepoints(buffer, text, length, 0, length);
    hb_buffer_guess_segment_properties(buffer);
    hb_shape(font, buffer, NULL, 0);
    return buffer;
}

static void compare(hb_font_t *varying, hb_font_t *still, const uint32_t *text, int length, mt_tally *tally) {
    hb_buffer_t *one = shape(varying, text, length), *other = shape(still, text, length);
    unsigned count, other_count;
    const hb_glyph_position_t *got = hb_buffer_get_glyph_positions(one, &count);
    const hb_glyph_position_t *wanted = hb_buffer_get_glyph_positions(other, &other_count);
    double x = 0, off = 0;
    bool kerned = false, lifted = false;
    assert_int_equal(count, other_count);
    for (unsigned i = 0; i < count; i++) {
        double dx = x + got[i].x_offset - wanted[i].x_offset, dy = got[i].y_offset - wanted[i].y_offset;
        x += got[i].x_advance - wanted[i].x_advance;
        off = fmax(off, fmax(fabs(x), fmax(fabs(dx), fabs(dy))) / (i + 1) / FINE);
        kerned |= wanted[i].x_advance && wanted[i].x_advance != FINE * ADVANCE;
        lifted |= wanted[i].y_offset != 0;
    }
    hb_buffer_destroy(one);
    hb_buffer_destroy(other);
    tally->texts++;
    tally->kerned += kerned;
    tally->lifted += lifted;
    tally->worst = fmax(tally->worst, off);
}

static const uint32_t letters[] = U"AVTWYLPFKaeovwyrtfijd.,-'\"()αυτΑΤΥΓλουатжгкуТГУРАу";
static const uint32_t bases[] = U"aeouAEOUinrszyαεηωΑОаеоуАЕبسحدlI";
static const uint32_t marks[] = U"\u0300\u0301\u0302\u0303\u0308\u0323\u0327\u064B\u064E\u0651";

enum {
    LETTER_COUNT = sizeof letters / sizeof *letters - 1,
    BASE_COUNT = sizeof bases / sizeof *bases - 1,
    MARK_COUNT = sizeof marks / sizeof *marks - 1
};

static void compare_texts(hb_font_t *varying, hb_font_t *still, mt_tally *tally) {
    for (int i = 0; i < LETTER_COUNT; i++)
        for (int k = 0; k < LETTER_COUNT; k++)
            compare(varying, still, (uint32_t[]){letters[i], letters[k]}, 2, tally);
    for (int i = 0; i < BASE_COUNT; i++)
        for (int k = 0; k < MARK_COUNT; k++)
            for (int l = 0; l < MARK_COUNT; l++)
                compare(varying, still, (uint32_t[]){bases[i], marks[k], marks[l]}, 3, tally);
}

/* At each place, all that is written is rounded in both fonts: a glyph may be off by a unit, and as many more as there
 * are glyphs before it. At the stops both are the same. Some texts at least have to be kerned, and glyphs lifted. */
static void check(const char *const *specs, int count, int least_kerned, int least_lifted) {
    static const double places[] = {0, 0.1, 0.25, 0.5, 0.75, 1, 2};
    mt_varied axis = axis_of(specs, count);
    size_t size, static_size, most = 0;
    hb_font_t *varying = varying_font(&axis, &size);
    for (int i = 0; i < 5 + count - 1; i++) {
        mt_tally tally = {0};
        hb_font_t *still = static_font(&axis, places[i], &static_size);
        mt_test_place_on_axis(varying, places[i] / (count - 1));
        compare_texts(varying, still, &tally);
        print_message("at %g: of %d texts %d kerned, %d lifted; %g off\n", places[i], tally.texts,
                      tally.kerned, tally.lifted, tally.worst);
        assert_true(tally.kerned >= least_kerned && tally.lifted >= least_lifted);
        assert_true(tally.worst <= (fmod(places[i], 1) == 0 ? 0 : 1));
        if (static_size > most) most = static_size;
        hb_font_destroy(still);
    }
    print_message("%zu bytes in GPOS and GDEF's store, at most %zu in a static font\n", size, most);
    hb_font_destroy(varying);
    close_axis(&axis);
}

static void sans_to_serif(void **state) {
    (void)state;
    check((const char *[]){MT_TEST_SANS, MT_TEST_SERIF}, 2, 80, 100);
}

static void lists_to_lists(void **state) {
    (void)state;
    check((const char *[]){NIMBUS, PALATINO}, 2, 400, 0);
}

static void inter_to_serif(void **state) {
    (void)state;
    check((const char *[]){INTER "@wght=650", MT_TEST_SERIF}, 2, 80, 0);
}

static void three_fonts(void **state) {
    (void)state;
    check((const char *[]){SANS, INTER "@wght=300", MT_TEST_SERIF}, 3, 80, 100);
    check((const char *[]){INTER "@wght=650", LIBERTINE, SANS}, 3, 80, 0);
}

/* Each of three fonts is positioned as in a blend of the first with it alone. */
static void each_stop_is_as_with_the_first_alone(void **state) {
    (void)state;
    const char *specs[] = {SANS, INTER "@wght=300", MT_TEST_SERIF};
    mt_varied three = axis_of(specs, 3);
    for (int k = 1; k < 3; k++) {
        mt_tally tally = {0};
        mt_varied two = three;
        size_t size;
        mt_font *fonts[] = {three.fonts[0], three.fonts[k]};
        two.count = 2;
        mt_assert_ok(
            mt_test_positions(fonts, &three.charsets[k - 1], 2, three.units, &arena, &two.positions));
        hb_font_t *one = static_font(&three, k, &size), *other = static_font(&two, 1, &size);
        compare_texts(one, other, &tally);
        print_message("font %d: %d texts kerned, %d lifted; %g off\n", k, tally.kerned, tally.lifted,
                      tally.worst);
        assert_true(tally.kerned >= 80 && tally.lifted >= 100 && tally.worst == 0);
        hb_font_destroy(one);
        hb_font_destroy(other);
    }
    close_axis(&three);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sans_to_serif),
        cmocka_unit_test(lists_to_lists),
        cmocka_unit_test(inter_to_serif),
        cmocka_unit_test(three_fonts),
        cmocka_unit_test(each_stop_is_as_with_the_first_alone),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
