/* Draws docs/figure1.png, the paper's figure 1: what one Minkowski sum of two whole shapes gives, and what
 * the sums of matched convex pieces give. Three rows, five steps from T = 0 to T = 1:
 *
 *     the sum rA ⊕ (1 - r)B of the whole shapes
 *     the paper's mapping
 *     the default method
 *
 * The first row sums every piece of A with every piece of B: ⊕ distributes over unions, so that the union of
 * all these sums is the sum of the whole shapes. Built on the library's inside.
 *
 *     figure1 A B U+CODE-POINT OUT.png
 */
#include "blend/pair.h"
#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "picture/canvas.h"
#include "picture/label.h"

#include <stdio.h>

#define EM 110.0 /* picture units */
#define GAP 16.0
#define LABEL 9.0
#define STEPS 5
#define ROWS 3

static const char *const titles[ROWS] = {"one Minkowski sum", "the paper's mapping", "the default method"};

typedef struct figure {
    mt_font *a, *b;
    uint32_t code_point;
    mt_arena arena;
    mt_canvas canvas;
} figure;

/* rA ⊕ (1 - r)B, whole. */
static mt_status whole_sum(const mt_morph *morph, mt_weights weights, mt_arena *arena, mt_shape *shape) {
    const mt_pieces *a = &morph->a.pieces, *b = &morph->b.pieces;
    size_t room = (size_t)a->count * (size_t)b->count;
    mt_rings sums = {0, mt_arena_new(arena, room, sizeof(mt_ring))};
    if (!sums.rings) return MT_NO_MEMORY;
    for (int i = 0; i < a->count; i++)
        for (int j = 0; j < b->count; j++) {
            mt_ring *sum = &sums.rings[sums.count++];
            mt_status status = mt_ring_new(arena, a->rings[i].count + b->rings[j].count, sum);
            if (status != MT_OK) return status;
            mt_minkowski(&a->rings[i], &b->rings[j], weights, sum);
        }
    return mt_union(&sums, MT_NONZERO, arena, shape);
}

static void draw_shape(cairo_t *cairo, const mt_shape *shape, double left, double baseline) {
    for (int k = 0; k < shape->count; k++)
        for (int i = 0; i < shape->components[k].count; i++) {
            const mt_ring *ring = &shape->components[k].rings[i];
            cairo_new_sub_path(cairo);
            for (int p = 0; p < ring->count; p++)
                cairo_line_to(cairo, left + ring->points[p].x * EM / MT_EM,
                              baseline - ring->points[p].y * EM / MT_EM);
            cairo_close_path(cairo);
        }
    cairo_fill(cairo);
}

static mt_status draw_row(figure *f, int row) {
    mt_params params = mt_params_default();
    mt_glyph_pair pair;
    if (row < 2) params.method = MT_METHOD_PAPER;
    mt_row fonts;
    mt_status status = mt_row_open((mt_font *[]){f->a, f->b}, 2, &params, &fonts);
    if (status != MT_OK) return status;
    status = mt_pair_prepare_char(&fonts, f->code_point, &f->arena, &pair);
    mt_row_close(&fonts);
    double top = GAP + row * (EM + 3 * LABEL + GAP);
    mt_label_draw(f->canvas.cairo, titles[row], GAP, top + LABEL, LABEL);
    for (int i = 0; status == MT_OK && i < STEPS; i++) {
        mt_weights weights = mt_weights_at((double)i / (STEPS - 1));
        mt_shape shape;
        status = row == 0 ? whole_sum(&pair.morph, weights, &f->arena, &shape)
                          : mt_morph_blend(&pair.morph, weights, &params, &f->arena, &shape);
        if (status == MT_OK)
            draw_shape(f->canvas.cairo, &shape, GAP + i * (EM + GAP), top + 3 * LABEL + 0.85 * EM);
    }
    return status;
}

static void draw_steps(cairo_t *cairo, double baseline) {
    for (int i = 0; i < STEPS; i++) {
        char text[32];
        mt_label_t((double)i / (STEPS - 1), text, sizeof text);
        mt_label_draw_centred(cairo, text, GAP + i * (EM + GAP) + EM / 2, baseline, LABEL);
    }
}

static mt_status draw(figure *f, const char *path) {
    double width = GAP + STEPS * (EM + GAP), height = 2 * GAP + ROWS * (EM + 3 * LABEL + GAP) + LABEL;
    mt_status status = mt_canvas_open(MT_FORMAT_PNG, width, height, &f->canvas);
    for (int row = 0; status == MT_OK && row < ROWS; row++) status = draw_row(f, row);
    if (status == MT_OK) {
        draw_steps(f->canvas.cairo, height - GAP);
        status = mt_canvas_save(&f->canvas, path);
    }
    mt_canvas_close(&f->canvas);
    return status;
}

int main(int argc, char **argv) {
    figure f = {0};
    unsigned code_point;
    if (argc != 5 || sscanf(argv[3], "U+%6x", &code_point) != 1) {
        fprintf(stderr, "usage: figure1 A B U+CODE-POINT OUT.png\n");
        return 2;
    }
    f.code_point = code_point;
    mt_status status = mt_font_open(argv[1], &f.a);
    if (status == MT_OK) status = mt_font_open(argv[2], &f.b);
    if (status == MT_OK) status = draw(&f, argv[4]);
    if (status != MT_OK) fprintf(stderr, "figure1: %s\n", mt_status_text(status));
    mt_arena_release(&f.arena);
    mt_font_close(f.a);
    mt_font_close(f.b);
    return status == MT_OK ? 0 : 1;
}
