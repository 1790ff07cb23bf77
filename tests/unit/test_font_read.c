#include "base/utf.h"
#include "geometry/limits.h"
#include "kerning/kern_table.h"
#include "sfnt/sfnt.h"
#include "sfnt/woff2.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/fonts.h"
#include "support/random.h"
#include "support/sample.h"
#include "write/write.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <errno.h>
#include <stdio.h>
#include <string.h>

#define CFF "/usr/share/fonts/opentype/noto/NotoSansCJK-Bold.ttc"
#define VARIABLE "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf"
#define TYPE1 "/usr/share/fonts/type1/urw-base35/NimbusSans-BoldItalic.t1"

static uint8_t *sample; /* the sample font's bytes */
static size_t sample_length;

static int set_up(void **state) {
    (void)state;
    uint8_t *bytes;
    mt_font_data data = mt_sample_font(&arena);
    directory = mt_sample_directory(&arena);
    mt_assert_ok(mt_font_write(&data, &bytes, &sample_length));
    sample = mt_arena_new(&arena, sample_length, 1);
    memcpy(sample, bytes, sample_length);
    mt_bytes_free(bytes);
    return 0;
}

static const char *save(const char *name, const void *bytes, size_t length) {
    const char *path = mt_sample_path(&arena, directory, name);
    mt_sample_save(path, bytes, length);
    return path;
}

static mt_font *open_sample(void) {
    mt_font *font;
    mt_assert_ok(mt_font_open(save("sample.ttf", sample, sample_length), &font));
    return font;
}

static void assert_fails(const char *spec, mt_status status) {
    mt_font *font = NULL;
    assert_int_equal(mt_font_open(spec, &font), status);
    assert_null(font);
}

/* A package's font at a place, or the test is skipped. */
static mt_font *open_package(const char *path, const char *rest) {
    char spec[256];
    mt_font_close(mt_test_font(path));
    snprintf(spec, sizeof spec, "%s%s", path, rest);
    mt_font *font;
    mt_assert_ok(mt_font_open(spec, &font));
    assert_string_equal(mt_font_spec(font), spec);
    return font;
}

static mt_outline outline_of(mt_font *font, uint32_t code_point, double *advance) {
    mt_outline outline;
    mt_assert_ok(mt_font_outline(font, mt_font_glyph(font, code_point), &arena, &outline, advance));
    return outline;
}

/* ---- outlines ------------------------------------------------------------------------------------------ */

static void assert_segment(const mt_segment *segment, int degree, int cx, int cy, int x, int y) {
    assert_int_equal(segment->degree, degree);
    if (degree == 2) assert_true(mt_point_equal(segment->control[0], (mt_point){cx, cy}));
    assert_true(mt_point_equal(segment->end, (mt_point){x, y}));
}

static void lines_and_the_closing_line(void **state) {
    (void)state;
    double advance;
    mt_font *font = open_sample();
    mt_outline outline = outline_of(font, 'A', &advance);
    assert_int_equal(outline.count, 1);
    assert_int_equal(outline.contours[0].count, 3);
    assert_segment(&outline.contours[0].segments[0], 1, 0, 0, 610 * 256, 0);
    assert_segment(&outline.contours[0].segments[1], 1, 0, 0, 310 * 256, 700 * 256);
    assert_segment(&outline.contours[0].segments[2], 1, 0, 0, 10 * 256, 0);
    assert_float_equal(advance, 620 * 256, 0);
    assert_int_equal(outline_of(font, 0xE9, &advance).count, 2);
    assert_int_equal(outline_of(font, 0x1F600, &advance).count, 0);
    assert_float_equal(advance, 500 * 256, 0);
    mt_font_close(font);
}

/* Points half-way between two off-curve ones are not rounded to font units: 246.5 and 250.5 are among them. */
static void curves_of_off_curve_points(void **state) {
    (void)state;
    double advance;
    mt_font *font = open_sample();
    mt_outline outline = outline_of(font, 'o', &advance);
    assert_int_equal(outline.count, 1);
    const mt_contour *contour = &outline.contours[0];
    assert_int_equal(contour->count, 4);
    static const int corners[4][2] = {{500, 0}, {500, 501}, {-7, 501}, {-7, 0}};
    for (int i = 0; i < 4; i++) {
        const int *from = corners[i], *to = corners[(i + 1) % 4];
        assert_segment(&contour->segments[i], 2, from[0] * 256, from[1] * 256, (from[0] + to[0]) * 128,
                       (from[1] + to[1]) * 128);
    }
    mt_font_close(font);
}

/* Writes one glyph in a font of its own, on a coarse em where the grid is not a multiple, and reads it. */
static mt_status read_glyph(const int16_t (*points)[2], int count, int units, mt_outline *outline) {
    uint8_t *bytes;
    size_t length;
    mt_font *font;
    double advance;
    mt_font_data data = mt_sample_font(&arena);
    data.units = units;
    data.glyphs[1] = mt_sample_glyph(&arena, points, count, true, 600);
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    mt_assert_ok(mt_font_open(save("glyph.ttf", bytes, length), &font));
    mt_bytes_free(bytes);
    mt_status status = mt_font_outline(font, 1, &arena, outline, &advance);
    mt_font_close(font);
    return status;
}

static void segments_without_length(void **state) {
    (void)state;
    static const int16_t points[][2] = {{0, 0}, {0, 0}, {5, 0}, {5, 0}, {5, 0}, {5, 5}, {0, 0}};
    static const int16_t still[][2] = {{3, 4}, {3, 4}, {3, 4}};
    mt_outline outline;
    mt_assert_ok(read_glyph(points, 7, 1000, &outline));
    assert_int_equal(outline.contours[0].count, 3);
    assert_segment(&outline.contours[0].segments[2], 1, 0, 0, 0, 0);
    mt_assert_ok(read_glyph(still, 3, 1000, &outline));
    assert_int_equal(outline.count, 0);
}

/* 256 000 / 1200 is 213⅓: rounded to the nearest, below zero too. */
static void coordinates_are_rounded(void **state) {
    (void)state;
    static const int16_t points[][2] = {{-1, -2}, {1, -2}, {2, 3}};
    mt_outline outline;
    mt_assert_ok(read_glyph(points, 3, 1200, &outline));
    assert_segment(&outline.contours[0].segments[0], 1, 0, 0, 213, -427);
    assert_segment(&outline.contours[0].segments[1], 1, 0, 0, 427, 640);
    assert_segment(&outline.contours[0].segments[2], 1, 0, 0, -213, -427);
}

static void coordinates_over_the_limit(void **state) {
    (void)state;
    static const int16_t inside[][2] = {{0, 0}, {524, 0}, {0, -524}},
                         outside[][2] = {{0, 0}, {525, 0}, {0, 9}},
                         below[][2] = {{0, 0}, {5, -32000}, {0, 9}};
    mt_outline outline;
    mt_assert_ok(read_glyph(inside, 3, 16, &outline)); /* 524 of 16 units are 32.75 em */
    assert_segment(&outline.contours[0].segments[0], 1, 0, 0, 524 * 16000, 0);
    assert_int_equal(read_glyph(outside, 3, 16, &outline), MT_TOO_LARGE);
    assert_int_equal(read_glyph(below, 3, 16, &outline), MT_TOO_LARGE);
}

static void glyphs_that_are_not_there(void **state) {
    (void)state;
    double advance;
    mt_outline outline;
    mt_font *font = open_sample();
    assert_int_equal(mt_font_outline(font, 5, &arena, &outline, &advance), MT_BAD_GLYPH);
    assert_int_equal(mt_font_outline(font, UINT32_MAX, &arena, &outline, &advance), MT_BAD_GLYPH);
    mt_assert_ok(mt_font_outline(font, 0, &arena, &outline, &advance));
    mt_font_close(font);
}

/* ---- characters ---------------------------------------------------------------------------------------- */

static void characters_in_order(void **state) {
    (void)state;
    static const uint32_t mapped[] = {'A', 'o', 0xE9, 0x1F600};
    mt_font *font = open_sample();
    uint32_t found, from = 0;
    for (int i = 0; i < 4; i++, from = found + 1) {
        assert_true(mt_font_next_char(font, from, &found));
        assert_int_equal(found, mapped[i]);
        assert_true(mt_font_next_char(font, found, &found));
        assert_int_equal(found, mapped[i]);
        assert_int_equal(mt_font_glyph(font, found), i + 1);
    }
    assert_false(mt_font_next_char(font, from, &found));
    assert_false(mt_font_next_char(font, 0x110000, &found));
    assert_false(mt_font_next_char(font, UINT32_MAX, &found));
    assert_true(mt_font_next_char(font, 0xD900, &found));
    assert_int_equal(found, 0x1F600);
    assert_int_equal(mt_font_glyph(font, 'B'), 0);
    assert_int_equal(mt_font_glyph(font, 0xD800), 0);
    assert_int_equal(mt_font_glyph(font, UINT32_MAX), 0);
    mt_font_close(font);
}

/* The sample with these characters in a map for symbols, and with no other one when `alone`. */
static const char *save_symbols(const uint32_t *code_points, int count, bool alone) {
    mt_font_data data = mt_sample_font(&arena);
    size_t length, cmap_length;
    uint8_t *bytes;
    data.is_symbol = true;
    data.char_count = count;
    for (int i = 0; i < count; i++) data.chars[i] = (mt_char){code_points[i], (uint16_t)(i + 1)};
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    uint8_t *cmap = bytes + (mt_sample_table(bytes, "cmap", &cmap_length) - bytes);
    assert_int_equal(mt_read_u16(cmap + 2), 3); /* Unicode's, the one for symbols, and Windows' */
    assert_int_equal(mt_read_u32(cmap + 12), 3 << 16);
    if (alone) memcpy(cmap + 4, cmap + 12, 8);
    if (alone) cmap[3] = 1;
    const char *path = save("symbols.ttf", bytes, length);
    mt_bytes_free(bytes);
    return path;
}

static void symbols_by_their_codes(void **state) {
    (void)state;
    static const uint32_t mapped[] = {'z', 0xF041, 0xF06F};
    mt_font *font;
    uint32_t found;
    for (int alone = 0; alone < 2; alone++) {
        mt_assert_ok(mt_font_open(save_symbols(mapped, 3, alone), &font));
        assert_true(mt_font_is_symbol(font));
        assert_true(mt_font_next_char(font, '{', &found));
        assert_int_equal(found, 0xF041);
        assert_int_equal(mt_font_glyph(font, 0xF041), 2);
        assert_int_equal(mt_font_glyph(font, 'A'), 2);
        assert_int_equal(mt_font_glyph(font, 'z'), 1);
        assert_int_equal(mt_font_glyph(font, 'B'), 0);
        assert_int_equal(mt_font_mapped_glyph(font, 'A'), 0);
        mt_font_close(font);
    }
    font = open_sample();
    assert_false(mt_font_is_symbol(font));
    mt_font_close(font);
}

/* ---- names and figures --------------------------------------------------------------------------------- */

static void names_come_back(void **state) {
    (void)state;
    mt_names names;
    mt_font *font = open_sample();
    mt_font_names(font, &names);
    assert_string_equal(names.family, "Sample 形 𝔘");
    assert_string_equal(names.style, "Half Way");
    assert_string_equal(names.version, "Version 1.250");
    assert_string_equal(names.copyright, "© é");
    assert_string_equal(names.license, "MIT");
    assert_string_equal(names.license_url, "https://example.org/");
    assert_string_equal(names.designer, "É. Signer");
    assert_string_equal(names.trademark, "Sample is no trademark");
    assert_string_equal(mt_font_family(font), names.family);
    assert_string_equal(mt_font_style(font), names.style);
    mt_font_close(font);
}

static void figures_come_back(void **state) {
    (void)state;
    mt_metrics read;
    mt_font_data data = mt_sample_font(&arena);
    mt_font *font = open_sample();
    mt_font_metrics(font, &read);
    assert_memory_equal(&read, &data.metrics, offsetof(mt_metrics, monospaced)); /* all the numbers */
    assert_false(read.monospaced);
    assert_true(read.use_typo_metrics);
    assert_false(read.vertical);
    assert_int_equal(mt_font_units_per_em(font), data.units);
    assert_int_equal(mt_font_modified(font), data.modified);
    assert_int_equal(mt_font_embedding(font), data.embedding);
    mt_font_close(font);
}

/* A heading without x-height and cap height: they are measured on x and H, which here are the glyphs of A and
 * é. */
static void heights_are_measured(void **state) {
    (void)state;
    mt_metrics read;
    mt_font *font;
    uint8_t *bytes;
    size_t length;
    mt_font_data data = mt_sample_font(&arena);
    data.metrics.x_height = data.metrics.cap_height = 0;
    data.chars[0] = (mt_char){'H', 1};
    data.chars[1] = (mt_char){'x', 3};
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    mt_assert_ok(mt_font_open(save("heights.ttf", bytes, length), &font));
    mt_bytes_free(bytes);
    mt_font_metrics(font, &read);
    assert_float_equal(read.cap_height, 700, 0);
    assert_float_equal(read.x_height, 800, 0);
    mt_font_close(font);
}

static void broken_utf16(void **state) {
    (void)state;
    static const uint8_t units[] = {0xD8, 0x3D, 0xDE, 0x00, 0xD8, 0x00, 0x00, 'a', 0xDC, 0x00, 0xD8, 0x00, 7};
    static const uint32_t expected[] = {0x1F600,        MT_REPLACEMENT, 'a',
                                        MT_REPLACEMENT, MT_REPLACEMENT, MT_REPLACEMENT};
    size_t at = 0;
    for (int i = 0; i < 6; i++) assert_int_equal(mt_utf16_next(units, sizeof units, &at), expected[i]);
    assert_int_equal(at, sizeof units);
}

static void utf8_there_and_back(void **state) {
    (void)state;
    for (uint32_t c = 1; c <= 0x10FFFF; c += c < 0x1000 ? 1 : 97) {
        char bytes[5] = "";
        const char *at = bytes;
        uint32_t read = 0;
        int length = mt_utf8_put(c, bytes);
        bool surrogate = c >= 0xD800 && c <= 0xDFFF;
        assert_int_equal(mt_utf8_next(&at, &read), !surrogate);
        assert_int_equal(at - bytes, surrogate ? 0 : length);
        assert_int_equal(read, surrogate ? 0 : c);
    }
}

/* ---- files that are none ------------------------------------------------------------------------------- */

static void files_that_are_no_fonts(void **state) {
    (void)state;
    static const char words[] = "root:x:0:0:root:/root:/bin/bash\n";
    assert_fails(mt_sample_path(&arena, directory, "missing.ttf#0@wght=5"), MT_NO_FILE);
    assert_int_equal(errno, ENOENT);
    assert_fails(directory, MT_NO_FILE);
    assert_int_equal(errno, EISDIR);
    assert_fails(save("empty.ttf", "", 0), MT_NOT_A_FONT);
    assert_fails(save("words.ttf", words, sizeof words - 1), MT_NOT_A_FONT);
    assert_fails(save("header.ttf", sample, 12), MT_NOT_A_FONT);
    assert_fails(save("ttc.ttc", "ttcf\0\1\0\0\0\0\0\1\0\0\0\377", 16), MT_NOT_A_FONT);
}

/* Cut anywhere before the last table's end, a font is no font. */
static void files_cut_short(void **state) {
    (void)state;
    size_t end = 0;
    for (unsigned i = 0; i < mt_read_u16(sample + 4); i++) {
        const uint8_t *entry = sample + 12 + 16 * i;
        size_t table_end = mt_read_u32(entry + 8) + mt_read_u32(entry + 12);
        end = table_end > end ? table_end : end;
    }
    for (size_t length = 0; length < end; length += 7)
        assert_fails(save("cut.ttf", sample, length), MT_NOT_A_FONT);
    assert_fails(save("cut.ttf", sample, end - 1), MT_NOT_A_FONT);
    mt_font *font;
    mt_assert_ok(mt_font_open(save("cut.ttf", sample, end), &font));
    mt_font_close(font);
}

/* The same bytes with a table's tag changed, as if it had none. */
static const char *save_without(const char *tag) {
    uint8_t *bytes = mt_arena_new(&arena, sample_length, 1);
    assert_non_null(bytes);
    memcpy(bytes, sample, sample_length);
    for (unsigned i = 0; i < mt_read_u16(bytes + 4); i++)
        if (memcmp(bytes + 12 + 16 * i, tag, 4) == 0) bytes[12 + 16 * i + 3] = '~';
    return save("without.ttf", bytes, sample_length);
}

static void fonts_that_lack_something(void **state) {
    (void)state;
    mt_font *font;
    mt_names names;
    assert_fails(save_without("cmap"), MT_NO_CHARMAP);
    assert_fails(save_without("head"), MT_NOT_A_FONT);
    mt_assert_ok(mt_font_open(save_without("name"), &font));
    mt_font_names(font, &names);
    assert_null(names.family);
    assert_string_equal(mt_font_family(font), "Untitled");
    assert_string_equal(mt_font_style(font), "Regular");
    mt_font_close(font);
    mt_font_data data = mt_sample_font(&arena);
    uint8_t *bytes;
    size_t length;
    data.char_count = 0;
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    assert_fails(save("uncharted.ttf", bytes, length), MT_NO_CHARMAP);
    mt_bytes_free(bytes);
}

/* ---- WOFF2 that FreeType 2.12 refuses --------------------------------------------------------------------- */

/* The sample with a table of zeros, packed to a small part of its size, which FreeType refuses. */
static uint8_t *pack_well(size_t *packed_length) {
    static const uint8_t zeros[45000];
    mt_font_data data = mt_sample_font(&arena);
    uint8_t *bytes, *packed;
    size_t length;
    data.extras[data.extra_count++] = (mt_extra_table){MT_TAG('Z', 'E', 'R', 'O'), {zeros, sizeof zeros}};
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    mt_assert_ok(mt_woff2_pack(bytes, length, &packed, packed_length));
    mt_bytes_free(bytes);
    assert_true(*packed_length * 20 < length);
    return packed;
}

static void woff2_packed_well(void **state) {
    (void)state;
    size_t length;
    FT_Library library;
    FT_Face face;
    mt_font *font;
    uint8_t *packed = pack_well(&length);
    assert_int_equal(FT_Init_FreeType(&library), 0);
    bool refused = FT_New_Memory_Face(library, packed, (FT_Long)length, 0, &face) != 0;
    FT_Done_FreeType(library);
    assert_true(refused);
    mt_assert_ok(mt_font_open(save("well.woff2", packed, length), &font));
    assert_int_equal(mt_font_glyph(font, 'o'), 2);
    assert_true(mt_font_has_table(font, MT_TAG('Z', 'E', 'R', 'O')));
    mt_font_close(font);
    assert_fails(save("cut.woff2", packed, length - 20), MT_NOT_A_FONT);
    memset(packed + length - 100, 0x55, 50);
    assert_fails(save("damaged.woff2", packed, length), MT_NOT_A_FONT);
    mt_bytes_free(packed);
    packed = pack_well(&length);
    packed[16] = 0x7F; /* the size of the font in it, by its header */
    assert_fails(save("large.woff2", packed, length), MT_TOO_LARGE);
    mt_bytes_free(packed);
}

/* A directory that declares 4 GiB is refused before any of it is unpacked. */
static void woff2_of_a_size_declared(void **state) {
    (void)state;
    static const uint8_t entry[] = {63, 'Z', 'E', 'R', 'O', 0x8F, 0xFF, 0xFF, 0xFF, 0x7F};
    uint8_t bytes[48 + sizeof entry] = "wOF2", *font = NULL;
    size_t length;
    bytes[13] = 1; /* table */
    memcpy(bytes + 48, entry, sizeof entry);
    assert_int_equal(mt_woff2_unpack(bytes, sizeof bytes, &font, &length), MT_TOO_LARGE);
    assert_int_equal(mt_woff2_unpack(bytes, sizeof bytes - 1, &font, &length), MT_NOT_A_FONT);
    assert_int_equal(mt_woff2_unpack(bytes, 47, &font, &length), MT_NOT_A_FONT);
    assert_null(font);
}

/* ---- metrics beside a Type 1 font ------------------------------------------------------------------------- */

/* What the font has for A before V beside it, or 0. */
static double kerning_of(const mt_font *font) {
    mt_bytes kern;
    mt_pair_source source = {0};
    mt_assert_ok(mt_font_kern(font, &arena, &kern));
    if (!mt_kern_table_kerns(kern)) return 0;
    mt_assert_ok(mt_pair_source_kern(kern, 1, &arena, &source));
    assert_int_equal(source.count, 1);
    assert_int_equal(mt_kern_listed_count(&source.subtables[0], mt_font_glyph(font, 'A')), 1);
    return mt_kern_listed_value(&source.subtables[0], mt_font_glyph(font, 'A'), mt_font_glyph(font, 'V'));
}

/* Windows' metrics with one pair, A before V. */
static void write_pfm(uint8_t bytes[160], int value) {
    enum { WIDTHS = 99, EXTENSION = WIDTHS + 18, KERNING = 150 };
    memset(bytes, 0, 160);
    bytes[1] = 1;
    bytes[2] = 160; /* the file's length */
    bytes[EXTENSION] = 0x1E;
    bytes[EXTENSION + 14] = KERNING;
    bytes[KERNING] = 1; /* pair */
    bytes[KERNING + 2] = 'A';
    bytes[KERNING + 3] = 'V';
    bytes[KERNING + 4] = (uint8_t)value;
    bytes[KERNING + 5] = (uint8_t)(value >> 8);
}

static void kerning_beside_type1(void **state) {
    (void)state;
    static const char afm[] = "StartFontMetrics 2.0\nFontName F\nFontBBox 0 0 500 700\nAscender 9000\n"
                              "StartKernData\nStartKernPairs 1\nKPX A V -75\nEndKernPairs\nEndKernData\n"
                              "EndFontMetrics\n";
    size_t length;
    uint8_t pfm[160], *bytes = mt_sample_load(&arena, TYPE1, &length);
    mt_font *font;
    mt_metrics plain, beside;
    const char *path = save("t1.of.pfb", bytes, length);
    mt_assert_ok(mt_font_open(path, &font));
    assert_true(kerning_of(font) == 0);
    assert_null(mt_font_unread_metrics(font));
    mt_font_metrics(font, &plain);
    mt_font_close(font);
    write_pfm(pfm, -31);
    save("t1.of.pfm", pfm, sizeof pfm);
    mt_assert_ok(mt_font_open(path, &font));
    assert_true(kerning_of(font) == -31);
    mt_font_close(font);
    save("t1.of.afm", afm, sizeof afm - 1);
    mt_assert_ok(mt_font_open(path, &font));
    assert_true(kerning_of(font) == -75);
    mt_font_metrics(font, &beside);
    assert_true(plain.hhea_ascender == beside.hhea_ascender);
    mt_font_close(font);
    const char *damaged = save("t1.of.afm", "no metrics", 10);
    mt_assert_ok(mt_font_open(path, &font));
    assert_true(kerning_of(font) == 0);
    assert_string_equal(mt_font_unread_metrics(font), damaged);
    mt_font_close(font);
}

/* Without OS/2 and post the figures are made up, and sensibly. */
static void figures_without_tables(void **state) {
    (void)state;
    mt_metrics read;
    mt_font *font;
    mt_assert_ok(mt_font_open(save_without("OS/2"), &font));
    mt_font_metrics(font, &read);
    assert_float_equal(read.typo_ascender, 900, 0);
    assert_float_equal(read.win_ascent, 800, 0);
    assert_float_equal(read.cap_height, 700, 0); /* 0.7 em: there is no H */
    assert_float_equal(read.weight_class, 400, 0);
    assert_true(read.strikeout_size > 0 && read.strikeout_position > 0 && read.subscript_size[0] > 0);
    assert_int_equal(mt_font_embedding(font), 0);
    mt_font_close(font);
    mt_assert_ok(mt_font_open(save_without("post"), &font));
    mt_font_metrics(font, &read);
    assert_float_equal(read.underline_thickness, 50, 0);
    assert_float_equal(read.underline_position, -100, 0);
    mt_font_close(font);
}

static void a_bitmap_font(void **state) {
    (void)state;
    static const char bdf[] =
        "STARTFONT 2.1\nFONT -a-b-medium-r-normal--8-80-75-75-c-80-iso10646-1\nSIZE 8 75 75\n"
        "FONTBOUNDINGBOX 8 8 0 0\nSTARTPROPERTIES 4\nFONT_ASCENT 8\nFONT_DESCENT 0\n"
        "CHARSET_REGISTRY \"ISO10646\"\nCHARSET_ENCODING \"1\"\nENDPROPERTIES\nCHARS 1\n"
        "STARTCHAR A\nENCODING 65\nSWIDTH 500 0\nDWIDTH 8 0\nBBX 8 2 0 0\nBITMAP\nFF\n81\n"
        "ENDCHAR\nENDFONT\n";
    assert_fails(save("bitmap.bdf", bdf, sizeof bdf - 1), MT_NO_OUTLINES);
}

static void faces_and_axes_that_are_not_there(void **state) {
    (void)state;
    mt_font_close(open_sample());
    assert_fails(mt_sample_path(&arena, directory, "sample.ttf#1"), MT_NO_FACE);
    assert_fails(mt_sample_path(&arena, directory, "sample.ttf#one"), MT_NO_FACE);
    assert_fails(mt_sample_path(&arena, directory, "sample.ttf@wght=400"), MT_NO_AXIS);
    assert_fails(mt_sample_path(&arena, directory, "sample.ttf@wght=bold"), MT_BAD_AXIS);
}

/* ---- the formats --------------------------------------------------------------------------------------- */

/* The sample font as WOFF (W3C, "WOFF File Format 1.0"), its tables stored as they are. */
static void put32(uint8_t *to, size_t value) {
    for (int i = 0; i < 4; i++) to[i] = (uint8_t)(value >> (24 - 8 * i));
}

static uint8_t *make_woff(size_t *length) {
    unsigned count = mt_read_u16(sample + 4);
    uint8_t *woff = mt_arena_new(&arena, 44 + 24 * count + sample_length, 1);
    assert_non_null(woff);
    *length = 44 + 20 * count;
    for (unsigned i = 0; i < count; i++) {
        const uint8_t *from = sample + 12 + 16 * i;
        uint8_t *entry = woff + 44 + 20 * i;
        size_t size = mt_read_u32(from + 12);
        memcpy(woff + *length, sample + mt_read_u32(from + 8), size);
        memcpy(entry, from, 4);
        put32(entry + 4, *length);
        put32(entry + 8, size);
        put32(entry + 12, size);
        memcpy(entry + 16, from + 4, 4);
        *length += (size + 3) / 4 * 4;
    }
    memcpy(woff, "wOFF", 4);
    memcpy(woff + 4, sample, 4);
    put32(woff + 8, *length);
    memcpy(woff + 12, sample + 4, 2);
    put32(woff + 16, sample_length);
    return woff;
}

static void a_woff(void **state) {
    (void)state;
    mt_font *font;
    double advance;
    size_t length;
    uint8_t *woff = make_woff(&length);
    mt_assert_ok(mt_font_open(save("sample.woff", woff, length), &font));
    assert_string_equal(mt_font_style(font), "Half Way");
    assert_int_equal(outline_of(font, 0xE9, &advance).count, 2);
    mt_font_close(font);
    assert_fails(save("sample.woff", woff, length - 4), MT_NOT_A_FONT);
}

/* Every glyph of a real font is read, closed,and has a sensible advance. */
static void assert_all_read(mt_font *font, int degree) {
    uint32_t c;
    int curves = 0, count = 0;
    for (uint32_t from = 0; count < 3000 && mt_font_next_char(font, from, &c); from = c + 1, count++) {
        mt_arena_place place = mt_arena_mark(&arena);
        double advance;
        mt_outline outline = outline_of(font, c, &advance);
        assert_true(advance >= 0 && advance < 10.0 * MT_EM);
        for (int i = 0; i < outline.count; i++) {
            mt_contour *contour = &outline.contours[i];
            assert_true(contour->count > 0);
            mt_point at = contour->segments[contour->count - 1].end;
            for (int s = 0; s < contour->count; s++) {
                const mt_segment *segment = &contour->segments[s];
                assert_true(segment->degree == 1 || segment->degree == degree);
                if (segment->degree == 1) assert_false(mt_point_equal(at, segment->end));
                curves += segment->degree > 1;
                at = segment->end;
            }
        }
        mt_arena_rewind(&arena, place);
    }
    assert_true(count > 200 && curves > 1000);
}

static void truetype(void **state) {
    (void)state;
    mt_font *font = open_package(MT_TEST_SANS, "");
    assert_string_equal(mt_font_family(font), "DejaVu Sans");
    assert_string_equal(mt_font_style(font), "Bold");
    assert_all_read(font, 2);
    mt_font_close(font);
}

static void a_collection_of_cff(void **state) {
    (void)state;
    mt_font *font = open_package(CFF, "#2");
    assert_string_equal(mt_font_family(font), "Noto Sans CJK SC");
    assert_all_read(font, 3);
    mt_font_close(font);
    assert_fails(CFF "#99", MT_NO_FACE);
}

static void a_variable_font(void **state) {
    (void)state;
    double light, given, heavy;
    mt_metrics metrics;
    mt_font *fonts[] = {open_package(VARIABLE, "@wght=400"), open_package(VARIABLE, "@wght=650,slnt=-5"),
                        open_package(VARIABLE, "@wght=900")};
    outline_of(fonts[0], 'n', &light);
    outline_of(fonts[1], 'n', &given);
    outline_of(fonts[2], 'n', &heavy);
    assert_true(light < given && given < heavy);
    mt_font_metrics(fonts[1], &metrics);
    assert_float_equal(metrics.weight_class, 650, 0);
    assert_float_equal(metrics.italic_angle, -5, 0);
    assert_string_equal(mt_font_style(fonts[2]), "Black"); /* the named instance at this place */
    assert_all_read(fonts[1], 2);
    for (int i = 0; i < 3; i++) mt_font_close(fonts[i]);
    assert_fails(VARIABLE "@wght=901", MT_BAD_AXIS);
    assert_fails(VARIABLE "@wght=99", MT_BAD_AXIS);
    assert_fails(VARIABLE "@zzzz=1", MT_NO_AXIS);
}

static void type1(void **state) {
    (void)state;
    mt_metrics metrics;
    mt_names names;
    mt_font *font = open_package(TYPE1, "");
    mt_font_metrics(font, &metrics);
    mt_font_names(font, &names);
    assert_string_equal(names.family, "Nimbus Sans");
    assert_string_equal(names.style, "Bold Italic");
    assert_non_null(strstr(names.copyright, "URW"));
    assert_float_equal(metrics.weight_class, 700, 0);
    assert_float_equal(metrics.italic_angle, -12, 0);
    assert_true(metrics.x_height > 500 && metrics.cap_height > metrics.x_height);
    assert_true(metrics.win_ascent > 0 && metrics.win_descent > 0 && metrics.hhea_descender < 0);
    assert_all_read(font, 3);
    mt_font_close(font);
}

/* ---- hostile bytes and want of memory ------------------------------------------------------------------ */

/* Whatever the bytes, a font is refused or read; the sanitizers see to the rest. */
static void random_damage(void **state) {
    (void)state;
    int opened = 0, refused = 0;
    uint8_t *bytes = mt_arena_new(&arena, sample_length, 1);
    assert_non_null(bytes);
    for (int number = 0; number < mt_test_cases(300); number++) {
        mt_random random = mt_random_case(number);
        mt_font *font;
        memcpy(bytes, sample, sample_length);
        for (int i = mt_random_between(&random, 1, 12); i > 0; i--)
            bytes[mt_random_between(&random, 0, (int)sample_length - 1)] = (uint8_t)mt_random_next(&random);
        mt_status status = mt_font_open(save("damaged.ttf", bytes, sample_length), &font);
        refused += status != MT_OK;
        if (status != MT_OK) continue;
        opened++;
        for (uint32_t glyph = 0; glyph < 5; glyph++) {
            mt_outline outline;
            double advance;
            status = mt_font_outline(font, glyph, &arena, &outline, &advance);
            assert_true(status == MT_OK || status == MT_BAD_GLYPH || status == MT_TOO_LARGE);
        }
        mt_font_close(font);
    }
    assert_true(opened > 10 && refused > 10);
}

static mt_status open_and_read(const char *spec) {
    mt_font *font;
    mt_arena own = {0};
    mt_outline outline;
    double advance;
    mt_status status = mt_font_open(spec, &font);
    if (status != MT_OK) return status;
    status = mt_font_outline(font, mt_font_glyph(font, 'o'), &own, &outline, &advance);
    mt_font_close(font);
    mt_arena_release(&own);
    return status;
}

static void assert_survives_each_failure(const char *spec) {
    mt_status status = MT_NO_MEMORY;
    long number;
    for (number = 0; status != MT_OK; number++) {
        mt_allocation_watch();
        mt_allocation_fail(number, false);
        status = open_and_read(spec);
        long live = mt_allocation_live();
        mt_allocation_unwatch();
        assert_true(status == MT_OK || status == MT_NO_MEMORY);
        assert_int_equal(live, 0);
    }
    assert_true(number > 50);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    assert_survives_each_failure(save("memory.ttf", sample, sample_length));
}

/* FreeType alone would read through a null pointer here. */
static void every_allocation_may_fail_in_a_variable_font(void **state) {
    (void)state;
    mt_font_close(mt_test_font(VARIABLE));
    assert_survives_each_failure(VARIABLE "@wght=650");
}

static void no_glyphs_after_want_of_memory(void **state) {
    (void)state;
    mt_outline outline;
    double advance;
    uint32_t found;
    mt_font *font = open_sample();
    uint32_t glyph = mt_font_glyph(font, 'o');
    mt_allocation_watch();
    mt_allocation_fail(0, true);
    mt_status first = mt_font_outline(font, glyph, &arena, &outline, &advance);
    mt_allocation_unwatch();
    assert_int_equal(first, MT_NO_MEMORY);
    assert_int_equal(mt_font_outline(font, glyph, &arena, &outline, &advance), MT_NO_MEMORY);
    assert_int_equal(mt_font_glyph(font, 'o'), 0);
    assert_false(mt_font_next_char(font, 0, &found));
    assert_int_equal(mt_font_units_per_em(font), 1000);
    assert_string_equal(mt_font_style(font), "Half Way");
    mt_font_close(font);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(lines_and_the_closing_line),
        cmocka_unit_test(curves_of_off_curve_points),
        cmocka_unit_test(segments_without_length),
        cmocka_unit_test(coordinates_are_rounded),
        cmocka_unit_test(coordinates_over_the_limit),
        cmocka_unit_test(glyphs_that_are_not_there),
        cmocka_unit_test(characters_in_order),
        cmocka_unit_test(symbols_by_their_codes),
        cmocka_unit_test(names_come_back),
        cmocka_unit_test(figures_come_back),
        cmocka_unit_test(heights_are_measured),
        cmocka_unit_test(broken_utf16),
        cmocka_unit_test(utf8_there_and_back),
        cmocka_unit_test(files_that_are_no_fonts),
        cmocka_unit_test(files_cut_short),
        cmocka_unit_test(fonts_that_lack_something),
        cmocka_unit_test(kerning_beside_type1),
        cmocka_unit_test(woff2_packed_well),
        cmocka_unit_test(woff2_of_a_size_declared),
        cmocka_unit_test(figures_without_tables),
        cmocka_unit_test(a_bitmap_font),
        cmocka_unit_test(faces_and_axes_that_are_not_there),
        cmocka_unit_test(a_woff),
        cmocka_unit_test(truetype),
        cmocka_unit_test(a_collection_of_cff),
        cmocka_unit_test(a_variable_font),
        cmocka_unit_test(type1),
        cmocka_unit_test(random_damage),
        cmocka_unit_test(every_allocation_may_fail),
        cmocka_unit_test(every_allocation_may_fail_in_a_variable_font),
        cmocka_unit_test(no_glyphs_after_want_of_memory),
    };
    return cmocka_run_group_tests(tests, set_up, mt_test_tear_down);
}
