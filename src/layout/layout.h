/* GPOS and GSUB as they are walked (OpenType spec, "Layout tables": ScriptList, FeatureList, LookupList; versions 1.0
 * and 1.1; FeatureVariations are not read). */
#pragma once

#include "base/memory.h"
#include "layout/ot.h"
#include "sfnt/sfnt.h"

#define MT_LANGUAGE_DEFAULT 0u /* the language of a script's default language system */

enum { MT_EXTENSION_GSUB = 7, MT_EXTENSION_GPOS = 9 };

/* A language system: what one script and language, or one script by default, has. */
typedef struct mt_system {
    uint32_t script, language;
    int required; /* the index of a feature; -1 when there is none */
    int feature_count;
    mt_bytes features; /* 16-bit indices */
} mt_system;

/* Which lookups the contexts call: lookup i those from first[i] up to first[i + 1], ascending, each once. */
typedef struct mt_calls {
    int *first; /* one more than there are lookups; NULL without lookups */
    uint16_t *lookups;
} mt_calls;

typedef struct mt_layout {
    int extension;
    int system_count;
    mt_system *systems; /* as the table has them: scripts in its order, the default before the others */
    int feature_count, lookup_count;
    mt_bytes features, lookups; /* FeatureList, LookupList */
    mt_calls calls;
} mt_layout;

/* The index of the system for a script and language: that of both, else the script's default, else that of DFLT, dflt
 * or latn (the language's own before the default in each), as HarfBuzz chooses it; -1 when there is none of these. */
int mt_layout_system(const mt_layout *layout, uint32_t script, uint32_t language);

/* How near a system is to that which text in Latin is set by: 0 for latn's default, 1 for DFLT's, 2 for all others. */
int mt_latin_rank(uint32_t script, uint32_t language);

/* The i-th feature of a system is an index into the FeatureList; -1 for an index that is out of range.
 * i == feature_count is the required feature. */
int mt_system_feature(const mt_layout *layout, const mt_system *system, int i);
uint32_t mt_feature_tag(const mt_layout *layout, int feature);
int mt_feature_lookup_count(const mt_layout *layout, int feature);
int mt_feature_lookup(const mt_layout *layout, int feature, int i); /* -1 when it is out of range */
bool mt_feature_has(const mt_layout *layout, int feature, int lookup);

#define MT_LOOKUP_MARK_SET 0x0010 /* the flag that a lookup has a mark glyph set */

typedef struct mt_lookup {
    int type; /* of the subtables; an extension's where it is one; 0 for a malformed lookup */
    int flag;
    int mark_set; /* GDEF's mark glyph set; -1 when there is none */
    int subtable_count;
    bool extended;
    mt_bytes table;
} mt_lookup;

mt_lookup mt_layout_lookup(const mt_layout *layout, int index);
/* An extension is followed; empty where that has not the lookup's type. */
mt_bytes mt_lookup_subtable(const mt_lookup *lookup, int i);
