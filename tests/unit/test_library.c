/* The library as a host uses it: fonts from memory, outlines, work that is stopped, strips, reports and specimens. */
#include "morphotype.h"

#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"
#include "write/write.h"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#define SANS "MorphotypeDemo-Sans.ttf"
#define SERIF "MorphotypeDemo-Serif.otf"

static const char *demo_path(const char *name) {
    return mt_sample_path(&arena, getenv("MT_DEMO_FONTS"), name);
}

static uint8_t *demo_bytes(const char *name, size_t *length) {
    return mt_sample_load(&arena, demo_path(name), length);
}

typedef struct font_pair {
    mt_font *a, *b;
    mt_blend *blend;
} font_pair;

static font_pair open_pair(int threads) {
    font_pair pair;
    mt_params params = mt_params_default();
    params.threads = threads;
    mt_assert_ok(mt_font_open(demo_path(SANS), &pair.a));
    mt_assert_ok(mt_font_open(demo_path(SERIF), &pair.b));
    mt_assert_ok(mt_blend_new(pair.a, pair.b, &params, &pair.blend));
    return pair;
}

static void close_pair(font_pair *pair) {
    mt_blend_free(pair->blend);
    mt_font_close(pair->a);
    mt_font_close(pair->b);
}

static void the_version_is_the_header_s(void **state) {
    (void)state;
    assert_string_equal(mt_version(), MORPHOTYPE_VERSION);
}

/* ---- fonts from memory ----------------------------------------------------------------------------------- */

static void assert_memory_fails(const void *bytes, size_t length, const char *choice, mt_status status) {
    mt_font *font = NULL;
    assert_int_equal(mt_font_open_memory(bytes, length, NULL, choice, &font), status);
    assert_null(font);
}

/* The bytes may go once the font is open. */
static mt_font *open_copy(const char *name) {
    size_t length;
    mt_font *font;
    uint8_t *bytes = demo_bytes(name, &length);
    mt_assert_ok(mt_font_open_memory(bytes, length, name, NULL, &font));
    memset(bytes, 0xAA, length);
    return font;
}

static void a_font_in_memory_is_as_its_file(void **state) {
    (void)state;
    font_pair files = open_pair(1), copies = {open_copy(SANS), open_copy(SERIF), NULL};
    mt_params params = mt_params_default();
    const uint32_t letters[] = {'A', 'g'};
    uint8_t *of_files, *of_copies;
    size_t files_length, copies_length;
    mt_assert_ok(mt_blend_new(copies.a, copies.b, &params, &copies.blend));
    mt_assert_ok(mt_blend_set_chars(files.blend, letters, 2));
    mt_assert_ok(mt_blend_set_chars(copies.blend, letters, 2));
    mt_assert_ok(mt_blend_font(files.blend, 0.5, &of_files, &files_length));
    mt_assert_ok(mt_blend_font(copies.blend, 0.5, &of_copies, &copies_length));
    assert_int_equal(files_length, copies_length);
    assert_memory_equal(of_files, of_copies, files_length);
    mt_bytes_free(of_files);
    mt_bytes_free(of_copies);
    close_pair(&files);
    close_pair(&copies);
}

static void a_choice_is_as_in_a_spec(void **state) {
    (void)state;
    size_t length;
    mt_font *font;
    uint8_t *bytes = demo_bytes(SANS, &length);
    mt_assert_ok(mt_font_open_memory(bytes, length, NULL, "#0", &font));
    mt_font_close(font);
    assert_memory_fails(bytes, length, "#1", MT_NO_FACE);
    assert_memory_fails(bytes, length, "#x", MT_NO_FACE);
    assert_memory_fails(bytes, length, "@wght=400", MT_NO_AXIS);
    assert_memory_fails(bytes, length, "@wght", MT_BAD_AXIS);
    assert_memory_fails(bytes, length, ":zzzz", MT_NO_FEATURE);
    assert_memory_fails(bytes, length, ":", MT_BAD_FEATURE);
    assert_memory_fails(bytes, length, "0", MT_BAD_PARAMETER);
}

static void bytes_that_are_no_font_are_told(void **state) {
    (void)state;
    size_t length;
    uint8_t *bytes = demo_bytes(SANS, &length);
    assert_memory_fails(NULL, 0, NULL, MT_NOT_A_FONT);
    assert_memory_fails("%PDF-1.4", 8, NULL, MT_NOT_A_FONT);
    assert_memory_fails(bytes, length / 2, NULL, MT_NOT_A_FONT);
    assert_memory_fails(bytes, ((size_t)1 << 30) + 1, NULL, MT_TOO_LARGE);
}

/* ---- outlines -------------------------------------------------------------------------------------------- */

/* Twice the area that contours enclose: exact for lines, within curves' 64 chords. */
typedef struct drawn {
    int moves, lines, curves, closed;
    double area, x, y, start_x, start_y;
} drawn;

static void go_to(drawn *d, double x, double y) {
    d->area += d->x * y - x * d->y;
    d->x = x;
    d->y = y;
}

static void move_to(double x, double y, void *user) {
    drawn *d = user;
    d->moves++;
    d->x = d->start_x = x;
    d->y = d->start_y = y;
}

static void line_to(double x, double y, void *user) {
    drawn *d = user;
    d->lines++;
    go_to(d, x, y);
}

static void cubic_to(double bx, double by, double cx, double cy, double x, double y, void *user) {
    drawn *d = user;
    double ax = d->x, ay = d->y;
    d->curves++;
    for (int i = 1; i <= 64; i++) {
        double t = i / 64.0, s = 1 - t;
        go_to(d, s * s * s * ax + 3 * s * s * t * bx + 3 * s * t * t * cx + t * t * t * x,
              s * s * s * ay + 3 * s * s * t * by + 3 * s * t * t * cy + t * t * t * y);
    }
}

static void quadratic_to(double cx, double cy, double x, double y, void *user) {
    drawn *d = user;
    cubic_to(d->x + (cx - d->x) * 2 / 3, d->y + (cy - d->y) * 2 / 3, x + (cx - x) * 2 / 3,
             y + (cy - y) * 2 / 3, x, y, user);
}

static void close_contour(void *user) {
    drawn *d = user;
    d->closed++;
    assert_true(d->x == d->start_x && d->y == d->start_y);
}

static const mt_draw draw = {move_to, line_to, quadratic_to, close_contour, cubic_to};

/* The same out of FreeType itself. */
static int ft_move(const FT_Vector *to, void *user) {
    drawn *d = user;
    if (d->moves) go_to(d, d->start_x, d->start_y);
    move_to((double)to->x, (double)to->y, user);
    return 0;
}

static int ft_line(const FT_Vector *to, void *user) {
    line_to((double)to->x, (double)to->y, user);
    return 0;
}

static int ft_conic(const FT_Vector *c, const FT_Vector *to, void *user) {
    quadratic_to((double)c->x, (double)c->y, (double)to->x, (double)to->y, user);
    return 0;
}

static int ft_cubic(const FT_Vector *b, const FT_Vector *c, const FT_Vector *to, void *user) {
    cubic_to((double)b->x, (double)b->y, (double)c->x, (double)c->y, (double)to->x, (double)to->y, user);
    return 0;
}

static drawn drawn_by_freetype(const char *path, FT_UInt glyph, double *advance) {
    static const FT_Outline_Funcs calls = {ft_move, ft_line, ft_conic, ft_cubic, 0, 0};
    drawn d = {0};
    FT_Library library;
    FT_Face face;
    assert_int_equal(FT_Init_FreeType(&library), 0);
    assert_int_equal(FT_New_Face(library, path, 0, &face), 0);
    assert_int_equal(FT_Load_Glyph(face, glyph, FT_LOAD_NO_SCALE), 0);
    assert_int_equal(FT_Outline_Decompose(&face->glyph->outline, &calls, &d), 0);
    if (d.moves) go_to(&d, d.start_x, d.start_y);
    *advance = (double)face->glyph->advance.x;
    FT_Done_FreeType(library);
    return d;
}

static void a_font_s_glyphs_are_its_own(void **state) {
    (void)state;
    static const char *const names[] = {SANS, SERIF};
    static const int units[] = {1000, 2048};
    for (int f = 0; f < 2; f++) {
        mt_font *font;
        mt_assert_ok(mt_font_open(demo_path(names[f]), &font));
        assert_int_equal(mt_font_units_per_em(font), units[f]);
        for (uint32_t code_point = 'a'; code_point <= 'z'; code_point++) {
            uint32_t glyph = mt_font_glyph(font, code_point);
            double advance = -1, expected_advance;
            drawn d = {0};
            if (glyph == 0) continue;
            mt_assert_ok(mt_font_draw(font, glyph, &draw, &d, &advance));
            drawn expected = drawn_by_freetype(demo_path(names[f]), glyph, &expected_advance);
            assert_int_equal(d.moves, expected.moves);
            assert_int_equal(d.closed, d.moves);
            assert_int_equal(d.curves, expected.curves);
            /* FreeType rounds the points that a TrueType outline implies. */
            assert_true(fabs(d.area - expected.area) < 0.002 * fabs(expected.area));
            assert_true(fabs(d.area) > 1000 && advance == expected_advance);
        }
        mt_font_close(font);
    }
}

static void glyphs_that_cannot_be_drawn(void **state) {
    (void)state;
    mt_draw without_cubics = draw;
    mt_font *font;
    drawn d = {0};
    double advance;
    without_cubics.cubic_to = NULL;
    mt_assert_ok(mt_font_open(demo_path(SERIF), &font));
    uint32_t glyph;
    mt_assert_ok(mt_font_glyph_of_name(font, "g", &glyph));
    assert_int_equal(mt_font_draw(font, glyph, &without_cubics, &d, &advance), MT_BAD_PARAMETER);
    assert_int_equal(mt_font_draw(font, 0x10000, &draw, &d, &advance), MT_NO_GLYPH);
    assert_int_equal(mt_font_draw(font, UINT32_MAX, &draw, &d, &advance), MT_NO_GLYPH);
    assert_int_equal(d.moves, 0);
    mt_font_close(font);
}

static void a_glyph_by_its_number_is_its_character_s(void **state) {
    (void)state;
    font_pair pair = open_pair(1);
    drawn by_char = {0}, by_number = {0};
    double advance, numbered_advance;
    uint32_t glyph = mt_font_glyph(pair.a, 'g');
    mt_assert_ok(mt_blend_glyph(pair.blend, 'g', 0.5, &draw, &by_char, &advance));
    mt_assert_ok(mt_blend_glyph_numbered(pair.blend, glyph, 0.5, &draw, &by_number, &numbered_advance));
    assert_memory_equal(&by_char, &by_number, sizeof by_char);
    assert_true(by_char.curves > 0 && advance == numbered_advance);
    assert_int_equal(mt_blend_glyph_numbered(pair.blend, 60000, 0.5, &draw, &by_number, &advance),
                     MT_NO_GLYPH);
    assert_int_equal(mt_blend_glyph_numbered(pair.blend, glyph, 2, &draw, &by_number, &advance),
                     MT_BAD_PARAMETER);
    close_pair(&pair);
}

/* ---- places ---------------------------------------------------------------------------------------------- */

static size_t length_of(mt_blend *blend, const double *t, int count) {
    uint8_t *bytes[2];
    size_t lengths[2];
    mt_assert_ok(mt_blend_fonts(blend, t, count, bytes, lengths));
    for (int i = 0; i < count; i++) mt_bytes_free(bytes[i]);
    return lengths[0];
}

static void heights_are_for_as_many_fonts(void **state) {
    (void)state;
    const double t[] = {0.3, 0.6}, far[] = {0.3, 2.5};
    const uint32_t text[] = {'n', 'o'};
    uint8_t *bytes[2];
    size_t lengths[2];
    drawn plain = {0}, high = {0};
    double advance;
    font_pair pair = open_pair(1);
    mt_assert_ok(mt_blend_set_chars(pair.blend, text, 2));
    mt_assert_ok(mt_blend_glyph(pair.blend, 'n', 0.3, &draw, &plain, &advance));
    mt_assert_ok(mt_blend_set_heights(pair.blend, &t[1], 1));
    mt_assert_ok(mt_blend_glyph(pair.blend, 'n', 0.3, &draw, &high, &advance));
    assert_memory_not_equal(&plain, &high, sizeof plain);
    assert_true(length_of(pair.blend, t, 1) > 0);
    assert_int_equal(mt_blend_fonts(pair.blend, t, 2, bytes, lengths), MT_BAD_PARAMETER);
    mt_assert_ok(mt_blend_set_heights(pair.blend, far, 2));
    assert_int_equal(mt_blend_fonts(pair.blend, t, 2, bytes, lengths), MT_BAD_PARAMETER);
    mt_assert_ok(mt_blend_set_heights(pair.blend, NULL, 0));
    assert_true(length_of(pair.blend, t, 2) > 0);
    close_pair(&pair);
}

static void places_are_of_glyphs_each_once(void **state) {
    (void)state;
    const double t[] = {0.3, 0.6}, far[] = {0.3, 2.5};
    font_pair pair = open_pair(1);
    const uint32_t n = mt_font_glyph(pair.a, 'n'), o = mt_font_glyph(pair.a, 'o');
    const uint32_t good[] = {n, o}, twice[] = {o, o}, none[] = {n, 60000}, text[] = {'n', 'o'};
    uint8_t *bytes;
    size_t length;
    assert_int_equal(mt_blend_set_places(pair.blend, twice, t, NULL, 2), MT_BAD_PARAMETER);
    assert_int_equal(mt_blend_set_places(pair.blend, none, t, NULL, 2), MT_BAD_PARAMETER);
    mt_assert_ok(mt_blend_set_chars(pair.blend, text, 2));
    mt_assert_ok(mt_blend_set_places(pair.blend, good, t, far, 2));
    assert_int_equal(mt_blend_font(pair.blend, 0.5, &bytes, &length), MT_BAD_PARAMETER);
    mt_assert_ok(mt_blend_set_places(pair.blend, good, t, NULL, 2));
    assert_true(length_of(pair.blend, t, 2) > 0);
    close_pair(&pair);
}

/* ---- work that is stopped -------------------------------------------------------------------------------- */

/* Stops the work at a call of the progress, and counts those that come later. */
typedef struct stopper {
    mt_blend *blend;
    mt_variable *variable;
    int at, last, late, told;
} stopper;

static void stop_at(int done, int all, void *user) {
    stopper *s = user;
    assert_int_equal(done, s->last + 1);
    assert_in_range(done, 1, all);
    s->last = done;
    s->late += done > s->at;
    if (done == s->at && s->blend) mt_blend_stop(s->blend, true);
    if (done == s->at && s->variable) mt_variable_stop(s->variable, true);
}

static void note_failure(const mt_glyph_note *note, void *user) {
    stopper *s = user;
    (void)note;
    s->told++;
}

static void stopped_work_leaves_nothing(void **state) {
    (void)state;
    for (int threads = 1; threads <= 3; threads++) {
        font_pair pair = open_pair(threads);
        stopper s = {.blend = pair.blend, .at = 5};
        uint8_t *bytes = NULL;
        size_t length = 0;
        mt_report *report = NULL;
        mt_blend_on_progress(pair.blend, stop_at, &s);
        mt_blend_on_glyph_failure(pair.blend, note_failure, &s);
        mt_blend_on_cut_short(pair.blend, note_failure, &s);
        assert_int_equal(mt_blend_save(pair.blend, 0.5, mt_sample_path(&arena, directory, "x.ttf")),
                         MT_STOPPED);
        assert_in_range(s.last, 5, 5 + threads);
        assert_int_equal(mt_blend_font(pair.blend, 0.5, &bytes, &length), MT_STOPPED);
        assert_int_equal(mt_report_new(pair.blend, &report), MT_STOPPED);
        assert_in_range(s.last, 5, 5 + threads);
        assert_int_equal(s.told, 0);
        assert_null(bytes);
        assert_null(report);
        assert_int_equal(mt_sample_count(directory), 0);
        close_pair(&pair);
    }
}

static void work_goes_on_as_if_never_stopped(void **state) {
    (void)state;
    const uint32_t letters[] = {'a', 'g', 'B'};
    uint8_t *bytes[2];
    size_t lengths[2];
    font_pair pair = open_pair(2);
    mt_assert_ok(mt_blend_set_chars(pair.blend, letters, 3));
    mt_assert_ok(mt_blend_font(pair.blend, 0.5, &bytes[0], &lengths[0]));
    mt_blend_stop(pair.blend, true);
    assert_int_equal(mt_blend_font(pair.blend, 0.5, &bytes[1], &lengths[1]), MT_STOPPED);
    drawn d = {0};
    double advance;
    assert_int_equal(mt_blend_glyph(pair.blend, 'g', 0.5, &draw, &d, &advance), MT_STOPPED);
    assert_int_equal(d.moves, 0);
    mt_blend_stop(pair.blend, false);
    mt_assert_ok(mt_blend_font(pair.blend, 0.5, &bytes[1], &lengths[1]));
    assert_int_equal(lengths[0], lengths[1]);
    assert_memory_equal(bytes[0], bytes[1], lengths[0]);
    for (int i = 0; i < 2; i++) mt_bytes_free(bytes[i]);
    close_pair(&pair);
}

static void variable_fonts_stop_too(void **state) {
    (void)state;
    font_pair pair = open_pair(1);
    mt_params params = mt_params_default();
    mt_variable *variable;
    mt_assert_ok(mt_variable_new((mt_font *[]){pair.a, pair.b}, 2, &params, &variable));
    stopper s = {.variable = variable, .at = 3};
    mt_variable_on_progress(variable, stop_at, &s);
    mt_variable_on_glyph_failure(variable, note_failure, &s);
    const mt_specimen_request request = {.variable = variable};
    assert_int_equal(mt_specimen_save(&request, mt_sample_path(&arena, directory, "x.html")), MT_STOPPED);
    assert_int_equal(mt_variable_save(variable, mt_sample_path(&arena, directory, "x.designspace")),
                     MT_STOPPED);
    assert_int_equal(s.told, 0);
    assert_int_equal(mt_sample_count(directory), 0);
    mt_variable_free(variable);
    close_pair(&pair);
}

/* ---- judging --------------------------------------------------------------------------------------------- */

static bool holds(const uint8_t *bytes, size_t length, const char *text) {
    size_t n = strlen(text);
    for (size_t i = 0; i + n <= length; i++)
        if (memcmp(bytes + i, text, n) == 0) return true;
    return false;
}

static bool file_holds(const char *path, const char *text) {
    size_t length;
    const uint8_t *bytes = mt_sample_load(&arena, path, &length);
    return holds(bytes, length, text);
}

static void a_report_is_data_and_a_file(void **state) {
    (void)state;
    const uint32_t letters[] = {'a', 'g', 'B'};
    const char *path = mt_sample_path(&arena, directory, "report.json");
    char glyphs[32], flagged[32];
    uint8_t *bytes;
    size_t length, file_length;
    mt_report *report;
    font_pair pair = open_pair(0);
    mt_assert_ok(mt_blend_set_chars(pair.blend, letters, 3));
    mt_assert_ok(mt_report_new(pair.blend, &report));
    assert_int_equal(mt_report_count(report), 3);
    mt_assert_ok(mt_report_bytes(report, MT_REPORT_JSON, &bytes, &length));
    snprintf(glyphs, sizeof glyphs, "\"glyphs\": %d", mt_report_count(report));
    snprintf(flagged, sizeof flagged, "\"flagged\": %d", mt_report_flagged(report, MT_FLAG_ALL));
    assert_true(holds(bytes, length, glyphs) && holds(bytes, length, flagged));
    mt_assert_ok(mt_report_save(report, path));
    uint8_t *file = mt_sample_load(&arena, path, &file_length);
    assert_int_equal(file_length, length);
    assert_memory_equal(file, bytes, length);
    assert_int_equal(mt_report_save(report, mt_sample_path(&arena, directory, "report.txt")),
                     MT_UNKNOWN_FORMAT);
    mt_bytes_free(bytes);
    mt_assert_ok(mt_report_bytes(report, MT_REPORT_HTML, &bytes, &length));
    assert_true(holds(bytes, length, "<!DOCTYPE html>"));
    mt_bytes_free(bytes);
    mt_report_free(report);
    close_pair(&pair);
    assert_int_equal(unlink(path), 0);
}

static void strips_and_specimens_are_files(void **state) {
    (void)state;
    font_pair pair = open_pair(0);
    const double at[] = {0, 0.5, 1};
    const mt_choice text[] = {{.code_point = 'g'}, {.name = "g", .glyph = mt_font_glyph(pair.a, 'g')}};
    mt_strip strip = {.text = text, .length = 2, .at = at, .step_count = 3, .size = 40};
    const char *picture = mt_sample_path(&arena, directory, "strip.svg"),
               *page = mt_sample_path(&arena, directory, "specimen.html");
    mt_assert_ok(mt_strip_save(pair.blend, &strip, picture));
    assert_true(file_holds(picture, "<svg"));
    assert_int_equal(mt_strip_save(pair.blend, &strip, "strip.doc"), MT_UNKNOWN_FORMAT);
    strip.size = 1;
    assert_int_equal(mt_strip_save(pair.blend, &strip, picture), MT_BAD_PARAMETER);
    const mt_choice none = {.name = "none", .glyph = 60000};
    strip = (mt_strip){.text = &none, .length = 1, .at = at, .step_count = 3, .size = 40};
    assert_int_equal(mt_strip_save(pair.blend, &strip, picture), MT_BAD_PARAMETER);
    mt_params params = mt_params_default();
    mt_variable *variable;
    mt_assert_ok(mt_variable_new((mt_font *[]){pair.a, pair.b}, 2, &params, &variable));
    mt_assert_ok(mt_variable_set_chars(variable, (uint32_t[]){'g'}, 1));
    mt_assert_ok(mt_specimen_save(&(mt_specimen_request){.variable = variable, .text = "g"}, page));
    assert_true(file_holds(page, "font/woff2"));
    mt_variable_free(variable);
    close_pair(&pair);
    assert_int_equal(unlink(picture) + unlink(page), 0);
}

/* ---- want of memory -------------------------------------------------------------------------------------- */

static uint8_t *sample;
static size_t sample_length;

/* The sample font with itself. */
static mt_status use(void) {
    mt_font *font = NULL;
    mt_blend *blend = NULL;
    mt_report *report = NULL;
    mt_params params = mt_params_default();
    drawn d = {0};
    double advance;
    uint8_t *bytes = NULL;
    size_t length;
    params.threads = 1;
    mt_status status = mt_font_open_memory(sample, sample_length, "sample", "", &font);
    if (status == MT_OK) status = mt_font_draw(font, 1, &draw, &d, &advance);
    if (status == MT_OK) status = mt_blend_new(font, font, &params, &blend);
    if (status == MT_OK) status = mt_blend_glyph_numbered(blend, 1, 0.5, &draw, &d, &advance);
    if (status == MT_OK) status = mt_report_new(blend, &report);
    if (status == MT_OK) status = mt_report_bytes(report, MT_REPORT_JSON, &bytes, &length);
    mt_bytes_free(bytes);
    mt_report_free(report);
    mt_blend_free(blend);
    mt_font_close(font);
    return status;
}

static void survives_want_of_memory(void **state) {
    (void)state;
    uint8_t *bytes;
    mt_font_data data = mt_sample_font(&arena);
    mt_assert_ok(mt_font_write(&data, &bytes, &sample_length));
    sample = mt_arena_new(&arena, sample_length, 1);
    memcpy(sample, bytes, sample_length);
    mt_bytes_free(bytes);
    mt_test_want_of_memory(use);
}

/* ---- handles in threads ---------------------------------------------------------------------------------- */

typedef struct host_thread {
    pthread_t thread;
    const char *sans, *serif;
    mt_status status;
    uint8_t *bytes[2]; /* a blend, and a variable font */
    size_t lengths[2];
} host_thread;

static mt_status make_variable(mt_font *const *fonts, const mt_params *params, const uint32_t *letters,
                               int count, host_thread *host) {
    mt_variable *variable = NULL;
    mt_status status = mt_variable_new(fonts, 2, params, &variable);
    if (status == MT_OK) status = mt_variable_set_chars(variable, letters, count);
    if (status == MT_OK) status = mt_variable_font(variable, &host->bytes[1], &host->lengths[1]);
    mt_variable_free(variable);
    return status;
}

/* Opens the fonts for itself, and makes both fonts with two threads of its own. */
static void *make_both(void *user) {
    host_thread *host = user;
    const uint32_t letters[] = {'A', 'g', 'k'};
    mt_params params = mt_params_default();
    mt_font *fonts[2] = {NULL, NULL};
    mt_blend *blend = NULL;
    params.threads = 2;
    host->status = mt_font_open(host->sans, &fonts[0]);
    if (host->status == MT_OK) host->status = mt_font_open(host->serif, &fonts[1]);
    if (host->status == MT_OK) host->status = mt_blend_new(fonts[0], fonts[1], &params, &blend);
    if (host->status == MT_OK) host->status = mt_blend_set_chars(blend, letters, 3);
    if (host->status == MT_OK) host->status = mt_blend_font(blend, 0.5, &host->bytes[0], &host->lengths[0]);
    if (host->status == MT_OK) host->status = make_variable(fonts, &params, letters, 3, host);
    mt_blend_free(blend);
    mt_font_close(fonts[0]);
    mt_font_close(fonts[1]);
    return NULL;
}

/* Different handles in different threads have nothing in common: all make the same bytes. */
static void threads_with_handles_of_their_own(void **state) {
    (void)state;
    enum { HOSTS = 4 };
    host_thread hosts[HOSTS] = {0};
    for (int i = 0; i < HOSTS; i++) {
        hosts[i].sans = demo_path(SANS);
        hosts[i].serif = demo_path(SERIF);
        assert_int_equal(pthread_create(&hosts[i].thread, NULL, make_both, &hosts[i]), 0);
    }
    for (int i = 0; i < HOSTS; i++) assert_int_equal(pthread_join(hosts[i].thread, NULL), 0);
    for (int i = 0; i < HOSTS; i++) {
        mt_assert_ok(hosts[i].status);
        for (int k = 0; k < 2; k++) {
            assert_int_equal(hosts[i].lengths[k], hosts[0].lengths[k]);
            assert_memory_equal(hosts[i].bytes[k], hosts[0].bytes[k], hosts[0].lengths[k]);
        }
    }
    for (int i = 0; i < HOSTS; i++)
        for (int k = 0; k < 2; k++) mt_bytes_free(hosts[i].bytes[k]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_version_is_the_header_s),
        cmocka_unit_test(a_font_in_memory_is_as_its_file),
        cmocka_unit_test(a_choice_is_as_in_a_spec),
        cmocka_unit_test(bytes_that_are_no_font_are_told),
        cmocka_unit_test(a_font_s_glyphs_are_its_own),
        cmocka_unit_test(glyphs_that_cannot_be_drawn),
        cmocka_unit_test(a_glyph_by_its_number_is_its_character_s),
        cmocka_unit_test(heights_are_for_as_many_fonts),
        cmocka_unit_test(places_are_of_glyphs_each_once),
        cmocka_unit_test(stopped_work_leaves_nothing),
        cmocka_unit_test(work_goes_on_as_if_never_stopped),
        cmocka_unit_test(variable_fonts_stop_too),
        cmocka_unit_test(a_report_is_data_and_a_file),
        cmocka_unit_test(strips_and_specimens_are_files),
        cmocka_unit_test(threads_with_handles_of_their_own),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
