/* What a UFO says of the font as a whole: fontinfo.plist. Glyphs' own figures stand in their files; what a compiler works
 * out from glyphs and characters is left to it. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "save/ufo_parts.h"
#include "write/postscript_name.h"
#include "write/tables.h"

/* ---- figures ---------------------------------------------------------------------------------------------- */

/* The nearest whole number in a range; 0, which each range here holds or is near to, for what is no number. */
static int whole(double value, int low, int high) {
    if (isnan(value)) value = 0;
    return (int)fmin(fmax(floor(value + 0.5), low), high);
}

static void put(mt_xml *xml, const char *key, double value) {
    mt_plist_integer(xml, key, whole(value, INT16_MIN, INT16_MAX));
}

/* The numbers of the bits that are set. */
static void put_bits(mt_xml *xml, const char *key, const uint32_t *bits, int words) {
    mt_plist_group(xml, key, "array");
    for (int i = 0; i < 32 * words; i++)
        if (bits[i / 32] >> i % 32 & 1) mt_plist_integer(xml, NULL, i);
    mt_xml_close(xml);
}

static void put_pair(mt_xml *xml, const char *x_key, const char *y_key, const double pair[2]) {
    put(xml, x_key, pair[0]);
    put(xml, y_key, pair[1]);
}

/* ---- names and dates -------------------------------------------------------------------------------------- */

/* Seconds since 1904. */
static void put_date(int64_t seconds, mt_xml *xml) {
    char text[32];
    struct tm date;
    time_t since_1970 = (time_t)(seconds - 2082844800);
    if (!gmtime_r(&since_1970, &date) || date.tm_year > 9999 - 1900) return;
    strftime(text, sizeof text, "%Y/%m/%d %H:%M:%S", &date);
    mt_plist_string(xml, "openTypeHeadCreated", text);
}

/* The style as old applications link it goes in small letters: "bold italic". */
static void put_linked_style(const char *style, mt_xml *xml) {
    char small[16] = "";
    for (size_t i = 0; style[i] && i < sizeof small - 1; i++)
        small[i] = (char)(style[i] | (style[i] == ' ' ? 0 : 0x20));
    mt_plist_string(xml, "styleMapStyleName", small);
}

/* The first name, and after a blank the first `length` bytes of the second where these are any. */
static void put_full_name(mt_xml *xml, const char *key, const char *first, const char *second,
                          size_t length) {
    size_t room = strlen(first) + length + 2;
    char *text = mt_new(room, 1);
    if (!text) {
        xml->failed = true;
        return;
    }
    snprintf(text, room, "%s%s%.*s", first, length ? " " : "", (int)length, second);
    mt_plist_string(xml, key, text);
    mt_free(text);
}

/* As the table 'name' has them (write_name.c). */
static void put_names(const mt_font_data *data, const mt_summary *summary, mt_xml *xml) {
    char postscript[MT_POSTSCRIPT_NAME_ROOM];
    const char *linked = mt_linked_style(summary);
    double revision = mt_font_revision(data->version);
    mt_postscript_name(data->family, data->style, postscript);
    mt_plist_string(xml, "familyName", data->family);
    mt_plist_string(xml, "styleName", data->style);
    put_full_name(xml, "styleMapFamilyName", data->family, data->style, summary->own_style);
    put_linked_style(linked, xml);
    mt_plist_integer(xml, "versionMajor", whole(floor(revision), 0, INT16_MAX));
    mt_plist_integer(xml, "versionMinor", whole((revision - floor(revision)) * 1000, 0, 999));
    mt_plist_string(xml, "copyright", data->copyright);
    mt_plist_string(xml, "trademark", data->trademark);
    mt_plist_string(xml, "postscriptFontName", postscript);
    put_full_name(xml, "postscriptFullName", data->family, data->style, strlen(data->style));
    mt_plist_string(xml, "openTypeNamePreferredFamilyName", data->family);
    mt_plist_string(xml, "openTypeNamePreferredSubfamilyName", data->style);
    mt_plist_string(xml, "openTypeNameUniqueID", data->unique_id);
    mt_plist_string(xml, "openTypeNameVersion", data->version);
    mt_plist_string(xml, "openTypeNameDescription", data->description);
    mt_plist_string(xml, "openTypeNameDesigner", data->designer);
    mt_plist_string(xml, "openTypeNameLicense", data->license);
    mt_plist_string(xml, "openTypeNameLicenseURL", data->license_url);
}

/* ---- the tables' figures ---------------------------------------------------------------------------------- */

static void put_heights(const mt_font_data *data, mt_xml *xml) {
    const mt_metrics *metrics = &data->metrics;
    mt_plist_integer(xml, "unitsPerEm", data->units);
    put(xml, "ascender", metrics->typo_ascender);
    mt_plist_integer(xml, "descender", whole(metrics->typo_descender, INT16_MIN, 0));
    put(xml, "xHeight", metrics->x_height);
    put(xml, "capHeight", metrics->cap_height);
    mt_plist_real(xml, "italicAngle", metrics->italic_angle);
    put(xml, "openTypeHheaAscender", metrics->hhea_ascender);
    put(xml, "openTypeHheaDescender", metrics->hhea_descender);
    put(xml, "openTypeHheaLineGap", metrics->hhea_line_gap);
    put(xml, "openTypeHheaCaretOffset", metrics->caret_offset);
}

static void put_vertical(const mt_metrics *metrics, mt_xml *xml) {
    put(xml, "openTypeVheaVertTypoAscender", metrics->vhea_ascender);
    put(xml, "openTypeVheaVertTypoDescender", metrics->vhea_descender);
    put(xml, "openTypeVheaVertTypoLineGap", metrics->vhea_line_gap);
    put(xml, "openTypeVheaCaretSlopeRise", 0); /* the caret lies across the line */
    put(xml, "openTypeVheaCaretSlopeRun", 1);
    put(xml, "openTypeVheaCaretOffset", 0);
}

static void put_os2_heights(const mt_metrics *metrics, mt_xml *xml) {
    put(xml, "openTypeOS2TypoAscender", metrics->typo_ascender);
    put(xml, "openTypeOS2TypoDescender", metrics->typo_descender);
    put(xml, "openTypeOS2TypoLineGap", metrics->typo_line_gap);
    mt_plist_integer(xml, "openTypeOS2WinAscent", whole(metrics->win_ascent, 0, UINT16_MAX));
    mt_plist_integer(xml, "openTypeOS2WinDescent", whole(metrics->win_descent, 0, UINT16_MAX));
    put_pair(xml, "openTypeOS2SubscriptXSize", "openTypeOS2SubscriptYSize", metrics->subscript_size);
    put_pair(xml, "openTypeOS2SubscriptXOffset", "openTypeOS2SubscriptYOffset", metrics->subscript_offset);
    put_pair(xml, "openTypeOS2SuperscriptXSize", "openTypeOS2SuperscriptYSize", metrics->superscript_size);
    put_pair(xml, "openTypeOS2SuperscriptXOffset", "openTypeOS2SuperscriptYOffset",
             metrics->superscript_offset);
    put(xml, "openTypeOS2StrikeoutSize", metrics->strikeout_size);
    put(xml, "openTypeOS2StrikeoutPosition", metrics->strikeout_position);
}

/* The class in the high byte and the subclass in the low one, where they are of those that a UFO may name. */
static void put_family(const mt_metrics *metrics, mt_xml *xml) {
    mt_plist_group(xml, "openTypeOS2Panose", "array");
    for (int i = 0; i < 10; i++) mt_plist_integer(xml, NULL, metrics->panose[i]);
    mt_xml_close(xml);
    int family = metrics->family_class >> 8 & 0xFF, kind = metrics->family_class & 0xFF;
    if (family > 14 || kind > 15) return;
    mt_plist_group(xml, "openTypeOS2FamilyClass", "array");
    mt_plist_integer(xml, NULL, family);
    mt_plist_integer(xml, NULL, kind);
    mt_xml_close(xml);
}

/* Of fsSelection, italic, bold and regular are told by the style's name. */
static void put_os2(const mt_font_data *data, mt_xml *xml) {
    enum { USE_TYPO_METRICS = 1 << 7 };
    const uint32_t selection = data->metrics.use_typo_metrics ? USE_TYPO_METRICS : 0, type = data->embedding;
    uint32_t ranges[4], pages[2];
    mt_unicode_ranges(data->chars, data->char_count, ranges);
    mt_code_pages(data->chars, data->char_count, data->is_symbol, pages);
    mt_plist_integer(xml, "openTypeOS2WeightClass", whole(data->metrics.weight_class, 1, 1000));
    mt_plist_integer(xml, "openTypeOS2WidthClass", whole(data->metrics.width_class, 1, 9));
    put_bits(xml, "openTypeOS2Type", &type, 1);
    put_bits(xml, "openTypeOS2Selection", &selection, 1);
    put_bits(xml, "openTypeOS2UnicodeRanges", ranges, 4);
    put_bits(xml, "openTypeOS2CodePageRanges", pages, 2);
    put_family(&data->metrics, xml);
    put_os2_heights(&data->metrics, xml);
}

/* Every size alike, as the table 'gasp' has it (write_gasp.c). */
static void put_gasp(mt_xml *xml) {
    const uint32_t behaviour = 1 << 0 | 1 << 1 | 1 << 2 | 1 << 3; /* grid-fitted and smoothed, both ways */
    mt_plist_group(xml, "openTypeGaspRangeRecords", "array");
    mt_plist_group(xml, NULL, "dict");
    mt_plist_integer(xml, "rangeMaxPPEM", UINT16_MAX);
    put_bits(xml, "rangeGaspBehavior", &behaviour, 1);
    mt_xml_close(xml);
    mt_xml_close(xml);
}

static void put_postscript(const mt_metrics *metrics, mt_xml *xml) {
    mt_plist_bool(xml, "postscriptIsFixedPitch", metrics->monospaced);
    put(xml, "postscriptUnderlinePosition", metrics->underline_position);
    put(xml, "postscriptUnderlineThickness", metrics->underline_thickness);
}

void mt_ufo_info(const mt_font_data *data, mt_xml *xml) {
    mt_summary summary = {0};
    mt_summarise_style(data, &summary);
    mt_plist_open(xml, "dict");
    put_names(data, &summary, xml);
    put_date(data->created, xml);
    put_heights(data, xml);
    if (data->metrics.vertical) put_vertical(&data->metrics, xml);
    put_os2(data, xml);
    put_postscript(&data->metrics, xml);
    put_gasp(xml);
    mt_plist_close(xml);
}
