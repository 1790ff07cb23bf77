/* The positions of two fonts blended, and HarfBuzz's widths of texts in the blend and in both. */
#pragma once

#include <hb.h>

#include "glyphset/charset.h"
#include "gpos/positions.h"

/* A source: as this program opens it, and as HarfBuzz does. */
typedef struct mt_test_end {
    mt_font *font;
    hb_font_t *shaping;
} mt_test_end;

/* Skips the test when the file is not there. `weight` is the place on the weight axis that the spec names; 0 for none. */
mt_test_end mt_test_open_end(const char *path, const char *spec, float weight);

typedef struct mt_test_blend {
    mt_arena *arena;
    mt_test_end ends[2];
    int units;
    mt_charset charset;
    mt_positions *positions;
} mt_test_blend;

/* charsets[k] pairs the first font's glyphs with those of font k + 1; all have the same glyphs of the first font.
 * MT_NO_MEMORY. */
mt_status mt_test_font_glyphs(const mt_charset *charsets, int font_count, mt_arena *arena,
                              mt_font_glyphs *glyphs);
/* The positions of `count` fonts; charsets[k] pairs the first with font k + 1. As mt_positions_prepare. */
mt_status mt_test_positions(mt_font *const *fonts, const mt_charset *charsets, int count, int units,
                            mt_arena *arena, mt_positions **positions);

/* Of all characters that both fonts have. */
mt_test_blend mt_test_blend_of(mt_test_end a, mt_test_end b, mt_arena *arena);
/* Its positions anew, when the charset was changed. */
void mt_test_blend_prepare(mt_test_blend *blend);
void mt_test_blend_close(mt_test_blend *blend); /* and both ends */

/* A blend at one T: a font of blank glyphs, and what was found as it was compared with its ends. */
typedef struct mt_test_place {
    const mt_test_blend *blend;
    double t;
    hb_font_t *font;
    hb_buffer_t *buffer;
    hb_feature_t feature; /* that is switched on in all texts; none at first */
    size_t gpos_length;
    double worst; /* difference of a text's width from the mix of the ends', units a glyph */
    int kerned;   /* texts that are not as wide as their glyphs */
} mt_test_place;

mt_test_place mt_test_place_at(const mt_test_blend *blend, double t);
/* The same, but a varying font at that place of its axis. */
mt_test_place mt_test_varying_place_at(const mt_test_blend *blend, double t);
void mt_test_place_close(mt_test_place *place);

/* Shapes the text in all three fonts; fails when the blend's width is off by more than a unit a glyph. */
void mt_test_compare(mt_test_place *place, const uint32_t *text, int length);

/* A GPOS table of one script with one feature of one lookup. */
mt_bytes mt_test_one_lookup(uint32_t script, uint32_t feature, int type, const mt_bytes *subtables, int count,
                            mt_arena *arena);

/* Saves a font of blank glyphs, 500 units wide, for `count` characters from `first` on (glyph 1 is the first), with one
 * more table unless that is empty. */
void mt_test_save_blank(const char *path, int units, uint32_t first, int count, uint32_t tag, mt_bytes table,
                        mt_arena *arena);
