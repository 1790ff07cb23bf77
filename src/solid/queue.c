/* A binary heap. */
#include "solid/queue.h"

static bool is_before(mt_queued p, mt_queued q) {
    return p.cost != q.cost ? p.cost < q.cost : p.number < q.number;
}

mt_status mt_queue_push(mt_queue *queue, mt_arena *arena, double cost, int number) {
    mt_queued item = {cost, number};
    queue->items = mt_arena_grow_list(arena, queue->items, queue->count, &queue->room, sizeof *queue->items);
    if (!queue->items) return MT_NO_MEMORY;
    int i = queue->count++;
    for (; i > 0 && is_before(item, queue->items[(i - 1) / 2]); i = (i - 1) / 2)
        queue->items[i] = queue->items[(i - 1) / 2];
    queue->items[i] = item;
    return MT_OK;
}

mt_queued mt_queue_pop(mt_queue *queue) {
    mt_queued top = queue->items[0], last = queue->items[--queue->count];
    int i = 0;
    for (int child; (child = 2 * i + 1) < queue->count; i = child) {
        if (child + 1 < queue->count && is_before(queue->items[child + 1], queue->items[child])) child++;
        if (!is_before(queue->items[child], last)) break;
        queue->items[i] = queue->items[child];
    }
    queue->items[i] = last;
    return top;
}
