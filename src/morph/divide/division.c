#include "morph/divide/division.h"

#include <math.h>

#include "geometry/inside.h"
#include "geometry/limits.h"
#include "morph/align/pairing.h"
#include "morph/divide/cut.h"
#include "morph/divide/ring_matching.h"

#define REACH 300.0 /* of a chord, 1/1000 em */

/* What aligning two parts may cost (pairing.h) for them to go together. */
#define PARTNER_MOST 2.0

/* What aligning two holes may cost for them to be the same hole. */
#define COMMON_MOST 0.6

/* One side on its way. */
typedef struct mt_division {
    mt_boundary boundary;
    bool *used; /* each chord, by the other side's matchers */
    mt_match_step *
        start; /* of each ring, where its walks on the other side's boundary start; here < 0: not known yet */
    bool **cut;    /* of each component's mesh, the half-edges along which it is cut */
    int **part_of; /* of each component's mesh, the part of each triangle */
    mt_cut_side made;
} mt_division;

/* ---- walks --------------------------------------------------------------------------------------------------------- */

/* Walks around all rings of one side on the other's boundary, and notes which chords are used, and where the walks start. */
static mt_status walk_on(mt_division *from, mt_division *to, const mt_cost_weights *weights,
                         mt_arena *arena) {
    for (int i = 0; i < to->boundary.first_chord[to->boundary.count]; i++) to->used[i] = false;
    for (int r = 0; r < from->boundary.ring_count; r++) {
        mt_arena_place before = mt_arena_mark(arena);
        mt_ring_match walk;
        mt_status status = mt_match_ring(&from->boundary, r, &to->boundary, weights,
                                         from->start[r].here < 0 ? NULL : &from->start[r], arena, &walk);
        if (status != MT_OK) return status;
        from->start[r] = walk.steps[0];
        for (int k = 0; k < walk.count; k++)
            if (walk.steps[k].chord >= 0) to->used[walk.steps[k].chord] = true;
        mt_arena_rewind(arena, before);
    }
    return MT_OK;
}

static mt_status walk_both_ways(mt_division *banks, const mt_cost_weights *weights, mt_arena *arena) {
    mt_status status = walk_on(&banks[0], &banks[1], weights, arena);
    return status == MT_OK ? walk_on(&banks[1], &banks[0], weights, arena) : status;
}

/* ---- holes that both sides have ------------------------------------------------------------------------------ */

/* The holes of a shape, which ring of its boundary each is, and which of those are outer ones. */
static mt_status holes_of(const mt_side *side, mt_arena *arena, mt_ring_list *holes, int *ring_of,
                          bool *outer) {
    int ring = 0;
    *holes = (mt_ring_list){0, NULL, side->box};
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

/* Bars the chords from common holes to the outside, and to one another: there is no need to open them. `common` tells of
 * each ring whether it is such a hole, and `outer` whether it is a component's outer ring. */
static void bar_common(mt_boundary *b, const bool *common, const bool *outer) {
    for (int sample = 0; sample < b->count; sample++)
        for (int i = b->first_chord[sample]; i < b->first_chord[sample + 1]; i++) {
            int from = mt_boundary_ring(b, sample), to = mt_boundary_ring(b, b->chords[i].to);
            bool needless = (common[from] && (common[to] || outer[to])) || (common[to] && outer[from]);
            if (from != to && needless) b->chords[i].cost = INFINITY;
        }
}

static mt_status keep_common_holes(const mt_side *a, const mt_side *b, mt_division *banks,
                                   const mt_settings *settings, mt_arena *arena) {
    mt_ring_list holes[2];
    int *ring_of[2], *partner[2];
    bool *common[2], *outer[2];
    mt_status status = MT_OK;
    for (int s = 0; status == MT_OK && s < 2; s++) {
        size_t rings = (size_t)banks[s].boundary.ring_count;
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
        bar_common(&banks[s].boundary, common[s], outer[s]);
    }
    return status;
}

/* ---- which chords may become cuts ----------------------------------------------------------------------------------- */

#define NEAR 0.3 /* em: how far apart two chords may be that are crossed to and fro for the same reason … */
#define NEAR_SHARE 1.0   /* … and more where they are long, this part of their length */
#define KNOWN_SHARE 0.25 /* of a chord's cost, once it is known that both ways are wanted */

/* Whether two chords lead in opposite directions. */
static bool lead_apart(const mt_boundary *b, int one, int other) {
    const mt_sample_view *p = &b->views[mt_chord_source(b, one)], *q = &b->views[b->chords[one].to],
                         *u = &b->views[mt_chord_source(b, other)], *v = &b->views[b->chords[other].to];
    return (q->x - p->x) * (v->x - u->x) + (q->y - p->y) * (v->y - u->y) < 0;
}

/* The used chord that leads back nearest to another; -1 where none does near enough. */
static int way_back(const mt_division *bank, int chord) {
    const mt_boundary *b = &bank->boundary;
    int from = mt_chord_source(b, chord), to = b->chords[chord].to, best = -1;
    double least = NEAR + NEAR_SHARE * mt_chord_length(b, chord);
    for (int i = 0; i < b->first_chord[b->count]; i++) {
        if (!bank->used[i] || b->chords[i].edge < 0 || !lead_apart(b, chord, i)) continue;
        double apart = mt_boundary_distance(b, from, b->chords[i].to) +
                       mt_boundary_distance(b, to, mt_chord_source(b, i));
        if (apart >= least) continue;
        least = apart;
        best = i;
    }
    return best;
}

/* How many of a chord's ends are vertices of the drawing, as those of a cut at the root of a stroke are. */
static int drawn_ends(const mt_boundary *b, int chord) {
    int c = 0, from = mt_chord_source(b, chord), to = b->chords[chord].to;
    while (b->first_sample[c + 1] <= from) c++;
    return b->drawn[c][from - b->first_sample[c]] + b->drawn[c][to - b->first_sample[c]];
}

/* Of two chords, which is the better place to cut: at vertices of the drawing, then where it is short. */
static int neater(const mt_boundary *b, int one, int other) {
    int ends = drawn_ends(b, one) - drawn_ends(b, other);
    double longer = mt_chord_length(b, one) - mt_chord_length(b, other);
    if (ends != 0) return ends > 0 ? one : other;
    if (longer != 0) return longer < 0 ? one : other;
    return one < other ? one : other;
}

/* Bars all chords but those that are crossed one way and, there or nearby, the other way too: a walker that only takes a short
 * cut, past a serif, does not come back. Of the two the neater stays. */
static mt_status bar_chords(mt_division *bank, mt_arena *arena) {
    mt_boundary *b = &bank->boundary;
    int total = b->first_chord[b->count];
    bool *keep = mt_arena_new(arena, (size_t)total, sizeof *keep);
    if (!keep) return MT_NO_MEMORY;
    for (int i = 0; i < total; i++) {
        if (b->chords[i].edge < 0) continue;
        int back = bank->used[i] ? way_back(bank, i) : -1;
        if (back < 0) continue;
        int chosen = neater(b, i, back);
        keep[chosen] = keep[mt_chord_back(b, chosen)] = true;
    }
    for (int i = 0; i < total; i++)
        if (b->chords[i].edge >= 0) b->chords[i].cost = keep[i] ? b->chords[i].cost * KNOWN_SHARE : INFINITY;
    return MT_OK;
}

/* Where to cut for a chord that is used: there, when it is crossed both ways; at the neater of two that are crossed to and fro
 * side by side; -1 for nowhere. */
static int place_to_cut(const mt_division *bank, int chord) {
    const mt_boundary *b = &bank->boundary;
    if (bank->used[mt_chord_back(b, chord)]) return chord;
    int back = way_back(bank, chord);
    if (back < 0 || bank->used[mt_chord_back(b, back)] || way_back(bank, back) != chord) return -1;
    return neater(b, chord, back);
}

/* Cuts along the diagonals that are crossed both ways. */
static mt_status choose_cuts(mt_division *bank, mt_arena *arena) {
    const mt_boundary *b = &bank->boundary;
    bank->cut = mt_arena_new(arena, (size_t)b->component_count, sizeof *bank->cut);
    bank->part_of = mt_arena_new(arena, (size_t)b->component_count, sizeof *bank->part_of);
    if (!bank->cut || !bank->part_of) return MT_NO_MEMORY;
    for (int c = 0; c < b->component_count; c++) {
        size_t triangles = (size_t)b->meshes[c].triangle_count;
        bank->cut[c] = mt_arena_new(arena, 3 * triangles, sizeof(bool));
        bank->part_of[c] = mt_arena_new(arena, triangles, sizeof(int));
        if (!bank->cut[c] || !bank->part_of[c]) return MT_NO_MEMORY;
        int first = b->first_chord[b->first_sample[c]], last = b->first_chord[b->first_sample[c + 1]];
        for (int i = first; i < last; i++) {
            int place = bank->used[i] && b->chords[i].edge >= 0 ? place_to_cut(bank, i) : -1;
            if (place < first || place >= last) continue;
            bank->cut[c][b->chords[place].edge] = true;
            bank->cut[c][b->meshes[c].twin[b->chords[place].edge]] = true;
        }
    }
    return MT_OK;
}

/* ---- parts ------------------------------------------------------------------------------------------------------------ */

static mt_status cut_all(mt_division *bank, mt_arena *arena) {
    mt_shape made = {0, mt_arena_new(arena, (size_t)bank->boundary.count, sizeof(mt_component))};
    if (!made.components) return MT_NO_MEMORY;
    for (int c = 0; c < bank->boundary.component_count; c++) {
        const mt_mesh *mesh = &bank->boundary.meshes[c];
        mt_stencil ink = {mesh, bank->boundary.drawn[c], bank->cut[c]};
        mt_shape parts;
        mt_status status = mt_cut(&ink, arena, &parts, bank->part_of[c]);
        if (status != MT_OK) return status;
        for (int t = 0; t < mesh->triangle_count; t++) bank->part_of[c][t] += made.count;
        for (int i = 0; i < parts.count; i++) made.components[made.count++] = parts.components[i];
    }
    bank->made = (mt_cut_side){made, mt_arena_new(arena, (size_t)made.count, sizeof(int))};
    return bank->made.partner ? MT_OK : MT_NO_MEMORY;
}

static mt_status pair_parts(mt_division *banks, const mt_hints *hints, const mt_settings *settings,
                            mt_arena *arena) {
    mt_cut_side *a = &banks[0].made, *b = &banks[1].made;
    mt_ring_list in_a, in_b;
    mt_status status = mt_outer_rings(&banks[0].made.parts, banks[0].boundary.box, arena, &in_a);
    if (status == MT_OK) status = mt_outer_rings(&banks[1].made.parts, banks[1].boundary.box, arena, &in_b);
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
typedef struct mt_frontier {
    mt_division *bank, *other;
    int component, edge;
    int here, there; /* the parts; there is no partner of `here` */
    int64_t area;    /* of `here`, twice, grid units squared */
    double length;   /* grid units */
} mt_frontier;

static void set_cut(const mt_frontier *f, bool cut) {
    f->bank->cut[f->component][f->edge] =
        f->bank->cut[f->component][f->bank->boundary.meshes[f->component].twin[f->edge]] = cut;
}

/* Whether the two parts together go with the other's partner better than that part alone. */
static mt_status is_better_whole(const mt_frontier *f, const mt_settings *settings, mt_arena *arena,
                                 bool *better) {
    const mt_division *bank = f->bank;
    const mt_mesh *mesh = &bank->boundary.meshes[f->component];
    mt_stencil ink = {mesh, bank->boundary.drawn[f->component], bank->cut[f->component]};
    const mt_ring *goal = &f->other->made.parts.components[bank->made.partner[f->there]].rings[0];
    mt_shape parts;
    double apart = 0, together = 0;
    int *part_of = mt_arena_new(arena, (size_t)mesh->triangle_count, sizeof *part_of);
    if (!part_of) return MT_NO_MEMORY;
    set_cut(f, false);
    mt_status status = mt_cut(&ink, arena, &parts, part_of);
    set_cut(f, true);
    if (status != MT_OK) return status;
    const mt_ring *whole = &parts.components[part_of[f->edge / 3]].rings[0],
                  *alone = &bank->made.parts.components[f->there].rings[0];
    status = mt_pair_cost(alone, bank->boundary.box, goal, f->other->boundary.box, settings, arena, &apart);
    if (status == MT_OK)
        status =
            mt_pair_cost(whole, bank->boundary.box, goal, f->other->boundary.box, settings, arena, &together);
    *better = together < apart;
    return status;
}

/* Whether the cut is better taken back: the other part has no partner either, or is the larger one, or gains by it. */
static mt_status is_idle(const mt_frontier *f, const mt_settings *settings, mt_arena *arena, bool *idle) {
    const mt_shape *parts = &f->bank->made.parts;
    *idle = f->bank->made.partner[f->there] < 0 || f->area < mt_component_area2(&parts->components[f->there]);
    return *idle ? MT_OK : is_better_whole(f, settings, arena, idle);
}

static bool frontier_at(mt_division *banks, int side, int component, int edge, mt_frontier *f) {
    mt_division *bank = &banks[side];
    const mt_mesh *mesh = &bank->boundary.meshes[component];
    if (!bank->cut[component][edge]) return false;
    int here = bank->part_of[component][edge / 3], there = bank->part_of[component][mesh->twin[edge] / 3];
    if (here == there || bank->made.partner[here] >= 0) return false;
    int end = mesh->start[mt_mesh_after(edge)];
    *f = (mt_frontier){bank,
                       &banks[1 - side],
                       component,
                       edge,
                       here,
                       there,
                       mt_component_area2(&bank->made.parts.components[here]),
                       sqrt((double)mt_distance2(mesh->points[mesh->start[edge]], mesh->points[end]))};
    return true;
}

/* Takes back one idle cut: of the smallest part the longest. *taken: there was one. */
static mt_status take_back(mt_division *banks, const mt_settings *settings, mt_arena *arena, bool *taken) {
    mt_frontier best = {0}, f;
    for (int s = 0; s < 2; s++)
        for (int c = 0; c < banks[s].boundary.component_count; c++)
            for (int e = 0; e < 3 * banks[s].boundary.meshes[c].triangle_count; e++) {
                bool idle;
                if (!frontier_at(banks, s, c, e, &f)) continue;
                if (best.bank && (f.area > best.area || (f.area == best.area && f.length <= best.length)))
                    continue;
                mt_status status = is_idle(&f, settings, arena, &idle);
                if (status != MT_OK) return status;
                if (idle) best = f;
            }
    if (best.bank) set_cut(&best, false);
    *taken = best.bank;
    return MT_OK;
}

/* ---- all of it ----------------------------------------------------------------------------------------------------------- */

static mt_status start_bank(const mt_side *side, const mt_settings *settings, mt_arena *arena,
                            mt_division *bank) {
    mt_status status =
        mt_boundary_of(&side->shape, side->box, settings, mt_grid_units(REACH), arena, &bank->boundary);
    if (status != MT_OK) return status;
    size_t chords = (size_t)bank->boundary.first_chord[bank->boundary.count],
           rings = (size_t)bank->boundary.ring_count;
    bank->used = mt_arena_new(arena, chords, sizeof *bank->used);
    bank->start = mt_arena_new(arena, rings, sizeof *bank->start);
    if (!bank->used || !bank->start) return MT_NO_MEMORY;
    for (size_t r = 0; r < rings; r++) bank->start[r].here = -1;
    return MT_OK;
}

static mt_status find_cuts(mt_division *banks, const mt_cost_weights *weights, mt_arena *arena) {
    mt_status status = walk_both_ways(banks, weights, arena);
    for (int s = 0; status == MT_OK && s < 2; s++) status = bar_chords(&banks[s], arena);
    if (status == MT_OK) status = walk_both_ways(banks, weights, arena);
    for (int s = 0; status == MT_OK && s < 2; s++) status = choose_cuts(&banks[s], arena);
    return status;
}

mt_status mt_divide(const mt_side *a, const mt_side *b, const mt_hints *hints, const mt_settings *settings,
                    mt_arena *arena, mt_cut_side *cut_a, mt_cut_side *cut_b) {
    mt_division banks[2] = {0};
    mt_status status = start_bank(a, settings, arena, &banks[0]);
    if (status == MT_OK) status = start_bank(b, settings, arena, &banks[1]);
    if (status == MT_OK) status = keep_common_holes(a, b, banks, settings, arena);
    if (status == MT_OK) status = find_cuts(banks, &settings->match, arena);
    bool changed = true;
    while (status == MT_OK && changed) {
        for (int s = 0; status == MT_OK && s < 2; s++) status = cut_all(&banks[s], arena);
        if (status == MT_OK) status = pair_parts(banks, hints, settings, arena);
        if (status == MT_OK) status = take_back(banks, settings, arena, &changed);
    }
    if (status != MT_OK) return status;
    *cut_a = banks[0].made;
    *cut_b = banks[1].made;
    return MT_OK;
}
