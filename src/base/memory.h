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
typedef struct mt_arena {
    mt_block *first, *current;
    size_t taken, most; /* bytes of what is in it; where its task is bounded, how many there may be */
    int64_t steps;      /* that its task may still do, where it is bounded */
    bool bounded;
} mt_arena; /* all zero is an empty arena, whose task may do as much as it likes */

/* count × size bytes, zeroed, aligned for any type; belongs to the arena. */
void *mt_arena_new(mt_arena *arena, size_t count, size_t size);
/* As mt_grow_list, in the arena, where the old list stays. */
void *mt_arena_grow_list(mt_arena *arena, void *list, int count, int *room, size_t size);
void mt_arena_reset(mt_arena *arena);   /* everything made in it is gone, and its bound; its blocks stay */
void mt_arena_release(mt_arena *arena); /* the blocks too */

/* A place in an arena: what was made after mt_arena_mark is gone after mt_arena_rewind. */
typedef struct mt_arena_place {
    mt_block *block;
    size_t used, taken;
} mt_arena_place;
mt_arena_place mt_arena_mark(const mt_arena *arena);
void mt_arena_rewind(mt_arena *arena, mt_arena_place place);

/* The work of an arena's task, counted in steps that are the same on any machine: a cell of a table, two points compared, a corner of a
 * union, 64 bytes made. Bounds what the task does from here on, or with 0 takes the bound away. The arena may hold an eighth as many bytes:
 * with more the steps are spent. */
void mt_arena_bound(mt_arena *arena, int64_t steps);
/* Takes steps that are to be done off those left; false where there are not as many, and from then on. */
bool mt_arena_spend(mt_arena *arena, int64_t steps);
/* Whether a large table of so many bytes may be made; where not, the steps are spent. */
bool mt_arena_has_room(mt_arena *arena, size_t bytes);
bool mt_arena_is_spent(const mt_arena *arena);
