/* Reading fonts, through FreeType. */
#pragma once

#include "geometry/outline.h"
#include "morphotype.h"
#include "sfnt/sfnt.h"

/* Font-wide figures that a blend interpolates, in font units unless said otherwise. */
typedef struct mt_metrics {
    double hhea_ascender, hhea_descender, hhea_line_gap;
    double typo_ascender, typo_descender, typo_line_gap; /* descenders are negative */
    double win_ascent, win_descent;                      /* both positive */
    double x_height, cap_height;
    double underline_position, underline_thickness; /* post's: position is of the stroke's top */
    double strikeout_position, strikeout_size;
    double subscript_size[2], subscript_offset[2];     /* x, y */
    double superscript_size[2], superscript_offset[2]; /* x, y */
    double italic_angle;              /* degrees, anticlockwise from upright: negative leans right */
    double weight_class, width_class; /* OS/2: 1 … 1000, 1 … 9 */
    double caret_offset;
    double caret_rise, caret_run; /* hhea: how the caret leans, as far up as to the right */
    double vhea_ascender, vhea_descender,
        vhea_line_gap;  /* from the line's middle to the right and to the left */
    uint8_t panose[10]; /* panose.h */
    int family_class;   /* OS/2 sFamilyClass */
    bool monospaced, use_typo_metrics;
    bool vertical; /* there are metrics for vertical lines; otherwise vhea's figures are made up */
} mt_metrics;

/* What the font says of itself; UTF-8, each NULL when it says nothing; belong to the font. */
typedef struct mt_names {
    const char *family, *style, *version, *copyright, *license, *license_url, *designer, *trademark;
} mt_names;

const char *mt_font_spec(const mt_font *font); /* as it was opened */
const char *mt_font_choice(
    const mt_font *font); /* of a face, axes and features, as the spec has it after the file's name; or "" */
void mt_font_metrics(const mt_font *font, mt_metrics *metrics);
/* OS/2 usWidthClass of a width as 'wdth' has it, between the classes too. */
double mt_width_class(double percent);
void mt_font_names(const mt_font *font, mt_names *names);
int64_t mt_font_modified(const mt_font *font);   /* head's time: seconds since 1904; 0 when there is none */
uint16_t mt_font_embedding(const mt_font *font); /* OS/2 fsType */

/* Where the font says that it stands on a registered axis: a variable one where it was opened, any other by OS/2 (usWeightClass for
 * wght, usWidthClass as a percentage for wdth), by post (slnt), or upright at 0 and italic at 1 (ital). False where it does not say. */
bool mt_font_stop(const mt_font *font, uint32_t tag, double *value);
/* Whether it says that its letters lean: OS/2, or head. */
bool mt_font_is_italic(const mt_font *font);

/* A table of an sfnt font, out of any container, in the arena; no bytes where the font has none of that tag or is no
 * sfnt. Not for two threads at once. MT_NO_MEMORY. */
mt_status mt_font_table(const mt_font *font, uint32_t tag, mt_arena *arena, mt_bytes *table);

/* The kerning outside of GPOS, as a 'kern' table in the arena: the font's own one, or what the metrics beside a Type 1 font
 * (F.afm or F.pfm beside F.pfb) have. No bytes where there is neither. MT_NO_MEMORY. */
mt_status mt_font_kern(const mt_font *font, mt_arena *arena, mt_bytes *kern);

/* The path of metrics beside a Type 1 font that could not be read; NULL for none. Belongs to the font. */
const char *mt_font_unread_metrics(const mt_font *font);

bool mt_font_has_table(const mt_font *font, uint32_t tag);

/* The tags of its axes, in the handle; how many, at most 64, 0 where it does not vary. */
int mt_font_axes(const mt_font *font, const uint32_t **tags);
/* The place on the axes of 'fvar' that the font was opened at: normalized, after 'avar', 16.16 in -1 … 1, one an axis.
 * Returns how many; 0 for a font that does not vary. They belong to the font. */
int mt_font_place(const mt_font *font, const int32_t **normalized);

/* How many glyphs it has: at most MT_GLYPHS_MAX are counted. */
int mt_font_glyph_count(const mt_font *font);

/* Whether mt_font_drop_layout was called. */
bool mt_font_is_without_layout(const mt_font *font);
/* Whether the font's spec has features and no character leads to another glyph by them. */
bool mt_font_features_do_nothing(const mt_font *font);

/* The glyph that the character map has for a code point, or that the features of the font's spec make of it; 0 when there is
 * none. */
uint32_t mt_font_mapped_glyph(const mt_font *font, uint32_t code_point);

/* Whether it has a character map for symbols (OpenType spec, "cmap": platform 3, encoding 0). Where that is its only one,
 * its codes, mostly U+F020 to U+F0FF, are the characters. */
bool mt_font_is_symbol(const mt_font *font);

/* The glyph's outline, unhinted, references resolved, on the grid (MT_EM to the em), and its advance in grid
 * units. MT_NO_MEMORY, MT_BAD_GLYPH, MT_TOO_LARGE. Where FreeType itself ran out of memory the font gives no
 * glyph any more: every later call is MT_NO_MEMORY. Not for two threads at once. */
mt_status mt_font_outline(mt_font *font, uint32_t glyph, mt_arena *arena, mt_outline *outline,
                          double *advance);
/* Whether an outline that can be read has no contour of more than one point. MT_NO_MEMORY. */
mt_status mt_font_is_blank(mt_font *font, uint32_t glyph, bool *blank);

/* The advance alone, grid units; also of a glyph whose outline cannot be read. MT_NO_MEMORY, MT_BAD_GLYPH. Not for two
 * threads at once. */
mt_status mt_font_advance(mt_font *font, uint32_t glyph, double *advance);

/* A glyph on a vertical line, grid units: how far down the next one is, and how high over its baseline the glyph hangs. */
typedef struct mt_vertical {
    double advance, origin;
} mt_vertical;

/* From VORG, vmtx and VVAR; where the font has no vertical metrics for it, the typographic lines' height and ascender.
 * MT_NO_MEMORY, MT_BAD_GLYPH. Not for two threads at once. */
mt_status mt_font_vertical(mt_font *font, uint32_t glyph, mt_vertical *vertical);

/* A glyph drawn as a part of another one, moved to the right and up by font units. */
typedef struct mt_reference {
    uint32_t glyph;
    int dx, dy;
} mt_reference;

typedef struct mt_references {
    int count;
    mt_reference *list;
} mt_references;

/* What a TrueType font builds the glyph from, in the arena or the font: glyphs that, moved and drawn together, are its outline point
 * by point. Empty for a glyph that is not built so: one with contours of its own, one whose references are scaled or
 * turned, one of another format. MT_NO_MEMORY. Not for two threads at once. */
mt_status mt_font_references(mt_font *font, uint32_t glyph, mt_arena *arena, mt_references *references);

/* Glyphs that are drawn together, each moved, and stand in a line as one: what a text leads to where another font has one
 * glyph. */
typedef struct mt_composed {
    mt_references parts; /* none for a blank */
    int advance;         /* font units */
    uint32_t like;       /* the glyph that it stands in a line like: down a vertical one, and in kerning */
} mt_composed;

/* Composed glyphs have numbers from here on, which no glyph of a font has. */
enum { MT_COMPOSED_FIRST = 0x10000 };

/* Gives the drawing a number, for which the font gives an outline, advances and references from then on: the parts are copied.
 * A drawing has one number, however often it is asked for. Not for two threads at once. MT_NO_MEMORY; MT_BAD_GLYPH for glyphs
 * that the font has not; MT_TOO_LARGE when it has more of them than any writing needs. */
mt_status mt_font_compose(mt_font *font, const mt_composed *composed, uint32_t *glyph);

/* NULL for a number that is none of these. Belongs to the font. */
const mt_composed *mt_font_composed(const mt_font *font, uint32_t glyph);
