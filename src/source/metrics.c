/* A font's figures, from OS/2, hhea, post and head, or made up from the face where a format has none of them. */
#include "source/handle.h"

#include <math.h>
#include <string.h>

#include FT_BBOX_H
#include FT_OUTLINE_H
#include FT_TRUETYPE_TABLES_H
#include FT_TYPE1_TABLES_H

#include "sfnt/sfnt.h"
#include "source/panose.h"

enum { NO_OS2 = 0xFFFF, WEIGHT_REGULAR = 400, WEIGHT_BOLD = 700, WIDTH_NORMAL = 5 };

static const TT_OS2 *find_os2(const mt_font *font) {
    const TT_OS2 *os2 = FT_Get_Sfnt_Table(font->face, FT_SFNT_OS2);
    return os2 && os2->version != NO_OS2 ? os2 : NULL;
}

/* ---- lines --------------------------------------------------------------------------------------------- */

static void read_hhea(const mt_font *font, mt_metrics *metrics) {
    const FT_Face face = font->face;
    const TT_HoriHeader *hhea = FT_Get_Sfnt_Table(face, FT_SFNT_HHEA);
    if (hhea && (hhea->Ascender || hhea->Descender)) {
        metrics->hhea_ascender = hhea->Ascender;
        metrics->hhea_descender = hhea->Descender;
        metrics->hhea_line_gap = hhea->Line_Gap;
    } else {
        metrics->hhea_ascender = face->ascender;
        metrics->hhea_descender = face->descender;
        metrics->hhea_line_gap = fmax(0, (double)face->height - face->ascender + face->descender);
    }
    metrics->caret_offset = hhea ? hhea->caret_Offset : 0;
}

/* A font without vertical metrics has lines as wide as its em, their middle in the em's. */
static void read_vhea(const mt_font *font, mt_metrics *metrics) {
    const TT_VertHeader *vhea = FT_Get_Sfnt_Table(font->face, FT_SFNT_VHEA);
    double half = font->face->units_per_EM / 2.0;
    metrics->vertical = FT_IS_SFNT(font->face) && FT_HAS_VERTICAL(font->face);
    bool told = metrics->vertical && vhea && (vhea->Ascender || vhea->Descender);
    metrics->vhea_ascender = told ? vhea->Ascender : half;
    metrics->vhea_descender = told ? vhea->Descender : -half;
    metrics->vhea_line_gap = told ? vhea->Line_Gap : 0;
}

/* Without OS/2 the typographic lines are hhea's and the clipping lines those of the font's box. */
static void guess_lines(const mt_font *font, mt_metrics *metrics) {
    metrics->typo_ascender = metrics->hhea_ascender;
    metrics->typo_descender = metrics->hhea_descender;
    metrics->typo_line_gap = metrics->hhea_line_gap;
    metrics->win_ascent = fmax(0, (double)font->face->bbox.yMax);
    metrics->win_descent = fmax(0, (double)-font->face->bbox.yMin);
}

/* ---- OS/2 ---------------------------------------------------------------------------------------------- */

static void read_scripts(const TT_OS2 *os2, mt_metrics *metrics) {
    metrics->strikeout_position = os2->yStrikeoutPosition;
    metrics->strikeout_size = os2->yStrikeoutSize;
    metrics->subscript_size[0] = os2->ySubscriptXSize;
    metrics->subscript_size[1] = os2->ySubscriptYSize;
    metrics->subscript_offset[0] = os2->ySubscriptXOffset;
    metrics->subscript_offset[1] = os2->ySubscriptYOffset;
    metrics->superscript_size[0] = os2->ySuperscriptXSize;
    metrics->superscript_size[1] = os2->ySuperscriptYSize;
    metrics->superscript_offset[0] = os2->ySuperscriptXOffset;
    metrics->superscript_offset[1] = os2->ySuperscriptYOffset;
}

/* Small figures of 65 × 60 hundredths of the em, as many a typeface has them; the stroke through half the
 * x-height. */
static void guess_scripts(const mt_font *font, mt_metrics *metrics) {
    double em = font->face->units_per_EM;
    metrics->strikeout_size = metrics->underline_thickness;
    metrics->strikeout_position = (metrics->x_height + metrics->strikeout_size) / 2;
    metrics->subscript_size[0] = metrics->superscript_size[0] = 0.65 * em;
    metrics->subscript_size[1] = metrics->superscript_size[1] = 0.60 * em;
    metrics->subscript_offset[1] = 0.075 * em;
    metrics->superscript_offset[1] = 0.35 * em;
}

static void read_os2(const TT_OS2 *os2, mt_metrics *metrics) {
    enum { USE_TYPO_METRICS = 1 << 7 };
    metrics->typo_ascender = os2->sTypoAscender;
    metrics->typo_descender = os2->sTypoDescender;
    metrics->typo_line_gap = os2->sTypoLineGap;
    metrics->win_ascent = os2->usWinAscent;
    metrics->win_descent = os2->usWinDescent;
    metrics->use_typo_metrics = os2->version >= 4 && (os2->fsSelection & USE_TYPO_METRICS);
    if (os2->version >= 2) {
        metrics->x_height = os2->sxHeight;
        metrics->cap_height = os2->sCapHeight;
    }
    read_scripts(os2, metrics);
    metrics->family_class = os2->sFamilyClass;
}

/* ---- heights ------------------------------------------------------------------------------------------- */

/* The top of a character's outline; `otherwise` when it has none. */
static double measure_top(mt_font *font, FT_ULong code_point, double otherwise) {
    FT_UInt glyph = FT_Get_Char_Index(font->face, code_point);
    FT_BBox box;
    if (glyph == 0 || mt_font_load(font, glyph, FT_LOAD_NO_SCALE | FT_LOAD_IGNORE_TRANSFORM) != MT_OK)
        return otherwise;
    FT_Outline *outline = &font->face->glyph->outline;
    if (font->face->glyph->format != FT_GLYPH_FORMAT_OUTLINE || outline->n_points == 0) return otherwise;
    return FT_Outline_Get_BBox(outline, &box) == 0 ? (double)box.yMax : otherwise;
}

static void measure_heights(mt_font *font, mt_metrics *metrics) {
    double em = font->face->units_per_EM;
    if (metrics->x_height <= 0) metrics->x_height = measure_top(font, 'x', 0.5 * em);
    if (metrics->cap_height <= 0) metrics->cap_height = measure_top(font, 'H', 0.7 * em);
}

/* ---- the underline and the slant ----------------------------------------------------------------------- */

static void read_post(const mt_font *font, mt_metrics *metrics) {
    const TT_Postscript *post = FT_Get_Sfnt_Table(font->face, FT_SFNT_POST);
    PS_FontInfoRec info;
    double em = font->face->units_per_EM;
    if (post) {
        metrics->underline_position = post->underlinePosition;
        metrics->underline_thickness = post->underlineThickness;
        metrics->italic_angle = (double)post->italicAngle / 65536.0;
    } else if (FT_Get_PS_Font_Info(font->face, &info) == 0) {
        metrics->underline_thickness = info.underline_thickness;
        metrics->underline_position =
            info.underline_position + info.underline_thickness / 2.0; /* it gives the middle */
        metrics->italic_angle = (double)info.italic_angle;
    }
    if (metrics->underline_thickness <= 0) {
        metrics->underline_thickness = 0.05 * em;
        metrics->underline_position = -0.1 * em;
    }
    mt_font_axis(font, MT_TAG('s', 'l', 'n', 't'), &metrics->italic_angle);
    metrics->monospaced = FT_IS_FIXED_WIDTH(font->face) != 0;
}

/* ---- weight and width ---------------------------------------------------------------------------------- */

/* The weight class that a Type 1 font's Weight stands for. */
static double weight_by_name(const char *name) {
    static const struct {
        const char *name;
        double weight;
    } weights[] = {
        {"Thin", 100},      {"ExtraLight", 200}, {"UltraLight", 200}, {"Light", 300},
        {"SemiBold", 600},  {"DemiBold", 600},   {"Demi", 600},       {"Bold", 700},
        {"ExtraBold", 800}, {"UltraBold", 800},  {"Heavy", 800},      {"Black", 900},
    };
    for (size_t i = 0; name && i < sizeof weights / sizeof *weights; i++)
        if (strcmp(name, weights[i].name) == 0) return weights[i].weight;
    return WEIGHT_REGULAR;
}

static double guess_weight(const mt_font *font) {
    PS_FontInfoRec info;
    double weight =
        FT_Get_PS_Font_Info(font->face, &info) == 0 ? weight_by_name(info.weight) : WEIGHT_REGULAR;
    bool bold = font->face->style_flags & FT_STYLE_FLAG_BOLD;
    return bold ? fmax(weight, WEIGHT_BOLD) : weight;
}

/* The width class of a 'wdth' coordinate, a percentage (OpenType spec, "OS/2": usWidthClass), between the
 * classes too. */
static const double percents[] = {50, 62.5, 75, 87.5, 100, 112.5, 125, 150, 200};

double mt_width_class(double percent) {
    int step = 0;
    while (step < 7 && percent > percents[step + 1]) step++;
    double share = (percent - percents[step]) / (percents[step + 1] - percents[step]);
    return fmin(fmax(1 + step + share, 1), 9);
}

/* The class that the table gives; the axes' where the spec sets them ('wght' is on the scale of
 * usWeightClass). */
static void read_classes(const mt_font *font, const TT_OS2 *os2, mt_metrics *metrics) {
    double weight = os2 ? os2->usWeightClass : guess_weight(font), percent;
    double width = os2 ? os2->usWidthClass : WIDTH_NORMAL;
    if (mt_font_axis(font, MT_TAG('w', 'd', 't', 'h'), &percent)) width = mt_width_class(percent);
    mt_font_axis(font, MT_TAG('w', 'g', 'h', 't'), &weight);
    metrics->weight_class = weight >= 1 && weight <= 1000 ? weight : WEIGHT_REGULAR;
    metrics->width_class = width >= 1 && width <= 9 ? width : WIDTH_NORMAL;
}

/* A weight that the spec has set is not the table's any more. */
static void read_panose(const mt_font *font, const TT_OS2 *os2, mt_metrics *metrics) {
    double weight;
    for (int i = 0; i < 10; i++) metrics->panose[i] = os2->panose[i];
    if (mt_font_axis(font, MT_TAG('w', 'g', 'h', 't'), &weight)) metrics->panose[MT_PANOSE_WEIGHT] = 0;
}

/* ---- all of them --------------------------------------------------------------------------------------- */

void mt_font_read_metrics(mt_font *font) {
    const TT_OS2 *os2 = find_os2(font);
    const TT_Header *head = FT_Get_Sfnt_Table(font->face, FT_SFNT_HEAD);
    mt_metrics *metrics = &font->metrics;
    font->units = font->face->units_per_EM;
    font->modified = head ? (int64_t)((uint64_t)head->Modified[0] << 32 | (uint32_t)head->Modified[1]) : 0;
    font->embedding = FT_Get_FSType_Flags(font->face);
    read_hhea(font, metrics);
    read_vhea(font, metrics);
    read_post(font, metrics);
    if (os2)
        read_os2(os2, metrics);
    else
        guess_lines(font, metrics);
    measure_heights(font, metrics);
    if (!os2) guess_scripts(font, metrics);
    if (os2) read_panose(font, os2, metrics);
    read_classes(font, os2, metrics);
}

void mt_font_metrics(const mt_font *font, mt_metrics *metrics) {
    *metrics = font->metrics;
}

int64_t mt_font_modified(const mt_font *font) {
    return font->modified;
}

uint16_t mt_font_embedding(const mt_font *font) {
    return font->embedding;
}

/* ---- where the font stands ----------------------------------------------------------------------------- */

bool mt_font_is_italic(const mt_font *font) {
    return (font->face->style_flags & FT_STYLE_FLAG_ITALIC) != 0;
}

/* A class of OS/2, within what it may be. */
static bool read_class(const mt_font *font, bool width, double *value) {
    const TT_OS2 *os2 = FT_Get_Sfnt_Table(font->face, FT_SFNT_OS2);
    if (!os2 || os2->version == 0xFFFF) return false;
    int found = width ? os2->usWidthClass : os2->usWeightClass;
    if (found < 1 || found > (width ? 9 : 1000)) return false;
    *value = width ? percents[found - 1] : found;
    return true;
}

bool mt_font_stop(const mt_font *font, uint32_t tag, double *value) {
    if (mt_font_axis(font, tag, value)) return true;
    switch (tag) {
    case MT_TAG('w', 'g', 'h', 't'): return read_class(font, false, value);
    case MT_TAG('w', 'd', 't', 'h'): return read_class(font, true, value);
    case MT_TAG('s', 'l', 'n', 't'): return *value = font->metrics.italic_angle, true;
    case MT_TAG('i', 't', 'a', 'l'): return *value = mt_font_is_italic(font), true;
    default: return false;
    }
}
