#include "morph/pairing.h"

#include <math.h>

#define STOPS 60.0      /* places along a ring that are compared, at least */
#define APART_MOST 0.35 /* how far the middles of two rings may be apart, in boxes */

/* How far the middles of two rings are apart, each relative to its glyph's box. */
static double apart(const mt_ring *p, mt_box box_p, const mt_ring *q, mt_box box_q) {
    mt_box a = mt_ring_box(p), b = mt_ring_box(q);
    double x = (a.min.x + (double)a.max.x - 2.0 * box_p.min.x) / mt_box_width(box_p) -
               (b.min.x + (double)b.max.x - 2.0 * box_q.min.x) / mt_box_width(box_q);
    double y = (a.min.y + (double)a.max.y - 2.0 * box_p.min.y) / mt_box_height(box_p) -
               (b.min.y + (double)b.max.y - 2.0 * box_q.min.y) / mt_box_height(box_q);
    return hypot(x, y) / 2;
}

mt_status mt_pair_price(const mt_ring *p, mt_box box_p, const mt_ring *q, mt_box box_q, double chord,
                        mt_arena *arena, double *price) {
    mt_arena_place before = mt_arena_mark(arena);
    mt_stops a, b;
    mt_alignment alignment;
    mt_status status = mt_ring_stops(p, chord, STOPS, arena, &a);
    if (status == MT_OK) status = mt_ring_stops(q, chord, STOPS, arena, &b);
    if (status == MT_OK) status = mt_align(&a, box_p, &b, box_q, &(mt_links){0}, arena, &alignment);
    if (status == MT_OK) *price = alignment.cost;
    mt_arena_rewind(arena, before);
    return status;
}

typedef struct mt_prices {
    int rows, columns;
    double *prices; /* rows × columns; INFINITY for what may not be paired */
} mt_prices;

static mt_status price_all(const mt_ring_list *a, const mt_ring_list *b, double most, double chord,
                           mt_arena *arena, mt_prices *p) {
    *p = (mt_prices){a->count, b->count, NULL};
    p->prices = mt_arena_new(arena, (size_t)a->count * (size_t)b->count, sizeof *p->prices);
    if (!p->prices) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i < p->rows; i++)
        for (int j = 0; status == MT_OK && j < p->columns; j++) {
            double *price = &p->prices[(size_t)i * (size_t)p->columns + (size_t)j];
            *price = INFINITY;
            if (apart(a->rings[i], a->box, b->rings[j], b->box) > APART_MOST) continue;
            status = mt_pair_price(a->rings[i], a->box, b->rings[j], b->box, chord, arena, price);
            if (*price > most) *price = INFINITY;
        }
    return status;
}

/* The cheapest pair of those that are left; false when none is. */
static bool cheapest(const mt_prices *p, const int *partner_a, const int *partner_b, int *row, int *column) {
    double least = INFINITY;
    for (int i = 0; i < p->rows; i++)
        for (int j = 0; j < p->columns && partner_a[i] < 0; j++) {
            double price = p->prices[(size_t)i * (size_t)p->columns + (size_t)j];
            if (partner_b[j] >= 0 || price >= least) continue;
            least = price;
            *row = i;
            *column = j;
        }
    return least < INFINITY;
}

mt_status mt_pair_rings(const mt_ring_list *a, const mt_ring_list *b, double most, double chord,
                        mt_arena *arena, int *partner_a, int *partner_b) {
    if (a->count == 0 || b->count == 0) return MT_OK;
    mt_prices prices;
    mt_status status = price_all(a, b, most, chord, arena, &prices);
    if (status != MT_OK) return status;
    for (int i, j; cheapest(&prices, partner_a, partner_b, &i, &j);) {
        partner_a[i] = j;
        partner_b[j] = i;
    }
    return MT_OK;
}

mt_status mt_outer_rings(const mt_shape *shape, mt_box box, mt_arena *arena, mt_ring_list *list) {
    *list = (mt_ring_list){shape->count, mt_arena_new(arena, (size_t)shape->count, sizeof(mt_ring *)), box};
    if (!list->rings) return MT_NO_MEMORY;
    for (int i = 0; i < shape->count; i++) list->rings[i] = &shape->components[i].rings[0];
    return MT_OK;
}
