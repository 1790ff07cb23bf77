/* Overlap along cuts. Contours on both sides of a cut meet in a line; rounded to whole units one by one, they leave a hairline.
 *
 *     ┌─────┊─────┐        ┌────┐┌────┐      Points of a master that lie at least twice `reach` deep in the ink of their side are on
 *     │     ┊ cut │  ──▶   │  ╔═╪╪═╗  │      a cut: they move out of their own contour by `reach`, into the other's ink.
 *     └─────┊─────┘        └────┘└────┘      Near both ends of a cut, two points are added that move as far as there is ink.
 *
 * A control point moves where all of its curve is deep in the ink. Invariants: the union of a side's contours stays its ink; both masters
 * keep as many segments, of the same degrees. O(n m) for n points of the contours and m vertices of the drawing. */
#include "morph/between/seam_overlap.h"

#include <math.h>

#include "arithmetic/angles.h"
#include "geometry/inside.h"

/* Both masters of a contour, and the ends of segments that were added to them. */
typedef struct mt_seam_state {
    const mt_morph *morph;
    double reach;
    mt_arena *arena;
    mt_contour_pair made;
    bool *added;
} mt_seam_state;

static const mt_shape *ink_of(const mt_seam_state *state, int master) {
    return master == 0 ? &state->morph->a.whole : &state->morph->b.whole;
}

static mt_point between(mt_point a, mt_point b, double u) {
    return (mt_point){a.x + (int32_t)lround(u * ((double)b.x - a.x)),
                      a.y + (int32_t)lround(u * ((double)b.y - a.y))};
}

static double length_of(mt_point a, mt_point b) {
    return sqrt((double)mt_distance2(a, b));
}

/* ---- points near the ends of a cut ----------------------------------------------------------------------- */

/* The place of a segment at u. */
static mt_point point_of(mt_point start, const mt_segment *s, double u) {
    if (s->degree == 1) return between(start, s->end, u);
    return between(between(start, s->control[0], u), between(s->control[0], s->end, u), u);
}

/* The part of the segment up to u, and the rest of it. */
static mt_segment split(mt_point start, const mt_segment *s, double u, mt_segment *rest) {
    mt_segment head = {.degree = s->degree};
    *rest = *s;
    if (s->degree == 1) {
        head.end = between(start, s->end, u);
        return head;
    }
    head.control[0] = between(start, s->control[0], u);
    rest->control[0] = between(s->control[0], s->end, u);
    head.end = between(head.control[0], rest->control[0], u);
    return head;
}

/* The fraction of a segment that is `reach` long, at most a third. */
static double share_of(const mt_seam_state *state, mt_point start, const mt_segment *s) {
    double length = length_of(start, s->end);
    return length > 3 * state->reach ? state->reach / length : 1.0 / 3;
}

static void append(mt_contour *contour, mt_segment s) {
    contour->segments[contour->count++] = s;
}

/* The segment in three, with a point near either end. */
static void append_three(const mt_seam_state *state, mt_point start, const mt_segment *s,
                         mt_contour *contour) {
    mt_segment rest, last;
    double u = share_of(state, start, s);
    append(contour, split(start, s, u, &rest));
    append(contour, split(contour->segments[contour->count - 1].end, &rest, 1 - u / (1 - u), &last));
    append(contour, last);
}

static mt_point start_of(const mt_contour *contour, int i) {
    return contour->segments[i ? i - 1 : contour->count - 1].end;
}

/* The least depth in the ink of the middle of a cut of this length: less for a short cut, and more than the error of a fitted border. */
static double cut_depth(const mt_seam_state *state, double length) {
    return fmin(2 * state->reach, fmax(state->reach / 2, length / 4));
}

/* Whether the segment is a cut in either master: deep in the ink. */
static bool is_cut(const mt_seam_state *state, const mt_contour_pair *drawn, int i) {
    for (int master = 0; master < 2; master++) {
        const mt_contour *contour = master == 0 ? &drawn->a : &drawn->b;
        const mt_segment *s = &contour->segments[i];
        mt_point start = start_of(contour, i);
        double depth = cut_depth(state, length_of(start, s->end));
        if (mt_is_deep_in_ink(ink_of(state, master), point_of(start, s, 0.5), depth)) return true;
    }
    return false;
}

static mt_status start(mt_seam_state *state, const mt_contour_pair *drawn) {
    size_t room = 3 * (size_t)drawn->a.count;
    state->made = (mt_contour_pair){{0, mt_arena_new(state->arena, room, sizeof(mt_segment))},
                                    {0, mt_arena_new(state->arena, room, sizeof(mt_segment))},
                                    drawn->displacement};
    state->added = mt_arena_new(state->arena, room, sizeof(bool));
    bool made = state->made.a.segments && state->made.b.segments && state->added;
    return made ? MT_OK : MT_NO_MEMORY;
}

static mt_status copy_split(mt_seam_state *state, const mt_contour_pair *drawn) {
    mt_status status = start(state, drawn);
    if (status != MT_OK) return status;
    mt_contour_pair *made = &state->made;
    for (int i = 0; i < drawn->a.count; i++) {
        if (!is_cut(state, drawn, i)) {
            append(&made->a, drawn->a.segments[i]);
            append(&made->b, drawn->b.segments[i]);
            continue;
        }
        state->added[made->a.count] = state->added[made->a.count + 1] = true;
        append_three(state, start_of(&drawn->a, i), &drawn->a.segments[i], &made->a);
        append_three(state, start_of(&drawn->b, i), &drawn->b.segments[i], &made->b);
    }
    return MT_OK;
}

/* ---- moving points out ------------------------------------------------------------------------------------------ */

/* The points of a contour in order, with control points. */
typedef struct mt_contour_points {
    int count;
    mt_point **points;
    mt_point *drawn; /* their places before */
    bool *deep;      /* whether the contour at each is deep in the ink */
    bool *added;
} mt_contour_points;

static void add(mt_contour_points *points, mt_point *point, bool deep, bool added) {
    points->points[points->count] = point;
    points->drawn[points->count] = *point;
    points->added[points->count] = added;
    points->deep[points->count++] = deep;
}

/* Whether a curve is a cut from end to end: one curve can be fitted to a cut and to the border beyond it. */
static bool is_deep_along(const mt_seam_state *state, const mt_shape *ink, mt_point start,
                          const mt_segment *s) {
    return mt_is_deep_in_ink(ink, point_of(start, s, 0.25), state->reach) &&
           mt_is_deep_in_ink(ink, point_of(start, s, 0.5), 2 * state->reach) &&
           mt_is_deep_in_ink(ink, point_of(start, s, 0.75), state->reach);
}

static mt_status list_points(const mt_seam_state *state, const mt_shape *ink, mt_contour *contour,
                             mt_contour_points *points) {
    size_t room = 2 * (size_t)contour->count;
    mt_arena *arena = state->arena;
    *points = (mt_contour_points){0, mt_arena_new(arena, room, sizeof *points->points),
                                  mt_arena_new(arena, room, sizeof *points->drawn),
                                  mt_arena_new(arena, room, sizeof *points->deep),
                                  mt_arena_new(arena, room, sizeof *points->added)};
    if (!points->points || !points->drawn || !points->deep || !points->added) return MT_NO_MEMORY;
    for (int i = 0; i < contour->count; i++) {
        mt_segment *s = &contour->segments[i];
        if (s->degree == 2)
            add(points, &s->control[0], is_deep_along(state, ink, start_of(contour, i), s), false);
        add(points, &s->end, mt_is_deep_in_ink(ink, s->end, 2 * state->reach), state->added[i]);
    }
    return MT_OK;
}

/* The next point from i on, in steps of `by`, at another place; i's own where there is none. */
static mt_point neighbour(const mt_contour_points *points, int i, int by) {
    mt_point p = points->drawn[i];
    for (int k = 1; k < points->count; k++) {
        mt_point q = points->drawn[(i + (by > 0 ? k : points->count - k)) % points->count];
        if (!mt_point_equal(p, q)) return q;
    }
    return p;
}

/* A point moved to the right of its contour, out of its ink. */
static mt_point shifted_out(const mt_contour_points *points, int i, double reach) {
    mt_point p = points->drawn[i], before = neighbour(points, i, -1), after = neighbour(points, i, 1);
    double dx = (double)after.x - before.x, dy = (double)after.y - before.y, length = mt_hypot(dx, dy);
    if (length <= 0) return p;
    return (mt_point){p.x + (int32_t)lround(reach * dy / length), p.y - (int32_t)lround(reach * dx / length)};
}

/* Whether a point moves: deep points do; added ones, near the border, where they stay in the ink. */
static bool may_move(const mt_shape *ink, const mt_contour_points *points, int i, mt_point to) {
    if (points->deep[i]) return true;
    return points->added[i] && mt_is_in_ink(ink, points->drawn[i]) && mt_is_in_ink(ink, to);
}

static mt_status overlap_master(const mt_seam_state *state, int master, mt_contour *contour) {
    mt_contour_points points;
    const mt_shape *ink = ink_of(state, master);
    mt_arena_place before = mt_arena_mark(state->arena);
    mt_status status = list_points(state, ink, contour, &points);
    for (int i = 0; status == MT_OK && i < points.count; i++) {
        mt_point to = shifted_out(&points, i, state->reach);
        if (may_move(ink, &points, i, to)) *points.points[i] = to;
    }
    mt_arena_rewind(state->arena, before);
    return status;
}

mt_status mt_overlap_seams(const mt_morph *morph, double reach, mt_arena *arena,
                           mt_variable_outline *variable) {
    mt_status status = MT_OK;
    for (int i = 0; i < variable->count && status == MT_OK; i++) {
        mt_seam_state state = {.morph = morph, .reach = reach, .arena = arena};
        status = copy_split(&state, &variable->contours[i]);
        if (status == MT_OK) status = overlap_master(&state, 0, &state.made.a);
        if (status == MT_OK) status = overlap_master(&state, 1, &state.made.b);
        if (status == MT_OK) variable->contours[i] = state.made;
    }
    return status;
}
