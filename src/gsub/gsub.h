/* A font's substitutions (OpenType spec, "GSUB"), as a list that can be matched with another font's and written again. */
#pragma once

#include "layout/layout.h"
#include "sfnt/sfnt.h"
#include "sfnt/table.h"

/* Types of lookups. */
enum {
    MT_GSUB_SINGLE = 1,
    MT_GSUB_MULTIPLE = 2,
    MT_GSUB_ALTERNATE = 3,
    MT_GSUB_LIGATURE = 4,
    MT_GSUB_CONTEXT = 5,
    MT_GSUB_CHAIN = 6,
    MT_GSUB_REVERSE = 8, /* a single one, from the end of the text, in a context */
};

/* These glyphs become those: one becomes one, several in a row, none, or one of several; or several become one. */
typedef struct mt_substitution {
    uint16_t *glyphs; /* the inputs, then the outputs */
    uint16_t inputs, outputs;
} mt_substitution;

/* A glyph that is substituted as another one is. */
typedef struct mt_twin {
    uint16_t glyph, like;
} mt_twin;

typedef struct mt_gsub_subtable {
    mt_bytes table; /* as the font has it */
    int count;      /* none for contexts, and for what is malformed */
    mt_substitution
        *list; /* by their first inputs, ascending; ligatures of one first input in the font's order */
} mt_gsub_subtable;

typedef struct mt_gsub_lookup {
    int type, flag; /* as mt_lookup */
    int mark_set;
    int subtable_count;
    mt_gsub_subtable *subtables;
} mt_gsub_lookup;

typedef struct mt_gsub {
    mt_bytes table;          /* as mt_layout_place makes it; empty where the font has none */
    mt_layout layout;        /* of that table */
    int glyph_count;         /* of the font */
    mt_gsub_lookup *lookups; /* layout.lookup_count of them */
} mt_gsub;

/* Reads the font's GSUB at its place on the axes, into the arena. What is malformed, and what goes beyond
 * MT_SUBSTITUTIONS_MAX, is passed over. MT_NO_MEMORY, MT_ENDLESS_LOOKUPS. */
mt_status mt_gsub_open(const mt_font *font, mt_arena *arena, mt_gsub *gsub);

/* The same of a table of version 1.0 by itself. */
mt_status mt_gsub_open_table(mt_bytes table, int glyph_count, mt_arena *arena, mt_gsub *gsub);

/* Marks the lookups of a feature, and those that they call, and so on; `marked` has one for each lookup. */
void mt_gsub_mark(const mt_gsub *gsub, int feature, bool *marked);

/* ---- between the files of it --------------------------------------------------------------------------- */

typedef struct mt_gsub_reader {
    mt_arena *arena;
    int glyph_count;
    int64_t
        left; /* of what may be read: a table whose parts share bytes can hold more than there is memory */
} mt_gsub_reader;

/* gsub_read.c: the substitutions of a subtable of one of the types 1 … 4 and 8. MT_NO_MEMORY. */
mt_status mt_gsub_read(mt_gsub_reader *reader, int type, mt_bytes table, mt_gsub_subtable *subtable);

/* gsub_twins.c: adds to each substitution of a twin's like one of the twin: they differ in the first glyph. Contexts do not
 * know twins. MT_NO_MEMORY. */
mt_status mt_gsub_add_twins(mt_gsub *gsub, const mt_twin *twins, int count, mt_arena *arena);

/* gsub_write.c: adds subtables of these substitutions to the table, each within its 16-bit offsets, and where they start
 * to the list. `old` is the subtable they come from: a reverse one has its context. MT_NO_MEMORY. */
typedef struct mt_gsub_part {
    size_t at;
    bool is_old; /* it starts in the font's own table */
} mt_gsub_part;

typedef struct mt_gsub_parts {
    int count, room;
    mt_gsub_part *list; /* in the arena */
    mt_arena *arena;
    mt_table bytes; /* the new subtables */
} mt_gsub_parts;

mt_status mt_gsub_add_part(mt_gsub_parts *parts, size_t at, bool is_old);
mt_status mt_gsub_write(mt_gsub_parts *parts, int type, mt_bytes old, const mt_substitution *list, int count);

/* gsub_cut.c: the table once more, without the substitutions that lead to a glyph that is not kept, or from one; `kept`
 * has one for each glyph of the font. All lookups are extensions. Empty when its offsets would not do. MT_NO_MEMORY. */
mt_status mt_gsub_cut(const mt_gsub *gsub, const bool *kept, mt_arena *arena, mt_bytes *cut);
