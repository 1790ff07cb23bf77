/* Cairo surfaces that write into memory. */
#include "picture/canvas.h"

#include "base/file.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <time.h>

mt_status mt_format_of(const char *path, mt_format *format) {
    static const char *const extensions[] = {".png", ".svg", ".pdf"};
    const char *dot = strrchr(path, '.');
    for (int i = 0; dot && i < 3; i++) {
        if (strcasecmp(dot, extensions[i]) != 0) continue;
        *format = (mt_format)i;
        return MT_OK;
    }
    return MT_UNKNOWN_FORMAT;
}

static mt_status from_cairo(cairo_status_t status) {
    switch (status) {
    case CAIRO_STATUS_SUCCESS: return MT_OK;
    case CAIRO_STATUS_INVALID_SIZE: return MT_TOO_LARGE;
    /* The only writer is the buffer, which fails for want of memory alone. */
    case CAIRO_STATUS_WRITE_ERROR:
    case CAIRO_STATUS_NO_MEMORY: return MT_NO_MEMORY;
    default: return MT_CANNOT_WRITE;
    }
}

static cairo_status_t add_bytes(void *user, const unsigned char *bytes, unsigned int length) {
    mt_buffer *buffer = user;
    return mt_buffer_add(buffer, bytes, length) == MT_OK ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

/* See reproducible-builds.org/specs/source-date-epoch: seconds since 1970. */
static void set_creation_date(cairo_surface_t *pdf) {
    const char *epoch = getenv("SOURCE_DATE_EPOCH");
    time_t seconds = 946684800; /* 2000-01-01 */
    char *end;
    if (epoch && *epoch) {
        long long given = strtoll(epoch, &end, 10);
        if (*end == '\0' && given >= 0 && given < 253402300800)
            seconds = (time_t)given; /* up to the year 9999 */
    }
    struct tm day;
    char text[32];
    if (!gmtime_r(&seconds, &day) || !strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &day)) return;
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATE_DATE, text);
}

static cairo_surface_t *make_surface(mt_canvas *canvas, int width, int height) {
    switch (canvas->format) {
    case MT_FORMAT_SVG: return cairo_svg_surface_create_for_stream(add_bytes, &canvas->bytes, width, height);
    case MT_FORMAT_PDF: return cairo_pdf_surface_create_for_stream(add_bytes, &canvas->bytes, width, height);
    default: return cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
    }
}

/* Whole units, at least one; false when the picture would be too large, or its size is no number. */
static bool whole_size(double width, double height, int *w, int *h) {
    if (!(width <= MT_PICTURE_SIDE_MAX && height <= MT_PICTURE_SIDE_MAX)) return false;
    *w = width < 1 ? 1 : (int)width + ((int)width < width);
    *h = height < 1 ? 1 : (int)height + ((int)height < height);
    return true;
}

static void clear_page(mt_canvas *canvas) {
    cairo_set_source_rgb(canvas->cairo, 1, 1, 1);
    if (canvas->format != MT_FORMAT_PDF) cairo_paint(canvas->cairo);
    cairo_set_source_rgb(canvas->cairo, 0, 0, 0);
}

mt_status mt_canvas_open(mt_format format, double width, double height, mt_canvas *canvas) {
    int w, h;
    *canvas = (mt_canvas){.format = format};
    if (!whole_size(width, height, &w, &h)) return MT_TOO_LARGE;
    if (format == MT_FORMAT_PNG && (int64_t)w * h > MT_PICTURE_PIXELS_MAX) return MT_TOO_LARGE;
    canvas->surface = make_surface(canvas, w, h);
    if (format == MT_FORMAT_PDF) set_creation_date(canvas->surface);
    canvas->cairo = cairo_create(canvas->surface);
    clear_page(canvas);
    mt_status status = from_cairo(cairo_status(canvas->cairo));
    if (status != MT_OK) mt_canvas_close(canvas);
    return status;
}

void mt_canvas_next_page(mt_canvas *canvas) {
    cairo_show_page(canvas->cairo);
    clear_page(canvas);
}

mt_status mt_canvas_finish(mt_canvas *canvas, mt_buffer *file) {
    cairo_status_t status = cairo_status(canvas->cairo);
    if (status == CAIRO_STATUS_SUCCESS && canvas->format == MT_FORMAT_PNG)
        status = cairo_surface_write_to_png_stream(canvas->surface, add_bytes, &canvas->bytes);
    cairo_surface_finish(canvas->surface);
    if (status == CAIRO_STATUS_SUCCESS) status = cairo_surface_status(canvas->surface);
    if (status != CAIRO_STATUS_SUCCESS) return from_cairo(status);
    *file = canvas->bytes;
    canvas->bytes = (mt_buffer){0};
    return MT_OK;
}

mt_status mt_canvas_save(mt_canvas *canvas, const char *path) {
    mt_buffer file;
    mt_status status = mt_canvas_finish(canvas, &file);
    if (status != MT_OK) return status;
    status = mt_file_write(path, file.bytes, file.length);
    mt_buffer_free(&file);
    return status;
}

void mt_canvas_close(mt_canvas *canvas) {
    if (canvas->cairo) cairo_destroy(canvas->cairo);
    if (canvas->surface) cairo_surface_destroy(canvas->surface);
    mt_buffer_free(&canvas->bytes);
    *canvas = (mt_canvas){0};
}
