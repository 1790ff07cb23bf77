/* Animations as a whole: parts paired, ends that are the sources, and every allocation failed in turn. */
#include "motion/motion.h"

#include <math.h>

#include "base/utf.h"
#include "motion/gif.h"
#include "motion/lottie.h"
#include "motion/png.h"
#include "motion/svg.h"
#include "motion/webp.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fonts.h"

static mt_font *sans, *serif;

static int set_up(void **state) {
    (void)state;
    sans = mt_test_font(MT_TEST_SANS);
    serif = mt_test_font(MT_TEST_SERIF);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    mt_font_close(sans);
    mt_font_close(serif);
    return 0;
}

static const mt_colour black = {0, 0, 0};

/* Small, slow, and on one thread, so that runs are alike. */
static mt_motion_request request_of(const mt_key *keys, int count) {
    mt_motion_request request = {.key_count = count,
                                 .keys = keys,
                                 .params = mt_params_default(),
                                 .timing = {.duration = 1, .easing = {0.42, 0, 0.58, 1}, .fps = 2},
                                 .page = {.size = 16},
                                 .colour_count = 1,
                                 .colours = &black,
                                 .has_background = true,
                                 .background = {255, 255, 255}};
    request.params.threads = 1;
    return request;
}

/* A text as a key frame has it. Each is of its own, as long as the test runs. */
static mt_text text_of(const char *utf8) {
    enum { TEXTS = 64, LENGTH = 16 };
    static mt_choice rooms[TEXTS][LENGTH];
    static int used;
    mt_text text = {0, rooms[used]};
    for (const char *at = utf8; *at; text.count++) {
        rooms[used][text.count] = (mt_choice){0};
        assert_true(mt_utf8_next(&at, &rooms[used][text.count].code_point));
        assert_true(text.count < LENGTH);
    }
    assert_true(++used < TEXTS);
    return text;
}

static mt_status read(mt_font *font, const char *utf8, mt_arena *arena, mt_figure *figure, int *lacking) {
    const mt_text text = text_of(utf8);
    return mt_figure_read(font, &text, 0.5, arena, figure, lacking);
}

/* ---- parts --------------------------------------------------------------------------------------------- */

/* Pairs as text: of each, the first characters of all parts, - for none. */
static void assert_pairs(const char *a, const char *b, const char *wanted) {
    mt_arena arena = {0};
    mt_figure first, second;
    mt_part_pairs pairs;
    int lacking;
    char text[128];
    int length = 0;
    mt_assert_ok(read(sans, a, &arena, &first, &lacking));
    mt_assert_ok(read(serif, b, &arena, &second, &lacking));
    mt_assert_ok(mt_pair_parts(&first, &second, &arena, &pairs));
    for (int i = 0; i < pairs.count; i++) {
        mt_part_pair pair = pairs.pairs[i];
        if (pair.a.count == 0) text[length++] = '-';
        for (int k = 0; k < pair.a.count; k++) text[length++] = (char)first.parts[pair.a.first + k].text[0];
        if (pair.b.count == 0) text[length++] = '-';
        for (int k = 0; k < pair.b.count; k++) text[length++] = (char)second.parts[pair.b.first + k].text[0];
        text[length++] = ' ';
    }
    text[length] = '\0';
    assert_string_equal(text, wanted);
    mt_arena_release(&arena);
}

static void parts_are_paired_in_order(void **state) {
    (void)state;
    assert_pairs("abc", "xyz", "ax by cz ");
    assert_pairs("cat", "cart", "cc aa -r tt ");
    assert_pairs("cart", "cat", "cc aa r- tt ");
    assert_pairs("a", "bab", "-b aa -b ");
    assert_pairs("a b", "cd", "ac bd ");
    assert_pairs("o", "xyz", "oxyz ");
    assert_pairs("wxyz", "o", "wxyzo ");
    assert_pairs("wxyz", "op", "wxo yzp "); /* each the nearest */
    assert_pairs("wanz", "axz", "w- aa nx zz ");
    assert_pairs("aw", "abc", "aa wbc ");
}

/* A letter and its marks are one part. */
static void clusters_are_parts(void **state) {
    (void)state;
    mt_arena arena = {0};
    mt_figure figure;
    int lacking;
    mt_assert_ok(read(sans, "x\xcc\x8b", &arena, &figure, &lacking)); /* U+030B */
    assert_int_equal(figure.count, 1);
    assert_int_equal(figure.parts[0].shape.count, 3);
    assert_int_equal(read(sans, " ", &arena, &figure, &lacking), MT_BLANK);
    assert_int_equal(read(sans, "a\xe4\xb8\x80", &arena, &figure, &lacking), MT_NO_GLYPH); /* U+4E00 */
    assert_int_equal(lacking, 1);
    mt_arena_release(&arena);
}

/* A glyph by its name between two characters is one part more, where the character would stand. */
static void names_stand_among_characters(void **state) {
    (void)state;
    mt_arena arena = {0};
    mt_figure typed, named;
    int lacking;
    mt_choice choices[] = {{.code_point = 'n'}, {.name = "o"}, {.code_point = 'i'}};
    const mt_text text = {3, choices};
    choices[1].glyph = mt_font_glyph(sans, 'o');
    mt_assert_ok(mt_figure_read(sans, &text, 0.5, &arena, &named, &lacking));
    mt_assert_ok(read(sans, "noi", &arena, &typed, &lacking));
    assert_int_equal(named.count, 3);
    assert_true(named.advance == typed.advance); /* no kerning in these */
    for (int i = 0; i < 3; i++) {
        assert_true(named.parts[i].place.x == typed.parts[i].place.x);
        assert_int_equal(named.parts[i].glyph, typed.parts[i].glyph);
    }
    assert_null(named.parts[1].text);
    assert_int_equal(named.parts[2].text[0], 'i');
    mt_arena_release(&arena);
}

/* ---- motion -------------------------------------------------------------------------------------------- */

/* Twice the signed area of all contours' points, grid units squared: a rough measure that only equal drawings share. */
static double area_of(const mt_drawing *drawing) {
    double area = 0;
    for (int i = 0; i < drawing->count; i++)
        for (int k = 0; k < drawing->list[i].outline.count; k++) {
            const mt_contour *c = &drawing->list[i].outline.contours[k];
            for (int j = 0; j < c->count; j++) {
                mt_point p = c->segments[j].end, q = c->segments[(j + 1) % c->count].end;
                area += (double)p.x * q.y - (double)q.x * p.y;
            }
        }
    return area;
}

static void ends_are_the_sources(void **state) {
    (void)state;
    const mt_key keys[] = {
        {sans, text_of("8"), NULL}, {serif, text_of("cat"), NULL}, {sans, text_of("S"), NULL}};
    mt_motion_request request = request_of(keys, 3);
    mt_motion motion;
    mt_motion_fault fault;
    mt_arena arena = {0};
    mt_assert_ok(mt_motion_open(&request, &motion, &fault));
    for (int i = 0; i < 2; i++)
        for (int end = 0; end < 2; end++) {
            mt_drawing drawing, source;
            mt_assert_ok(mt_motion_draw(&motion, (mt_moment){i, end}, true, &arena, &drawing));
            mt_assert_ok(mt_figure_drawing(&motion.figures[i + end], &arena, &source));
            assert_int_equal(drawing.count, source.count);
            assert_true(area_of(&drawing) == area_of(&source));
        }
    assert_int_equal(motion.page.width % 2, 0);
    mt_arena_release(&arena);
    mt_motion_close(&motion);
}

/* A letter that has no partner is a point at one end, and its own area at the other; half-way it has a quarter of that. */
static void surplus_grows(void **state) {
    (void)state;
    mt_arena arena = {0};
    mt_figure figure;
    mt_moving_part part;
    int lacking;
    const mt_params params = mt_params_default();
    double areas[3];
    mt_assert_ok(read(sans, "r", &arena, &figure, &lacking));
    mt_assert_ok(mt_moving_part_make(NULL, &figure.parts[0], &(mt_hints){0}, &params, &arena, &arena, &part));
    mt_stretch stretch = {.pairs = {.count = 1}, .parts = &part};
    assert_int_equal(mt_stretch_steps(&stretch), 1);
    for (int i = 0; i < 3; i++) {
        mt_drawing drawing;
        mt_assert_ok(mt_stretch_at(&stretch, i / 2.0, &arena, &drawing));
        areas[i] = fabs(area_of(&drawing));
    }
    assert_true(areas[0] == 0 && areas[2] > 0);
    assert_true(fabs(areas[1] / areas[2] - 0.25) < 0.001);
    mt_arena_release(&arena);
}

/* ---- memory -------------------------------------------------------------------------------------------- */

typedef mt_status (*write_format)(const mt_motion *motion, mt_buffer *file);

static mt_status make(const mt_motion_request *request, write_format write) {
    mt_motion motion;
    mt_motion_fault fault;
    mt_buffer file = {0};
    mt_status status = mt_motion_open(request, &motion, &fault);
    if (status == MT_OK) status = write(&motion, &file);
    mt_buffer_free(&file);
    mt_motion_close(&motion);
    return status;
}

/* The fonts stay open, so that what is counted is the motion's own. Once FreeType went without memory a font gives no glyph: the
 * requests that are failed are those after the key frames are read. */
static void survives_want_of_memory(void **state) {
    (void)state;
    static const write_format formats[] = {mt_svg_smil, mt_svg_css, mt_lottie, mt_apng, mt_gif, mt_webp};
    mt_font *a = sans, *b = serif;
    const mt_key keys[] = {{a, text_of("l"), NULL}, {b, text_of("li"), NULL}, {a, text_of("i"), NULL}};
    mt_motion_request request = request_of(keys, 3);
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++) {
        mt_motion motion;
        mt_motion_fault fault;
        mt_assert_ok(make(&request, formats[f]));
        mt_assert_ok(mt_motion_open(&request, &motion, &fault));
        mt_status status = MT_NO_MEMORY;
        for (long fails = 0; status == MT_NO_MEMORY; fails++) {
            mt_buffer file = {0};
            mt_allocation_watch();
            mt_allocation_fail(fails, true);
            status = formats[f](&motion, &file);
            mt_allocation_succeed();
            mt_buffer_free(&file);
            assert_int_equal(mt_allocation_live(), 0);
            mt_allocation_unwatch();
            assert_true(fails < 10000);
        }
        mt_assert_ok(status);
        mt_motion_close(&motion);
    }
}

/* From drawing to drawing no font is asked, so that all of it can be failed: drawings read, parts prepared, the canvas. */
static mt_status make_of_drawings(void) {
    static const char ring[] =
        "<svg viewBox='0 0 9 9'><path fill-rule='evenodd' d='M0 0H9V9H0zM3 3H6V6H3z'/></svg>";
    static const char bar[] =
        "<svg viewBox='0 0 9 9'><path d='M0 0H9V3H0z'/><circle cx='4' cy='2' r='2'/></svg>";
    mt_arena arena = {0};
    mt_svg_drawing drawings[2];
    const char *problem;
    mt_key keys[] = {{.drawing = &drawings[0]}, {.drawing = &drawings[1]}};
    mt_motion_request request = request_of(keys, 2);
    mt_status status = mt_svg_read((const uint8_t *)ring, sizeof ring - 1, &arena, &drawings[0], &problem);
    if (status == MT_OK)
        status = mt_svg_read((const uint8_t *)bar, sizeof bar - 1, &arena, &drawings[1], &problem);
    if (status == MT_OK) status = make(&request, mt_apng);
    mt_arena_release(&arena);
    return status;
}

static void drawings_survive_want_of_memory(void **state) {
    (void)state;
    mt_test_want_of_memory(make_of_drawings);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_are_paired_in_order),
        cmocka_unit_test(clusters_are_parts),
        cmocka_unit_test(names_stand_among_characters),
        cmocka_unit_test(ends_are_the_sources),
        cmocka_unit_test(surplus_grows),
        cmocka_unit_test(survives_want_of_memory),
        cmocka_unit_test(drawings_survive_want_of_memory),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
