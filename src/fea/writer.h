/* What the parts of the text are written with; only files of this room use it. */
#pragma once

#include "fea/fea.h"
#include "layout/gdef_deltas.h"
#include "layout/layout.h"
#include "sfnt/intern.h"

/* How a lookup of GPOS is told: in the text, by pairs elsewhere, by anchors. */
typedef enum mt_fea_way { MT_FEA_TEXT, MT_FEA_PAIRS, MT_FEA_ANCHORS } mt_fea_way;

/* One of the two tables, while it is written. */
typedef struct mt_fea_table {
    mt_layout layout;
    const char *verb, *prefix; /* "sub" and "gsub", or "pos" and "gpos" */
    mt_fea_way *ways;          /* of each lookup */
    bool *applied, *called;    /* by features that text can name; by contexts */
    int *parts; /* how many blocks each became: one a subtable of attachments, else one; 0: it does nothing */
} mt_fea_table;

typedef struct mt_fea_writer {
    const mt_fea_source *source;
    mt_arena *arena;
    mt_gdef_deltas deltas;
    mt_buffer systems, classes, lookups, features; /* the text, in this order */
    mt_interned lists; /* each list of glyphs: (the list without its last glyph, that glyph) */
    int *class_of, class_room, class_count;
    int anchor_room;
    mt_fea *fea;
    int64_t
        left; /* of what may be written: tables whose parts share bytes can hold more than there is memory */
    mt_status status;
} mt_fea_writer;

/* What fails is told by `status`; nothing is written from then on. */
void mt_fea_put(mt_fea_writer *writer, mt_buffer *to, const char *text);
void mt_fea_print(mt_fea_writer *writer, mt_buffer *to, const char *format, ...)
    __attribute__((format(printf, 3, 4))); /* of a short text */
void mt_fea_glyph(mt_fea_writer *writer, mt_buffer *to, int glyph);
/* A glyph's name, or that of a class, which is defined where it first comes. `count` is over 0. */
void mt_fea_class(mt_fea_writer *writer, mt_buffer *to, const uint16_t *glyphs, int count);
/* Takes steps off what is left; false where there are not as many. */
bool mt_fea_spend(mt_fea_writer *writer, int64_t steps);
/* Zeroed memory of the arena; NULL, and told by `status`, where there is none. */
void *mt_fea_new(mt_fea_writer *writer, size_t count, size_t size);

/* The name of one of the blocks that a lookup became. */
void mt_fea_name(mt_fea_writer *writer, mt_buffer *to, const mt_fea_table *table, int lookup, int part,
                 bool called);
/* " lookup NAME" for all that it became, as contexts call it. */
void mt_fea_call(mt_fea_writer *writer, mt_buffer *to, const mt_fea_table *table, int lookup);

/* All glyphs of a class of a ClassDef, ascending; 0 is that of those in no other. False where that is told by `status`. */
bool mt_fea_class_list(mt_fea_writer *writer, mt_bytes class_def, unsigned number, uint16_t **glyphs,
                       int *count);
/* All of a Coverage. */
bool mt_fea_coverage_list(mt_fea_writer *writer, mt_bytes coverage, uint16_t **glyphs, int *count);
/* Writes each glyph that subtables cover, by the first of them that does, which hides it from the others. */
void mt_fea_each_glyph(mt_fea_writer *writer, const mt_lookup *lookup,
                       mt_bytes (*coverage_of)(mt_bytes table),
                       void (*put)(mt_fea_writer *writer, mt_bytes table, mt_covered covered));

/* ---- a lookup's rules, one file each; they write into writer->lookups ---------------------------------- */

void mt_fea_substitutions(mt_fea_writer *writer, const mt_layout *layout, int lookup);
void mt_fea_contexts(mt_fea_writer *writer, const mt_fea_table *table, int lookup);
void mt_fea_singles(mt_fea_writer *writer, const mt_lookup *lookup);
void mt_fea_pairs(mt_fea_writer *writer, const mt_lookup *lookup);
void mt_fea_cursives(mt_fea_writer *writer, const mt_lookup *lookup);
/* Those of one subtable. `number` is the lookup's; `defines` for the first time that it is written. */
void mt_fea_attachments(mt_fea_writer *writer, const mt_lookup *lookup, int number, int subtable,
                        bool defines);

/* ---- lookups, features and GDEF ------------------------------------------------------------------------ */

/* lookups.c: all lookups that are told in text, those that contexts call before these. */
void mt_fea_lookups(mt_fea_writer *writer, mt_fea_table *table);
/* features.c: which lookups features apply; the language systems; the features. */
void mt_fea_mark_applied(mt_fea_writer *writer, mt_fea_table *table);
void mt_fea_systems(mt_fea_writer *writer, const mt_layout *layout);
void mt_fea_features(mt_fea_writer *writer, const mt_fea_table *table);
/* Whether any system has the lookup in a feature of that tag. */
bool mt_fea_has_tag(const mt_layout *layout, int lookup, uint32_t tag);
/* gdef.c */
void mt_fea_gdef(mt_fea_writer *writer, const bool *bases);
mt_bytes mt_fea_mark_set(const mt_fea_writer *writer, int set); /* its Coverage */
/* ways.c: how the lookups of GPOS are told. */
void mt_fea_choose_ways(mt_fea_writer *writer, mt_fea_table *table);
/* anchors.c: the anchors of those that are told by these, and which glyphs are bases for that. */
void mt_fea_anchors(mt_fea_writer *writer, const mt_fea_table *table, bool *bases);
