/* For test_variable.py. Code points come on stdin, hexadecimal, and a line for each goes out.
 *
 *     variable-sample compare|apart ENGINE VARIABLE MORF FONT
 *
 * The area of the intersection of a glyph in a variable font at a place of its axis and the glyph in another font, over that
 * of their union; by how many units of the other font the advance is longer in the first; with apart, how far, in 1/1000 em, the border
 * of the one is from that of the other at most. ENGINE is what puts the variable font to that place: freetype, by design
 * coordinates; harfbuzz, whose points are rounded to the variable font's units, as they are in the other font; none, for a
 * font that is there already.
 *
 *     variable-sample pixels VARIABLE MORF SIZE [FONT]
 *
 * A glyph drawn by FreeType as it is in the variable font, beside that of the other font or, without one, beside the union of its own
 * contours: by how much, 0 … 255, any pixel of the first is darker, or lighter, than that of the second; then the same of those
 * pixels alone which, with all their neighbours, are white in the second, or black: what a dark join or a hairline would be. */
#include <hb-ot.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_MULTIPLE_MASTERS_H
#include FT_OUTLINE_H

#include "geometry/limits.h"
#include "geometry/union.h"
#include "source/font.h"
#include "support/check.h"

enum { POINTS_MAX = 65536, CONTOURS_MAX = 8192 };

/* Fine enough for the largest size that is looked at. */
#define TOLERANCE 8.0

/* ---- outlines ------------------------------------------------------------------------------------------ */

typedef struct mt_reader {
    double scale; /* to the grid */
    bool whole;   /* points are rounded before they are scaled */
    mt_outline outline;
    mt_contour contours[CONTOURS_MAX];
    mt_segment segments[POINTS_MAX];
    int used;
    mt_point at, start;
} mt_reader;

static mt_point on_grid(const mt_reader *reader, double x, double y) {
    if (reader->whole) x = floor(x + 0.5), y = floor(y + 0.5);
    return (mt_point){(int32_t)lround(x * reader->scale), (int32_t)lround(y * reader->scale)};
}

static void begin(mt_reader *reader, mt_point p) {
    assert_true(reader->outline.count < CONTOURS_MAX);
    mt_contour *contour = &reader->contours[reader->outline.count++];
    *contour = (mt_contour){0, reader->segments + reader->used};
    reader->outline.contours = reader->contours;
    reader->at = reader->start = p;
}

static void add(mt_reader *reader, mt_segment segment) {
    assert_true(reader->used < POINTS_MAX);
    reader->segments[reader->used++] = segment;
    reader->contours[reader->outline.count - 1].count++;
    reader->at = segment.end;
}

static void finish(mt_reader *reader) {
    if (reader->outline.count == 0) return;
    mt_contour *contour = &reader->contours[reader->outline.count - 1];
    if (!mt_point_equal(reader->at, reader->start) || contour->count == 0)
        add(reader, (mt_segment){.degree = 1, .end = reader->start});
}

/* ---- by HarfBuzz --------------------------------------------------------------------------------------- */

static void hb_move(hb_draw_funcs_t *f, void *to, hb_draw_state_t *st, float x, float y, void *user) {
    (void)f, (void)st, (void)user;
    begin(to, on_grid(to, (double)x, (double)y));
}

static void hb_line(hb_draw_funcs_t *f, void *to, hb_draw_state_t *st, float x, float y, void *user) {
    (void)f, (void)st, (void)user;
    add(to, (mt_segment){.degree = 1, .end = on_grid(to, (double)x, (double)y)});
}

static void hb_quadratic(hb_draw_funcs_t *f, void *to, hb_draw_state_t *st, float cx, float cy, float x,
                         float y, void *user) {
    (void)f, (void)st, (void)user;
    add(to, (mt_segment){2, {on_grid(to, (double)cx, (double)cy)}, on_grid(to, (double)x, (double)y)});
}

static void hb_close(hb_draw_funcs_t *f, void *to, hb_draw_state_t *st, void *user) {
    (void)f, (void)st, (void)user;
    finish(to);
}

static hb_font_t *open_hb(const char *path, double place) {
    hb_blob_t *blob = hb_blob_create_from_file_or_fail(path);
    assert_non_null(blob);
    hb_face_t *face = hb_face_create(blob, 0);
    hb_font_t *font = hb_font_create(face);
    hb_variation_t setting = {HB_TAG('M', 'O', 'R', 'F'), (float)place};
    hb_font_set_variations(font, &setting, 1);
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    return font;
}

/* The advance, em. */
static double read_hb(hb_font_t *font, uint32_t code_point, mt_reader *reader) {
    hb_codepoint_t glyph;
    hb_draw_funcs_t *funcs = hb_draw_funcs_create();
    double units = hb_face_get_upem(hb_font_get_face(font));
    hb_draw_funcs_set_move_to_func(funcs, hb_move, NULL, NULL);
    hb_draw_funcs_set_line_to_func(funcs, hb_line, NULL, NULL);
    hb_draw_funcs_set_quadratic_to_func(funcs, hb_quadratic, NULL, NULL);
    hb_draw_funcs_set_close_path_func(funcs, hb_close, NULL, NULL);
    assert_true(hb_font_get_nominal_glyph(font, code_point, &glyph));
    reader->scale = MT_EM / units;
    reader->whole = true;
    hb_font_get_glyph_shape(font, glyph, funcs, reader);
    hb_draw_funcs_destroy(funcs);
    return hb_font_get_glyph_h_advance(font, glyph) / units;
}

/* ---- comparing ----------------------------------------------------------------------------------------- */

static mt_shape ink_of(const mt_outline *outline, mt_arena *arena) {
    mt_shape shape;
    bool clean;
    mt_assert_ok(mt_outline_resolve(outline, TOLERANCE, arena, &shape, &clean));
    return shape;
}

static double shared_share(const mt_shape *a, const mt_shape *b, mt_arena *arena) {
    mt_rings in_a, in_b;
    mt_shape both;
    mt_assert_ok(mt_shape_rings(a, arena, &in_a));
    mt_assert_ok(mt_shape_rings(b, arena, &in_b));
    mt_rings all = {0, mt_arena_new(arena, (size_t)(in_a.count + in_b.count), sizeof(mt_ring))};
    assert_non_null(all.rings);
    for (int i = 0; i < in_a.count; i++) all.rings[all.count++] = in_a.rings[i];
    for (int i = 0; i < in_b.count; i++) all.rings[all.count++] = in_b.rings[i];
    mt_assert_ok(mt_union(&all, MT_NONZERO, arena, &both));
    double union_area = (double)mt_shape_area2(&both);
    if (union_area == 0) return 1;
    return ((double)mt_shape_area2(a) + (double)mt_shape_area2(b) - union_area) / union_area;
}

static double distance_to_edge(mt_point p, mt_point a, mt_point b) {
    double dx = b.x - a.x, dy = b.y - a.y, length2 = dx * dx + dy * dy;
    double u = length2 > 0 ? ((p.x - a.x) * dx + (p.y - a.y) * dy) / length2 : 0;
    u = fmin(1, fmax(0, u));
    return hypot(p.x - a.x - u * dx, p.y - a.y - u * dy);
}

/* How far a corner of the one border is from the other at most, grid units. */
static double reach(const mt_shape *from, const mt_shape *to, mt_arena *arena) {
    mt_rings corners, edges;
    double most = 0;
    mt_assert_ok(mt_shape_rings(from, arena, &corners));
    mt_assert_ok(mt_shape_rings(to, arena, &edges));
    for (int i = 0; i < corners.count; i++)
        for (int k = 0; k < corners.rings[i].count; k++) {
            double least = INFINITY;
            for (int r = 0; r < edges.count; r++)
                for (int e = 0; e < edges.rings[r].count; e++)
                    least =
                        fmin(least, distance_to_edge(corners.rings[i].points[k], edges.rings[r].points[e],
                                                     edges.rings[r].points[(e + 1) % edges.rings[r].count]));
            most = fmax(most, least);
        }
    return most;
}

static mt_font *open_font(const char *spec) {
    mt_font *font;
    mt_assert_ok(mt_font_open(spec, &font));
    return font;
}

static mt_font *open_at(const char *path, const char *place) {
    char spec[4096];
    snprintf(spec, sizeof spec, "%s@MORF=%s", path, place);
    return open_font(spec);
}

static mt_shape read_font(mt_font *font, uint32_t code_point, mt_arena *arena, double *advance) {
    mt_outline outline;
    uint32_t glyph = mt_font_glyph(font, code_point);
    assert_int_not_equal(glyph, 0);
    mt_assert_ok(mt_font_outline(font, glyph, arena, &outline, advance));
    *advance /= MT_EM;
    return ink_of(&outline, arena);
}

static void compare(bool tell_apart, const char *engine, const char *path, const char *place,
                    const char *other) {
    static mt_reader reader;
    mt_arena arena = {0};
    bool by_hb = strcmp(engine, "harfbuzz") == 0, there = strcmp(engine, "none") == 0;
    hb_font_t *hb = by_hb ? open_hb(path, atof(place)) : NULL;
    mt_font *font = by_hb ? NULL : there ? open_font(path) : open_at(path, place);
    mt_font *second = open_font(other);
    unsigned code_point;
    while (scanf("%x", &code_point) == 1) {
        double advance, in_second;
        mt_shape a;
        memset(&reader, 0, sizeof reader);
        if (by_hb) {
            advance = read_hb(hb, code_point, &reader);
            a = ink_of(&reader.outline, &arena);
        } else {
            a = read_font(font, code_point, &arena, &advance);
        }
        mt_shape b = read_font(second, code_point, &arena, &in_second);
        printf("%x %.6f %.3f", code_point, shared_share(&a, &b, &arena),
               (advance - in_second) * mt_font_units_per_em(second));
        if (tell_apart) printf(" %.3f", fmax(reach(&a, &b, &arena), reach(&b, &a, &arena)) * 1000 / MT_EM);
        putchar('\n');
        mt_arena_reset(&arena);
    }
    mt_arena_release(&arena);
    hb_font_destroy(hb);
    mt_font_close(font);
    mt_font_close(second);
}

/* ---- pixels -------------------------------------------------------------------------------------------- */

static int ft_move(const FT_Vector *p, void *to) {
    finish(to);
    begin(to, on_grid(to, (double)p->x, (double)p->y));
    return 0;
}

static int ft_line(const FT_Vector *p, void *to) {
    add(to, (mt_segment){.degree = 1, .end = on_grid(to, (double)p->x, (double)p->y)});
    return 0;
}

static int ft_quadratic(const FT_Vector *c, const FT_Vector *p, void *to) {
    add(to,
        (mt_segment){2, {on_grid(to, (double)c->x, (double)c->y)}, on_grid(to, (double)p->x, (double)p->y)});
    return 0;
}

/* The union of the glyph's contours in place of these. */
static void put_union(FT_Library library, FT_Outline *outline, double scale, mt_arena *arena,
                      FT_Outline *united) {
    static mt_reader reader;
    static const FT_Outline_Funcs funcs = {.move_to = ft_move, .line_to = ft_line, .conic_to = ft_quadratic};
    memset(&reader, 0, sizeof reader);
    reader.scale = scale;
    assert_int_equal(FT_Outline_Decompose(outline, &funcs, &reader), 0);
    finish(&reader);
    mt_rings rings;
    mt_shape ink = ink_of(&reader.outline, arena);
    mt_assert_ok(mt_shape_rings(&ink, arena, &rings));
    int points = 0, at = 0;
    for (int i = 0; i < rings.count; i++) points += rings.rings[i].count;
    assert_int_equal(FT_Outline_New(library, (FT_UInt)points, rings.count, united), 0);
    for (int i = 0; i < rings.count; i++) {
        for (int k = 0; k < rings.rings[i].count; k++, at++) {
            united->points[at] = (FT_Vector){lround(rings.rings[i].points[k].x / scale),
                                             lround(rings.rings[i].points[k].y / scale)};
            united->tags[at] = FT_CURVE_TAG_ON;
        }
        united->contours[i] = (short)(at - 1);
    }
}

typedef struct mt_gray {
    int left, top, width, rows;
    unsigned char *pixels;
} mt_gray;

static mt_gray copy_bitmap(FT_GlyphSlot slot) {
    FT_Bitmap *b = &slot->bitmap;
    mt_gray gray = {slot->bitmap_left, slot->bitmap_top, (int)b->width, (int)b->rows, NULL};
    gray.pixels = mt_test_new((size_t)gray.width * (size_t)gray.rows + 1, 1);
    for (int y = 0; y < gray.rows; y++)
        memcpy(gray.pixels + y * gray.width, b->buffer + y * b->pitch, (size_t)gray.width);
    return gray;
}

static int pixel(const mt_gray *gray, int x, int y) {
    int column = x - gray->left, row = gray->top - y;
    bool inside = column >= 0 && column < gray->width && row >= 0 && row < gray->rows;
    return inside ? gray->pixels[row * gray->width + column] : 0;
}

typedef struct mt_difference {
    int darker, lighter, in_white, in_black;
} mt_difference;

/* Whether the pixel and its neighbours are all of one value. */
static bool is_even(const mt_gray *gray, int x, int y) {
    for (int i = -1; i <= 1; i++)
        for (int k = -1; k <= 1; k++)
            if (pixel(gray, x + i, y + k) != pixel(gray, x, y)) return false;
    return true;
}

static int larger(int a, int b) {
    return a > b ? a : b;
}

static mt_difference difference(const mt_gray *a, const mt_gray *b) {
    mt_difference most = {0};
    int left = a->left < b->left ? a->left : b->left, top = a->top > b->top ? a->top : b->top;
    for (int y = top; y > top - a->rows - b->rows - 2; y--)
        for (int x = left; x < left + a->width + b->width + 2; x++) {
            int d = pixel(a, x, y) - pixel(b, x, y);
            most.darker = larger(most.darker, d);
            most.lighter = larger(most.lighter, -d);
            if (d == 0 || !is_even(b, x, y)) continue;
            most.in_white = larger(most.in_white, pixel(b, x, y) == 0 ? d : 0);
            most.in_black = larger(most.in_black, pixel(b, x, y) == 255 ? -d : 0);
        }
    return most;
}

static mt_gray draw(FT_Face face, unsigned code_point) {
    FT_UInt glyph = FT_Get_Char_Index(face, code_point);
    assert_int_not_equal(glyph, 0);
    assert_int_equal(FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING | FT_LOAD_RENDER), 0);
    return copy_bitmap(face->glyph);
}

/* The union of the glyph's contours. */
static mt_gray draw_union(FT_Face face, unsigned code_point, int size, mt_arena *arena) {
    FT_Outline united;
    double scale = floor(4.0 * MT_EM / (64.0 * size)); /* of a 64th of a pixel, on the grid */
    FT_UInt glyph = FT_Get_Char_Index(face, code_point);
    assert_int_equal(FT_Load_Glyph(face, glyph, FT_LOAD_NO_HINTING), 0);
    FT_Outline own = face->glyph->outline;
    put_union(face->glyph->library, &own, scale, arena, &united);
    face->glyph->outline = united;
    assert_int_equal(FT_Render_Glyph(face->glyph, FT_RENDER_MODE_NORMAL), 0);
    mt_gray drawn = copy_bitmap(face->glyph);
    face->glyph->outline = own;
    FT_Outline_Done(face->glyph->library, &united);
    return drawn;
}

static FT_Face open_face(FT_Library library, const char *path, int size) {
    FT_Face face;
    assert_int_equal(FT_New_Face(library, path, 0, &face), 0);
    assert_int_equal(FT_Set_Pixel_Sizes(face, 0, (FT_UInt)size), 0);
    return face;
}

static void compare_pixels(const char *path, const char *place, int size, const char *other) {
    FT_Library library;
    mt_arena arena = {0};
    unsigned code_point;
    FT_Fixed value = lround(atof(place) * 65536);
    assert_int_equal(FT_Init_FreeType(&library), 0);
    FT_Face face = open_face(library, path, size), second = other ? open_face(library, other, size) : NULL;
    assert_int_equal(FT_Set_Var_Design_Coordinates(face, 1, &value), 0);
    while (scanf("%x", &code_point) == 1) {
        mt_gray drawn = draw(face, code_point);
        mt_gray expected = second ? draw(second, code_point) : draw_union(face, code_point, size, &arena);
        mt_difference most = difference(&drawn, &expected);
        printf("%x %d %d %d %d\n", code_point, most.darker, most.lighter, most.in_white, most.in_black);
        free(drawn.pixels);
        free(expected.pixels);
        mt_arena_reset(&arena);
    }
    mt_arena_release(&arena);
    FT_Done_FreeType(library); /* and its faces */
}

int main(int argc, char **argv) {
    bool tell_apart = argc == 6 && strcmp(argv[1], "apart") == 0;
    if (tell_apart || (argc == 6 && strcmp(argv[1], "compare") == 0))
        compare(tell_apart, argv[2], argv[3], argv[4], argv[5]);
    else if ((argc == 5 || argc == 6) && strcmp(argv[1], "pixels") == 0)
        compare_pixels(argv[2], argv[3], atoi(argv[4]), argc == 6 ? argv[5] : NULL);
    else
        return 2;
    return 0;
}
