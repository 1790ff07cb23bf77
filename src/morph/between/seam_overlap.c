#include "morph/between/seam_overlap.h"

#include <math.h>

#include "geometry/inside.h"

/* Both masters of a contour while it is lapped, and which of its segments' ends were put in for that. */
typedef struct mt_seam_state {
    const mt_morph *morph;
    double reach;
    mt_arena *arena;
    mt_contour_pair made;
    bool *put_in;
} mt_seam_state;

static const mt_shape *ink_of(const mt_seam_state *lapping, int master) {
    return master == 0 ? &lapping->morph->a.whole : &lapping->morph->b.whole;
}

static mt_point between(mt_point a, mt_point b, double u) {
    return (mt_point){a.x + (int32_t)lround(u * ((double)b.x - a.x)),
                      a.y + (int32_t)lround(u * ((double)b.y - a.y))};
}

static double length_of(mt_point a, mt_point b) {
    return sqrt((double)mt_distance2(a, b));
}

/* ---- points near the ends of a cut ----------------------------------------------------------------------- */

/* Where a segment is at u. */
static mt_point point_of(mt_point start, const mt_segment *s, double u) {
    if (s->degree == 1) return between(start, s->end, u);
    return between(between(start, s->control[0], u), between(s->control[0], s->end, u), u);
}

/* The part of the segment up to u, and in *rest what is left of it. */
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

/* Which part of a segment is `reach` long, at most a third. */
static double share_of(const mt_seam_state *lapping, mt_point start, const mt_segment *s) {
    double length = length_of(start, s->end);
    return length > 3 * lapping->reach ? lapping->reach / length : 1.0 / 3;
}

static void append(mt_contour *contour, mt_segment s) {
    contour->segments[contour->count++] = s;
}

/* The segment in three, with a point near either end. */
static void append_three(const mt_seam_state *lapping, mt_point start, const mt_segment *s,
                         mt_contour *contour) {
    mt_segment rest, last;
    double u = share_of(lapping, start, s);
    append(contour, split(start, s, u, &rest));
    append(contour, split(contour->segments[contour->count - 1].end, &rest, 1 - u / (1 - u), &last));
    append(contour, last);
}

static mt_point start_of(const mt_contour *contour, int i) {
    return contour->segments[i ? i - 1 : contour->count - 1].end;
}

/* How deep in the ink the middle of a cut so long lies at least: less where a narrow neck was cut, and never as little as a
 * border is off by where it was fitted. */
static double cut_depth(const mt_seam_state *lapping, double length) {
    return fmin(2 * lapping->reach, fmax(lapping->reach / 2, length / 4));
}

/* Whether the segment is a cut of either master: in the ink. */
static bool is_cut(const mt_seam_state *lapping, const mt_contour_pair *drawn, int i) {
    for (int master = 0; master < 2; master++) {
        const mt_contour *contour = master == 0 ? &drawn->a : &drawn->b;
        const mt_segment *s = &contour->segments[i];
        mt_point start = start_of(contour, i);
        double depth = cut_depth(lapping, length_of(start, s->end));
        if (mt_is_deep_in_ink(ink_of(lapping, master), point_of(start, s, 0.5), depth)) return true;
    }
    return false;
}

static mt_status start(mt_seam_state *lapping, const mt_contour_pair *drawn) {
    size_t room = 3 * (size_t)drawn->a.count;
    lapping->made = (mt_contour_pair){{0, mt_arena_new(lapping->arena, room, sizeof(mt_segment))},
                                      {0, mt_arena_new(lapping->arena, room, sizeof(mt_segment))},
                                      drawn->displacement};
    lapping->put_in = mt_arena_new(lapping->arena, room, sizeof(bool));
    bool made = lapping->made.a.segments && lapping->made.b.segments && lapping->put_in;
    return made ? MT_OK : MT_NO_MEMORY;
}

static mt_status copy_split(mt_seam_state *lapping, const mt_contour_pair *drawn) {
    mt_status status = start(lapping, drawn);
    if (status != MT_OK) return status;
    mt_contour_pair *made = &lapping->made;
    for (int i = 0; i < drawn->a.count; i++) {
        if (!is_cut(lapping, drawn, i)) {
            append(&made->a, drawn->a.segments[i]);
            append(&made->b, drawn->b.segments[i]);
            continue;
        }
        lapping->put_in[made->a.count] = lapping->put_in[made->a.count + 1] = true;
        append_three(lapping, start_of(&drawn->a, i), &drawn->a.segments[i], &made->a);
        append_three(lapping, start_of(&drawn->b, i), &drawn->b.segments[i], &made->b);
    }
    return MT_OK;
}

/* ---- moving out ------------------------------------------------------------------------------------------ */

/* The points of a contour in order, those off the curve too. */
typedef struct mt_beads {
    int count;
    mt_point **points;
    mt_point *drawn; /* where they were */
    bool *deep;      /* where the contour, which they take along, is deep in the ink */
    bool *put_in;
} mt_beads;

static void add(mt_beads *beads, mt_point *point, bool deep, bool put_in) {
    beads->points[beads->count] = point;
    beads->drawn[beads->count] = *point;
    beads->put_in[beads->count] = put_in;
    beads->deep[beads->count++] = deep;
}

/* Whether a curve is a cut all along: a cut can go on where a border ends, and one curve be fitted to both. */
static bool is_deep_along(const mt_seam_state *lapping, const mt_shape *ink, mt_point start,
                          const mt_segment *s) {
    return mt_is_deep_in_ink(ink, point_of(start, s, 0.25), lapping->reach) &&
           mt_is_deep_in_ink(ink, point_of(start, s, 0.5), 2 * lapping->reach) &&
           mt_is_deep_in_ink(ink, point_of(start, s, 0.75), lapping->reach);
}

static mt_status string_beads(const mt_seam_state *lapping, const mt_shape *ink, mt_contour *contour,
                              mt_beads *beads) {
    size_t room = 2 * (size_t)contour->count;
    mt_arena *arena = lapping->arena;
    *beads = (mt_beads){
        0, mt_arena_new(arena, room, sizeof *beads->points), mt_arena_new(arena, room, sizeof *beads->drawn),
        mt_arena_new(arena, room, sizeof *beads->deep), mt_arena_new(arena, room, sizeof *beads->put_in)};
    if (!beads->points || !beads->drawn || !beads->deep || !beads->put_in) return MT_NO_MEMORY;
    for (int i = 0; i < contour->count; i++) {
        mt_segment *s = &contour->segments[i];
        if (s->degree == 2)
            add(beads, &s->control[0], is_deep_along(lapping, ink, start_of(contour, i), s), false);
        add(beads, &s->end, mt_is_deep_in_ink(ink, s->end, 2 * lapping->reach), lapping->put_in[i]);
    }
    return MT_OK;
}

/* The next point from i on, in steps of `by`, that is somewhere else; i's own where there is none. */
static mt_point neighbour(const mt_beads *beads, int i, int by) {
    mt_point p = beads->drawn[i];
    for (int k = 1; k < beads->count; k++) {
        mt_point q = beads->drawn[(i + (by > 0 ? k : beads->count - k)) % beads->count];
        if (!mt_point_equal(p, q)) return q;
    }
    return p;
}

/* Ink is to the left of a contour: to the right is out of it. */
static mt_point moved_out(const mt_beads *beads, int i, double reach) {
    mt_point p = beads->drawn[i], before = neighbour(beads, i, -1), after = neighbour(beads, i, 1);
    double dx = (double)after.x - before.x, dy = (double)after.y - before.y, length = hypot(dx, dy);
    if (length <= 0) return p;
    return (mt_point){p.x + (int32_t)lround(reach * dy / length), p.y - (int32_t)lround(reach * dx / length)};
}

/* Points near the ends of a cut are near the border too: they move where that leaves them in the ink. */
static bool may_move(const mt_shape *ink, const mt_beads *beads, int i, mt_point to) {
    if (beads->deep[i]) return true;
    return beads->put_in[i] && mt_is_in_ink(ink, beads->drawn[i]) && mt_is_in_ink(ink, to);
}

static mt_status lap_master(const mt_seam_state *lapping, int master, mt_contour *contour) {
    mt_beads beads;
    const mt_shape *ink = ink_of(lapping, master);
    mt_arena_place before = mt_arena_mark(lapping->arena);
    mt_status status = string_beads(lapping, ink, contour, &beads);
    for (int i = 0; status == MT_OK && i < beads.count; i++) {
        mt_point to = moved_out(&beads, i, lapping->reach);
        if (may_move(ink, &beads, i, to)) *beads.points[i] = to;
    }
    mt_arena_rewind(lapping->arena, before);
    return status;
}

mt_status mt_overlap_seams(const mt_morph *morph, double reach, mt_arena *arena,
                           mt_variable_outline *moving) {
    mt_status status = MT_OK;
    for (int i = 0; i < moving->count && status == MT_OK; i++) {
        mt_seam_state lapping = {.morph = morph, .reach = reach, .arena = arena};
        status = copy_split(&lapping, &moving->contours[i]);
        if (status == MT_OK) status = lap_master(&lapping, 0, &lapping.made.a);
        if (status == MT_OK) status = lap_master(&lapping, 1, &lapping.made.b);
        if (status == MT_OK) moving->contours[i] = lapping.made;
    }
    return status;
}
