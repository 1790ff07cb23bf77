/* The one place where memory comes from.
 *
 * An arena holds everything made for one glyph: allocate at will, free nothing, reset when the glyph is done.
 * Its blocks are kept between resets, so that after a few glyphs nothing is asked of the system any more. An
 * arena belongs to one thread. Sizes are checked before they are multiplied; a call that fails returns NULL
 * and changes nothing. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "morphotype.h"

/* The allocator underneath, replaceable by a test: `resize` is realloc's contract, with size 0 meaning free. */
typedef void *(*mt_resize)(void *memory, size_t size);
void mt_memory_replace(mt_resize resize); /* NULL goes back to the C library's */

/* count × size bytes, zeroed, from the allocator; NULL when out of memory or when the product overflows. */
void *mt_new(size_t count, size_t size);
/* `memory` grown or shrunk to count × size bytes; on NULL `memory` is as it was. New bytes are not zeroed. */
void *mt_grow(void *memory, size_t count, size_t size);
/* A list of `count` items of `size` bytes, which has room for one more: as it is, or where *room is used up moved to twice that.
 * On NULL list and room are as they were. */
void *mt_grow_list(void *list, int count, int *room, size_t size);
void mt_free(void *memory); /* NULL is fine */
char *mt_copy_text(const char *text);

typedef struct mt_block mt_block;
typedef struct mt_stop mt_stop; /* stop.h */
typedef struct mt_arena {
    mt_block *first, *current;
    size_t used, most;   /* bytes handed out; and that may be, where it is bounded */
    int64_t steps;       /* that its task may still do, where it is bounded */
    const mt_stop *stop; /* as its allowance */
    bool bounded;
} mt_arena; /* all zero is an empty arena, whose task may do and take as much as it likes */

/* count × size bytes, zeroed, aligned for any type; belongs to the arena. */
void *mt_arena_new(mt_arena *arena, size_t count, size_t size);
/* As mt_grow_list, in the arena, where the old list stays. */
void *mt_arena_grow_list(mt_arena *arena, void *list, int count, int *room, size_t size);
void mt_arena_reset(mt_arena *arena);   /* everything made in it is gone, and its bound; its blocks stay */
void mt_arena_release(mt_arena *arena); /* the blocks too */

/* A place in an arena: what was made after mt_arena_mark is gone after mt_arena_rewind. */
typedef struct mt_arena_place {
    mt_block *block;
    size_t block_used, used;
} mt_arena_place;
mt_arena_place mt_arena_mark(const mt_arena *arena);
void mt_arena_rewind(mt_arena *arena, mt_arena_place place);

/* What an arena's task may do, in steps that are the same on any machine (a cell of a table, two points compared, a corner of a union, 64 bytes made), and
 * the bytes that it may take. */
typedef struct mt_allowance {
    int64_t steps;
    size_t bytes;
    const mt_stop *stop; /* once it is set, nothing is left of the steps; NULL: it never is */
} mt_allowance;
/* Bounds what the task does and takes from here on; NULL takes the bound away. A call that needs more bytes than are left fails as one
 * out of memory does, and the steps are spent as well. */
void mt_arena_bound(mt_arena *arena, const mt_allowance *allowance);
/* Takes steps that are to be done off those left; false where there are not as many, and from then on. */
bool mt_arena_spend(mt_arena *arena, int64_t steps);
bool mt_arena_is_spent(const mt_arena *arena);
/* What a status means of a task: MT_TOO_COSTLY where its allowance is why it was out of memory, or too large. */
mt_status mt_arena_verdict(const mt_arena *arena, mt_status status);
