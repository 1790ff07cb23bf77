/* The specimen: one page of HTML on which the variable font of two fonts or more is tried out. The font is in it; it
 * fetches nothing.
 *
 *     specimen.c  the font made and its glyphs judged, in one go; the page put together; the file
 *     font.c      what is said of the font: its name, characters and features
 *     data.c      all this as the page's script reads it
 *     page.h      the page itself, made by base/embed.py of page/page.html, page/style.css and the scripts there
 */
#pragma once

#include "report/report.h"

/* The font as it was made, in an arena but for its bytes. */
typedef struct mt_specimen_font {
    const uint8_t *bytes; /* TrueType */
    size_t length;
    const char *family; /* as it calls itself; "" where it does not */
    int char_count;
    uint32_t *chars;   /* ascending; without control characters */
    uint32_t *glyphs;  /* of each */
    uint32_t *scripts; /* of each: a tag of ISO 15924 */
    int feature_count;
    uint32_t *features; /* tags of GSUB and GPOS, ascending, each once */
} mt_specimen_font;

/* Reads a font that this program has written. MT_NO_MEMORY, MT_TOO_LARGE. */
mt_status mt_specimen_font_read(const uint8_t *bytes, size_t length, mt_arena *arena, mt_specimen_font *font);

/* What a page is put together from. */
typedef struct mt_specimen {
    const mt_specimen_request *request;
    mt_specimen_font font;
    const uint8_t *packed; /* the font as WOFF2 */
    size_t packed_length;
    mt_report_figures figures; /* of the font's glyphs */
} mt_specimen;

/* Adds what the page's script reads: JSON in which no markup can be. docs/architecture.md has its members. MT_NO_MEMORY. */
mt_status mt_specimen_data(const mt_specimen *specimen, mt_buffer *text);
/* The page in a buffer of the caller's. MT_NO_MEMORY. */
mt_status mt_specimen_html(const mt_specimen *specimen, mt_buffer *text);

/* A specimen with the font that is in it, in memory. */
typedef struct mt_specimen_made {
    uint8_t *font; /* TrueType */
    size_t font_length;
    uint8_t *packed; /* the same as WOFF2 */
    size_t packed_length;
    mt_buffer page;
} mt_specimen_made;

/* Makes the font and the page; what mt_specimen_save gives, but for the file. To be given back. */
mt_status mt_specimen_make(const mt_specimen_request *request, mt_specimen_made *made);
void mt_specimen_made_free(mt_specimen_made *made);

/* Whether the extension is that of a page, in either case. */
bool mt_specimen_is_page(const char *path);
