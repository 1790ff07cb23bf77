#include "base/memory.h"

#include "base/stop.h"

#include <stdalign.h>
#include <stdatomic.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ---- the allocator ------------------------------------------------------------------------------------- */

static void *system_resize(void *memory, size_t size) {
    if (size) return realloc(memory, size);
    free(memory);
    return NULL;
}

/* The only state that outlives a call: which allocator is underneath. Tests set it before anything else runs. */
static _Atomic(mt_resize) resize = system_resize;

void mt_memory_replace(mt_resize replacement) {
    atomic_store(&resize, replacement ? replacement : system_resize);
}

void *mt_grow(void *memory, size_t count, size_t size) {
    if (size && count > PTRDIFF_MAX / size) return NULL;
    size_t bytes = count * size;
    return atomic_load(&resize)(memory, bytes ? bytes : 1);
}

void *mt_new(size_t count, size_t size) {
    void *memory = mt_grow(NULL, count, size);
    if (memory) memset(memory, 0, count * size);
    return memory;
}

/* What a full list of that room grows to. */
static int more_room(int room) {
    return room ? 2 * room : 16;
}

void *mt_grow_list(void *list, int count, int *room, size_t size) {
    if (count < *room) return list;
    void *grown = mt_grow(list, (size_t)more_room(*room), size);
    if (grown) *room = more_room(*room);
    return grown;
}

void mt_free(void *memory) {
    if (memory) atomic_load (&resize)(memory, 0);
}

char *mt_copy_text(const char *text) {
    size_t length = strlen(text) + 1;
    char *copy = mt_new(length, 1);
    return copy ? memcpy(copy, text, length) : NULL;
}

/* ---- arenas -------------------------------------------------------------------------------------------- */

struct mt_block {
    mt_block *next;
    size_t size, used; /* of the bytes after the header */
    alignas(max_align_t) unsigned char bytes[];
};

/* With the build's option arenas-apart, each allocation is a block of its very size, which a rewind gives back: so sanitizers see what
 * goes beyond its end, and what is used too late. */
#ifdef MT_ARENAS_APART
enum { APART = true };
#else
enum { APART = false };
#endif

/* Bytes that are set to zero in a step. */
enum { BYTES_A_STEP = 64 };

enum { BLOCK_MIN = 1 << 16, BLOCK_DOUBLED_MOST = 1 << 24 };

static void *take(mt_block *block, size_t size) {
    if (!block || block->size - block->used < size) return NULL;
    void *memory = block->bytes + block->used;
    block->used += size;
    return memset(memory, 0, size);
}

/* Of the blocks after the current one the first that is large enough, emptied, and put next. */
static mt_block *find_block(mt_block **next, size_t size) {
    mt_block **at = next;
    while (*at && (*at)->size < size) at = &(*at)->next;
    mt_block *found = *at;
    if (!found) return NULL;
    *at = found->next;
    found->next = *next;
    found->used = 0;
    return *next = found;
}

static mt_block *next_block(mt_arena *arena, size_t size) {
    mt_block **next = arena->current ? &arena->current->next : &arena->first;
    mt_block *block = APART ? NULL : find_block(next, size);
    if (block) return block;
    size_t doubled = arena->current ? 2 * arena->current->size : BLOCK_MIN;
    if (doubled > BLOCK_DOUBLED_MOST) doubled = BLOCK_DOUBLED_MOST;
    size_t room = APART || size > doubled ? size : doubled;
    if (room > PTRDIFF_MAX - sizeof(mt_block)) return NULL;
    block = mt_new(1, sizeof(mt_block) + room);
    if (!block) return NULL;
    *block = (mt_block){.next = *next, .size = room};
    return *next = block;
}

/* Whether the task may take so many bytes more. What it asks for counts, not the blocks, so that it is the same whatever was made before. */
static bool may_take(mt_arena *arena, size_t bytes) {
    if (!arena->bounded || bytes <= arena->most - arena->used) return true;
    arena->steps = -1;
    return false;
}

void *mt_arena_new(mt_arena *arena, size_t count, size_t size) {
    if (size && count > (PTRDIFF_MAX - alignof(max_align_t)) / size) return NULL;
    size_t bytes = (count * size + alignof(max_align_t) - 1) / alignof(max_align_t) * alignof(max_align_t);
    if (!may_take(arena, bytes)) return NULL;
    size_t taken = APART ? count * size : bytes;
    void *memory = APART ? NULL : take(arena->current, taken);
    if (!memory) {
        mt_block *block = next_block(arena, taken);
        if (!block) return NULL;
        arena->current = block;
        memory = take(block, taken);
    }
    arena->used += bytes;
    mt_arena_spend(arena, (int64_t)(bytes / BYTES_A_STEP));
    return memory;
}

void *mt_arena_grow_list(mt_arena *arena, void *list, int count, int *room, size_t size) {
    if (count < *room) return list;
    void *grown = mt_arena_new(arena, (size_t)more_room(*room), size);
    if (!grown) return NULL;
    *room = more_room(*room);
    return count ? memcpy(grown, list, (size_t)count * size) : grown;
}

static void free_blocks(mt_block **first) {
    for (mt_block *block = *first, *next; block; block = next) {
        next = block->next;
        mt_free(block);
    }
    *first = NULL;
}

void mt_arena_reset(mt_arena *arena) {
    if (APART) free_blocks(&arena->first);
    arena->current = NULL;
    arena->used = 0;
    mt_arena_bound(arena, NULL);
}

void mt_arena_release(mt_arena *arena) {
    free_blocks(&arena->first);
    *arena = (mt_arena){0};
}

mt_arena_place mt_arena_mark(const mt_arena *arena) {
    return (mt_arena_place){arena->current, arena->current ? arena->current->used : 0, arena->used};
}

void mt_arena_rewind(mt_arena *arena, mt_arena_place place) {
    arena->current = place.block;
    arena->used = place.used;
    if (place.block) place.block->used = place.block_used;
    if (APART) free_blocks(place.block ? &place.block->next : &arena->first);
}

/* ---- work ---------------------------------------------------------------------------------------------- */

void mt_arena_bound(mt_arena *arena, const mt_allowance *allowance) {
    arena->bounded = allowance != NULL;
    arena->stop = allowance ? allowance->stop : NULL;
    if (!allowance) return;
    arena->steps = allowance->steps;
    arena->most = allowance->bytes < SIZE_MAX - arena->used ? arena->used + allowance->bytes : SIZE_MAX;
}

bool mt_arena_spend(mt_arena *arena, int64_t steps) {
    if (!arena->bounded) return true;
    bool stopped = arena->stop && atomic_load_explicit(&arena->stop->set, memory_order_relaxed);
    arena->steps = stopped || steps > arena->steps ? -1 : arena->steps - steps;
    return arena->steps >= 0;
}

bool mt_arena_is_spent(const mt_arena *arena) {
    return arena->bounded && arena->steps < 0;
}

mt_status mt_arena_verdict(const mt_arena *arena, mt_status status) {
    bool out = status == MT_NO_MEMORY || status == MT_TOO_LARGE;
    return out && mt_arena_is_spent(arena) ? MT_TOO_COSTLY : status;
}
