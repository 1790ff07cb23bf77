/* The graph of a shape's boundary: vertices are samples, edges lead along rings, over chords and over jumps.
 *
 *     ┌──●──●──●──┐        ┌──●──┐     ●  sample: a vertex, or a place on a long edge (settings' step)
 *     ●  :  ink   ●- - - - ●     ●     :  chord: a diagonal of the constrained Delaunay triangulation of the ink, not an ear's
 *     └──●──●──●──┘  jump  └──●──┘     -  jump: between samples of two components, each the other's nearest, within JUMP_REACH
 *
 * A chord is kept where it is at most `reach` long and no ear: the boundary between its ends has to be longer than EAR_SHARE times the
 * chord and EAR. Invariants: samples of a ring, rings of a component, and components are numbered consecutively; the chords of a sample
 * are first_chord[i] … first_chord[i + 1] - 1; each chord has its reverse, which the same diagonal or jump gives.
 * O(n log n) for n samples in practice, as the triangulation is; with jumps O(n²) at the worst between components near to one another,
 * in steps of the arena. */
#include "morph/divide/boundary_graph.h"

#include <assert.h>
#include <math.h>

#include "geometry/limits.h"

/* What a sample costs, in steps of the arena, mostly to be triangulated. */
#define SAMPLE_STEPS 256

/* ---- samples ----------------------------------------------------------------------------------------------------- */

static int parts_of(mt_point a, mt_point b, double step) {
    return 1 + (int)(sqrt((double)mt_distance2(a, b)) / step);
}

/* The place at k / parts of the way from a to b: the same from either end, so that both sides of a slit keep the same points. */
static mt_point place_between(mt_point a, mt_point b, int k, int parts) {
    if (b.x < a.x || (b.x == a.x && b.y < a.y)) return place_between(b, a, parts - k, parts);
    double s = (double)k / parts;
    return (mt_point){a.x + (int32_t)lround(s * ((double)b.x - a.x)),
                      a.y + (int32_t)lround(s * ((double)b.y - a.y))};
}

/* The ring with its long edges divided; drawn[i]: the ring had vertex i before. */
static mt_status refine(const mt_ring *ring, double step, mt_arena *arena, mt_ring *fine, bool *drawn) {
    int64_t total = 0;
    for (int i = 0; i < ring->count; i++)
        total += parts_of(ring->points[i], ring->points[(i + 1) % ring->count], step);
    if (total > MT_POINTS_MAX) return MT_TOO_LARGE;
    mt_status status = mt_ring_new(arena, (int)total, fine);
    if (status != MT_OK) return status;
    int made = 0;
    for (int i = 0; i < ring->count; i++) {
        mt_point a = ring->points[i], b = ring->points[(i + 1) % ring->count];
        int parts = parts_of(a, b, step);
        for (int k = 0; k < parts; k++, made++) {
            fine->points[made] = place_between(a, b, k, parts);
            fine->marks[made] = k ? ring->marks[i] & MT_EDGE_MARKS : ring->marks[i];
            drawn[made] = k == 0;
        }
    }
    return MT_OK;
}

static int64_t samples_in(const mt_component *component, double step) {
    int64_t total = 0;
    for (int r = 0; r < component->count; r++) {
        const mt_ring *ring = &component->rings[r];
        for (int i = 0; i < ring->count; i++)
            total += parts_of(ring->points[i], ring->points[(i + 1) % ring->count], step);
    }
    return total;
}

static mt_status view_ring(const mt_ring *ring, double flatness, int first, mt_arena *arena,
                           mt_boundary *boundary) {
    mt_trace trace;
    mt_status status = mt_trace_ring(ring, flatness, arena, &trace);
    if (status != MT_OK) return status;
    for (int i = 0; i < ring->count; i++) {
        mt_ring_sample sample = {.x = ring->points[i].x,
                                 .y = ring->points[i].y,
                                 .in = mt_trace_in(&trace, i),
                                 .out = mt_trace_out(&trace, i)};
        boundary->views[first + i] = mt_sample_view_of(&sample, &boundary->frame);
        boundary->places[first + i] = ring->points[i];
        boundary->length[first + i] = trace.length[i] / MT_EM;
        boundary->along[first + i] = i ? boundary->along[first + i - 1] + boundary->length[first + i - 1] : 0;
    }
    return MT_OK;
}

static mt_status add_component(const mt_component *component, int c, double flatness, double step,
                               mt_arena *arena, mt_boundary *boundary) {
    mt_component fine = {component->count, mt_arena_new(arena, (size_t)component->count, sizeof(mt_ring))};
    int first = boundary->first_sample[c];
    boundary->drawn[c] = mt_arena_new(arena, (size_t)(boundary->first_sample[c + 1] - first), sizeof(bool));
    if (!fine.rings || !boundary->drawn[c]) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int r = 0, at = first; status == MT_OK && r < component->count; r++) {
        status = refine(&component->rings[r], step, arena, &fine.rings[r], boundary->drawn[c] + (at - first));
        if (status == MT_OK) status = view_ring(&fine.rings[r], flatness, at, arena, boundary);
        at += fine.rings[r].count;
        boundary->first_of_ring[++boundary->ring_count] = at;
    }
    return status == MT_OK ? mt_triangulate(&fine, arena, &boundary->meshes[c]) : status;
}

/* ---- chords ----------------------------------------------------------------------------------------------------- */

#define EAR 0.02 /* em, and … */
#define EAR_SHARE                                                                                            \
    2.0 /* … times the diagonal's length: a diagonal with a shorter boundary between its ends is an ear's */
#define CHORD_COST 1.0   /* of each chord: as much as a place with opposite headings … */
#define CHORD_EM_COST 10 /* … and of each em of its length */

static int edge_end(const mt_half_edges *mesh, int e) {
    return mesh->start[mt_mesh_after(e)];
}

static double diagonal_length(const mt_half_edges *mesh, int e) {
    return sqrt((double)mt_distance2(mesh->points[mesh->start[e]], mesh->points[edge_end(mesh, e)]));
}

/* The length of boundary between two samples of a ring, the shorter way round; INFINITY between rings. */
static double way_round(const mt_boundary *b, int from, int to) {
    int ring = mt_boundary_ring(b, from);
    if (to < b->first_of_ring[ring] || to >= b->first_of_ring[ring + 1]) return INFINITY;
    int last = b->first_of_ring[ring + 1] - 1;
    double whole = b->along[last] + b->length[last], way = fabs(b->along[from] - b->along[to]);
    return fmin(way, whole - way);
}

/* Whether a diagonal only cuts off a corner: the boundary between its ends is hardly longer. */
static bool is_ear(const mt_boundary *b, int from, int to, double length) {
    return way_round(b, from, to) < EAR_SHARE * length / MT_EM + EAR;
}

/* Counts the chords of component c, or writes them when there is room for them. */
static void list_chords(mt_boundary *boundary, int c, double reach, int *next) {
    const mt_half_edges *mesh = &boundary->meshes[c];
    for (int e = 0; e < 3 * mesh->triangle_count; e++) {
        double length = diagonal_length(mesh, e);
        if (mesh->twin[e] < 0 || length > reach) continue;
        int from = boundary->first_sample[c] + mesh->start[e],
            to = boundary->first_sample[c] + edge_end(mesh, e);
        if (is_ear(boundary, from, to, length)) continue;
        if (boundary->chords)
            boundary->chords[next[from]] = (mt_chord){to, e, CHORD_COST + CHORD_EM_COST * length / MT_EM};
        next[from]++;
    }
}

/* ---- jumps ------------------------------------------------------------------------------------------------------- */

#define JUMP_REACH 0.15 /* em: parts further apart are not taken for one */
#define JUMP_COST 1.0   /* of each jump … */
#define JUMP_EM_COST 10 /* … and of each em of its length: as a chord's */

/* The distance of a place from a component's box, em. */
static double outside(const mt_boundary *b, int c, mt_point place) {
    mt_box box = b->boxes[c];
    double x = fmax(0, fmax((double)box.min.x - place.x, (double)place.x - box.max.x));
    double y = fmax(0, fmax((double)box.min.y - place.y, (double)place.y - box.max.y));
    return sqrt(x * x + y * y) / MT_EM;
}

/* The distance of a place from a block of samples, grid units squared. */
static int64_t from_block(const mt_box *block, mt_point place) {
    int64_t x = place.x < block->min.x ? (int64_t)block->min.x - place.x : (int64_t)place.x - block->max.x;
    int64_t y = place.y < block->min.y ? (int64_t)block->min.y - place.y : (int64_t)place.y - block->max.y;
    return (x > 0 ? x * x : 0) + (y > 0 ? y * y : 0);
}

/* The sample of component c nearest to a sample of another component; -1 where it is further than JUMP_REACH. Adds to *compared. */
static int nearest_of(const mt_boundary *b, int c, int sample, int64_t *compared) {
    mt_point place = b->places[sample];
    if (outside(b, c, place) > JUMP_REACH) return -1;
    int best = b->first_sample[c], end = b->first_sample[c + 1];
    int64_t least = mt_distance2(b->places[best], place);
    for (int i = best, next; i < end; i = next) {
        int block = i / MT_BLOCK_SAMPLES;
        next = (block + 1) * MT_BLOCK_SAMPLES;
        ++*compared;
        if (from_block(&b->blocks[block], place) >= least) continue;
        *compared += MT_BLOCK_SAMPLES;
        for (int k = i; k < next && k < end; k++) {
            int64_t apart = mt_distance2(b->places[k], place);
            if (apart >= least) continue;
            least = apart;
            best = k;
        }
    }
    return mt_boundary_distance(b, sample, best) <= JUMP_REACH ? best : -1;
}

/* Whether two components are too far apart for a jump. */
static bool are_far(const mt_boundary *b, int c, int d) {
    mt_box p = b->boxes[c], q = b->boxes[d];
    int64_t reach = (int64_t)(JUMP_REACH * MT_EM) + 1;
    return p.min.x - q.max.x > reach || q.min.x - p.max.x > reach || p.min.y - q.max.y > reach ||
           q.min.y - p.max.y > reach;
}

/* Counts the jumps between two components, or writes them when there is room. Gives how often places were compared. */
static int64_t list_jumps(mt_boundary *b, int c, int d, int *next) {
    int64_t compared = 1;
    for (int i = b->first_sample[c]; i < b->first_sample[c + 1] && !are_far(b, c, d); i++) {
        int k = nearest_of(b, d, i, &compared);
        if (k < 0 || nearest_of(b, c, k, &compared) != i) continue;
        double cost = JUMP_COST + JUMP_EM_COST * mt_boundary_distance(b, i, k);
        if (b->chords) b->chords[next[i]] = (mt_chord){k, -1, cost};
        if (b->chords) b->chords[next[k]] = (mt_chord){i, -1, cost};
        next[i]++;
        next[k]++;
    }
    return compared;
}

static mt_status list_all(mt_boundary *boundary, double reach, bool jumps, mt_arena *arena, int *next) {
    for (int c = 0; c < boundary->component_count; c++) {
        list_chords(boundary, c, reach, next);
        for (int d = 0; jumps && d < c; d++)
            if (!mt_arena_spend(arena, list_jumps(boundary, c, d, next))) return MT_TOO_LARGE;
    }
    return MT_OK;
}

static mt_status make_blocks(mt_boundary *boundary, mt_arena *arena) {
    int count = (boundary->count + MT_BLOCK_SAMPLES - 1) / MT_BLOCK_SAMPLES;
    boundary->blocks = mt_arena_new(arena, (size_t)count + 1, sizeof *boundary->blocks);
    if (!boundary->blocks) return MT_NO_MEMORY;
    for (int i = 0; i < boundary->count; i++) {
        mt_box own = {boundary->places[i], boundary->places[i]},
               *block = &boundary->blocks[i / MT_BLOCK_SAMPLES];
        *block = i % MT_BLOCK_SAMPLES ? mt_box_around(*block, own) : own;
    }
    return MT_OK;
}

static mt_status add_chords(mt_boundary *boundary, double reach, bool jumps, mt_arena *arena) {
    int *next = mt_arena_new(arena, (size_t)boundary->count + 1, sizeof *next);
    boundary->first_chord = mt_arena_new(arena, (size_t)boundary->count + 1, sizeof(int));
    if (!next || !boundary->first_chord) return MT_NO_MEMORY;
    mt_status status = make_blocks(boundary, arena);
    if (status == MT_OK) status = list_all(boundary, reach, jumps, arena, next);
    if (status != MT_OK) return status;
    for (int i = 0; i < boundary->count; i++) {
        boundary->first_chord[i + 1] = boundary->first_chord[i] + next[i];
        next[i] = boundary->first_chord[i];
    }
    boundary->chords =
        mt_arena_new(arena, (size_t)boundary->first_chord[boundary->count] + 1, sizeof(mt_chord));
    if (!boundary->chords) return MT_NO_MEMORY;
    return list_all(boundary, reach, jumps, arena, next);
}

/* ---- all of it --------------------------------------------------------------------------------------------------- */

/* The run that holds `item`, of `count` runs of which run i begins at first[i]. */
static int run_of(const int *first, int count, int item) {
    int low = 0, high = count;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (first[middle] <= item)
            low = middle;
        else
            high = middle;
    }
    return low;
}

int mt_boundary_ring(const mt_boundary *boundary, int sample) {
    return run_of(boundary->first_of_ring, boundary->ring_count, sample);
}

int mt_chord_source(const mt_boundary *boundary, int chord) {
    /* samples without chords begin where the next one begins: the search finds the last of these, which has the chord */
    return run_of(boundary->first_chord, boundary->count, chord);
}

int mt_chord_back(const mt_boundary *boundary, int chord) {
    int from = mt_chord_source(boundary, chord), to = boundary->chords[chord].to,
        back = boundary->first_chord[to];
    while (boundary->chords[back].to != from) back++;
    return back;
}

double mt_boundary_distance(const mt_boundary *boundary, int i, int j) {
    return sqrt((double)mt_distance2(boundary->places[i], boundary->places[j])) / MT_EM;
}

double mt_chord_length(const mt_boundary *boundary, int chord) {
    return mt_boundary_distance(boundary, mt_chord_source(boundary, chord), boundary->chords[chord].to);
}

static mt_status start_boundary(const mt_shape *shape, double step, mt_arena *arena, mt_boundary *made) {
    size_t parts = (size_t)shape->count, rings = 0;
    int64_t samples = 0;
    made->component_count = shape->count;
    made->meshes = mt_arena_new(arena, parts, sizeof *made->meshes);
    made->drawn = mt_arena_new(arena, parts, sizeof *made->drawn);
    made->boxes = mt_arena_new(arena, parts, sizeof *made->boxes);
    made->first_sample = mt_arena_new(arena, parts + 1, sizeof *made->first_sample);
    if (!made->meshes || !made->drawn || !made->boxes || !made->first_sample) return MT_NO_MEMORY;
    for (int c = 0; c < shape->count; c++) {
        made->boxes[c] = mt_ring_box(&shape->components[c].rings[0]);
        rings += (size_t)shape->components[c].count;
        samples += samples_in(&shape->components[c], step);
        if (samples > MT_POINTS_MAX) return MT_TOO_LARGE;
        made->first_sample[c + 1] = (int)samples;
    }
    if (!mt_arena_spend(arena, SAMPLE_STEPS * samples)) return MT_TOO_LARGE;
    made->count = (int)samples;
    made->first_of_ring = mt_arena_new(arena, rings + 1, sizeof *made->first_of_ring);
    made->views = mt_arena_new(arena, (size_t)samples, sizeof *made->views);
    made->places = mt_arena_new(arena, (size_t)samples, sizeof *made->places);
    made->length = mt_arena_new(arena, (size_t)samples, sizeof *made->length);
    made->along = mt_arena_new(arena, (size_t)samples, sizeof *made->along);
    return made->first_of_ring && made->views && made->places && made->length && made->along ? MT_OK
                                                                                             : MT_NO_MEMORY;
}

mt_status mt_boundary_of(const mt_shape *shape, const mt_frame *frame, const mt_settings *settings,
                         double reach, mt_arena *arena, mt_boundary *boundary) {
    mt_boundary made = {.frame = *frame};
    double step = mt_grid_units(settings->step);
    mt_status status = start_boundary(shape, step, arena, &made);
    for (int c = 0; status == MT_OK && c < shape->count; c++)
        status = add_component(&shape->components[c], c, settings->flatness, step, arena, &made);
    if (status == MT_OK) status = add_chords(&made, reach, settings->jumps, arena);
    assert(status != MT_OK || mt_boundary_is_valid(&made));
    if (status == MT_OK) *boundary = made;
    return status;
}

/* ---- invariants -------------------------------------------------------------------------------------------------- */

static bool is_numbering(const int *first, int count, int total) {
    bool valid = first[0] == 0 && first[count] == total;
    for (int i = 0; valid && i < count; i++) valid = first[i] <= first[i + 1];
    return valid;
}

bool mt_boundary_is_valid(const mt_boundary *b) {
    bool valid = is_numbering(b->first_sample, b->component_count, b->count) &&
                 is_numbering(b->first_of_ring, b->ring_count, b->count) &&
                 is_numbering(b->first_chord, b->count, b->first_chord[b->count]);
    for (int i = 0; valid && i < b->count; i++)
        for (int k = b->first_chord[i]; valid && k < b->first_chord[i + 1]; k++)
            valid = b->chords[k].to >= 0 && b->chords[k].to < b->count && b->chords[k].to != i &&
                    b->chords[k].cost > 0;
    return valid;
}
