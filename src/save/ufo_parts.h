/* The parts of a UFO, a function each; only ufo.c calls them. */
#pragma once

#include "base/memory.h"
#include "base/xml.h"
#include "fea/fea.h"
#include "gpos/kerning.h"
#include "write/font_data.h"

/* What the parts share of the glyphs, which belongs to an arena. */
typedef struct mt_ufo_glyphs {
    const char **names; /* unique: letters, digits, dots and underscores, the first of them no digit */
    const char *const *old_names; /* the font's own, which some of these are not; NULL: none */
    int *starts;                  /* code points of glyph i: code_points[starts[i] … starts[i + 1]) */
    uint32_t *code_points;        /* ascending for each glyph */
} mt_ufo_glyphs;

/* ufo_glyphs.c. MT_NO_MEMORY. */
mt_status mt_ufo_glyphs_make(const mt_font_data *data, mt_arena *arena, mt_ufo_glyphs *glyphs);

/* ufo_files.c: the names of the glyphs' files, by UFO 3's "Common User Name to File Name Algorithm". MT_NO_MEMORY. */
mt_status mt_ufo_file_names(const char *const *names, int count, mt_arena *arena, const char ***files);

/* ufo_features.c: the layout as text and anchors. As mt_fea_make. */
mt_status mt_ufo_features(const mt_font_data *data, const mt_ufo_glyphs *glyphs, mt_arena *arena,
                          mt_fea *fea);

/* ufo_glif.c: one glyph's GLIF 2 document. */
void mt_ufo_glif(const mt_font_data *data, const mt_ufo_glyphs *glyphs, const mt_fea *fea, int glyph,
                 mt_xml *xml);

/* ufo_info.c: fontinfo.plist. */
void mt_ufo_info(const mt_font_data *data, mt_xml *xml);

/* What groups.plist and kerning.plist share, which belongs to an arena. */
typedef struct mt_ufo_kerning {
    const mt_kerning *of;
    const char **left, **right; /* the groups' names */
    int pair_count;
    mt_kerning_pair *pairs; /* those with the same left side one after another */
} mt_ufo_kerning;

/* ufo_kerning.c. MT_NO_MEMORY. */
mt_status mt_ufo_kerning_make(const mt_kerning *of, const mt_ufo_glyphs *glyphs, mt_arena *arena,
                              mt_ufo_kerning *kerning);
void mt_ufo_groups(const mt_ufo_kerning *kerning, const mt_ufo_glyphs *glyphs, mt_xml *xml);
void mt_ufo_pairs(const mt_ufo_kerning *kerning, const mt_ufo_glyphs *glyphs, mt_xml *xml);
