#include "scene/strip.h"

#include <math.h>

#include "picture/canvas.h"
#include "picture/label.h"
#include "scene/render.h"

/* Distances as shares of the size. */
#define MARGIN 0.1
#define GAP 0.08
#define LABEL_GAP 0.06

/* Room for the line around a solid, pixels. */
#define LINE_ROOM 4

typedef struct strip_page {
    const mt_solid_strip *strip;
    mt_eye eye;
    mt_vector3 *middles; /* of each step's box, as it is seen */
    double scale;        /* pixels a unit */
    int width, height;   /* of a step's picture, pixels */
    double label_height; /* 0 without labels */
    double step_width;
} strip_page;

/* ---- the layout ------------------------------------------------------------------------------------------ */

/* Takes the step's box into the width and height that all of them need, in the scene's units. */
static mt_status measure_step(strip_page *page, int step, double *width, double *height) {
    mt_arena arena = {0};
    mt_mesh mesh;
    mt_status status = page->strip->mesh(step, &arena, &mesh, page->strip->user);
    if (status == MT_OK) {
        mt_seen_box box = mt_eye_box(&page->eye, &mesh);
        *width = fmax(*width, box.high.x - box.low.x);
        *height = fmax(*height, box.high.y - box.low.y);
        page->middles[step] = (mt_vector3){(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2,
                                           (box.low.z + box.high.z) / 2};
    }
    mt_arena_release(&arena);
    return status;
}

static double widest_label(const mt_solid_strip *strip, double height) {
    char label[32];
    double width = 0;
    for (int i = 0; i < strip->step_count && strip->labels; i++) {
        mt_label_t(strip->at[i], label, sizeof label);
        width = fmax(width, mt_label_width(label, height));
    }
    return width;
}

static mt_status lay_out(strip_page *page) {
    const mt_solid_strip *strip = page->strip;
    double width = 0, height = 0;
    mt_status status = MT_OK;
    for (int i = 0; i < strip->step_count && status == MT_OK; i++)
        status = measure_step(page, i, &width, &height);
    if (status != MT_OK) return status;
    page->scale = strip->size / fmax(width, height);
    page->width = (int)ceil(width * page->scale) + LINE_ROOM;
    page->height = (int)ceil(height * page->scale) + LINE_ROOM;
    page->label_height = strip->labels ? mt_label_height(strip->size) : 0;
    page->step_width = fmax(page->width, widest_label(strip, page->label_height));
    return MT_OK;
}

/* ---- the drawing ----------------------------------------------------------------------------------------- */

/* The place in the scene that is seen at `seen`. */
static mt_vector3 place_of(const mt_eye *eye, mt_vector3 seen) {
    return (mt_vector3){seen.x * eye->right.x + seen.y * eye->up.x + seen.z * eye->towards.x,
                        seen.x * eye->right.y + seen.y * eye->up.y + seen.z * eye->towards.y,
                        seen.x * eye->right.z + seen.y * eye->up.z + seen.z * eye->towards.z};
}

static mt_status render_step(const strip_page *page, int step, cairo_surface_t **image) {
    mt_arena arena = {0};
    mt_mesh mesh;
    mt_render render = {.eye = page->eye,
                        .middle = place_of(&page->eye, page->middles[step]),
                        .scale = page->scale,
                        .width = page->width,
                        .height = page->height};
    mt_status status = page->strip->mesh(step, &arena, &mesh, page->strip->user);
    if (status == MT_OK) status = mt_render_mesh(&mesh, &render, image);
    mt_arena_release(&arena);
    return status;
}

static mt_status draw_step(const strip_page *page, int step, cairo_t *cairo) {
    double size = page->strip->size, left = MARGIN * size + step * (page->step_width + GAP * size),
           top = MARGIN * size;
    cairo_surface_t *image;
    char label[32];
    mt_status status = render_step(page, step, &image);
    if (status != MT_OK) return status;
    cairo_set_source_surface(cairo, image, round(left + (page->step_width - page->width) / 2), round(top));
    cairo_paint(cairo);
    cairo_surface_destroy(image);
    cairo_set_source_rgb(cairo, 0, 0, 0);
    if (!page->strip->labels) return MT_OK;
    mt_label_t(page->strip->at[step], label, sizeof label);
    mt_label_draw_centred(cairo, label, left + page->step_width / 2,
                          top + page->height + LABEL_GAP * size + page->label_height, page->label_height);
    return MT_OK;
}

static mt_status draw_page(strip_page *page, mt_format format, const char *path) {
    const mt_solid_strip *strip = page->strip;
    mt_canvas canvas = {0};
    mt_status status = lay_out(page);
    if (status != MT_OK) return status;
    double labels = strip->labels ? LABEL_GAP * strip->size + page->label_height : 0;
    status = mt_canvas_open(format,
                            2 * MARGIN * strip->size + strip->step_count * page->step_width +
                                (strip->step_count - 1) * GAP * strip->size,
                            2 * MARGIN * strip->size + page->height + labels, &canvas);
    for (int i = 0; i < strip->step_count && status == MT_OK; i++) status = draw_step(page, i, canvas.cairo);
    if (status == MT_OK) status = mt_canvas_save(&canvas, path);
    mt_canvas_close(&canvas);
    return status;
}

mt_status mt_solid_strip_save(const mt_solid_strip *strip, const char *path) {
    mt_format format;
    mt_status status = mt_format_of(path, &format);
    if (status != MT_OK) return status;
    if (strip->step_count < 1 || !(strip->size >= MT_SCENE_SIZE_MIN && strip->size <= MT_SCENE_SIZE_MAX))
        return MT_BAD_PARAMETER;
    strip_page page = {.strip = strip,
                       .eye = mt_eye_at(strip->turn, strip->tilt),
                       .middles = mt_new((size_t)strip->step_count, sizeof *page.middles)};
    status = page.middles ? draw_page(&page, format, path) : MT_NO_MEMORY;
    mt_free(page.middles);
    return status;
}
