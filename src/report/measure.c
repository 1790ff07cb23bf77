/* The figures of one glyph: what is counted on each in-between, and on the ends to hold it against. */
#include "geometry/limits.h"
#include "geometry/union.h"
#include "morph/between/instance.h"
#include "blend/contours.h"
#include "report/report.h"
#include "write/extent.h"

#include <math.h>

#include "arithmetic/angles.h"

/* ---- ink ----------------------------------------------------------------------------------------------- */

/* Chords may touch where the curves do not: what is not clean is looked at again, more finely. */
static mt_status resolve(const mt_outline *outline, double tolerance, mt_arena *arena, mt_shape *ink) {
    bool clean;
    mt_status status = mt_outline_resolve(outline, tolerance, arena, ink, &clean);
    if (status == MT_OK && !clean)
        status = mt_outline_resolve(outline, tolerance / MT_OVERLAP_CARE, arena, ink, &clean);
    return status;
}

/* ---- joins --------------------------------------------------------------------------------------------- */

static mt_vector from_to(mt_point p, mt_point q) {
    return (mt_vector){(double)q.x - p.x, (double)q.y - p.y};
}

static double length(mt_vector v) {
    return mt_hypot(v.x, v.y);
}

/* How a contour leaves point `start` along a segment, and how it comes to the segment's end. A control point that lies on
 * the end says nothing of the direction. */
static mt_vector leaving(mt_point start, const mt_segment *segment) {
    for (int i = 0; i < segment->degree - 1; i++)
        if (!mt_point_equal(segment->control[i], start)) return from_to(start, segment->control[i]);
    return from_to(start, segment->end);
}

static mt_vector arriving(mt_point start, const mt_segment *segment) {
    for (int i = segment->degree - 2; i >= 0; i--)
        if (!mt_point_equal(segment->control[i], segment->end))
            return from_to(segment->control[i], segment->end);
    return from_to(start, segment->end);
}

static double turn(mt_vector in, mt_vector out) {
    return fabs(mt_atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y)) * 180 /
           3.14159265358979323846;
}

static bool is_long(mt_point start, const mt_segment *segment) {
    return length(from_to(start, segment->end)) >= mt_grid_units(MT_REPORT_KINK_LENGTH);
}

/* By how many degrees the contour turns where segment i ends; 0 where either side is too short to tell. */
static double turn_after(const mt_contour *contour, int i) {
    int n = contour->count;
    const mt_segment *in = &contour->segments[i], *out = &contour->segments[(i + 1) % n];
    mt_point start = contour->segments[(i + n - 1) % n].end;
    if (!is_long(start, in) || !is_long(in->end, out)) return 0;
    return turn(arriving(start, in), leaving(in->end, out));
}

void mt_report_count_corners(const mt_outline *outline, mt_report_drawing *drawing) {
    drawing->corners = drawing->slight = 0;
    for (int c = 0; c < outline->count; c++)
        for (int i = 0; i < outline->contours[c].count; i++) {
            double angle = turn_after(&outline->contours[c], i);
            drawing->corners += angle >= MT_REPORT_KINK_MIN;
            drawing->slight += angle >= MT_REPORT_KINK_MIN && angle <= MT_REPORT_KINK_MAX;
        }
}

/* ---- the glyph ----------------------------------------------------------------------------------------- */

static mt_status measure_drawing(const mt_outline *outline, int units, mt_arena *arena,
                                 mt_report_drawing *drawing) {
    mt_glyf glyf;
    mt_status status = mt_outline_glyf(outline, units, arena, &glyf);
    if (status != MT_OK) return status;
    drawing->points = mt_glyf_point_count(&glyf);
    mt_report_count_corners(outline, drawing);
    return MT_OK;
}

static mt_status measure_end(const mt_shape *shape, const mt_params *params, int units, mt_arena *arena,
                             mt_topology *ink, mt_report_drawing *drawing) {
    mt_outline outline;
    mt_status status = mt_shape_outline(shape, params, arena, &outline);
    if (status == MT_OK) status = measure_drawing(&outline, units, arena, drawing);
    if (status == MT_OK) *ink = mt_topology_of(shape);
    return status;
}

/* The ends themselves look as they should. */
static mt_status measure_ink(const mt_onlooker *onlooker, const mt_shape *ink, int step, mt_arena *arena,
                             mt_report_glyph *glyph) {
    bool end = step == 0 || step == MT_REPORT_STEPS - 1;
    glyph->ink[step] = mt_topology_of(ink);
    glyph->seen[step] = MT_NOTHING_SEEN;
    return end ? MT_OK : mt_look_at_ink(onlooker, ink, mt_report_t(step), arena, &glyph->seen[step]);
}

static mt_status measure_step(const mt_morph *morph, const mt_onlooker *onlooker, int step,
                              const mt_params *params, int units, mt_arena *arena, mt_report_glyph *glyph) {
    mt_outline outline;
    mt_shape ink;
    mt_status status = mt_morph_outline(morph, mt_weights_at(mt_report_t(step)), params, arena, &outline);
    if (status == MT_OK) status = resolve(&outline, mt_grid_units(params->tolerance), arena, &ink);
    if (status == MT_OK) status = measure_ink(onlooker, &ink, step, arena, glyph);
    if (status == MT_OK && step == MT_REPORT_HALF)
        status = measure_drawing(&outline, units, arena, &glyph->drawing_half);
    return status;
}

/* Formula (5) turns all of an in-between: what is measured is not changed by it. */
static mt_morph unturned(const mt_morph *morph) {
    mt_morph still = *morph;
    still.degrees = 0;
    return still;
}

static mt_report_method method_of(const mt_morph *morph) {
    if (morph->links.count == 0) return MT_REPORT_ALIGNED;
    return morph->contour_count == 0 ? MT_REPORT_LINKED : MT_REPORT_BOTH;
}

mt_status mt_report_measure(const mt_glyph_pair *pair, const mt_params *params, int units, mt_arena *arena,
                            mt_report_glyph *glyph) {
    mt_report_glyph made = {
        .measured = true, .of = glyph->of, .method = method_of(&pair->morph), .proved = pair->morph.proved};
    mt_arena_place before = mt_arena_mark(arena);
    mt_morph morph = unturned(&pair->morph);
    mt_onlooker *onlooker;
    mt_status status = measure_end(&pair->a, params, units, arena, &made.ink_a, &made.drawing_a);
    if (status == MT_OK) status = measure_end(&pair->b, params, units, arena, &made.ink_b, &made.drawing_b);
    if (status == MT_OK) status = mt_look_at_ends(&morph, arena, &onlooker);
    for (int i = 0; status == MT_OK && i < MT_REPORT_STEPS; i++) {
        mt_arena_place place = mt_arena_mark(arena);
        status = measure_step(&morph, onlooker, i, params, units, arena, &made);
        mt_arena_rewind(arena, place);
    }
    mt_arena_rewind(arena, before);
    if (status == MT_OK) *glyph = made;
    return status;
}

/* ---- a row's glyphs ------------------------------------------------------------------------------------ */

static mt_status start(mt_making *making, void *user) {
    mt_report_figures *figures = user;
    int steps = making->step_count;
    figures->steps = mt_new((size_t)steps, sizeof *figures->steps);
    if (!figures->steps) return MT_NO_MEMORY;
    figures->step_count = steps;
    figures->glyph_count = making->glyph_count;
    for (int i = 0; i < steps; i++) {
        figures->steps[i] = mt_new((size_t)making->glyph_count, sizeof(mt_report_glyph));
        if (!figures->steps[i]) return MT_NO_MEMORY;
    }
    return MT_OK;
}

static mt_status begin(mt_glyph_task *task, void *user, bool *wanted) {
    const mt_report_figures *figures = user;
    bool mapped = task->making->set.charset.glyphs[task->glyph].mapped;
    *wanted = task->b != MT_NO_PARTNER && task->glyph != 0 && (mapped || !figures->mapped_only);
    return MT_OK;
}

static mt_status measure_reach(const mt_glyph_task *task, mt_report_glyph *glyph) {
    const mt_reach farthest = {-MT_REACH_MOST, 1 + MT_REACH_MOST};
    return mt_pair_reach(&task->pair, farthest, &task->making->row->params, task->scratch, &glyph->reach);
}

static mt_status take(mt_glyph_task *task, mt_status prepared, void *user) {
    const mt_report_figures *figures = user;
    const mt_making *making = task->making;
    mt_report_glyph *glyph = &figures->steps[task->step][task->glyph];
    mt_status status = prepared;
    glyph->measured = true;
    glyph->of = making->set.charset.glyphs[task->glyph];
    if (status == MT_OK)
        status = mt_report_measure(&task->pair, &making->row->params, making->units, task->scratch, glyph);
    if (status == MT_OK && figures->reach) status = measure_reach(task, glyph);
    if (status == MT_NO_MEMORY) return status;
    glyph->status = status;
    mt_report_judge(glyph);
    return MT_OK;
}

mt_sink mt_report_sink(mt_report_figures *figures) {
    return (mt_sink){start, begin, take, figures};
}

void mt_report_figures_free(mt_report_figures *figures) {
    for (int i = 0; i < figures->step_count; i++) mt_free(figures->steps[i]);
    mt_free(figures->steps);
}
