/* Division: where A has two parts and B has them joined, B is cut, and the other way round.
 *
 *     A  ┌───┐ ┌────┐      B  ┌────────┐    The match of A's left ring crosses B's ink downwards at the chord ┊,
 *        │   │ │    │         │   ┊    │    the match of its right ring upwards: B is cut there.
 *        └───┘ └────┘         └────────┘    A match that only takes a short cut past a serif does not return: no cut.
 *
 * 1. Both boundaries become graphs; chords between holes that both sides have and the outside are barred (keep_common_holes).
 * 2. All rings are matched both ways; of the chords used, all are barred but those with a return nearby (bar_chords), and all rings are
 *    matched again with what is left, if anything is.
 * 3. Each side is cut along the chords used both ways (choose_cuts, cut_all), and the parts are paired (pair_parts).
 * 4. While there is a useless cut, at a part without partner, it is undone, and 3 is done again (undo_cut).
 * Invariants: parts have the ink of their side; partners are mutual. O(n m) for the matches, O(k²) alignments for k parts a round. */
#include "morph/divide/division.h"

#include <assert.h>
#include <math.h>

#include "geometry/inside.h"
#include "geometry/limits.h"
#include "morph/align/pairing.h"
#include "morph/divide/cut.h"
#include "morph/divide/ring_matching.h"

/* The most that aligning two parts may cost for them to be partners (align/pairing.h); costlier ones are left to reconcile.c. */
#define PARTNER_MOST 2.0

/* The most that aligning two holes may cost for them to be the same hole. */
#define COMMON_MOST 0.6

/* The state of one side. */
typedef struct mt_division {
    mt_boundary boundary;
    bool *used;           /* of each chord: whether a match of the other side's rings crosses it */
    bool kept;            /* whether there is a chord that may become a cut */
    mt_match_step *start; /* of each ring, a step of its match with the other side; here < 0: not known yet */
    bool **cut;           /* of each component's mesh, the half-edges along which it is cut */
    int **part_of;        /* of each component's mesh, the part of each triangle */
    mt_cut_side made;
} mt_division;

/* ---- matches ------------------------------------------------------------------------------------------------------- */

/* Matches all rings of one side with the other's boundary; notes the chords that they use, and a step of each. Where no chord may become
 * a cut, none is used. */
static mt_status match_onto(mt_division *from, mt_division *to, const mt_cost_weights *weights,
                            mt_arena *arena) {
    for (int i = 0; i < to->boundary.first_chord[to->boundary.count]; i++) to->used[i] = false;
    for (int r = 0; to->kept && r < from->boundary.ring_count; r++) {
        mt_arena_place before = mt_arena_mark(arena);
        mt_ring_match match;
        mt_status status = mt_match_ring(&from->boundary, r, &to->boundary, weights,
                                         from->start[r].here < 0 ? NULL : &from->start[r], arena, &match);
        if (status != MT_OK) return status;
        from->start[r] = match.steps[0];
        for (int k = 0; k < match.count; k++)
            if (match.steps[k].chord >= 0) to->used[match.steps[k].chord] = true;
        mt_arena_rewind(arena, before);
    }
    return MT_OK;
}

static mt_status match_both_ways(mt_division *sides, const mt_cost_weights *weights, mt_arena *arena) {
    mt_status status = match_onto(&sides[0], &sides[1], weights, arena);
    return status == MT_OK ? match_onto(&sides[1], &sides[0], weights, arena) : status;
}

/* ---- holes that both sides have ------------------------------------------------------------------------------ */

/* The holes of a shape, the number of each in its boundary's rings, and which of those are outer rings. */
static mt_status holes_of(const mt_side *side, mt_arena *arena, mt_ring_list *holes, int *ring_of,
                          bool *outer) {
    int ring = 0;
    *holes = (mt_ring_list){0, NULL, side->frame};
    for (int k = 0; k < side->shape.count; k++) ring += side->shape.components[k].count;
    holes->rings = mt_arena_new(arena, (size_t)ring, sizeof(mt_ring *));
    if (!holes->rings) return MT_NO_MEMORY;
    ring = 0;
    for (int k = 0; k < side->shape.count; k++)
        for (int i = 0; i < side->shape.components[k].count; i++, ring++) {
            outer[ring] = i == 0;
            if (i == 0) continue;
            ring_of[holes->count] = ring;
            holes->rings[holes->count++] = &side->shape.components[k].rings[i];
        }
    return MT_OK;
}

/* Bars the chords from common holes to the outside, and to one another: such holes need not be opened. `common` and `outer`, of each
 * ring: whether it is a common hole, and whether it is a component's outer ring. */
static void bar_common(mt_boundary *b, const bool *common, const bool *outer) {
    for (int sample = 0; sample < b->count; sample++)
        for (int i = b->first_chord[sample]; i < b->first_chord[sample + 1]; i++) {
            int from = mt_boundary_ring(b, sample), to = mt_boundary_ring(b, b->chords[i].to);
            bool needless = (common[from] && (common[to] || outer[to])) || (common[to] && outer[from]);
            if (from != to && needless) b->chords[i].cost = INFINITY;
        }
}

static mt_status keep_common_holes(const mt_side *a, const mt_side *b, mt_division *sides,
                                   const mt_settings *settings, mt_arena *arena) {
    mt_ring_list holes[2];
    int *ring_of[2], *partner[2];
    bool *common[2], *outer[2];
    mt_status status = MT_OK;
    for (int s = 0; status == MT_OK && s < 2; s++) {
        size_t rings = (size_t)sides[s].boundary.ring_count;
        ring_of[s] = mt_arena_new(arena, rings, sizeof(int));
        partner[s] = mt_arena_new(arena, rings, sizeof(int));
        common[s] = mt_arena_new(arena, rings, sizeof(bool));
        outer[s] = mt_arena_new(arena, rings, sizeof(bool));
        if (!ring_of[s] || !partner[s] || !common[s] || !outer[s]) return MT_NO_MEMORY;
        status = holes_of(s == 0 ? a : b, arena, &holes[s], ring_of[s], outer[s]);
        for (int i = 0; status == MT_OK && i < holes[s].count; i++) partner[s][i] = -1;
    }
    if (status == MT_OK)
        status = mt_pair_rings(&holes[0], &holes[1], COMMON_MOST, settings, arena, partner[0], partner[1]);
    for (int s = 0; status == MT_OK && s < 2; s++) {
        for (int i = 0; i < holes[s].count; i++) common[s][ring_of[s][i]] = partner[s][i] >= 0;
        bar_common(&sides[s].boundary, common[s], outer[s]);
    }
    return status;
}

/* ---- chords that may become cuts ------------------------------------------------------------------------------------ */

#define RETURN_REACH 0.3 /* em: between the ends of a chord and of its return, both together, at most … */
#define RETURN_SHARE 1.0 /* … and this part of the chord's length more */
#define KEPT_SHARE 0.25  /* of its cost remains of a chord that has a return */

/* Whether the directions of two chords are more than a right angle apart. */
static bool are_opposite(const mt_boundary *b, int one, int other) {
    const mt_sample_view *p = &b->views[mt_chord_source(b, one)], *q = &b->views[b->chords[one].to],
                         *u = &b->views[mt_chord_source(b, other)], *v = &b->views[b->chords[other].to];
    return (q->x - p->x) * (v->x - u->x) + (q->y - p->y) * (v->y - u->y) < 0;
}

/* The return of a chord: the nearest used chord in the opposite direction; -1 where none is near enough. */
static int return_chord(const mt_division *division, int chord) {
    const mt_boundary *b = &division->boundary;
    int from = mt_chord_source(b, chord), to = b->chords[chord].to, best = -1;
    double least = RETURN_REACH + RETURN_SHARE * mt_chord_length(b, chord);
    for (int i = 0; i < b->first_chord[b->count]; i++) {
        if (!division->used[i] || b->chords[i].edge < 0 || !are_opposite(b, chord, i)) continue;
        double apart = mt_boundary_distance(b, from, b->chords[i].to) +
                       mt_boundary_distance(b, to, mt_chord_source(b, i));
        if (apart >= least) continue;
        least = apart;
        best = i;
    }
    return best;
}

/* How many ends of a chord are vertices of the drawing, as those of a cut at the root of a stroke are. */
static int drawn_ends(const mt_boundary *b, int chord) {
    int c = 0, from = mt_chord_source(b, chord), to = b->chords[chord].to;
    while (b->first_sample[c + 1] <= from) c++;
    return b->drawn[c][from - b->first_sample[c]] + b->drawn[c][to - b->first_sample[c]];
}

/* The better place to cut of two chords: with more ends at vertices of the drawing, then the shorter, then the first. */
static int better_cut(const mt_boundary *b, int one, int other) {
    int ends = drawn_ends(b, one) - drawn_ends(b, other);
    double longer = mt_chord_length(b, one) - mt_chord_length(b, other);
    if (ends != 0) return ends > 0 ? one : other;
    if (longer != 0) return longer < 0 ? one : other;
    return one < other ? one : other;
}

/* Bars all chords but the used ones with a return: of the two, the better place to cut stays. */
static mt_status bar_chords(mt_division *division, mt_arena *arena) {
    mt_boundary *b = &division->boundary;
    int total = b->first_chord[b->count], used = 0;
    for (int i = 0; i < total; i++) used += division->used[i];
    if (!mt_arena_spend(arena, (int64_t)used * total)) return MT_TOO_LARGE;
    bool *keep = mt_arena_new(arena, (size_t)total, sizeof *keep);
    if (!keep) return MT_NO_MEMORY;
    division->kept = false;
    for (int i = 0; i < total; i++) {
        if (b->chords[i].edge < 0) continue;
        int back = division->used[i] ? return_chord(division, i) : -1;
        if (back < 0) continue;
        int chosen = better_cut(b, i, back);
        keep[chosen] = keep[mt_chord_back(b, chosen)] = division->kept = true;
    }
    for (int i = 0; i < total; i++)
        if (b->chords[i].edge >= 0) b->chords[i].cost = keep[i] ? b->chords[i].cost * KEPT_SHARE : INFINITY;
    return MT_OK;
}

/* The chord to cut along for a used chord: itself, when it is used both ways; the better of two that are each other's return and used
 * one way; -1: none. */
static int cut_for_chord(const mt_division *division, int chord) {
    const mt_boundary *b = &division->boundary;
    if (division->used[mt_chord_back(b, chord)]) return chord;
    int back = return_chord(division, chord);
    if (back < 0 || division->used[mt_chord_back(b, back)] || return_chord(division, back) != chord)
        return -1;
    return better_cut(b, chord, back);
}

/* Marks the diagonals to cut along. */
static mt_status choose_cuts(mt_division *division, mt_arena *arena) {
    const mt_boundary *b = &division->boundary;
    division->cut = mt_arena_new(arena, (size_t)b->component_count, sizeof *division->cut);
    division->part_of = mt_arena_new(arena, (size_t)b->component_count, sizeof *division->part_of);
    if (!division->cut || !division->part_of) return MT_NO_MEMORY;
    for (int c = 0; c < b->component_count; c++) {
        size_t triangles = (size_t)b->meshes[c].triangle_count;
        division->cut[c] = mt_arena_new(arena, 3 * triangles, sizeof(bool));
        division->part_of[c] = mt_arena_new(arena, triangles, sizeof(int));
        if (!division->cut[c] || !division->part_of[c]) return MT_NO_MEMORY;
        int first = b->first_chord[b->first_sample[c]], last = b->first_chord[b->first_sample[c + 1]];
        for (int i = first; i < last; i++) {
            int place = division->used[i] && b->chords[i].edge >= 0 ? cut_for_chord(division, i) : -1;
            if (place < first || place >= last) continue;
            division->cut[c][b->chords[place].edge] = true;
            division->cut[c][b->meshes[c].twin[b->chords[place].edge]] = true;
        }
    }
    return MT_OK;
}

/* ---- parts ------------------------------------------------------------------------------------------------------------ */

static mt_status cut_all(mt_division *division, mt_arena *arena) {
    mt_shape made = {0, mt_arena_new(arena, (size_t)division->boundary.count, sizeof(mt_component))};
    if (!made.components) return MT_NO_MEMORY;
    for (int c = 0; c < division->boundary.component_count; c++) {
        const mt_half_edges *mesh = &division->boundary.meshes[c];
        mt_cut_plan plan = {mesh, division->boundary.drawn[c], division->cut[c]};
        mt_shape parts;
        mt_status status = mt_cut(&plan, arena, &parts, division->part_of[c]);
        if (status != MT_OK) return status;
        for (int t = 0; t < mesh->triangle_count; t++) division->part_of[c][t] += made.count;
        for (int i = 0; i < parts.count; i++) made.components[made.count++] = parts.components[i];
    }
    division->made = (mt_cut_side){made, mt_arena_new(arena, (size_t)made.count, sizeof(int))};
    return division->made.partner ? MT_OK : MT_NO_MEMORY;
}

static mt_status pair_parts(mt_division *sides, const mt_hints *hints, const mt_settings *settings,
                            mt_arena *arena) {
    mt_cut_side *a = &sides[0].made, *b = &sides[1].made;
    mt_ring_list in_a, in_b;
    mt_status status = mt_outer_rings(&sides[0].made.parts, &sides[0].boundary.frame, arena, &in_a);
    if (status == MT_OK)
        status = mt_outer_rings(&sides[1].made.parts, &sides[1].boundary.frame, arena, &in_b);
    if (status != MT_OK) return status;
    for (int i = 0; i < a->parts.count; i++) a->partner[i] = -1;
    for (int i = 0; i < b->parts.count; i++) b->partner[i] = -1;
    for (int i = 0; i < hints->count; i++) {
        if (hints->hints[i].kind != MT_HINT_COMPONENT) continue;
        int p = mt_component_at(&a->parts, hints->hints[i].a),
            q = mt_component_at(&b->parts, hints->hints[i].b);
        if (a->partner[p] >= 0 || b->partner[q] >= 0) continue;
        a->partner[p] = q;
        b->partner[q] = p;
    }
    return mt_pair_rings(&in_a, &in_b, PARTNER_MOST, settings, arena, a->partner, b->partner);
}

/* ---- cuts that do not help ------------------------------------------------------------------------------------------------- */

/* A cut between a part that has no partner and another. */
typedef struct mt_unpaired_cut {
    mt_division *division, *other;
    int component, edge;
    int here, there; /* the parts; `here` has no partner */
    int64_t area;    /* of `here`, twice, grid units squared */
    double length;   /* grid units */
} mt_unpaired_cut;

static void set_cut(const mt_unpaired_cut *f, bool cut) {
    f->division->cut[f->component][f->edge] =
        f->division->cut[f->component][f->division->boundary.meshes[f->component].twin[f->edge]] = cut;
}

/* Whether both parts together align with the other's partner at less cost than that part alone. */
static mt_status is_better_whole(const mt_unpaired_cut *f, const mt_settings *settings, mt_arena *arena,
                                 bool *better) {
    const mt_division *division = f->division;
    const mt_half_edges *mesh = &division->boundary.meshes[f->component];
    mt_cut_plan plan = {mesh, division->boundary.drawn[f->component], division->cut[f->component]};
    const mt_ring *goal = &f->other->made.parts.components[division->made.partner[f->there]].rings[0];
    mt_shape parts;
    double apart = 0, together = 0;
    int *part_of = mt_arena_new(arena, (size_t)mesh->triangle_count, sizeof *part_of);
    if (!part_of) return MT_NO_MEMORY;
    set_cut(f, false);
    mt_status status = mt_cut(&plan, arena, &parts, part_of);
    set_cut(f, true);
    if (status != MT_OK) return status;
    const mt_ring *whole = &parts.components[part_of[f->edge / 3]].rings[0],
                  *alone = &division->made.parts.components[f->there].rings[0];
    status = mt_pair_cost(alone, &division->boundary.frame, goal, &f->other->boundary.frame, settings, arena,
                          &apart);
    if (status == MT_OK)
        status = mt_pair_cost(whole, &division->boundary.frame, goal, &f->other->boundary.frame, settings,
                              arena, &together);
    *better = together < apart;
    return status;
}

/* Whether to undo the cut: the other part has no partner either, or is the larger one, or aligns better with this one. */
static mt_status is_useless(const mt_unpaired_cut *f, const mt_settings *settings, mt_arena *arena,
                            bool *useless) {
    const mt_shape *parts = &f->division->made.parts;
    *useless =
        f->division->made.partner[f->there] < 0 || f->area < mt_component_area2(&parts->components[f->there]);
    return *useless ? MT_OK : is_better_whole(f, settings, arena, useless);
}

static bool unpaired_cut_at(mt_division *sides, int side, int component, int edge, mt_unpaired_cut *f) {
    mt_division *division = &sides[side];
    const mt_half_edges *mesh = &division->boundary.meshes[component];
    if (!division->cut[component][edge]) return false;
    int here = division->part_of[component][edge / 3],
        there = division->part_of[component][mesh->twin[edge] / 3];
    if (here == there || division->made.partner[here] >= 0) return false;
    int end = mesh->start[mt_mesh_after(edge)];
    *f = (mt_unpaired_cut){division,
                           &sides[1 - side],
                           component,
                           edge,
                           here,
                           there,
                           mt_component_area2(&division->made.parts.components[here]),
                           sqrt((double)mt_distance2(mesh->points[mesh->start[edge]], mesh->points[end]))};
    return true;
}

/* Undoes one useless cut: the longest one of the smallest part. *undone: there was one. */
static mt_status undo_cut(mt_division *sides, const mt_settings *settings, mt_arena *arena, bool *undone) {
    mt_unpaired_cut best = {0}, f;
    for (int s = 0; s < 2; s++)
        for (int c = 0; c < sides[s].boundary.component_count; c++)
            for (int e = 0; e < 3 * sides[s].boundary.meshes[c].triangle_count; e++) {
                bool useless;
                if (!unpaired_cut_at(sides, s, c, e, &f)) continue;
                if (best.division && (f.area > best.area || (f.area == best.area && f.length <= best.length)))
                    continue;
                mt_status status = is_useless(&f, settings, arena, &useless);
                if (status != MT_OK) return status;
                if (useless) best = f;
            }
    if (best.division) set_cut(&best, false);
    *undone = best.division;
    return MT_OK;
}

/* ---- all of it ----------------------------------------------------------------------------------------------------------- */

static mt_status start_division(const mt_side *side, const mt_settings *settings, mt_arena *arena,
                                mt_division *division) {
    mt_status status = mt_boundary_of(&side->shape, &side->frame, settings, mt_grid_units(MT_CHORD_REACH),
                                      arena, &division->boundary);
    if (status != MT_OK) return status;
    size_t chords = (size_t)division->boundary.first_chord[division->boundary.count],
           rings = (size_t)division->boundary.ring_count;
    division->used = mt_arena_new(arena, chords, sizeof *division->used);
    division->start = mt_arena_new(arena, rings, sizeof *division->start);
    if (!division->used || !division->start) return MT_NO_MEMORY;
    division->kept = true;
    for (size_t r = 0; r < rings; r++) division->start[r].here = -1;
    return MT_OK;
}

static mt_status find_cuts(mt_division *sides, const mt_cost_weights *weights, mt_arena *arena) {
    mt_status status = match_both_ways(sides, weights, arena);
    for (int s = 0; status == MT_OK && s < 2; s++) status = bar_chords(&sides[s], arena);
    if (status == MT_OK) status = match_both_ways(sides, weights, arena);
    for (int s = 0; status == MT_OK && s < 2; s++) status = choose_cuts(&sides[s], arena);
    return status;
}

mt_status mt_divide(const mt_side *a, const mt_side *b, const mt_hints *hints, const mt_settings *settings,
                    mt_arena *arena, mt_cut_side *cut_a, mt_cut_side *cut_b) {
    mt_division sides[2] = {0};
    mt_status status = start_division(a, settings, arena, &sides[0]);
    if (status == MT_OK) status = start_division(b, settings, arena, &sides[1]);
    if (status == MT_OK) status = keep_common_holes(a, b, sides, settings, arena);
    if (status == MT_OK) status = find_cuts(sides, &settings->match, arena);
    bool changed = true;
    while (status == MT_OK && changed) {
        for (int s = 0; status == MT_OK && s < 2; s++) status = cut_all(&sides[s], arena);
        if (status == MT_OK) status = pair_parts(sides, hints, settings, arena);
        if (status == MT_OK) status = undo_cut(sides, settings, arena, &changed);
    }
    if (status != MT_OK) return status;
    *cut_a = sides[0].made;
    *cut_b = sides[1].made;
    assert(mt_cut_side_is_valid(cut_a, cut_b) && mt_cut_side_is_valid(cut_b, cut_a));
    return MT_OK;
}

bool mt_cut_side_is_valid(const mt_cut_side *cut, const mt_cut_side *other) {
    bool valid = mt_shape_is_valid(&cut->parts);
    for (int i = 0; valid && i < cut->parts.count; i++) {
        int partner = cut->partner[i];
        valid = partner < 0 || (partner < other->parts.count && other->partner[partner] == i);
    }
    return valid;
}
