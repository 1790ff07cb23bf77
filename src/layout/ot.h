/* Reading OpenType layout tables (OpenType spec, "OpenType Layout Common Table Formats").
 *
 * A table is the bytes from its start to the end of the file's table. What is read past the end is 0, and a table at
 * offset 0 or past the end is empty: so malformed data gives empty lists, and nothing has to be checked twice. */
#pragma once

#include "sfnt/sfnt.h"
#include "source/font.h"

/* Whether `length` bytes at `at` lie within. */
bool mt_ot_has(mt_bytes table, size_t at, size_t length);
unsigned mt_ot_u16(mt_bytes table, size_t at);
int mt_ot_i16(mt_bytes table, size_t at);
uint32_t mt_ot_u32(mt_bytes table, size_t at);

/* What lies at `offset`, which counts from the table's start; empty for 0 and for an offset past the end. */
mt_bytes mt_ot_at(mt_bytes table, size_t offset);
/* What the 16-bit or the 32-bit offset at `at` leads to. */
mt_bytes mt_ot_follow(mt_bytes table, size_t at);
mt_bytes mt_ot_follow32(mt_bytes table, size_t at);

/* How many records of `size` bytes from `at` on lie within, `count` at most. */
int mt_ot_fit(mt_bytes table, size_t at, unsigned count, size_t size);

/* ---- sets and classes of glyphs ------------------------------------------------------------------------ */

/* The place of a glyph in a Coverage table (formats 1 and 2); -1 when it is not covered. */
int mt_coverage_find(mt_bytes coverage, uint32_t glyph);

typedef struct mt_covered {
    uint16_t glyph, index;
} mt_covered;

/* All covered glyphs, ascending. Ranges that do not ascend are passed over. MT_NO_MEMORY. */
mt_status mt_coverage_list(mt_bytes coverage, mt_arena *arena, mt_covered **list, int *count);

/* The class of a glyph in a ClassDef table (formats 1 and 2); 0 when it is in none. */
unsigned mt_class_find(mt_bytes class_def, uint32_t glyph);
