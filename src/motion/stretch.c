#include "motion/stretch.h"

#include "geometry/limits.h"
#include "morph/between/instance.h"
#include "morph/between/variable_outline.h"
#include "morph/paper/rotation.h"
#include "morph/prepare.h"
#include "motion/symmetry.h"

/* How far a point may be from the way that formula (5) takes it, 1/1000 em. */
#define TURN_WITHIN 1.0

/* Steps (base/memory.h) that the morph of two parts may take, of drawings some five seconds and 128 MiB, and what moves again as many. Two
 * Han characters of 64 strokes take half of the first, drawings of 10 000 points nearly all of the second. */
#define TEXT_STEPS ((int64_t)1 << 33)
#define DRAWING_STEPS ((int64_t)1 << 30)
enum { STEPS_A_BYTE = 8 }; /* that it may take */

/* ---- one part ------------------------------------------------------------------------------------------ */

static mt_status keep_contour(const mt_contour *contour, mt_arena *kept, mt_contour *copy) {
    *copy = (mt_contour){contour->count, mt_arena_new(kept, (size_t)contour->count, sizeof(mt_segment))};
    if (!copy->segments) return MT_NO_MEMORY;
    for (int i = 0; i < contour->count; i++) copy->segments[i] = contour->segments[i];
    return MT_OK;
}

static mt_status keep_pair(const mt_contour_pair *pair, mt_arena *kept, mt_contour_pair *copy) {
    mt_status status = keep_contour(&pair->a, kept, &copy->a);
    if (status == MT_OK) status = keep_contour(&pair->b, kept, &copy->b);
    copy->displacement = pair->displacement;
    return status;
}

static mt_status keep_contours(const mt_variable_outline *contours, mt_arena *kept,
                               mt_variable_outline *copy) {
    mt_variable_outline made = {0, mt_arena_new(kept, (size_t)contours->count + 1, sizeof *made.contours)};
    if (!made.contours) return MT_NO_MEMORY;
    while (made.count < contours->count) {
        mt_status status = keep_pair(&contours->contours[made.count], kept, &made.contours[made.count]);
        if (status != MT_OK) return status;
        made.count++;
    }
    *copy = made;
    return MT_OK;
}

/* The contours between two shapes, each task within its steps. */
static mt_status move(const mt_shape *a, const mt_shape *b, const mt_hints *hints, const mt_params *params,
                      int64_t steps, mt_arena *scratch, mt_morph *prepared, mt_variable_outline *contours) {
    int64_t most = (int64_t)(params->effort * (double)steps);
    const mt_allowance allowance = {most, (size_t)(most / STEPS_A_BYTE), NULL};
    mt_arena_bound(scratch, &allowance);
    mt_status status = mt_arena_verdict(scratch, mt_morph_prepare(a, b, hints, params, scratch, prepared));
    mt_arena_bound(scratch, &allowance);
    if (status == MT_OK) status = mt_variable_outline_make(prepared, params, scratch, contours);
    status = mt_arena_verdict(scratch, status);
    mt_arena_bound(scratch, NULL);
    return status;
}

/* Two shapes that are alike on the left and the right: one half and its image. *done is false for others. */
static mt_status move_halves(const mt_shape *a, const mt_shape *b, const mt_params *params, int64_t steps,
                             mt_arena *scratch, mt_variable_outline *contours, bool *done) {
    mt_halves halves;
    mt_morph prepared;
    mt_status status = mt_halves_of(a, b, scratch, &halves);
    *done = halves.alike;
    if (status != MT_OK || !halves.alike) return status;
    const mt_hints found = {halves.hints.count, halves.hints.list};
    status = move(&halves.a, &halves.b, &found, params, steps, scratch, &prepared, contours);
    return status == MT_OK ? mt_add_images(&halves, contours, scratch) : status;
}

static mt_status morph(const mt_figure_part *a, const mt_figure_part *b, const mt_hints *hints,
                       const mt_params *params, mt_arena *scratch, mt_arena *kept, mt_moving_part *part) {
    mt_morph prepared = {.a.box = mt_shape_box(&a->shape), .b.box = mt_shape_box(&b->shape)};
    mt_variable_outline contours;
    bool free = hints->count == 0 && params->rotation == MT_ROTATION_NONE, done = false;
    mt_axis_hints axis = free ? mt_axis_hints_of(&a->shape, &b->shape) : (mt_axis_hints){0};
    const mt_hints found = {axis.count, axis.list};
    int64_t steps = a->apart || b->apart ? DRAWING_STEPS : TEXT_STEPS;
    mt_status status = MT_OK;
    if (free && axis.count == 0)
        status = move_halves(&a->shape, &b->shape, params, steps, scratch, &contours, &done);
    if (status == MT_OK && !done) {
        status = move(&a->shape, &b->shape, axis.count ? &found : hints, params, steps, scratch, &prepared,
                      &contours);
        if (status == MT_OK) status = mt_axis_mirror(&axis, &contours, scratch, &done);
        if (status == MT_OK && axis.count > 0 && !done)
            status = move_halves(&a->shape, &b->shape, params, steps, scratch, &contours, &done);
    }
    if (status != MT_OK) return status;
    part->turning = (mt_morph){.a.box = prepared.a.box, .b.box = prepared.b.box, .degrees = prepared.degrees};
    return keep_contours(&contours, kept, &part->contours);
}

/* The contour and as many segments that are all one point. */
static mt_status collapse(const mt_contour *contour, mt_point point, mt_arena *kept, mt_contour *copy,
                          mt_contour *collapsed) {
    mt_status status = keep_contour(contour, kept, copy);
    if (status == MT_OK) status = keep_contour(contour, kept, collapsed);
    for (int i = 0; status == MT_OK && i < collapsed->count; i++)
        collapsed->segments[i] =
            (mt_segment){.degree = contour->segments[i].degree, .control = {point, point}, .end = point};
    return status;
}

/* Adds a shape's contours, which shrink to the middle of its box, or grow from there. */
static mt_status add_alone(const mt_shape *shape, bool grows, const mt_params *params, mt_arena *scratch,
                           mt_arena *kept, mt_variable_outline *all) {
    mt_outline outline;
    mt_point middle = mt_box_middle(mt_shape_box(shape));
    mt_status status = mt_shape_outline(shape, params, scratch, &outline);
    if (status != MT_OK) return status;
    mt_contour_pair *grown =
        mt_arena_new(kept, (size_t)all->count + (size_t)outline.count + 1, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    for (int i = 0; i < all->count; i++) grown[i] = all->contours[i];
    all->contours = grown;
    for (int i = 0; i < outline.count; i++) {
        mt_contour_pair *pair = &all->contours[all->count++];
        status = collapse(&outline.contours[i], middle, kept, grows ? &pair->b : &pair->a,
                          grows ? &pair->a : &pair->b);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

/* A shrinks to nothing and B grows from nothing; either may be missing. */
static mt_status pass(const mt_figure_part *a, const mt_figure_part *b, const mt_params *params,
                      mt_arena *scratch, mt_arena *kept, mt_moving_part *part) {
    part->contours = (mt_variable_outline){0};
    mt_status status = a ? add_alone(&a->shape, false, params, scratch, kept, &part->contours) : MT_OK;
    return status == MT_OK && b ? add_alone(&b->shape, true, params, scratch, kept, &part->contours) : status;
}

mt_status mt_moving_part_make(const mt_figure_part *a, const mt_figure_part *b, const mt_hints *hints,
                              const mt_params *params, mt_arena *scratch, mt_arena *kept,
                              mt_moving_part *part) {
    mt_moving_part made = {.a = a ? a->place : b->place, .b = b ? b->place : a->place};
    mt_status status = MT_OK;
    if (a && b) status = made.failed = morph(a, b, hints, params, scratch, kept, &made);
    if (status == MT_NO_MEMORY) return status;
    if (!a || !b || status != MT_OK) status = pass(a, b, params, scratch, kept, &made);
    if (status == MT_OK) *part = made;
    return status;
}

/* ---- all of them --------------------------------------------------------------------------------------- */

int mt_stretch_steps(const mt_stretch *stretch) {
    int most = 1;
    bool even = false;
    for (int i = 0; i < stretch->pairs.count; i++) {
        const mt_moving_part *part = &stretch->parts[i];
        int steps = mt_variable_outline_steps(&part->turning, &part->contours, mt_grid_units(TURN_WITHIN));
        if (steps > most) most = steps;
        even = even || steps % 2 == 0; /* a displaced contour bends half-way */
    }
    return most + (even && most % 2 != 0);
}

mt_status mt_stretch_at(const mt_stretch *stretch, double t, mt_arena *arena, mt_drawing *drawing) {
    mt_weights weights = mt_weights_at(t);
    mt_drawing made = {stretch->pairs.count,
                       mt_arena_new(arena, (size_t)stretch->pairs.count, sizeof *made.list)};
    if (!made.list) return MT_NO_MEMORY;
    for (int i = 0; i < made.count; i++) {
        const mt_moving_part *part = &stretch->parts[i];
        mt_placed *placed = &made.list[i];
        mt_status status =
            mt_variable_outline_at(&part->turning, &part->contours, weights, arena, &placed->outline);
        if (status != MT_OK) return status;
        placed->place = (mt_vector){(1 - t) * part->a.x + t * part->b.x, (1 - t) * part->a.y + t * part->b.y};
    }
    *drawing = made;
    return MT_OK;
}

mt_status mt_figure_drawing(const mt_figure *figure, mt_arena *arena, mt_drawing *drawing) {
    size_t count = 0;
    for (int i = 0; i < figure->count; i++) count += (size_t)figure->parts[i].drawing.count;
    mt_drawing made = {0, mt_arena_new(arena, count + 1, sizeof *made.list)};
    if (!made.list) return MT_NO_MEMORY;
    for (int i = 0; i < figure->count; i++) {
        const mt_figure_part *part = &figure->parts[i];
        for (int k = 0; k < part->drawing.count; k++)
            made.list[made.count++] = (mt_placed){part->drawing.list[k].outline, part->place, part->apart,
                                                  part->drawing.list[k].rule};
    }
    *drawing = made;
    return MT_OK;
}
