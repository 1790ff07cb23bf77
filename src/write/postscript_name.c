#include "write/postscript_name.h"

#include <hb.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/utf.h"

enum { NAME_MAX_BYTES = MT_POSTSCRIPT_NAME_ROOM - 1, STYLE_MAX_BYTES = 31, LETTERS_ROOM = 12 };

/* ---- letters ------------------------------------------------------------------------------------------- */

/* Letters that have no decomposition into one of ASCII, small ones; ascending. */
static const struct mt_letter {
    uint32_t code_point;
    const char *ascii;
} letters[] = {
    {0x00DF, "ss"},   {0x00E6, "ae"}, {0x00F0, "d"},  {0x00F8, "o"},  {0x00FE, "th"}, {0x0111, "d"},
    {0x0127, "h"},    {0x0131, "i"},  {0x0133, "ij"}, {0x0138, "k"},  {0x0142, "l"},  {0x014B, "ng"},
    {0x0153, "oe"},   {0x0167, "t"},  {0x017F, "s"},  {0x01DD, "e"},  {0x0253, "b"},  {0x0254, "o"},
    {0x0259, "e"},    {0x025B, "e"},  {0x0268, "i"},  {0x0289, "u"},  {0x03B1, "a"},  {0x03B2, "v"},
    {0x03B3, "g"},    {0x03B4, "d"},  {0x03B5, "e"},  {0x03B6, "z"},  {0x03B7, "i"},  {0x03B8, "th"},
    {0x03B9, "i"},    {0x03BA, "k"},  {0x03BB, "l"},  {0x03BC, "m"},  {0x03BD, "n"},  {0x03BE, "x"},
    {0x03BF, "o"},    {0x03C0, "p"},  {0x03C1, "r"},  {0x03C2, "s"},  {0x03C3, "s"},  {0x03C4, "t"},
    {0x03C5, "y"},    {0x03C6, "f"},  {0x03C7, "ch"}, {0x03C8, "ps"}, {0x03C9, "o"},  {0x0430, "a"},
    {0x0431, "b"},    {0x0432, "v"},  {0x0433, "g"},  {0x0434, "d"},  {0x0435, "e"},  {0x0436, "zh"},
    {0x0437, "z"},    {0x0438, "i"},  {0x0439, "j"},  {0x043A, "k"},  {0x043B, "l"},  {0x043C, "m"},
    {0x043D, "n"},    {0x043E, "o"},  {0x043F, "p"},  {0x0440, "r"},  {0x0441, "s"},  {0x0442, "t"},
    {0x0443, "u"},    {0x0444, "f"},  {0x0445, "kh"}, {0x0446, "ts"}, {0x0447, "ch"}, {0x0448, "sh"},
    {0x0449, "shch"}, {0x044A, ""},   {0x044B, "y"},  {0x044C, ""},   {0x044D, "e"},  {0x044E, "yu"},
    {0x044F, "ya"},   {0x0452, "dj"}, {0x0454, "ye"}, {0x0455, "dz"}, {0x0456, "i"},  {0x0458, "j"},
    {0x0459, "lj"},   {0x045A, "nj"}, {0x045B, "c"},  {0x045F, "dz"}, {0x0491, "g"},  {0x1E9E, "ss"},
};

static int compare(const void *key, const void *row) {
    uint32_t x = *(const uint32_t *)key, y = ((const struct mt_letter *)row)->code_point;
    return (x > y) - (x < y);
}

static const struct mt_letter *find_letter(uint32_t c) {
    return bsearch(&c, letters, sizeof letters / sizeof *letters, sizeof *letters, compare);
}

/* The small letter of a capital in the scripts of the table; any other character itself. */
static uint32_t to_small(uint32_t c) {
    if ((c >= 0xC0 && c <= 0xDE && c != 0xD7) || (c >= 0x391 && c <= 0x3A9) || (c >= 0x410 && c <= 0x42F))
        return c + 0x20;
    if (c >= 0x400 && c <= 0x40F) return c + 0x50;
    bool odd_is_small =
        (c >= 0x100 && c <= 0x137) || (c >= 0x14A && c <= 0x177) || (c >= 0x460 && c <= 0x4FF);
    if (odd_is_small) return c | 1;
    return c >= 0x139 && c <= 0x148 && c % 2 ? c + 1 : c;
}

static bool is_mark(uint32_t c) {
    return hb_unicode_general_category(hb_unicode_funcs_get_default(), c) ==
           HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK;
}

/* Writes a character beyond ASCII. Of a letter with accents the letter is written. */
static void transliterate(uint32_t c, char text[LETTERS_ROOM]) {
    hb_codepoint_t base, mark;
    const struct mt_letter *letter = find_letter(to_small(c));
    if (letter) {
        snprintf(text, LETTERS_ROOM, "%s", letter->ascii);
        if (to_small(c) != c && *text) *text = (char)(*text - 'a' + 'A');
    } else if (is_mark(c)) {
        *text = '\0';
    } else if (hb_unicode_decompose(hb_unicode_funcs_get_default(), c, &base, &mark) && base != c &&
               is_mark(mark)) {
        if (base < 0x80)
            snprintf(text, LETTERS_ROOM, "%c", (char)base);
        else
            transliterate(base, text);
    } else {
        snprintf(text, LETTERS_ROOM, "u%04X", (unsigned)c);
    }
}

/* ---- names --------------------------------------------------------------------------------------------- */

static bool is_alphanumeric(uint32_t c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/* Copies what the name may hold, at most `limit` bytes and a NUL. */
static void copy_name(const char *text, bool alphanumeric, size_t limit, char *name) {
    size_t length = 0;
    uint32_t c;
    while (mt_utf8_next(&text, &c) && c) {
        char written[LETTERS_ROOM] = {(char)c};
        bool left_out = c <= ' ' || c == 0x7F || (c < 0x7F && strchr("[](){}<>/%-", (int)c));
        if (left_out || (alphanumeric && c < 0x80 && !is_alphanumeric(c))) continue;
        if (c > 0x7F) transliterate(c, written);
        if (length + strlen(written) > limit) break;
        memcpy(name + length, written, strlen(written));
        length += strlen(written);
    }
    name[length] = '\0';
}

static void join(const char *family, bool alphanumeric, const char *style, char *name) {
    char second[STYLE_MAX_BYTES + 1];
    copy_name(style, false, STYLE_MAX_BYTES, second);
    copy_name(family, alphanumeric, NAME_MAX_BYTES - 1 - strlen(second), name);
    strcat(name, "-");
    strcat(name, second);
}

void mt_postscript_name(const char *family, const char *style, char name[MT_POSTSCRIPT_NAME_ROOM]) {
    join(family, false, style, name);
}

void mt_postscript_prefix(const char *family, char name[MT_POSTSCRIPT_NAME_ROOM]) {
    copy_name(family, true, NAME_MAX_BYTES - 1 - STYLE_MAX_BYTES, name);
}

void mt_postscript_place_name(const char *family, const char *place, char name[MT_POSTSCRIPT_NAME_ROOM]) {
    char prefix[MT_POSTSCRIPT_NAME_ROOM];
    mt_postscript_prefix(family, prefix);
    join(prefix, true, place, name);
}
