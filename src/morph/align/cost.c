/* The cost of pairing a sample of A with a sample of B, from the samples' views:
 *
 *     cost = direction · (2 − in·in' − out·out') / 4       unit vectors: 0 where both head alike, 1 where opposite
 *          + distance · |place − place'|                   places as seen in their own glyph's frame
 *          + corner · (1 − turn·turn') / 2                 how differently they turn
 *
 * It is symmetric in A and B, and at least 0. Against m samples at once it takes O(m), in float, over columns, so that the compiler
 * makes vector instructions of it. */
#include "morph/align/cost.h"

mt_status mt_columns_of(const mt_sample_view *views, int count, mt_arena *arena, mt_columns *columns) {
    size_t m = (size_t)count;
    float *room = mt_arena_new(arena, 8 * m, sizeof *room);
    if (!room) return MT_NO_MEMORY;
    mt_columns *c = columns;
    *c = (mt_columns){room,         room + m,     room + 2 * m, room + 3 * m,
                      room + 4 * m, room + 5 * m, room + 6 * m, room + 7 * m};
    for (size_t j = 0; j < m; j++) {
        const mt_sample_view *view = &views[j];
        c->x[j] = (float)view->x;
        c->y[j] = (float)view->y;
        c->in_x[j] = (float)view->in_x;
        c->in_y[j] = (float)view->in_y;
        c->out_x[j] = (float)view->out_x;
        c->out_y[j] = (float)view->out_y;
        c->turn_x[j] = (float)view->turn_x;
        c->turn_y[j] = (float)view->turn_y;
    }
    return MT_OK;
}

void mt_step_costs(const mt_cost_weights *weights, const mt_sample_view *view, const mt_columns *c, int first,
                   int end, float *restrict costs) {
    const float x = (float)view->x, y = (float)view->y, in_x = (float)view->in_x, in_y = (float)view->in_y,
                out_x = (float)view->out_x, out_y = (float)view->out_y, turn_x = (float)view->turn_x,
                turn_y = (float)view->turn_y;
    const float direction = (float)weights->direction / 4, distance = (float)weights->distance,
                corner = (float)weights->corner / 2;
    for (int j = first; j < end; j++) {
        float same = in_x * c->in_x[j] + in_y * c->in_y[j] + out_x * c->out_x[j] + out_y * c->out_y[j];
        float alike = turn_x * c->turn_x[j] + turn_y * c->turn_y[j];
        float dx = x - c->x[j], dy = y - c->y[j];
        costs[j] = direction * (2 - same) + distance * sqrtf(dx * dx + dy * dy) + corner * (1 - alike);
    }
}
