/* Numbers by their costs, the least first; of equals, the lowest number. */
#pragma once

#include "base/memory.h"
#include "morphotype.h"

typedef struct mt_queued {
    double cost;
    int number;
} mt_queued;

typedef struct mt_queue {
    int count, room;
    mt_queued *items; /* a heap */
} mt_queue;

/* MT_NO_MEMORY. */
mt_status mt_queue_push(mt_queue *queue, mt_arena *arena, double cost, int number);
/* Takes out the first; there is one. */
mt_queued mt_queue_pop(mt_queue *queue);
