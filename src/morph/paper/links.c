/* Section 2.2.2: the list R of links between convex pieces, by formula (3) and the algorithm's three steps.
 *
 *     A  1 2 3      step 2: each piece of A, its nearest of B, by coordinate vectors relative to the boxes   1–p 2–p 3–q
 *        │╱  │      step 3: each piece of B without a link, its nearest of A                                  (r) 3–r
 *     B  p   q r    step 1: only among pieces of matched components
 *
 * Invariant: every piece of a matched component has a link; links are ordered and no two alike; mt_link_evenly gives the swapped links
 * for swapped sides. O(m · n) for m and n pieces. */
#include "morph/paper/links.h"

#include <math.h>
#include <stdlib.h>

typedef struct mt_relative_place {
    double x, y; /* the paper's coordinate vector of a piece */
} mt_relative_place;

/* The pieces of one side to be linked with those of the other. */
typedef struct mt_mapping {
    const mt_side *from, *to;
    const mt_relative_place *from_places, *to_places;
    const mt_links *matches;
    bool forth; /* from A to B; otherwise from B to A */
} mt_mapping;

static mt_relative_place *places_of(const mt_side *side, bool one_scale, mt_arena *arena) {
    mt_relative_place *places = mt_arena_new(arena, (size_t)side->pieces.count, sizeof *places);
    if (!places) return NULL;
    double width = mt_box_width(side->box), height = mt_box_height(side->box);
    if (one_scale) width = height = fmax(width, height);
    for (int i = 0; i < side->pieces.count; i++) {
        double x, y;
        mt_ring_centre(&side->pieces.rings[i], &x, &y);
        places[i] = (mt_relative_place){(x - side->box.min.x) / width, (y - side->box.min.y) / height};
    }
    return places;
}

/* Formula (3): of all pieces of the components that component k is matched with, the nearest to `piece`. The
 * first of equals. */
static int nearest(const mt_mapping *m, int k, int piece) {
    mt_relative_place p = m->from_places[piece];
    double least = INFINITY;
    int found = -1;
    for (int i = 0; i < m->matches->count; i++) {
        mt_link match = m->matches->links[i];
        if ((m->forth ? match.a : match.b) != k) continue;
        int other = m->forth ? match.b : match.a;
        for (int j = m->to->first[other]; j < m->to->first[other + 1]; j++) {
            double dx = p.x - m->to_places[j].x, dy = p.y - m->to_places[j].y, distance = dx * dx + dy * dy;
            if (distance >= least) continue;
            least = distance;
            found = j;
        }
    }
    return found;
}

mt_status mt_link_pieces(const mt_side *a, const mt_side *b, const mt_links *matches, bool one_scale,
                         mt_arena *arena, mt_links *links) {
    const mt_relative_place *in_a = places_of(a, one_scale, arena), *in_b = places_of(b, one_scale, arena);
    bool *marked = mt_arena_new(arena, (size_t)b->pieces.count, sizeof *marked);
    mt_links made = {0,
                     mt_arena_new(arena, (size_t)a->pieces.count + (size_t)b->pieces.count, sizeof(mt_link))};
    if (!in_a || !in_b || !marked || !made.links) return MT_NO_MEMORY;

    /* Step 1, only pieces of matched components may be linked, is in nearest(). Step 2: each piece of A, its
     * nearest of B. */
    mt_mapping forth = {a, b, in_a, in_b, matches, true}, back = {b, a, in_b, in_a, matches, false};
    for (int k = 0; k < a->shape.count; k++)
        for (int i = a->first[k]; i < a->first[k + 1]; i++) {
            int h = nearest(&forth, k, i);
            if (h < 0) break; /* a component that is not matched here */
            made.links[made.count++] = (mt_link){i, h};
            marked[h] = true;
        }
    /* Step 3: each piece of B that is not marked yet, its nearest of A. */
    for (int l = 0; l < b->shape.count; l++)
        for (int j = b->first[l]; j < b->first[l + 1]; j++)
            if (!marked[j] && nearest(&back, l, j) >= 0)
                made.links[made.count++] = (mt_link){nearest(&back, l, j), j};
    qsort(made.links, (size_t)made.count, sizeof(mt_link), mt_link_compare);
    *links = made;
    return MT_OK;
}

/* ---- order of the sides -------------------------------------------------------------------------------- */

/* Orders two sides by their pieces alone: < 0, 0, > 0. */
static int compare_sides(const mt_side *p, const mt_side *q) {
    if (p->pieces.count != q->pieces.count) return p->pieces.count < q->pieces.count ? -1 : 1;
    for (int i = 0; i < p->pieces.count; i++) {
        int64_t in_p = mt_ring_area2(&p->pieces.rings[i]), in_q = mt_ring_area2(&q->pieces.rings[i]);
        if (in_p != in_q) return in_p < in_q ? -1 : 1;
    }
    return 0;
}

static mt_status swapped(const mt_links *links, mt_arena *arena, mt_links *made) {
    *made = (mt_links){links->count, mt_arena_new(arena, (size_t)links->count, sizeof(mt_link))};
    if (!made->links) return MT_NO_MEMORY;
    for (int i = 0; i < links->count; i++) made->links[i] = (mt_link){links->links[i].b, links->links[i].a};
    qsort(made->links, (size_t)made->count, sizeof(mt_link), mt_link_compare);
    return MT_OK;
}

mt_status mt_link_evenly(const mt_side *a, const mt_side *b, const mt_links *matches, bool one_scale,
                         mt_arena *arena, mt_links *links) {
    if (compare_sides(a, b) <= 0) return mt_link_pieces(a, b, matches, one_scale, arena, links);
    mt_links matches_back, links_back;
    mt_status status = swapped(matches, arena, &matches_back);
    if (status == MT_OK) status = mt_link_pieces(b, a, &matches_back, one_scale, arena, &links_back);
    return status == MT_OK ? swapped(&links_back, arena, links) : status;
}
