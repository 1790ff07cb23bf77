#include "scene/render.h"

#include <math.h>

#include "scene/lines.h"

/* Rows of pixels that are drawn in one go, for a bound on memory. */
enum { BAND = 64 };

/* Rows of samples around a band in which its lines may begin, and which tell whether they are lines. */
enum { HALO = MT_LINE_REACH + 1 + MT_SAMPLES };

typedef struct mt_light {
    mt_vector3 from; /* of length 1 */
    double strength;
} mt_light;

/* Over the left shoulder, and a weaker one from the right. */
static const double ambient = 0.34;
static const mt_light lights[] = {{{-0.4472136, 0.7155418, 0.5366563}, 0.56},
                                  {{0.8017837, 0.2672612, 0.5345225}, 0.22}};
static const double body[3] = {0.86, 0.88, 0.92}; /* red, green, blue */
static const uint32_t line_grey = 40, white = 255;

typedef struct mt_band {
    mt_samples samples;
    uint8_t *marks, *ink;
} mt_band;

static double brightness(mt_vector3 normal) {
    double sum = ambient;
    for (int i = 0; i < 2; i++) {
        mt_vector3 from = lights[i].from;
        sum += lights[i].strength * fmax(0, normal.x * from.x + normal.y * from.y + normal.z * from.z);
    }
    return fmin(sum, 1);
}

/* Adds a sample's colour. */
static void add_sample(const mt_seen_mesh *seen, const mt_band *band, size_t i, uint32_t sum[3]) {
    int triangle = band->samples.triangle[i];
    for (int k = 0; k < 3; k++) {
        if (band->ink[i])
            sum[k] += line_grey;
        else if (triangle < 0)
            sum[k] += white;
        else
            sum[k] += (uint32_t)lround(255 * body[k] * brightness(seen->normals[triangle]));
    }
}

static uint32_t pixel_at(const mt_seen_mesh *seen, const mt_band *band, int x, int row) {
    enum { ALL = MT_SAMPLES * MT_SAMPLES };
    uint32_t sum[3] = {0};
    for (int i = 0; i < ALL; i++) {
        size_t y = (size_t)(row + i / MT_SAMPLES), across = (size_t)x * MT_SAMPLES + (size_t)(i % MT_SAMPLES);
        add_sample(seen, band, y * (size_t)band->samples.width + across, sum);
    }
    for (int k = 0; k < 3; k++) sum[k] = (sum[k] + ALL / 2) / ALL;
    return sum[0] << 16 | sum[1] << 8 | sum[2];
}

/* Draws the rows of pixels from `first` on. */
static void draw_band(const mt_seen_mesh *seen, mt_band *band, int first, cairo_surface_t *image) {
    int width = cairo_image_surface_get_width(image), height = cairo_image_surface_get_height(image),
        end = first + BAND < height ? first + BAND : height;
    uint8_t *bytes = cairo_image_surface_get_data(image);
    mt_samples_take(seen, first * MT_SAMPLES - HALO, &band->samples);
    mt_lines_find(seen, &band->samples, band->marks, band->ink);
    for (int y = first; y < end; y++) {
        uint32_t *row =
            (uint32_t *)(void *)(bytes + (size_t)y * (size_t)cairo_image_surface_get_stride(image));
        for (int x = 0; x < width; x++) row[x] = pixel_at(seen, band, x, (y - first) * MT_SAMPLES + HALO);
    }
}

static mt_status make_band(int width, mt_arena *arena, mt_band *band) {
    int rows = BAND * MT_SAMPLES + 2 * HALO;
    size_t count = (size_t)width * MT_SAMPLES * (size_t)rows;
    mt_status status = mt_samples_new(width * MT_SAMPLES, rows, arena, &band->samples);
    band->marks = mt_arena_new(arena, count, 1);
    band->ink = mt_arena_new(arena, count, 1);
    return band->marks && band->ink ? status : MT_NO_MEMORY;
}

static mt_status draw(const mt_mesh *mesh, const mt_render *render, cairo_surface_t *image) {
    mt_arena arena = {0};
    mt_seen_mesh seen;
    mt_band band;
    mt_status status = mt_seen_mesh_make(mesh, &render->eye, render->middle, render->scale, render->width,
                                         render->height, &arena, &seen);
    if (status == MT_OK) status = make_band(render->width, &arena, &band);
    cairo_surface_flush(image);
    for (int y = 0; y < render->height && status == MT_OK; y += BAND) draw_band(&seen, &band, y, image);
    cairo_surface_mark_dirty(image);
    mt_arena_release(&arena);
    return status;
}

mt_status mt_render_mesh(const mt_mesh *mesh, const mt_render *render, cairo_surface_t **image) {
    cairo_surface_t *made = cairo_image_surface_create(CAIRO_FORMAT_RGB24, render->width, render->height);
    mt_status status =
        cairo_surface_status(made) == CAIRO_STATUS_SUCCESS ? draw(mesh, render, made) : MT_NO_MEMORY;
    if (status == MT_OK)
        *image = made;
    else
        cairo_surface_destroy(made);
    return status;
}
