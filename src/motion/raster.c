#include "motion/raster.h"

#include <cairo.h>
#include <string.h>

/* ---- coverage ------------------------------------------------------------------------------------------ */

static double page_x(const mt_page *page, mt_vector place, mt_point p) {
    return (place.x + p.x - page->left) * page->scale;
}

static double page_y(const mt_page *page, mt_vector place, mt_point p) {
    return (page->top - place.y - p.y) * page->scale;
}

/* A quadratic curve as the cubic one that it is. */
static void add_quadratic(cairo_t *cairo, double cx, double cy, double x, double y) {
    double from_x, from_y;
    cairo_get_current_point(cairo, &from_x, &from_y);
    cairo_curve_to(cairo, from_x + (cx - from_x) * 2 / 3, from_y + (cy - from_y) * 2 / 3,
                   x + (cx - x) * 2 / 3, y + (cy - y) * 2 / 3, x, y);
}

static void add_segment(cairo_t *cairo, const mt_page *page, mt_vector place, const mt_segment *s) {
    double x = page_x(page, place, s->end), y = page_y(page, place, s->end);
    double c0x = page_x(page, place, s->control[0]), c0y = page_y(page, place, s->control[0]);
    if (s->degree == 1) cairo_line_to(cairo, x, y);
    if (s->degree == 2) add_quadratic(cairo, c0x, c0y, x, y);
    if (s->degree == 3)
        cairo_curve_to(cairo, c0x, c0y, page_x(page, place, s->control[1]),
                       page_y(page, place, s->control[1]), x, y);
}

static void add_contour(cairo_t *cairo, const mt_page *page, mt_vector place, const mt_contour *contour) {
    mt_point start = contour->segments[contour->count - 1].end;
    cairo_move_to(cairo, page_x(page, place, start), page_y(page, place, start));
    for (int i = 0; i < contour->count; i++) add_segment(cairo, page, place, &contour->segments[i]);
    cairo_close_path(cairo);
}

static void add_placed(cairo_t *cairo, const mt_page *page, const mt_placed *placed) {
    for (int k = 0; k < placed->outline.count; k++)
        add_contour(cairo, page, placed->place, &placed->outline.contours[k]);
}

/* Letters and what moves are one path: where they overlap, ink is ink. */
static void fill(cairo_t *cairo, const mt_page *page, const mt_drawing *drawing) {
    for (int i = 0; i < drawing->count; i++)
        if (!drawing->list[i].apart) add_placed(cairo, page, &drawing->list[i]);
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING);
    cairo_fill(cairo);
    for (int i = 0; i < drawing->count; i++) {
        const mt_placed *placed = &drawing->list[i];
        if (!placed->apart) continue;
        add_placed(cairo, page, placed);
        cairo_set_fill_rule(cairo,
                            placed->rule == MT_EVEN_ODD ? CAIRO_FILL_RULE_EVEN_ODD : CAIRO_FILL_RULE_WINDING);
        cairo_fill(cairo);
    }
}

/* The surface's rows without what pads them. */
static mt_status copy_rows(cairo_surface_t *surface, mt_arena *arena, mt_drawn_frame *frame) {
    size_t width = (size_t)frame->width, stride = (size_t)cairo_image_surface_get_stride(surface);
    const uint8_t *rows = cairo_image_surface_get_data(surface);
    frame->coverage = mt_arena_new(arena, width * (size_t)frame->height, 1);
    if (!frame->coverage) return MT_NO_MEMORY;
    for (size_t y = 0; y < (size_t)frame->height; y++)
        memcpy(frame->coverage + y * width, rows + y * stride, width);
    return MT_OK;
}

static mt_status draw(const mt_page *page, const mt_drawing *drawing, mt_arena *arena,
                      mt_drawn_frame *frame) {
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_A8, page->width, page->height);
    cairo_t *cairo = cairo_create(surface);
    fill(cairo, page, drawing);
    cairo_surface_flush(surface);
    mt_status status =
        cairo_status(cairo) == CAIRO_STATUS_SUCCESS ? copy_rows(surface, arena, frame) : MT_NO_MEMORY;
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    return status;
}

mt_status mt_raster_draw(const mt_motion *motion, mt_moment moment, mt_arena *arena, mt_drawn_frame *frame) {
    mt_drawing drawing;
    mt_status status = mt_motion_draw(motion, moment, true, arena, &drawing);
    *frame = (mt_drawn_frame){.width = motion->page.width,
                              .height = motion->page.height,
                              .ink = mt_motion_colour(motion, moment),
                              .has_background = motion->request.has_background,
                              .background = motion->request.background,
                              .length = 1};
    return status == MT_OK ? draw(&motion->page, &drawing, arena, frame) : status;
}

mt_status mt_raster_check(const mt_motion *motion, int plays) {
    double frames = motion->timeline.length * motion->request.timing.fps + 1;
    return frames * plays * motion->page.width * motion->page.height > MT_PIXELS_MAX ? MT_TOO_LARGE : MT_OK;
}

mt_status mt_raster_play(const mt_motion *motion, mt_take_frame take, void *user) {
    mt_arena arena = {0}, scratch = {0};
    mt_timed_frames frames;
    mt_drawn_frame frame;
    mt_status status = mt_timeline_frames(&motion->timeline, &motion->request.timing, &arena, &frames);
    if (status == MT_OK) status = mt_raster_check(motion, 1);
    for (int i = 0; status == MT_OK && i < frames.count; i++) {
        status = mt_raster_draw(motion, frames.list[i].moment, &scratch, &frame);
        frame.number = frames.list[i].number;
        frame.length = frames.list[i].length;
        if (status == MT_OK) status = take(&frame, user);
        mt_arena_reset(&scratch);
    }
    mt_arena_release(&scratch);
    mt_arena_release(&arena);
    return status;
}

/* ---- pixels -------------------------------------------------------------------------------------------- */

static uint8_t mix(uint8_t background, uint8_t ink, uint8_t coverage) {
    return (uint8_t)((background * (255 - coverage) + ink * coverage + 127) / 255);
}

uint8_t *mt_raster_pixels(const mt_drawn_frame *frame, mt_arena *arena) {
    size_t count = (size_t)frame->width * (size_t)frame->height, channels = (size_t)mt_raster_channels(frame);
    uint8_t *pixels = mt_arena_new(arena, count, channels);
    for (size_t i = 0; pixels && i < count; i++) {
        uint8_t *pixel = pixels + i * channels, coverage = frame->coverage[i];
        uint8_t over = frame->has_background ? coverage : 255;
        pixel[0] = mix(frame->background.red, frame->ink.red, over);
        pixel[1] = mix(frame->background.green, frame->ink.green, over);
        pixel[2] = mix(frame->background.blue, frame->ink.blue, over);
        if (!frame->has_background) pixel[3] = coverage;
    }
    return pixels;
}
