/* Rings are paired and aligned, and a map is fitted to where samples go, twice:
 *
 *     as the boxes lie ──▶ aligned ──▶ evidence ──▶ map ──▶ aligned with it ──▶ evidence ──▶ map ──▶ aligned with it
 *
 * The first evidence comes from an alignment with little weight on places, which the boxes alone do not tell. Evidence is a step whose
 * headings agree; it weighs what its samples do by lifted length. Along each axis, the place on B is fitted to 1, u, v and the normal on
 * A by iteratively reweighted least squares with Cauchy's weights, which let what is drawn otherwise count little (P. W. Holland and
 * R. E. Welsch, "Robust regression using iteratively reweighted least squares", 1977). The map with the cheapest alignment is the one to begin
 * with, if rings had partners, it explains enough, and all of A reaches as far as all of B with it; else the boxes are. Invariants: a map neither turns nor mirrors; swapping A and B swaps the result. Costs four alignments
 * of at least SAMPLES samples for each pair of rings, and the pairing. */
#include "morph/align/registration.h"

#include <assert.h>
#include <math.h>

#include "arithmetic/angles.h"
#include "morph/align/lifted.h"
#include "morph/align/pairing.h"

#define SAMPLES 60.0      /* places along a ring, at least */
#define PLACE_SHARE 0.25  /* of the weight on places, while the map is not known */
#define AGREE 0.8         /* of headings, in and out, as a mean cosine: less is no evidence */
#define PAIRED_LEAST 0.75 /* share of the length of all rings: with less in pairs, the wholes are not known */
/* A map has to bring what boundaries cost as their boxes lie down to that, … */
#define WORTH_WHILE 0.9
#define REACH_MOST 0.2 /* … and how far a whole reaches may change by that, boxes */
#define PRIOR 0.002    /* weight of the map that changes nothing; all evidence together weighs 1 */
#define NARROWEST 0.05 /* of a map's determinant: less is no drawing's */
#define HEADS_ON 0.1   /* of what a map makes of an axis, along that axis, relative to its size */
enum { PASSES = 2 };

/* Two rings that go together. */
typedef struct mt_ring_pair {
    mt_ring_samples a, b;
    double *in_a, *in_b; /* what each sample weighs, by lifted length as the boxes lie */
    double share;        /* of the length of all rings */
} mt_ring_pair;

/* A place on A's boundary that is known to go to a place on B's: along each axis 1, u, v and the normal; and where it goes. */
typedef struct mt_evidence {
    double from[2][4], to[2];
    double weight;
} mt_evidence;

/* Maps of A's places. */
typedef struct mt_maps {
    bool found;
    mt_frame last, best; /* the last that was found, if any; the one to begin with */
} mt_maps;

/* How far the ink reaches in a frame. */
typedef struct mt_extents {
    double left, right, bottom, top;
} mt_extents;

typedef struct mt_registration {
    const mt_shape *a, *b;
    mt_frame box_a, box_b, carried; /* B's frame stays */
    mt_cost_weights weights;
    double flatness; /* grid units, of the rings */
    double paired;   /* share of the length of all rings that have a partner */
    int pair_count, count;
    mt_ring_pair *pairs;
    mt_evidence *evidence;
    mt_arena *arena;
} mt_registration;

/* ---- which rings go together --------------------------------------------------------------------------------------- */

static double length_of(const mt_shape *shape) {
    double length = 0;
    for (int k = 0; k < shape->count; k++)
        for (int i = 0; i < shape->components[k].count; i++)
            length += mt_ring_length(&shape->components[k].rings[i]);
    return length;
}

static mt_status list_rings(const mt_shape *shape, const mt_frame *frame, bool outer, mt_arena *arena,
                            mt_ring_list *list) {
    *list =
        (mt_ring_list){0, mt_arena_new(arena, (size_t)mt_shape_ring_count(shape), sizeof(mt_ring *)), *frame};
    if (!list->rings) return MT_NO_MEMORY;
    for (int k = 0; k < shape->count; k++)
        for (int i = 0; i < shape->components[k].count; i++)
            if ((i == 0) == outer) list->rings[list->count++] = &shape->components[k].rings[i];
    return MT_OK;
}

/* What each sample of a ring weighs. */
static mt_status weights_of(const mt_ring_samples *samples, const mt_frame *frame, mt_arena *arena,
                            double **weights) {
    mt_lifted_ring lifted;
    *weights = mt_arena_new(arena, (size_t)samples->count, sizeof **weights);
    mt_status status = *weights ? mt_lift_ring(samples, frame, arena, &lifted) : MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < lifted.count; i++) (*weights)[lifted.of[i]] += lifted.weight[i];
    return status;
}

static mt_status add_pair(mt_registration *r, const mt_ring *p, const mt_ring *q) {
    mt_ring_pair *pair = &r->pairs[r->pair_count++];
    pair->share = mt_ring_length(p) + mt_ring_length(q);
    mt_status status = mt_ring_samples_at_least(p, r->flatness, SAMPLES, r->arena, &pair->a);
    if (status == MT_OK) status = mt_ring_samples_at_least(q, r->flatness, SAMPLES, r->arena, &pair->b);
    if (status == MT_OK) status = weights_of(&pair->a, &r->box_a, r->arena, &pair->in_a);
    return status == MT_OK ? weights_of(&pair->b, &r->box_b, r->arena, &pair->in_b) : status;
}

static mt_status pair_rings(mt_registration *r, bool outer, const mt_settings *settings) {
    mt_ring_list in_a, in_b;
    mt_status status = list_rings(r->a, &r->box_a, outer, r->arena, &in_a);
    if (status == MT_OK) status = list_rings(r->b, &r->box_b, outer, r->arena, &in_b);
    if (status != MT_OK) return status;
    int *partner_a = mt_arena_new(r->arena, (size_t)in_a.count + 1, sizeof(int)),
        *partner_b = mt_arena_new(r->arena, (size_t)in_b.count + 1, sizeof(int));
    if (!partner_a || !partner_b) return MT_NO_MEMORY;
    for (int i = 0; i < in_a.count; i++) partner_a[i] = -1;
    for (int i = 0; i < in_b.count; i++) partner_b[i] = -1;
    status = mt_pair_rings(&in_a, &in_b, INFINITY, settings, r->arena, partner_a, partner_b);
    for (int i = 0; status == MT_OK && i < in_a.count; i++)
        if (partner_a[i] >= 0) status = add_pair(r, in_a.rings[i], in_b.rings[partner_a[i]]);
    return status;
}

static mt_status pair_all(mt_registration *r, const mt_settings *settings) {
    r->pairs = mt_arena_new(r->arena, (size_t)mt_shape_ring_count(r->a) + 1, sizeof *r->pairs);
    if (!r->pairs) return MT_NO_MEMORY;
    mt_status status = pair_rings(r, true, settings);
    if (status == MT_OK) status = pair_rings(r, false, settings);
    double whole = 0;
    size_t room = 1;
    for (int i = 0; i < r->pair_count; i++) {
        whole += r->pairs[i].share;
        room += (size_t)r->pairs[i].a.count + (size_t)r->pairs[i].b.count;
    }
    for (int i = 0; i < r->pair_count; i++) r->pairs[i].share /= whole;
    r->paired = whole / (length_of(r->a) + length_of(r->b));
    r->evidence = mt_arena_new(r->arena, room, sizeof *r->evidence);
    return status == MT_OK && !r->evidence ? MT_NO_MEMORY : status;
}

/* ---- evidence ------------------------------------------------------------------------------------------------------ */

/* The mean cosine between the headings of two samples. */
static double agreement(const mt_sample_view *p, const mt_sample_view *q) {
    return (p->in_x * q->in_x + p->in_y * q->in_y + p->out_x * q->out_x + p->out_y * q->out_y) / 2;
}

static void add_evidence(mt_registration *r, const mt_ring_sample *here, const mt_ring_sample *there,
                         double weight) {
    mt_sample_view p = mt_sample_view_of(here, &r->box_a), q = mt_sample_view_of(there, &r->box_b);
    double normal[2];
    if (agreement(&p, &q) < AGREE) return;
    mt_normal_of(p.in_x + p.out_x + q.in_x + q.out_x, p.in_y + p.out_y + q.in_y + q.out_y, normal);
    r->evidence[r->count++] = (mt_evidence){
        .from = {{1, p.x, p.y, normal[0]}, {1, p.x, p.y, normal[1]}}, .to = {q.x, q.y}, .weight = weight};
}

static mt_status look_at_pair(mt_registration *r, const mt_ring_pair *pair, double *cost) {
    mt_arena_place before = mt_arena_mark(r->arena);
    mt_alignment alignment;
    mt_status status = mt_align(&pair->a, &r->carried, &pair->b, &r->box_b, &r->weights, &(mt_links){0},
                                r->arena, &alignment);
    if (status == MT_OK) *cost += pair->share * alignment.cost;
    for (int k = 0; status == MT_OK && k < alignment.count; k++) {
        mt_link step = alignment.steps[k];
        double weight = pair->share * (pair->in_a[step.a] + pair->in_b[step.b]) / 2;
        add_evidence(r, &pair->a.samples[step.a], &pair->b.samples[step.b], weight);
    }
    mt_arena_rewind(r->arena, before);
    return status;
}

/* ---- the map ------------------------------------------------------------------------------------------------------- */

/* Solves four linear equations, the last column their right sides, by elimination with pivots; the result comes to stand there. The
 * matrix is positive definite, by its PRIOR. */
static void solve(double m[4][5]) {
    for (int i = 0; i < 4; i++) {
        int pivot = i;
        for (int k = i + 1; k < 4; k++)
            if (fabs(m[k][i]) > fabs(m[pivot][i])) pivot = k;
        for (int c = 0; c < 5; c++) {
            double swap = m[i][c];
            m[i][c] = m[pivot][c];
            m[pivot][c] = swap;
        }
        for (int k = 0; k < 4; k++) {
            if (k == i) continue;
            double times = m[k][i] / m[i][i];
            for (int c = i; c < 5; c++) m[k][c] -= times * m[i][c];
        }
    }
    for (int i = 0; i < 4; i++) m[i][4] /= m[i][i];
}

static double residual(const mt_evidence *e, int axis, const double map[4]) {
    double off = e->to[axis];
    for (int i = 0; i < 4; i++) off -= map[i] * e->from[axis][i];
    return off;
}

/* What a place may be off by and still count half, boxes: less and less, as the map becomes known. */
static const double scales[] = {0.4, 0.2, 0.1, 0.1};
enum { ROUNDS = sizeof scales / sizeof *scales };

/* Fits one axis of the map, which is a first guess before. */
static void fit_axis(const mt_registration *r, int axis, double map[4]) {
    for (int round = 0; round < ROUNDS; round++) {
        double m[4][5] = {{0}};
        for (int k = 0; k < r->count; k++) {
            const mt_evidence *e = &r->evidence[k];
            double off = residual(e, axis, map) / scales[round], weight = e->weight / (1 + off * off);
            for (int i = 0; i < 4; i++) {
                for (int j = 0; j < 4; j++) m[i][j] += weight * e->from[axis][i] * e->from[axis][j];
                m[i][4] += weight * e->from[axis][i] * e->to[axis];
            }
        }
        for (int i = 0; i < 4; i++) {
            m[i][i] += PRIOR;
            m[i][4] += PRIOR * (i == axis + 1);
        }
        solve(m);
        for (int i = 0; i < 4; i++) map[i] = m[i][4];
    }
}

/* What the map makes of headings, which are those of the drawings and not of their boxes; false for a map that turns or flattens. */
static bool carry_headings(mt_frame *carried, const mt_frame *other) {
    double wide = mt_box_width(carried->box), high = mt_box_height(carried->box),
           other_wide = mt_box_width(other->box), other_high = mt_box_height(other->box);
    double x = mt_frame_side(wide, high), y = mt_frame_side(high, wide),
           to_x = mt_frame_side(other_wide, other_high), to_y = mt_frame_side(other_high, other_wide);
    double j[4] = {carried->x[1] * to_x / x, carried->x[2] * to_x / y, carried->y[1] * to_y / x,
                   carried->y[2] * to_y / y};
    double determinant = j[0] * j[3] - j[1] * j[2], size = sqrt(fabs(determinant));
    if (determinant < NARROWEST || j[0] < HEADS_ON * size || j[3] < HEADS_ON * size) return false;
    for (int i = 0; i < 4; i++) carried->heading[i] = j[i];
    return true;
}

/* Whether a map was found; else the boxes carry. */
static bool fit_map(mt_registration *r) {
    mt_frame made = r->box_a;
    fit_axis(r, 0, made.x);
    fit_axis(r, 1, made.y);
    bool found = carry_headings(&made, &r->box_b);
    r->carried = found ? made : r->box_a;
    return found;
}

/* ---- extents ------------------------------------------------------------------------------------------------------- */

static mt_status find_extents(const mt_registration *r, const mt_shape *shape, const mt_frame *frame,
                              mt_extents *extents) {
    mt_arena_place before = mt_arena_mark(r->arena);
    mt_status status = MT_OK;
    *extents = (mt_extents){INFINITY, -INFINITY, INFINITY, -INFINITY};
    for (int k = 0; status == MT_OK && k < shape->count; k++) {
        mt_ring_samples samples;
        status = mt_ring_samples_at_least(&shape->components[k].rings[0], r->flatness, SAMPLES, r->arena,
                                          &samples);
        for (int i = 0; status == MT_OK && i < samples.count; i++) {
            mt_sample_view view = mt_sample_view_of(&samples.samples[i], frame);
            extents->left = fmin(extents->left, view.x);
            extents->right = fmax(extents->right, view.x);
            extents->bottom = fmin(extents->bottom, view.y);
            extents->top = fmax(extents->top, view.y);
        }
    }
    mt_arena_rewind(r->arena, before);
    return status;
}

/* Whether all of A, carried, reaches as far as all of B. */
static mt_status reaches_alike(const mt_registration *r, bool *alike) {
    mt_extents a, b;
    mt_status status = find_extents(r, r->a, &r->carried, &a);
    if (status == MT_OK) status = find_extents(r, r->b, &r->box_b, &b);
    *alike = status == MT_OK && fabs(a.left - b.left) <= REACH_MOST &&
             fabs(a.right - b.right) <= REACH_MOST && fabs(a.bottom - b.bottom) <= REACH_MOST &&
             fabs(a.top - b.top) <= REACH_MOST;
    return status;
}

/* ---- the best map -------------------------------------------------------------------------------------------------- */

/* Aligns all pairs in the frames that hold, for evidence. *cost: the mean of the alignments'. */
static mt_status look(mt_registration *r, double *cost) {
    mt_status status = MT_OK;
    r->count = 0;
    *cost = 0;
    for (int i = 0; status == MT_OK && i < r->pair_count; i++) status = look_at_pair(r, &r->pairs[i], cost);
    return status;
}

/* The map of most use: boundaries are less apart with it than as their boxes lie. */
static mt_status fit_maps(mt_registration *r, mt_maps *maps) {
    mt_cost_weights weights = r->weights;
    double cost, least;
    mt_status status = look(r, &least);
    least *= WORTH_WHILE;
    r->weights.distance *= PLACE_SHARE;
    if (status == MT_OK) status = look(r, &cost);
    r->weights = weights;
    for (int pass = 0; status == MT_OK && pass < PASSES; pass++) {
        bool alike = false;
        if (fit_map(r)) {
            maps->last = r->carried;
            maps->found = true;
        }
        status = look(r, &cost);
        if (status == MT_OK && cost < least) status = reaches_alike(r, &alike);
        if (!alike || r->paired < PAIRED_LEAST) continue;
        least = cost;
        maps->best = r->carried;
    }
    return status;
}

static mt_status find_maps(mt_registration *r, const mt_settings *settings, mt_maps *maps) {
    *maps = (mt_maps){.best = r->box_a};
    mt_status status = pair_all(r, settings);
    return status == MT_OK && r->pair_count > 0 ? fit_maps(r, maps) : status;
}

/* ---- placings without a map ---------------------------------------------------------------------------------------- */

/* Both boxes with their middles on one another, as one box around both: places are apart as on the page. */
static void lay(const mt_side *a, const mt_side *b, mt_registered *made) {
    mt_box p = a->box, q = b->box;
    int32_t shift = (p.min.x + p.max.x - q.min.x - q.max.x) / 2;
    mt_box both = mt_box_around(p, (mt_box){{q.min.x + shift, q.min.y}, {q.max.x + shift, q.max.y}});
    made->a[MT_LAID] = mt_frame_of_box(both);
    made->b[MT_LAID] =
        mt_frame_of_box((mt_box){{both.min.x - shift, both.min.y}, {both.max.x - shift, both.max.y}});
    made->applies[MT_LAID] = true;
}

/* The frame of a side that is slanted first: each place moves to the right by `tangent` of its height. */
static mt_frame slanted_frame(const mt_side *side, double tangent) {
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < side->shape.count; k++)
        for (int i = 0; i < side->shape.components[k].rings[0].count; i++) {
            mt_point p = side->shape.components[k].rings[0].points[i];
            low = fmin(low, p.x + tangent * p.y);
            high = fmax(high, p.x + tangent * p.y);
        }
    double width = mt_box_width(side->box), height = mt_box_height(side->box);
    double across = mt_frame_side(width, height), up = mt_frame_side(height, width),
           slanted = mt_frame_side(fmax(1, high - low), height);
    double x = side->box.min.x + width / 2, y = side->box.min.y + height / 2;
    mt_frame made = mt_frame_of_box(side->box);
    made.x[0] = (x + tangent * y - (low + high) / 2) / slanted;
    made.x[1] = across / slanted;
    made.x[2] = tangent * up / slanted;
    made.heading[1] = tangent;
    return made;
}

/* Half of the slant is taken off on either side, so that swapping A and B swaps the result. */
static void lean(const mt_side *a, const mt_side *b, double degrees, mt_registered *made) {
    double half = mt_tan(degrees * (M_PI / 180)) / 2;
    made->applies[MT_LEANING] = degrees != 0;
    made->a[MT_LEANING] = slanted_frame(a, half);
    made->b[MT_LEANING] = slanted_frame(b, -half);
}

/* ---- which is carried ---------------------------------------------------------------------------------------------- */

static int64_t compare_rings(const mt_ring *a, const mt_ring *b) {
    if (a->count != b->count) return a->count - b->count;
    for (int i = 0; i < a->count; i++) {
        if (a->points[i].x != b->points[i].x) return (int64_t)a->points[i].x - b->points[i].x;
        if (a->points[i].y != b->points[i].y) return (int64_t)a->points[i].y - b->points[i].y;
    }
    return 0;
}

/* An order of shapes by their contents alone: < 0, 0, > 0. */
static int64_t compare(const mt_shape *p, const mt_shape *q) {
    int64_t order = mt_shape_area2(p) - mt_shape_area2(q);
    if (order == 0) order = p->count - q->count;
    for (int k = 0; order == 0 && k < p->count; k++) {
        const mt_component *a = &p->components[k], *b = &q->components[k];
        order = a->count - b->count;
        for (int i = 0; order == 0 && i < a->count; i++) order = compare_rings(&a->rings[i], &b->rings[i]);
    }
    return order;
}

mt_status mt_register(const mt_side *a, const mt_side *b, double degrees, const mt_settings *settings,
                      mt_arena *arena, mt_registered *made) {
    bool turned = compare(&a->shape, &b->shape) > 0;
    const mt_side *first = turned ? b : a, *second = turned ? a : b;
    mt_registration r = {.box_a = mt_frame_of_box(first->box),
                         .box_b = mt_frame_of_box(second->box),
                         .a = &first->shape,
                         .b = &second->shape,
                         .weights = settings->align,
                         .flatness = settings->flatness,
                         .arena = arena};
    mt_maps maps;
    r.carried = r.box_a;
    mt_status status = find_maps(&r, settings, &maps);
    if (status != MT_OK) maps = (mt_maps){.best = r.box_a};
    mt_frame *in_first = turned ? made->b : made->a, *in_second = turned ? made->a : made->b;
    in_first[MT_REGISTERED] = maps.best;
    in_first[MT_MAPPED] = maps.found ? maps.last : r.box_a;
    in_second[MT_REGISTERED] = in_second[MT_MAPPED] = r.box_b;
    made->applies[MT_REGISTERED] = true;
    made->applies[MT_MAPPED] = maps.found;
    lay(a, b, made);
    lean(a, b, degrees, made);
    for (int i = 0; i < MT_PLACINGS; i++)
        assert(mt_frame_is_valid(&made->a[i]) && mt_frame_is_valid(&made->b[i]));
    return status == MT_TOO_LARGE ? MT_OK : status;
}
