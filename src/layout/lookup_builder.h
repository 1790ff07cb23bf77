/* GPOS in the making: Coverage and ClassDef tables, and lookups whose subtables are ready. */
#pragma once

#include "layout/layout.h"
#include "sfnt/sfnt.h"
#include "sfnt/table.h"

/* A Coverage table of these glyphs, ascending, in the shorter format. */
void mt_table_coverage(mt_table *table, const uint16_t *glyphs, int count);

typedef struct mt_glyph_class {
    uint16_t glyph, class;
} mt_glyph_class;

/* A ClassDef table, glyphs ascending, in the shorter format; class 0 need not be listed. */
void mt_table_classes(mt_table *table, const mt_glyph_class *glyphs, int count);

/* Moves what was written into the arena and frees the table. MT_NO_MEMORY when the table has failed. */
mt_status mt_table_keep(mt_table *table, mt_arena *arena, mt_bytes *bytes);

/* A list of subtables that grows in an arena; all zero is empty. */
typedef struct mt_subtables {
    int count, room;
    mt_bytes *list;
} mt_subtables;

/* Moves what was written into the arena and the list; the table is empty then. MT_NO_MEMORY. */
mt_status mt_subtables_add(mt_table *table, mt_arena *arena, mt_subtables *subtables);

/* That a lookup belongs to a feature of a language system (an index of the new font's systems). */
typedef struct mt_member {
    int system;
    uint32_t feature;
} mt_member;

/* That a context in a lookup calls another one: the number stands in two bytes of a subtable. */
typedef struct mt_lookup_call {
    int subtable;
    size_t at;
    int called_as;
} mt_lookup_call;

/* From here on is the order of lookups that contexts call: behind all that features apply. */
enum { MT_CALLED_ORDER = 1 << 20 };

typedef struct mt_lookup_builder {
    int order; /* lookups are applied by ascending order, then as they were added: the index of A's lookup */
    int type, flag;
    int mark_set; /* -1: none */
    int member_count;
    const mt_member *members;
    int subtable_count;
    const mt_bytes *subtables; /* each under 64 KB or with 16-bit offsets of its own; not extensions */
    int called_as;  /* what contexts call it by, from 1 on, whatever features it is in; 0: no context does */
    int call_count; /* of a context */
    const mt_lookup_call *calls;
} mt_lookup_builder;

/* Where a lookup of A's belongs, for systems that are A's own; a member may come twice. MT_NO_MEMORY. */
mt_status mt_members_of(const mt_layout *layout, int lookup, mt_arena *arena, mt_member **members,
                        int *count);

/* A list that grows in an arena; all zero is empty. */
typedef struct mt_lookup_builders {
    int count, room;
    mt_lookup_builder *lookups;
} mt_lookup_builders;
mt_status mt_lookup_builders_add(mt_lookup_builders *made, const mt_lookup_builder *lookup,
                                 mt_arena *arena); /* MT_NO_MEMORY */
