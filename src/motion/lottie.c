/* A run is a shape layer that is there while the run lasts; its contours are paths with key frames, filled together by the nonzero rule.
 * Lottie has cubic curves only: a quadratic one with control point c is the cubic one whose handles are two thirds of the way to c. */
#include "motion/lottie.h"

#include <math.h>

#include "base/json.h"
#include "geometry/limits.h"
#include "motion/runs.h"

/* Places in pixels are written to so many of a pixel. */
#define PLACES_A_PIXEL 1000.0

typedef struct mt_lottie_writing {
    const mt_motion *motion;
    mt_runs runs;
    mt_json json;
    mt_arena arena; /* of the runs, and of the drawings of the run at hand */
    mt_status status;
} mt_lottie_writing;

static double frame_at(const mt_lottie_writing *w, double time) {
    return time * w->motion->timeline.length * w->motion->request.timing.fps;
}

/* ---- values -------------------------------------------------------------------------------------------- */

static double rounded(double pixels) {
    return round(pixels * PLACES_A_PIXEL) / PLACES_A_PIXEL;
}

/* A property that does not change. */
static void write_constant(mt_json *json, const char *key, double value) {
    mt_json_object(json, key);
    mt_json_int(json, "a", 0);
    mt_json_number(json, "k", value);
    mt_json_object_end(json);
}

static void write_constant_pair(mt_json *json, const char *key, double value) {
    mt_json_object(json, key);
    mt_json_int(json, "a", 0);
    mt_json_array(json, "k");
    mt_json_number(json, NULL, value);
    mt_json_number(json, NULL, value);
    mt_json_array_end(json);
    mt_json_object_end(json);
}

static void write_transform(mt_json *json) {
    write_constant(json, "o", 100);
    write_constant(json, "r", 0);
    write_constant_pair(json, "p", 0);
    write_constant_pair(json, "a", 0);
    write_constant_pair(json, "s", 100);
}

static void write_handle(mt_json *json, const char *key, double x, double y) {
    mt_json_object(json, key);
    mt_json_number(json, "x", x);
    mt_json_number(json, "y", y);
    mt_json_object_end(json);
}

/* Time and easing of a key frame, the last of which has none; and its value, which comes next. */
static void begin_key_frame(mt_lottie_writing *w, const mt_run *run, int key) {
    const mt_key_time *time = &run->times[key];
    mt_json_object(&w->json, NULL);
    mt_json_number(&w->json, "t", frame_at(w, time->time));
    if (key + 1 < run->count) {
        write_handle(&w->json, "o", time->easing.x1, time->easing.y1);
        write_handle(&w->json, "i", time->easing.x2, time->easing.y2);
    }
    mt_json_array(&w->json, "s");
}

static void end_key_frame(mt_json *json) {
    mt_json_array_end(json);
    mt_json_object_end(json);
}

/* A property that changes from key frame to key frame. */
static void begin_keys(mt_json *json, const char *key) {
    mt_json_object(json, key);
    mt_json_int(json, "a", 1);
    mt_json_array(json, "k");
}

static void end_keys(mt_json *json) {
    mt_json_array_end(json);
    mt_json_object_end(json);
}

/* ---- paths --------------------------------------------------------------------------------------------- */

/* A point's place on the page. */
static mt_vector on_page(const mt_lottie_writing *w, const mt_placed *placed, mt_point p) {
    const mt_page *page = &w->motion->page;
    return (mt_vector){(placed->place.x + p.x - page->left) * page->scale,
                       (page->top - placed->place.y - p.y) * page->scale};
}

static void write_vector(mt_json *json, double x, double y) {
    mt_json_array(json, NULL);
    mt_json_number(json, NULL, rounded(x));
    mt_json_number(json, NULL, rounded(y));
    mt_json_array_end(json);
}

/* The handle of segment `s` at its end `at`, relative to that. */
static void write_tangent(mt_lottie_writing *w, const mt_placed *placed, const mt_segment *s, mt_point at) {
    mt_vector from = on_page(w, placed, at), to = on_page(w, placed, s->control[0]);
    if (s->degree == 1) to = from;
    write_vector(&w->json, (to.x - from.x) * 2 / 3, (to.y - from.y) * 2 / 3);
}

static void write_contour(mt_lottie_writing *w, const mt_placed *placed, const mt_contour *contour) {
    mt_json *json = &w->json;
    int count = contour->count;
    mt_json_object(json, NULL);
    mt_json_array(json, "i");
    for (int i = 0; i < count; i++) write_tangent(w, placed, &contour->segments[i], contour->segments[i].end);
    mt_json_array_end(json);
    mt_json_array(json, "o");
    for (int i = 0; i < count; i++)
        write_tangent(w, placed, &contour->segments[(i + 1) % count], contour->segments[i].end);
    mt_json_array_end(json);
    mt_json_array(json, "v");
    for (int i = 0; i < count; i++) {
        mt_vector at = on_page(w, placed, contour->segments[i].end);
        write_vector(json, at.x, at.y);
    }
    mt_json_array_end(json);
    mt_json_bool(json, "c", true);
    mt_json_object_end(json);
}

/* One contour through all key times of the run. */
static void write_path(mt_lottie_writing *w, const mt_run *run, const mt_drawing *drawings, int part,
                       int contour) {
    mt_json *json = &w->json;
    mt_json_one_line(json);
    mt_json_object(json, NULL);
    mt_json_text(json, "ty", "sh");
    begin_keys(json, "ks");
    for (int i = 0; i < run->count; i++) {
        const mt_placed *placed = &drawings[i].list[part];
        begin_key_frame(w, run, i);
        write_contour(w, placed, &placed->outline.contours[contour]);
        end_key_frame(json);
    }
    end_keys(json);
    mt_json_object_end(json);
}

/* ---- layers -------------------------------------------------------------------------------------------- */

static void write_colour(mt_json *json, mt_colour colour) {
    const double parts[] = {colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0, 1};
    for (int i = 0; i < 4; i++) mt_json_number(json, NULL, parts[i]);
}

static void write_fill(mt_lottie_writing *w, const mt_run *run) {
    mt_json *json = &w->json;
    mt_json_one_line(json);
    mt_json_object(json, NULL);
    mt_json_text(json, "ty", "fl");
    begin_keys(json, "c");
    for (int i = 0; i < run->count; i++) {
        begin_key_frame(w, run, i);
        write_colour(json, mt_motion_colour(w->motion, run->times[i].moment));
        end_key_frame(json);
    }
    end_keys(json);
    write_constant(json, "o", 100);
    mt_json_int(json, "r", 1); /* nonzero */
    mt_json_object_end(json);
}

static void write_layer_head(mt_lottie_writing *w, int number, int kind, double start, double end) {
    mt_json *json = &w->json;
    mt_json_object(json, NULL);
    mt_json_int(json, "ind", number);
    mt_json_int(json, "ty", kind);
    mt_json_number(json, "ip", start);
    mt_json_number(json, "op", end);
    mt_json_int(json, "st", 0);
    mt_json_object(json, "ks");
    write_transform(json);
    mt_json_object_end(json);
}

static mt_status draw_run(mt_lottie_writing *w, const mt_run *run, mt_drawing **drawings) {
    mt_drawing *list = mt_arena_new(&w->arena, (size_t)run->count, sizeof *list);
    mt_status status = list ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i < run->count && status == MT_OK; i++)
        status = mt_motion_draw(w->motion, run->times[i].moment, false, &w->arena, &list[i]);
    if (status == MT_OK) *drawings = list;
    return status;
}

static void write_run(mt_lottie_writing *w, int number, double end) {
    enum { SHAPE_LAYER = 4 };
    const mt_run *run = &w->runs.list[number];
    mt_json *json = &w->json;
    mt_drawing *drawings;
    mt_arena_place before = mt_arena_mark(&w->arena);
    if (w->status == MT_OK) w->status = draw_run(w, run, &drawings);
    if (w->status != MT_OK) return;
    write_layer_head(w, number + 1, SHAPE_LAYER, frame_at(w, run->times[0].time), end);
    mt_json_array(json, "shapes");
    mt_json_object(json, NULL);
    mt_json_text(json, "ty", "gr");
    mt_json_array(json, "it");
    for (int i = 0; i < drawings[0].count; i++)
        for (int k = 0; k < drawings[0].list[i].outline.count; k++) write_path(w, run, drawings, i, k);
    write_fill(w, run);
    mt_json_object(json, NULL);
    mt_json_text(json, "ty", "tr");
    write_transform(json);
    mt_json_object_end(json);
    mt_json_array_end(json);
    mt_json_object_end(json);
    mt_json_array_end(json);
    mt_json_object_end(json);
    mt_arena_rewind(&w->arena, before);
}

static void write_background(mt_lottie_writing *w, double end) {
    enum { SOLID_LAYER = 1 };
    char colour[8];
    const mt_motion_request *request = &w->motion->request;
    if (!request->has_background) return;
    mt_colour_write(request->background, colour);
    write_layer_head(w, w->runs.count + 1, SOLID_LAYER, 0, end);
    mt_json_int(&w->json, "sw", w->motion->page.width);
    mt_json_int(&w->json, "sh", w->motion->page.height);
    mt_json_text(&w->json, "sc", colour);
    mt_json_object_end(&w->json);
}

static void write_document(mt_lottie_writing *w) {
    mt_json *json = &w->json;
    const mt_timing *timing = &w->motion->request.timing;
    /* A frame after the play shows its end, unless the next play begins with that. */
    double end = ceil(frame_at(w, 1)) + !(timing->yoyo && timing->plays != 1);
    mt_json_object(json, NULL);
    mt_json_text(json, "v", "5.7.0");
    mt_json_int(json, "fr", timing->fps);
    mt_json_int(json, "ip", 0);
    mt_json_number(json, "op", end);
    mt_json_int(json, "w", w->motion->page.width);
    mt_json_int(json, "h", w->motion->page.height);
    mt_json_text(json, "nm", "Morphotype");
    mt_json_int(json, "ddd", 0);
    mt_json_array(json, "assets");
    mt_json_array_end(json);
    mt_json_array(json, "layers");
    for (int i = 0; i < w->runs.count; i++) {
        bool last = i + 1 == w->runs.count;
        write_run(w, i, last ? end : frame_at(w, w->runs.list[i + 1].times[0].time));
    }
    write_background(w, end);
    mt_json_array_end(json);
    mt_json_object_end(json);
}

mt_status mt_lottie(const mt_motion *motion, mt_buffer *file) {
    mt_lottie_writing w = {.motion = motion};
    w.status = mt_runs_make(motion, &w.arena, &w.runs);
    if (w.status == MT_OK) write_document(&w);
    if (w.status == MT_OK) w.status = w.json.status;
    if (w.status == MT_OK)
        *file = w.json.text;
    else
        mt_buffer_free(&w.json.text);
    mt_arena_release(&w.arena);
    return w.status;
}
