/* Contextual positioning of one of the fonts (OpenType spec, "Sequence context" and "Chained sequence context"; GPOS lookup
 * types 7 and 8), for the new font's glyphs.
 *
 * Rules of formats 1 and 2 become rules of classes: of format 1, each of the font's glyphs is a class by itself, with
 * all new glyphs that are it. Format 3 stays. A rule is left out when one of its places has no glyph any more. What a rule
 * calls is told by what the lookup is called as. */
#pragma once

#include "glyphset/places.h"
#include "layout/layout.h"
#include "layout/lookup_builder.h"
#include "layout/rule.h"

enum { MT_CONTEXT = 7, MT_CHAINED_CONTEXT = 8 };

typedef struct mt_context_call {
    uint16_t at;   /* place in the input */
    int called_as; /* lookup_builder.h */
} mt_context_call;

typedef struct mt_glyph_list {
    int count;
    uint16_t *glyphs; /* ascending */
} mt_glyph_list;

typedef struct mt_context_rule {
    int counts[MT_SEQUENCES];
    uint16_t *classes[MT_SEQUENCES];    /* of each place; NULL in format 3 */
    mt_glyph_list *lists[MT_SEQUENCES]; /* of each place, in format 3 */
    int call_count;
    mt_context_call *calls;
} mt_context_rule;

typedef struct mt_context_set {
    int count;
    mt_context_rule *rules;
} mt_context_set;

typedef struct mt_context_subtable {
    bool by_lists;                         /* format 3: one set of one rule */
    mt_glyph_list first;                   /* the glyphs that a rule may begin with */
    int class_counts[MT_SEQUENCES];        /* glyphs that are listed */
    mt_glyph_class *classes[MT_SEQUENCES]; /* ascending; class 0 is not listed */
    int set_count;
    mt_context_set *sets; /* by the class of the first glyph */
} mt_context_subtable;

/* What contexts of a malformed font may cost, in steps (a glyph looked up, a number read): the largest fonts take a
 * hundredth. */
#define MT_CONTEXT_STEPS_MAX ((int64_t)1 << 27)

typedef struct mt_context_reader {
    const mt_layout *layout;
    const uint32_t *own; /* of each new glyph, the font's */
    int glyph_count;     /* of the new font */
    int first_call;      /* its lookup 0 is called as the one after this */
    const bool *has;     /* of each of the font's glyphs, whether it is in the new font */
    mt_arena *arena, *scratch;
    int64_t steps; /* that are left; when none are, the rest is left out */
} mt_context_reader;

/* A subtable of a lookup of type 7 or 8; *found is false for one that has no rule, or is malformed. MT_NO_MEMORY. */
mt_status mt_context_read(mt_context_reader *reader, int type, mt_bytes table, mt_context_subtable *subtable,
                          bool *found);

/* Marks the lookups that contexts in a system's features of a tag call, and those that they call, and so on; `reached` has
 * one for each lookup. */
void mt_context_reach_feature(const mt_layout *layout, int system, uint32_t tag, bool *reached);

/* A lookup of such subtables in the new font. */
typedef struct mt_context_lookup {
    mt_lookup_builder head; /* without subtables */
    int count;
    mt_context_subtable *subtables;
} mt_context_lookup;

typedef struct mt_contexts {
    int count;
    mt_context_lookup *list;
} mt_contexts;

/* Adds the lookups to GPOS in the making. A rule calls what is there: the lookups of `made`, and those of `contexts`.
 * MT_NO_MEMORY; MT_TOO_LARGE for a rule that no font has. */
mt_status mt_contexts_write(const mt_contexts *contexts, mt_arena *arena, mt_lookup_builders *made);
