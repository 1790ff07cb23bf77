/* A font's MATH table as it is read (OpenType spec, "MATH"): in the font's own units, at its place on the axes. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* The constants in the order of the MathConstants table. */
enum {
    MT_MATH_PERCENTS = 2,    /* so many come first: scale of scripts and of their scripts, in percent */
    MT_MATH_HEIGHTS = 2,     /* then least heights, without variations */
    MT_MATH_FIRST_VALUE = 4, /* then what may vary */
    MT_MATH_SPACE_AFTER_SCRIPT = 17, /* these, unlike the others, are widths */
    MT_MATH_SKEWED_FRACTION_GAP = 41,
    MT_MATH_KERN_BEFORE_DEGREE = 53,
    MT_MATH_KERN_AFTER_DEGREE = 54,
    MT_MATH_LAST_PERCENT = 55, /* how far a root's degree is raised, in percent of the root */
    MT_MATH_CONSTANTS = 56,
};

typedef struct mt_math_value {
    uint16_t glyph;
    double value;
} mt_math_value;

typedef struct mt_math_values {
    bool present; /* the font has such a table, which may be empty */
    int count;
    mt_math_value *list; /* ascending by glyph */
} mt_math_values;

enum { MT_MATH_CORNERS = 4 }; /* top right, top left, bottom right, bottom left */

/* How far a script moves in at a corner: kerns[i] below heights[i], kerns[count] above all. */
typedef struct mt_math_kern {
    bool present;
    int count; /* of the heights */
    double *heights, *kerns;
} mt_math_kern;

typedef struct mt_math_glyph_kerns {
    uint16_t glyph;
    mt_math_kern corners[MT_MATH_CORNERS];
} mt_math_glyph_kerns;

typedef struct mt_math_kerns {
    int count;
    mt_math_glyph_kerns *list; /* ascending by glyph */
} mt_math_kerns;

typedef struct mt_math_variant {
    uint16_t glyph;
    double measure; /* its extent in the direction of growth */
} mt_math_variant;

typedef struct mt_math_part {
    uint16_t glyph;
    unsigned flags;          /* bit 0: an extender */
    double start, end, full; /* lengths of the straight connectors, and the extent */
} mt_math_part;

/* What stands for a glyph where it has to grow: a larger one, or one put together of parts. */
typedef struct mt_math_construction {
    uint16_t glyph;
    int variant_count;
    mt_math_variant *variants; /* in the font's order: the smallest first */
    bool has_assembly;
    double italics; /* of the assembly */
    int part_count;
    mt_math_part *parts; /* from left to right, or from the bottom to the top */
} mt_math_construction;

enum { MT_MATH_VERTICAL, MT_MATH_HORIZONTAL, MT_MATH_DIRECTIONS };

typedef struct mt_math_constructions {
    int count;
    mt_math_construction *list; /* ascending by glyph */
} mt_math_constructions;

typedef enum mt_math_state {
    MT_MATH_NONE,
    MT_MATH_DAMAGED, /* an offset or a count leads out of the table, or to more than the most below */
    MT_MATH_WHOLE,
} mt_math_state;

/* Records that a table may lead to: those that are shared count each time. The largest fonts have some ten thousand. Those that
 * one glyph may have of a kind: fonts have some ten. */
enum { MT_MATH_RECORDS_MAX = 1 << 18, MT_MATH_OWN_MAX = 256 };

typedef struct mt_math_table {
    mt_math_state state; /* all else is empty unless it is whole */
    bool has_constants;
    double constants[MT_MATH_CONSTANTS];
    mt_math_values italics, accents; /* corrections; where an accent is put, from the left */
    mt_math_values extended;         /* glyphs that grow, as scripts are put to them; the values are 0 */
    mt_math_kerns kerns;
    double least_overlap; /* of two parts */
    mt_math_constructions constructions[MT_MATH_DIRECTIONS];
} mt_math_table;

/* NULL where there is none for the glyph. */
const mt_math_value *mt_math_value_find(const mt_math_values *values, uint32_t glyph);
const mt_math_glyph_kerns *mt_math_kerns_find(const mt_math_kerns *kerns, uint32_t glyph);
const mt_math_construction *mt_math_construction_find(const mt_math_constructions *constructions,
                                                      uint32_t glyph);

/* Whether two constructions have assemblies of as many parts, extenders in the same places. */
bool mt_math_same_assembly(const mt_math_construction *one, const mt_math_construction *other);
