/* Drawings of SVG: what each element, attribute and path command draws, and what is refused. */
#include "drawing/svg_drawing.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "geometry/limits.h"
#include "support/allocation.h"
#include "support/check.h"

#define HEAD                                                                                                 \
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' viewBox='0 0 100 "   \
    "100'>"

/* Says which case it is that fails. */
static void tell(bool fails, const char *which) {
    if (fails) print_error("%s\n", which);
}

static mt_status read(const char *text, mt_arena *arena, mt_svg_drawing *drawing, const char **problem) {
    return mt_svg_read((const uint8_t *)text, strlen(text), arena, drawing, problem);
}

static mt_svg_drawing read_inside(const char *content, mt_arena *arena) {
    char text[4096];
    const char *problem;
    mt_svg_drawing drawing;
    assert_true((size_t)snprintf(text, sizeof text, HEAD "%s</svg>", content) < sizeof text);
    mt_status status = read(text, arena, &drawing, &problem);
    if (status != MT_OK) print_error("%s: %s\n", content, mt_status_text(status));
    mt_assert_ok(status);
    return drawing;
}

static mt_status shape_of(const char *content, mt_arena *arena, mt_shape *shape) {
    mt_svg_drawing drawing = read_inside(content, arena);
    return mt_layers_shape(&drawing.layers, 0.5, arena, shape);
}

/* The area that is ink, in units of a page of 100 by 100. */
static double area_of(const char *content) {
    mt_arena arena = {0};
    mt_shape shape;
    mt_assert_ok(shape_of(content, &arena, &shape));
    double area = (double)mt_shape_area2(&shape) / 2 / (MT_EM / 100.0) / (MT_EM / 100.0);
    mt_arena_release(&arena);
    return area;
}

static void assert_area(const char *content, double wanted) {
    double area = area_of(content);
    if (fabs(area - wanted) > 0.002 * wanted + 0.01) print_error("%s: %g for %g\n", content, area, wanted);
    assert_true(fabs(area - wanted) <= 0.002 * wanted + 0.01);
}

/* Both draw the same segments, point by point but for a rounding. */
static void assert_same(const char *one, const char *two) {
    mt_arena arena = {0};
    mt_svg_drawing a = read_inside(one, &arena), b = read_inside(two, &arena);
    assert_int_equal(a.layers.count, b.layers.count);
    for (int i = 0; i < a.layers.count; i++) {
        const mt_outline *p = &a.layers.list[i].outline, *q = &b.layers.list[i].outline;
        assert_int_equal(p->count, q->count);
        assert_int_equal(a.layers.list[i].rule, b.layers.list[i].rule);
        for (int k = 0; k < p->count; k++) {
            if (p->contours[k].count != q->contours[k].count) print_error("%s, %s\n", one, two);
            assert_int_equal(p->contours[k].count, q->contours[k].count);
            for (int j = 0; j < p->contours[k].count; j++) {
                const mt_segment *s = &p->contours[k].segments[j], *t = &q->contours[k].segments[j];
                assert_int_equal(s->degree, t->degree);
                assert_true(abs(s->end.x - t->end.x) <= 1 && abs(s->end.y - t->end.y) <= 1);
                for (int c = 0; c < s->degree - 1; c++)
                    assert_true(abs(s->control[c].x - t->control[c].x) <= 1 &&
                                abs(s->control[c].y - t->control[c].y) <= 1);
            }
        }
    }
    mt_arena_release(&arena);
}

#define PATH(data) "<path d='" data "'/>"

static void path_commands_say_the_same(void **state) {
    (void)state;
    static const char square[] = PATH("M10 10 L30 10 L30 30 L10 30 Z");
    assert_same(square, PATH("m10 10 20 0 0 20 -20 0z"));
    assert_same(square, PATH("M10,10H30V30H10"));
    assert_same(square, PATH("m1e1 10.0h2e1v+20h-.2e2z"));
    assert_same(square, PATH("M10-0M10 10L30 10 30 30 10 30z"));
    assert_same(square, "<polygon points='10,10 30,10 30,30 10,30'/>");
    assert_same(square, "<polyline points='10 10 30 10 30 30 10 30'/>");
    assert_same(square, "<rect x='10' y='10%' width='20px' height='20'/>");
    assert_same(PATH("M0 0l9 0 0 9zl-9 0 0 -9z"),
                PATH("M0 0L9 0 9 9z M0 0L-9 0 -9 -9z")); /* z, and on from there */
    assert_same(PATH("M0 50C0 20 20 0 50 0S100 20 100 50"), PATH("m0 50c0-30 20-50 50-50s50 20 50 50"));
    assert_same(PATH("M0 50C0 20 20 0 50 0S100 20 100 50"), PATH("M0 50C0 20 20 0 50 0 80 0 100 20 100 50"));
    assert_same(PATH("M0 50S20 0 50 0"), PATH("M0 50C0 50 20 0 50 0"));
    assert_same(PATH("M0 50Q25 0 50 50T100 50V99"), PATH("m0 50q25-50 50 0 25 50 50 0v49"));
    assert_area(PATH("M0 0T50 0V50"), 1250); /* no handle before: straight */
}

static void wrong_paths_are_drawn_up_to_there(void **state) {
    (void)state;
    assert_same(PATH("M0 0H9V9L 4 x"), PATH("M0 0H9V9"));
    assert_same(PATH("M0 0H9V9 L4 5 6"), PATH("M0 0H9V9 L4 5"));
    assert_same(PATH("M0 0H9V9 B4 5 6 H50"), PATH("M0 0H9V9"));
    assert_same(PATH("M0 0H9V9A5 5 0 2 1 9 9"), PATH("M0 0H9V9"));
}

#define PI 3.14159265358979

static void arcs_are_of_ellipses(void **state) {
    (void)state;
    assert_area("<circle cx='50' cy='50' r='40'/>", PI * 1600);
    assert_area("<ellipse cx='50' cy='50' rx='40' ry='20'/>", PI * 800);
    assert_area("<ellipse cx='50' cy='50' rx='40'/>", PI * 1600);
    assert_area("<rect width='40' height='20' rx='5'/>", 800 - (4 - PI) * 25);
    assert_area("<rect width='40' height='20' rx='50' ry='5'/>", 800 - (4 - PI) * 100);
    assert_area(PATH("M10 50A40 40 0 0 1 90 50z"), PI * 800);
    assert_area(PATH("M10 50a40 40 0 0180 0z"), PI * 800); /* flags without blanks */
    assert_area(PATH("M50 10A40 40 0 0 1 90 50L50 50z"), PI * 400);
    assert_area(PATH("M50 10A40 40 0 1 0 90 50L50 50z"), PI * 1200);
    assert_area(PATH("M50 10A40 40 0 1 1 90 50z"), PI * 1200 + 800); /* about (90, 10) */
    assert_area(PATH("M10 50A1 1 0 0 1 90 50z"), PI * 800);          /* made large enough */
    assert_area(PATH("M30 50A40 20 90 0 1 70 50z"), PI * 400);
    assert_same(PATH("M10 50A0 9 0 0 1 90 50V9"), PATH("M10 50L90 50V9"));
}

static void rules_and_layers_make_holes_or_do_not(void **state) {
    (void)state;
    static const char both[] = "M0 0H60V60H0zM20 20H40V40H20z";
    char text[256];
    snprintf(text, sizeof text, "<path d='%s'/>", both);
    assert_area(text, 3600);
    snprintf(text, sizeof text, "<path fill-rule='evenodd' d='%s'/>", both);
    assert_area(text, 3200);
    snprintf(text, sizeof text, "<g style='fill-rule:evenodd'><path d='%s'/></g>", both);
    assert_area(text, 3200);
    assert_area(PATH("M0 0H60V60H0zM20 20V40H40V20z"), 3200);
    /* Layers one over the other, in opposite directions. */
    assert_area(PATH("M0 0H60V60H0z") PATH("M40 40V80H80V40z"), 3600 + 1600 - 400);
    assert_area(PATH("M0 0H60V60H0z") PATH("M20 20V40H40V20z"), 3600);
}

static void places_are_transformed(void **state) {
    (void)state;
    static const char wanted[] = PATH("M30 20H50V30H30z");
    assert_same(wanted, "<g transform='translate(30 20)'><rect width='20' height='10'/></g>");
    assert_same(wanted, "<g transform='translate(30,20) scale(2)'><rect width='10' height='5'/></g>");
    assert_same(wanted, "<g transform='matrix(2 0 0 2 30 20)'><rect width='10' height='5'/></g>");
    assert_same(
        wanted,
        "<g transform='translate(30)'><rect transform='translate(0 20)' width='20' height='10'/></g>");
    assert_same(
        wanted,
        "<svg x='30' y='20' width='20' height='10' viewBox='0 0 2 1'><rect width='2' height='1'/></svg>");
    assert_same(wanted,
                "<defs><rect id='r' width='20' height='10'/></defs><use xlink:href='#r' x='30' y='20'/>");
    assert_same(wanted, "<symbol id='s' viewBox='0 0 2 1'><rect width='2' height='1'/></symbol>"
                        "<use href='#s' x='30' y='20' width='20' height='10'/>");
    assert_area("<rect transform='rotate(30)' x='40' width='20' height='10'/>", 200);
    assert_area("<rect transform='skewX(30) scale(2 3)' width='20' height='5'/>", 600);
    assert_same(PATH("M10 0L10 20 20 0z"),
                PATH("M0 10L20 10 0 0z' transform='rotate(90 10 10) translate(0 0)"));
}

static void only_solid_fills_are_drawn(void **state) {
    (void)state;
    static const struct {
        const char *content;
        unsigned left_out;
        bool drawn;
    } cases[] = {
        {"<rect width='9' height='9' fill='none'/>", 0, false},
        {"<g fill='none'><rect width='9' height='9'/></g>", 0, false},
        {"<g style='display:none'><rect width='9' height='9'/></g>", 0, false},
        {"<g visibility='hidden'><rect width='9' height='9'/></g>", 0, false},
        {"<g opacity='0'><rect width='9' height='9'/></g>", 0, false},
        {"<rect width='9' height='9' fill='#12345600'/>", 0, false},
        {"<rect width='9' height='9' fill='none' stroke='red'/>", MT_LEFT_STROKES, false},
        {"<rect width='9' height='9' fill='none' stroke='red' stroke-width='0'/>", 0, false},
        {"<rect width='9' height='9' fill='url(#g)'/>", MT_LEFT_GRADIENTS, false},
        {"<rect width='9' height='9' opacity='.5' filter='url(#f)'/>", MT_LEFT_OPACITY | MT_LEFT_FILTERS,
         true},
        {"<g style='mask:url(#m);clip-path: url(#c)'><rect width='9' height='9'/></g>",
         MT_LEFT_MASKS | MT_LEFT_CLIP_PATHS, true},
        {"<text>a</text><image href='http://example.org/a.png'/>", MT_LEFT_TEXT | MT_LEFT_IMAGES, false},
        {"<script>alert(1)</script><style>g > a{}</style>", MT_LEFT_SCRIPTS | MT_LEFT_STYLE_SHEETS, false},
        {"<rect width='9' height='9' onclick='x()'/>", MT_LEFT_SCRIPTS, true},
        {"<use href='other.svg#a'/>", MT_LEFT_REFERENCES, false},
        {"<clipPath id='c'><rect width='9' height='9'/></clipPath>", 0, false},
        {"<use href='#nothing'/>", 0, false},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1024];
        const char *problem;
        mt_arena arena = {0};
        mt_svg_drawing alone, beside = {0};
        snprintf(text, sizeof text, HEAD "%s</svg>", cases[i].content);
        mt_status status = read(text, &arena, &alone, &problem);
        bool drawn = cases[i].drawn;
        tell(status != (drawn ? MT_OK : MT_BLANK), cases[i].content);
        assert_int_equal(status, drawn ? MT_OK : MT_BLANK);
        assert_int_equal(alone.left_out, cases[i].left_out);
        snprintf(text, sizeof text, HEAD "%s<circle r='5'/></svg>", cases[i].content);
        mt_assert_ok(read(text, &arena, &beside, &problem));
        assert_int_equal(beside.layers.count, 1 + drawn);
        mt_arena_release(&arena);
    }
}

static void style_sheets_select_by_name_class_and_id(void **state) {
    (void)state;
    static const char shapes[] =
        "<rect class='a b' width='10' height='10'/><rect id='r' x='20' width='10' height='10'/>"
        "<path d='M45 0h10v8h-10z'/>";
    static const struct {
        const char *sheet;
        double area;
    } cases[] = {
        {"", 280},
        {".b{fill:none}", 180},
        {"/* .b */ .c,.a {fill:none} #r{fill:red}", 180},
        {"rect{fill:none}", 80},
        {"*{fill:none} path{fill:red}", 80},
        {".b{fill:red} rect{fill:none}", 180}, /* a class outweighs a name */
        {"#r{fill:red} *{fill:none}", 100},
        {"@media print { rect{fill:none} } #r{fill:none}", 180},
        {"<![CDATA[.a>.b,#r{fill:none}]]>", 180},
        {".b{fill:none", 280},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1024];
        snprintf(text, sizeof text, "%s<style>%s</style>", shapes, cases[i].sheet);
        assert_area(text, cases[i].area);
    }
}

/* A long attribute on an element that is used again and again. */
static void long_attributes_do_not_explode(void **state) {
    (void)state;
    enum { LONG = 1 << 20, USES = 1000 };
    char *text = mt_test_new(LONG + 100 * USES, 1), *at = text;
    mt_arena arena = {0};
    mt_svg_drawing drawing;
    const char *problem;
    at += sprintf(at, HEAD "<circle id='a' r='5' style='");
    memset(at, ';', LONG);
    at += LONG;
    at += sprintf(at, "'/>");
    for (int i = 0; i < USES; i++) at += sprintf(at, "<use href='#a'/>");
    sprintf(at, "</svg>");
    assert_int_equal(read(text, &arena, &drawing, &problem), MT_TOO_LARGE);
    mt_arena_release(&arena);
    free(text);
}

static void one_colour_is_told(void **state) {
    (void)state;
    static const struct {
        const char *content;
        int rgb; /* -1: several */
    } cases[] = {
        {"<circle r='5'/>", 0},
        {"<g fill='#f80'><circle r='5'/><circle r='9'/></g>", 0xff8800},
        {"<g color='rebeccapurple'><circle r='5' fill='currentColor'/></g>", 0x663399},
        {"<circle r='5' style='fill: rgb(100%, 0%, 20%) !important'/>", 0xff0033},
        {"<circle r='5' fill='rgba(1, 2, 3, .5)'/>", 0x010203},
        {"<circle r='5' fill='red' style='fill:#00f'/>", 0x0000ff},
        {"<g fill='red'><circle r='5' fill='nonsense'/></g>", 0xff0000},
        {"<circle r='5' fill='red'/><circle r='5' fill='#f00'/>", 0xff0000},
        {"<circle r='5' fill='red'/><circle r='5'/>", -1},
        {"<circle r='5' fill='red'/><circle r='0'/>", 0xff0000},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mt_arena arena = {0};
        mt_svg_drawing drawing = read_inside(cases[i].content, &arena);
        tell(drawing.one_colour != (cases[i].rgb >= 0), cases[i].content);
        assert_int_equal(drawing.one_colour, cases[i].rgb >= 0);
        if (drawing.one_colour)
            assert_int_equal(drawing.colour.red << 16 | drawing.colour.green << 8 | drawing.colour.blue,
                             cases[i].rgb);
        mt_arena_release(&arena);
    }
}

/* The view's middle is above the origin, an eighth of it below the baseline. */
static void the_view_is_an_em(void **state) {
    (void)state;
    static const char *const heads[] = {
        "<svg viewBox='10 20 48 24'><rect x='10' y='20' width='48' height='24'/></svg>",
        "<svg width='48' height='24'><rect width='100%' height='100%'/></svg>",
        "<svg width='1in' height='48pt'><rect width='1in' height='.5cm'/></svg>",
        "<svg><rect x='70' y='-9' width='48' height='24'/></svg>",
    };
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        mt_arena arena = {0};
        mt_svg_drawing drawing;
        const char *problem;
        mt_shape shape;
        mt_assert_ok(read(heads[i], &arena, &drawing, &problem));
        mt_assert_ok(mt_layers_shape(&drawing.layers, 0.5, &arena, &shape));
        mt_box box = mt_shape_box(&shape);
        assert_int_equal(box.min.x, -MT_EM / 2);
        assert_int_equal(box.max.x, MT_EM / 2);
        if (i == 2)
            assert_int_equal(box.max.y, MT_EM * 3 / 8 + MT_EM / 3);
        else
            assert_int_equal(box.min.y + box.max.y, MT_EM * 3 / 4);
        mt_arena_release(&arena);
    }
}

static void bad_input_is_refused(void **state) {
    (void)state;
    static char deep[8192], circle[] = HEAD "<g id='a'><circle r='5'/><use href='#a'/></g></svg>";
    static const char huge[] =
        "<svg viewBox='0 0 1 1'><g transform='scale(1e300)'><g transform='scale(1e300)'>"
        "<rect width='1' height='1'/></g></g></svg>";
    strcpy(deep, HEAD);
    for (int i = 0; i < 101; i++) strcat(deep, "<g>");
    strcat(deep, "<circle r='5'/>");
    for (int i = 0; i < 101; i++) strcat(deep, "</g>");
    strcat(deep, "</svg>");
    const struct {
        const char *text, *problem;
        mt_status status;
    } cases[] = {
        {"", "damaged", MT_BAD_DRAWING},
        {"<svg", "damaged", MT_BAD_DRAWING},
        {"<svg></g>", "damaged", MT_BAD_DRAWING},
        {"<html/>", "no SVG drawing", MT_BAD_DRAWING},
        {"<svg xmlns='http://example.org'/>", "no SVG drawing", MT_BAD_DRAWING},
        {"<!DOCTYPE svg [<!ENTITY a 'b'>]><svg/>", "entities", MT_BAD_DRAWING},
        {"<!DOCTYPE svg [<!ENTITY % a SYSTEM 'file:///etc/passwd'>%a;]><svg/>", "entities", MT_BAD_DRAWING},
        {"<svg>&a;</svg>", "damaged", MT_BAD_DRAWING},
        {deep, "100 levels", MT_BAD_DRAWING},
        {circle, "100 levels", MT_BAD_DRAWING},
        {"<svg/>", NULL, MT_BLANK},
        {"<svg viewBox='0 0 1 1'><rect width='1e9' height='1'/></svg>", NULL, MT_TOO_LARGE},
        {huge, NULL, MT_TOO_LARGE},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        mt_arena arena = {0};
        mt_svg_drawing drawing;
        const char *problem;
        mt_status status = read(cases[i].text, &arena, &drawing, &problem);
        tell(status != cases[i].status, cases[i].text);
        assert_int_equal(status, cases[i].status);
        assert_int_equal(problem != NULL, cases[i].problem != NULL);
        if (problem) assert_non_null(strstr(problem, cases[i].problem));
        mt_arena_release(&arena);
    }
}

/* Uses of uses: 10 to the power of 8 circles are not drawn. */
static void uses_do_not_explode(void **state) {
    (void)state;
    char text[4096] = HEAD "<circle id='a0' r='5'/>";
    mt_arena arena = {0};
    mt_svg_drawing drawing;
    const char *problem;
    for (int i = 1; i <= 8; i++) {
        snprintf(text + strlen(text), sizeof text - strlen(text), "<g id='a%d'>", i);
        for (int k = 0; k < 10; k++)
            snprintf(text + strlen(text), sizeof text - strlen(text), "<use href='#a%d'/>", i - 1);
        strcat(text, "</g>");
    }
    strcat(text, "</svg>");
    assert_int_equal(read(text, &arena, &drawing, &problem), MT_TOO_LARGE);
    mt_arena_release(&arena);
}

/* A ball of wool: each of 1000 lines crosses half of the others. */
static void crossings_have_a_limit(void **state) {
    (void)state;
    mt_arena arena = {0};
    mt_shape shape;
    static mt_segment segments[1000];
    mt_contour contour = {1000, segments};
    mt_layer layer = {{1, &contour}, MT_NONZERO};
    const mt_layers layers = {1, &layer};
    unsigned seed = 1;
    for (int i = 0; i < 1000; i++) {
        segments[i].degree = 1;
        segments[i].end.x = (int32_t)((seed = seed * 1664525u + 1013904223u) >> 12);
        segments[i].end.y = (int32_t)((seed = seed * 1664525u + 1013904223u) >> 12);
    }
    assert_int_equal(mt_layers_shape(&layers, 0.5, &arena, &shape), MT_TOO_LARGE);
    contour.count = 100;
    mt_assert_ok(mt_layers_shape(&layers, 0.5, &arena, &shape));
    mt_arena_release(&arena);
}

static mt_status read_and_fill(void) {
    static const char text[] =
        HEAD "<g id='a' fill='red'><path d='M0 0Q9 0 9 9A5 5 0 0 1 0 0M20 20H40V40'/><circle r='9'/></g>"
             "<use href='#a' x='30' y='30'/></svg>";
    mt_arena arena = {0};
    mt_svg_drawing drawing;
    mt_shape shape;
    const char *problem;
    mt_status status = read(text, &arena, &drawing, &problem);
    if (status == MT_OK) status = mt_layers_shape(&drawing.layers, 0.5, &arena, &shape);
    mt_arena_release(&arena);
    return status;
}

static void survives_want_of_memory(void **state) {
    (void)state;
    mt_test_want_of_memory(read_and_fill);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(path_commands_say_the_same),
        cmocka_unit_test(wrong_paths_are_drawn_up_to_there),
        cmocka_unit_test(arcs_are_of_ellipses),
        cmocka_unit_test(rules_and_layers_make_holes_or_do_not),
        cmocka_unit_test(places_are_transformed),
        cmocka_unit_test(only_solid_fills_are_drawn),
        cmocka_unit_test(style_sheets_select_by_name_class_and_id),
        cmocka_unit_test(long_attributes_do_not_explode),
        cmocka_unit_test(one_colour_is_told),
        cmocka_unit_test(the_view_is_an_em),
        cmocka_unit_test(bad_input_is_refused),
        cmocka_unit_test(uses_do_not_explode),
        cmocka_unit_test(crossings_have_a_limit),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
