/* A small program on libmorphotype: writes the font at T between two fonts and prints one of its glyphs, SVG.
 *
 *     example A B T U+0067 OUT.ttf > glyph.svg
 *
 * With the library installed, it builds by itself:
 *
 *     cc -o example example.c $(pkg-config --cflags --libs morphotype)
 */
#define _POSIX_C_SOURCE 200809L /* open_memstream */

#include <morphotype.h>

#include <stdio.h>
#include <stdlib.h>

typedef struct request {
    const char *a, *b; /* fonts, FILE[#FACE][@AXIS=VALUE,…] */
    double t;
    unsigned code_point;
    const char *output;
} request;

/* ---- a glyph as an SVG path: y runs downwards there, upwards in a font */

static void move_to(double x, double y, void *user) {
    fprintf(user, "M%g %g", x, -y);
}

static void line_to(double x, double y, void *user) {
    fprintf(user, "L%g %g", x, -y);
}

static void quadratic_to(double cx, double cy, double x, double y, void *user) {
    fprintf(user, "Q%g %g %g %g", cx, -cy, x, -y);
}

static void close_path(void *user) {
    fputs("Z", user);
}

/* The path goes into memory first: nothing is printed for a glyph that cannot be had, and the page is as wide
 * as the glyph. */
static mt_status print_glyph(mt_blend *blend, const request *wanted) {
    const mt_draw draw = {
        .move_to = move_to, .line_to = line_to, .quadratic_to = quadratic_to, .close = close_path};
    int em = mt_blend_units_per_em(blend);
    double advance;
    char *path = NULL;
    size_t length;
    FILE *memory = open_memstream(&path, &length);
    if (!memory) return MT_NO_MEMORY;
    mt_status status = mt_blend_glyph(blend, wanted->code_point, wanted->t, &draw, memory, &advance);
    if (fclose(memory) != 0) status = MT_NO_MEMORY;
    if (status == MT_OK)
        printf("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 %d %g %g\"><path d=\"%s\"/></svg>\n",
               -em, advance, 1.25 * em, path);
    free(path);
    return status;
}

/* ---- a font, with a word on each glyph that could not be blended */

static void tell_failure(uint32_t code_point, mt_status why, void *user) {
    (void)user;
    fprintf(stderr, "U+%04X: the nearer font's glyph stands in: %s\n", (unsigned)code_point,
            mt_status_text(why));
}

static mt_status save_font(mt_blend *blend, const request *wanted) {
    mt_blend_on_failure(blend, tell_failure, NULL);
    return mt_blend_save(blend, wanted->t, wanted->output);
}

/* ---- opening and closing: what was opened is closed, however far it went */

static mt_status run(const request *wanted) {
    mt_font *a = NULL, *b = NULL;
    mt_blend *blend = NULL;
    mt_params params = mt_params_default();
    mt_status status = mt_font_open(wanted->a, &a);
    if (status == MT_OK) status = mt_font_open(wanted->b, &b);
    if (status == MT_OK) status = mt_blend_new(a, b, &params, &blend);
    if (status == MT_OK) status = print_glyph(blend, wanted);
    if (status == MT_OK) status = save_font(blend, wanted);
    mt_blend_free(blend); /* before the fonts, which it uses */
    mt_font_close(a);
    mt_font_close(b);
    return status;
}

static int read_arguments(char **argv, request *wanted) {
    char *end;
    *wanted = (request){.a = argv[1], .b = argv[2], .output = argv[5]};
    wanted->t = strtod(argv[3], &end);
    return end != argv[3] && *end == '\0' && sscanf(argv[4], "U+%6x", &wanted->code_point) == 1;
}

int main(int argc, char **argv) {
    request wanted;
    if (argc != 6 || !read_arguments(argv, &wanted)) {
        fprintf(stderr, "usage: example A B T U+CODE-POINT OUT.ttf\n");
        return 2;
    }
    mt_status status = run(&wanted);
    if (status != MT_OK) fprintf(stderr, "example: %s\n", mt_status_text(status));
    return status == MT_OK && fflush(stdout) == 0 ? 0 : 1;
}
