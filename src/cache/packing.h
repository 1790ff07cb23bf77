/* Structs as bytes and back, by the same functions: each goes through the fields in their order, and writes them or reads them. So one
 * place says what is kept of a struct. Numbers are short where they are small; a point is told by its way from the one before.
 *
 * What is read may be damaged: a count is never larger than the bytes that are left could hold, a number is within its bounds, and
 * after the first fault everything reads as 0 and nothing. */
#pragma once

#include "base/buffer.h"
#include "geometry/outline.h"

typedef struct mt_packing {
    mt_buffer *out;          /* what is written, to its end; NULL: it is read */
    const uint8_t *at, *end; /* what is left to read */
    mt_arena *arena;         /* where what is read will be */
    mt_point last;
    mt_status status; /* MT_OK; MT_BAD_GEOMETRY for damage; MT_NO_MEMORY */
} mt_packing;

mt_packing mt_packing_to(mt_buffer *out);
mt_packing mt_packing_from(const uint8_t *bytes, size_t length, mt_arena *arena);
/* The status; of what is read, also damage where bytes are left. */
mt_status mt_packing_end(mt_packing *packing);
/* What was read cannot be. */
void mt_packing_refuse(mt_packing *packing);

void mt_pack_int(mt_packing *packing, int *value, int least, int most);
void mt_pack_bool(mt_packing *packing, bool *value);
void mt_pack_double(mt_packing *packing, double *value);  /* bit by bit; finite */
void mt_pack_point(mt_packing *packing, mt_point *point); /* within four times MT_COORD_MAX */
void mt_pack_box(mt_packing *packing, mt_box *box);

/* A list's count; gives the list, which is new where it is read. An item takes at least a byte. NULL, and a count of 0, on a fault. */
void *mt_pack_list(mt_packing *packing, int *count, void *list, size_t size);

void mt_pack_rings(mt_packing *packing, mt_rings *rings);
void mt_pack_shape(mt_packing *packing, mt_shape *shape);
/* Segments of up to `most` as their degree. */
void mt_pack_contour(mt_packing *packing, mt_contour *contour, int most);
