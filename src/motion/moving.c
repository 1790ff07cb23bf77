/* Drawings from memory, and what moves between two of them, for users of the library. */
#include <math.h>

#include "geometry/layers.h"
#include "geometry/limits.h"
#include "morph/model/params.h"
#include "motion/stretch.h"

/* An em in a drawing's own units. */
#define EM_MIN 1e-6
#define EM_MAX 1e9

struct mt_path {
    double em;
    bool open; /* a contour has begun */
    mt_point start, at;
    int contour_count, contour_room;
    mt_contour *contours; /* their segments are set when the drawing is read */
    int segment_count, segment_room;
    mt_segment *segments; /* of all contours, one after another */
};

struct mt_moving {
    double em;
    mt_moving_part part;
    mt_arena arena;
};

/* ---- drawings ------------------------------------------------------------------------------------------ */

mt_status mt_path_new(double em, mt_path **path) {
    if (!(em >= EM_MIN && em <= EM_MAX)) return MT_BAD_PARAMETER;
    mt_path *made = mt_new(1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    made->em = em;
    *path = made;
    return MT_OK;
}

void mt_path_free(mt_path *path) {
    if (!path) return;
    mt_free(path->contours);
    mt_free(path->segments);
    mt_free(path);
}

static mt_status to_grid(const mt_path *path, double x, double y, mt_point *point) {
    double gx = round(x / path->em * MT_EM), gy = round(y / path->em * MT_EM);
    if (isnan(gx) || isnan(gy)) return MT_BAD_PARAMETER;
    if (fabs(gx) > MT_COORD_MAX || fabs(gy) > MT_COORD_MAX) return MT_TOO_LARGE;
    *point = (mt_point){(int32_t)gx, (int32_t)gy};
    return MT_OK;
}

/* Adds a segment to the contour at hand, unless all of it is one point. */
static mt_status add(mt_path *path, mt_segment segment) {
    bool still = mt_point_equal(segment.end, path->at);
    for (int i = 0; i < segment.degree - 1; i++)
        still = still && mt_point_equal(segment.control[i], path->at);
    if (still) return MT_OK;
    if (path->segment_count == MT_POINTS_MAX) return MT_TOO_LARGE;
    mt_segment *grown = mt_grow_list(path->segments, path->segment_count, &path->segment_room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    path->segments = grown;
    grown[path->segment_count++] = segment;
    path->contours[path->contour_count - 1].count++;
    path->at = segment.end;
    return MT_OK;
}

static mt_status close_contour(mt_path *path) {
    if (!path->open) return MT_OK;
    mt_status status = add(path, (mt_segment){.degree = 1, .end = path->start});
    if (status == MT_OK) path->open = false;
    return status;
}

mt_status mt_path_move_to(mt_path *path, double x, double y) {
    mt_point start;
    mt_status status = to_grid(path, x, y, &start);
    if (status == MT_OK) status = close_contour(path);
    if (status != MT_OK) return status;
    mt_contour *grown = mt_grow_list(path->contours, path->contour_count, &path->contour_room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    path->contours = grown;
    grown[path->contour_count++] = (mt_contour){0};
    path->open = true;
    path->start = path->at = start;
    return MT_OK;
}

/* A segment whose points are x and y, one after another. */
static mt_status add_segment(mt_path *path, int degree, const double *places) {
    mt_point points[3];
    if (!path->open) return MT_BAD_PARAMETER;
    for (int i = 0; i < degree; i++) {
        mt_status status = to_grid(path, places[2 * i], places[2 * i + 1], &points[i]);
        if (status != MT_OK) return status;
    }
    mt_segment segment = {.degree = degree, .end = points[degree - 1]};
    for (int i = 0; i < degree - 1; i++) segment.control[i] = points[i];
    return add(path, segment);
}

mt_status mt_path_line_to(mt_path *path, double x, double y) {
    return add_segment(path, 1, (double[]){x, y});
}

mt_status mt_path_quadratic_to(mt_path *path, double cx, double cy, double x, double y) {
    return add_segment(path, 2, (double[]){cx, cy, x, y});
}

mt_status mt_path_cubic_to(mt_path *path, double c1x, double c1y, double c2x, double c2y, double x,
                           double y) {
    return add_segment(path, 3, (double[]){c1x, c1y, c2x, c2y, x, y});
}

/* The drawing as an outline whose segments are the path's, but for lines that close a contour that is open. */
static mt_status read_outline(const mt_path *path, mt_arena *arena, mt_outline *outline) {
    mt_outline made = {0, mt_arena_new(arena, (size_t)path->contour_count + 1, sizeof *made.contours)};
    mt_segment *segments = mt_arena_new(arena, (size_t)path->segment_count + 1, sizeof *segments);
    if (!made.contours || !segments) return MT_NO_MEMORY;
    for (int i = 0; i < path->segment_count; i++) segments[i] = path->segments[i];
    for (int i = 0; i < path->contour_count; i++) {
        mt_contour contour = {path->contours[i].count, segments};
        bool is_open = path->open && i + 1 == path->contour_count && !mt_point_equal(path->at, path->start);
        segments += contour.count;
        if (is_open) contour.segments[contour.count++] = (mt_segment){.degree = 1, .end = path->start};
        if (contour.count > 0) made.contours[made.count++] = contour;
    }
    *outline = made;
    return MT_OK;
}

/* ---- what moves ---------------------------------------------------------------------------------------- */

static mt_status read_part(const mt_path *path, const mt_params *params, mt_arena *arena,
                           mt_figure_part *part) {
    *part = (mt_figure_part){.glyph = MT_SEVERAL_GLYPHS};
    mt_outline outline;
    mt_status status = read_outline(path, arena, &outline);
    if (status == MT_OK) status = mt_outline_shape(&outline, params->tolerance, arena, &part->shape);
    return status == MT_OK && part->shape.count == 0 ? MT_BLANK : status;
}

static mt_status prepare(const mt_path *a, const mt_path *b, const mt_params *params, mt_moving *moving) {
    mt_arena scratch = {0};
    mt_figure_part first, second;
    const mt_hints none = {0};
    mt_status status = mt_params_check(params);
    if (status == MT_OK) status = read_part(a, params, &scratch, &first);
    if (status == MT_OK) status = read_part(b, params, &scratch, &second);
    if (status == MT_OK)
        status = mt_moving_part_make(&first, &second, &none, params, &scratch, &moving->arena, &moving->part);
    if (status == MT_OK) status = moving->part.failed;
    mt_arena_release(&scratch);
    return status;
}

mt_status mt_moving_new(const mt_path *a, const mt_path *b, const mt_params *params, mt_moving **moving) {
    mt_moving *made = mt_new(1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    made->em = a->em;
    mt_status status = prepare(a, b, params, made);
    if (status == MT_OK)
        *moving = made;
    else
        mt_moving_free(made);
    return status;
}

void mt_moving_free(mt_moving *moving) {
    if (!moving) return;
    mt_arena_release(&moving->arena);
    mt_free(moving);
}

mt_status mt_moving_draw(const mt_moving *moving, double t, const mt_draw *draw, void *user) {
    if (!(t >= 0 && t <= 1)) return MT_BAD_PARAMETER;
    mt_arena arena = {0};
    mt_drawing drawing;
    mt_moving_part part = moving->part;
    const mt_stretch stretch = {.pairs = {.count = 1}, .parts = &part, .steps = 1};
    mt_status status = mt_stretch_at(&stretch, t, &arena, &drawing);
    if (status == MT_OK) mt_outline_draw(&drawing.list[0].outline, moving->em / MT_EM, draw, user);
    mt_arena_release(&arena);
    return status;
}
