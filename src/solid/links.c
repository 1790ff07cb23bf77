/* The links of the paper's algorithm need not hang together: neighbours of one solid may be linked with pieces of the other that do not
 * meet, and the morph would fall apart there. If pieces i and k of the first solid meet, and j and l of the second, then so do the
 * sums of (i, j) and (k, l): both hold r (i ∩ k) ⊕ (1 - r) (j ∩ l). So the union hangs together for every r when the graph of links does,
 * with an edge between links whose pieces meet on both sides. Where it falls apart for two matched components, links are
 * added: those on a way through pairs of pieces from one group of links to another, the fewest, and of those the nearest by formula (3). */
#include "solid/links.h"

#include <stdlib.h>

#include "morph/paper/relax.h"
#include "solid/queue.h"
#include "space/vector.h"

typedef struct mt_linking {
    mt_arena *arena;
    const mt_half *first, *second;
    mt_links matches;
    bool *linked; /* first's pieces × second's */
} mt_linking;

static size_t pair_of(const mt_linking *l, int i, int j) {
    return (size_t)i * (size_t)l->second->n_pieces + (size_t)j;
}

/* ---- components ---------------------------------------------------------------------------------------- */

static mt_status match(mt_linking *l) {
    int rows = l->first->n_components, columns = l->second->n_components;
    mt_params params = mt_params_default();
    double *s = mt_arena_new(l->arena, (size_t)rows * (size_t)columns, sizeof *s);
    if (!s) return MT_NO_MEMORY;
    for (int i = 0; i < rows; i++)
        for (int j = 0; j < columns; j++)
            s[(size_t)i * (size_t)columns + (size_t)j] =
                mt_bulk_similarity(&l->first->components[i], &l->second->components[j], params.weights);
    return mt_match_components(s, rows, columns, params.rounds, params.threshold, l->arena, &l->matches);
}

static bool is_matched(const mt_linking *l, int component_a, int component_b) {
    for (int i = 0; i < l->matches.count; i++)
        if (l->matches.links[i].a == component_a && l->matches.links[i].b == component_b) return true;
    return false;
}

/* ---- formula (3) --------------------------------------------------------------------------------------- */

static double distance(const mt_linking *l, int i, int j) {
    return mt_length3(mt_minus3(l->first->places[i], l->second->places[j]));
}

static bool may_link(const mt_linking *l, int i, int j) {
    return is_matched(l, l->first->component_of[i], l->second->component_of[j]);
}

/* Step 2: each piece of the first, its nearest of the second. Step 3: each of the second that has none, its nearest of the first. */
static void link_nearest(mt_linking *l) {
    for (int i = 0; i < l->first->n_pieces; i++) {
        int found = -1;
        for (int j = 0; j < l->second->n_pieces; j++)
            if (may_link(l, i, j) && (found < 0 || distance(l, i, j) < distance(l, i, found))) found = j;
        if (found >= 0) l->linked[pair_of(l, i, found)] = true;
    }
    for (int j = 0; j < l->second->n_pieces; j++) {
        int found = -1;
        bool marked = false;
        for (int i = 0; i < l->first->n_pieces; i++) {
            marked |= l->linked[pair_of(l, i, j)];
            if (may_link(l, i, j) && (found < 0 || distance(l, i, j) < distance(l, found, j))) found = i;
        }
        if (!marked && found >= 0) l->linked[pair_of(l, found, j)] = true;
    }
}

/* ---- what hangs together ------------------------------------------------------------------------------- */

/* A search over the pairs of pieces of two matched components. */
typedef struct mt_joining {
    mt_linking *l;
    int component_a, component_b;
    double *cost;
    int *from; /* the pair that led to each; -1 where it began */
    bool *done;
    mt_queue queue;
} mt_joining;

static bool concerns(const mt_joining *s, int i, int j) {
    return s->l->first->component_of[i] == s->component_a && s->l->second->component_of[j] == s->component_b;
}

/* Offers a way to all pairs that meet pair (i, j). A pair that is linked already costs nothing. */
static mt_status spread(mt_joining *s, int i, int j) {
    const mt_half *first = s->l->first, *second = s->l->second;
    size_t here = pair_of(s->l, i, j);
    for (int k = 0; k < first->n_pieces; k++) {
        if (!first->meets[(size_t)i * (size_t)first->n_pieces + (size_t)k]) continue;
        for (int m = 0; m < second->n_pieces; m++) {
            size_t there = pair_of(s->l, k, m);
            if (!second->meets[(size_t)j * (size_t)second->n_pieces + (size_t)m] || s->done[there]) continue;
            double cost = s->cost[here] + (s->l->linked[there] ? 0 : 1 + distance(s->l, k, m));
            if (cost >= s->cost[there]) continue;
            s->cost[there] = cost;
            s->from[there] = (int)here;
            mt_status status = mt_queue_push(&s->queue, s->l->arena, cost, (int)there);
            if (status != MT_OK) return status;
        }
    }
    return MT_OK;
}

/* Begins with the first link of the two components; false when they have none. */
static bool begin(mt_joining *s) {
    int columns = s->l->second->n_pieces, n = s->l->first->n_pieces * columns, start = -1;
    for (int p = 0; p < n; p++) {
        s->cost[p] = INFINITY;
        s->done[p] = false;
        if (start < 0 && s->l->linked[p] && concerns(s, p / columns, p % columns)) start = p;
    }
    s->queue.count = 0;
    if (start < 0) return false;
    s->cost[start] = 0;
    s->from[start] = -1;
    return true;
}

/* Joins one more group of links with that of the first link; *any is false when there is none. */
static mt_status join_one(mt_joining *s, bool *any) {
    int columns = s->l->second->n_pieces, start = 0;
    *any = false;
    if (!begin(s)) return MT_OK;
    while (s->cost[start] > 0) start++;
    mt_status status = mt_queue_push(&s->queue, s->l->arena, 0, start);
    while (status == MT_OK && s->queue.count > 0) {
        int here = mt_queue_pop(&s->queue).number;
        if (s->done[here]) continue;
        s->done[here] = true;
        if (s->l->linked[here] && s->cost[here] > 0) { /* another group: the way to it becomes links */
            for (int p = here; p >= 0; p = s->from[p]) s->l->linked[p] = true;
            *any = true;
            return MT_OK;
        }
        status = spread(s, here / columns, here % columns);
    }
    return status;
}

static mt_status join_groups(mt_linking *l) {
    size_t n = (size_t)l->first->n_pieces * (size_t)l->second->n_pieces;
    mt_joining s = {.l = l,
                    .cost = mt_arena_new(l->arena, n, sizeof(double)),
                    .from = mt_arena_new(l->arena, n, sizeof(int)),
                    .done = mt_arena_new(l->arena, n, sizeof(bool))};
    if (!s.cost || !s.from || !s.done) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; status == MT_OK && i < l->matches.count; i++) {
        s.component_a = l->matches.links[i].a;
        s.component_b = l->matches.links[i].b;
        for (bool any = true; status == MT_OK && any;) status = join_one(&s, &any);
    }
    return status;
}

/* ---- all of it ----------------------------------------------------------------------------------------- */

static mt_status begin_linking(mt_arena *arena, const mt_half *first, const mt_half *second, mt_linking *l) {
    size_t n = (size_t)first->n_pieces * (size_t)second->n_pieces;
    *l = (mt_linking){
        .arena = arena, .first = first, .second = second, .linked = mt_arena_new(arena, n, sizeof(bool))};
    return l->linked ? match(l) : MT_NO_MEMORY;
}

/* Joins groups, and lists all links. */
static mt_status end_linking(mt_linking *l, mt_links *links) {
    size_t n = (size_t)l->first->n_pieces * (size_t)l->second->n_pieces;
    mt_status status = join_groups(l);
    mt_links made = {0, NULL};
    for (size_t p = 0; p < n; p++) made.count += l->linked[p];
    made.links = mt_arena_new(l->arena, (size_t)made.count, sizeof *made.links);
    if (status != MT_OK || !made.links) return status != MT_OK ? status : MT_NO_MEMORY;
    made.count = 0;
    for (int i = 0; i < l->first->n_pieces; i++)
        for (int j = 0; j < l->second->n_pieces; j++)
            if (l->linked[pair_of(l, i, j)]) made.links[made.count++] = (mt_link){i, j};
    *links = made;
    return MT_OK;
}

mt_status mt_link_halves(mt_arena *arena, const mt_half *first, const mt_half *second, mt_links *links) {
    mt_linking l;
    mt_status status = begin_linking(arena, first, second, &l);
    if (status != MT_OK) return status;
    link_nearest(&l);
    return end_linking(&l, links);
}

mt_status mt_links_join(mt_arena *arena, const mt_half *first, const mt_half *second, mt_links *links) {
    mt_linking l;
    mt_status status = begin_linking(arena, first, second, &l);
    if (status != MT_OK) return status;
    for (int i = 0; i < links->count; i++) l.linked[pair_of(&l, links->links[i].a, links->links[i].b)] = true;
    return end_linking(&l, links);
}
