/* The tables of a font in writing, one function each; only write.c calls them. `summary` is what several
 * tables need to know of all glyphs. Every size and count was checked before (write_check.c). */
#pragma once

#include "sfnt/table.h"
#include "write/extent.h"

typedef struct mt_summary {
    mt_extent *extents;           /* of each glyph */
    mt_bounds bounds;             /* of all glyphs that have points */
    int max_points, max_contours; /* of a glyph with contours of its own */
    int max_composite_points, max_composite_contours, max_references, max_depth; /* of a composite */
    int max_advance;                                                             /* of all glyphs */
    int min_left, min_right, max_extent; /* side bearings, and the farthest xMax: of the glyphs with points */
    int max_height, min_top, min_bottom, max_vertical_extent; /* the same of vertical lines */
    bool bold, italic; /* as the style links of 'name', head and OS/2 tell it */
    size_t own_style;  /* bytes of the style's name that belong to the family there; style.h */
    uint32_t *offsets; /* into glyf: glyph_count + 1 of them */
} mt_summary;

/* write_check.c. MT_OK, MT_BAD_PARAMETER or MT_TOO_LARGE; what references lead to is mt_extents_fill's to check. */
mt_status mt_font_data_check(const mt_font_data *data);

/* write_summary.c */
void mt_summarise_style(const mt_font_data *data, mt_summary *summary); /* bold, italic and own_style */
void mt_summarise(const mt_font_data *data, mt_summary *summary); /* from the extents; all but the offsets */
/* The one of Regular, Bold, Italic and Bold Italic that the font is linked as. */
const char *mt_linked_style(const mt_summary *summary);

typedef void (*mt_write_table)(const mt_font_data *data, const mt_summary *summary, mt_table *table);

void mt_write_glyf(const mt_font_data *data, const mt_summary *summary,
                   mt_table *table); /* fills summary->offsets */
void mt_write_loca(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_hmtx(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_hhea(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_cmap(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_head(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_maxp(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_os2(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_post(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_name(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_gasp(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_prep(const mt_font_data *data, const mt_summary *summary, mt_table *table);
/* Nothing where the font has no vertical metrics. */
void mt_write_vhea(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_vmtx(const mt_font_data *data, const mt_summary *summary, mt_table *table);

/* Nothing where the font does not vary. */
void mt_write_fvar(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_stat(const mt_font_data *data, const mt_summary *summary, mt_table *table);
void mt_write_avar(const mt_font_data *data, const mt_summary *summary, mt_table *table); /* or has no map */
/* MT_NO_MEMORY, MT_TOO_LARGE for what the table has no room for. */
mt_status mt_write_gvar(const mt_font_data *data, mt_table *table);

/* write_vmtx.c: the top side bearing. */
int mt_top_bearing(const mt_glyf *glyph, const mt_extent *extent);

/* write_head.c: the first decimal number of the version text, such as 1.25 of "Version 1.25; …"; 1 without one. */
double mt_font_revision(const char *version);

/* write_cmap14.c: the subtable of variation sequences. */
void mt_write_variation_sequences(const mt_font_data *data, mt_table *table);

/* write_glyf.c: whether loca needs 32-bit offsets; known when glyf is written. */
bool mt_loca_is_long(const mt_font_data *data, const mt_summary *summary);

/* coverage.c: the bits of OS/2 ulUnicodeRange and ulCodePageRange for what the font maps. */
void mt_unicode_ranges(const mt_char *chars, int count, uint32_t bits[4]);
void mt_code_pages(const mt_char *chars, int count, bool is_symbol, uint32_t bits[2]);
bool mt_has_char(const mt_char *chars, int count, uint32_t code_point);
