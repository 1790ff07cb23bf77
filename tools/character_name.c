/* How a message names a character, so that it can be seen. */
#include "characters.h"

#include "base/utf.h"

#include <hb.h>
#include <stdio.h>
#include <stdlib.h>

#define DOTTED_CIRCLE "\xe2\x97\x8c" /* U+25CC: what a mark by itself is shown on */

/* Characters without ink that texts have, by their names in Unicode; ascending. */
static const struct unseen {
    uint32_t code_point;
    const char *name;
} unseen[] = {
    {0x0009, "TAB"},
    {0x0020, "SPACE"},
    {0x00A0, "NO-BREAK SPACE"},
    {0x00AD, "SOFT HYPHEN"},
    {0x034F, "COMBINING GRAPHEME JOINER"},
    {0x061C, "ARABIC LETTER MARK"},
    {0x115F, "HANGUL CHOSEONG FILLER"},
    {0x1160, "HANGUL JUNGSEONG FILLER"},
    {0x1680, "OGHAM SPACE MARK"},
    {0x17B4, "KHMER VOWEL INHERENT AQ"},
    {0x17B5, "KHMER VOWEL INHERENT AA"},
    {0x180E, "MONGOLIAN VOWEL SEPARATOR"},
    {0x2000, "EN QUAD"},
    {0x2001, "EM QUAD"},
    {0x2002, "EN SPACE"},
    {0x2003, "EM SPACE"},
    {0x2004, "THREE-PER-EM SPACE"},
    {0x2005, "FOUR-PER-EM SPACE"},
    {0x2006, "SIX-PER-EM SPACE"},
    {0x2007, "FIGURE SPACE"},
    {0x2008, "PUNCTUATION SPACE"},
    {0x2009, "THIN SPACE"},
    {0x200A, "HAIR SPACE"},
    {0x200B, "ZERO WIDTH SPACE"},
    {0x200C, "ZERO WIDTH NON-JOINER"},
    {0x200D, "ZERO WIDTH JOINER"},
    {0x200E, "LEFT-TO-RIGHT MARK"},
    {0x200F, "RIGHT-TO-LEFT MARK"},
    {0x2028, "LINE SEPARATOR"},
    {0x2029, "PARAGRAPH SEPARATOR"},
    {0x202A, "LEFT-TO-RIGHT EMBEDDING"},
    {0x202B, "RIGHT-TO-LEFT EMBEDDING"},
    {0x202C, "POP DIRECTIONAL FORMATTING"},
    {0x202D, "LEFT-TO-RIGHT OVERRIDE"},
    {0x202E, "RIGHT-TO-LEFT OVERRIDE"},
    {0x202F, "NARROW NO-BREAK SPACE"},
    {0x205F, "MEDIUM MATHEMATICAL SPACE"},
    {0x2060, "WORD JOINER"},
    {0x2061, "FUNCTION APPLICATION"},
    {0x2062, "INVISIBLE TIMES"},
    {0x2063, "INVISIBLE SEPARATOR"},
    {0x2064, "INVISIBLE PLUS"},
    {0x2066, "LEFT-TO-RIGHT ISOLATE"},
    {0x2067, "RIGHT-TO-LEFT ISOLATE"},
    {0x2068, "FIRST STRONG ISOLATE"},
    {0x2069, "POP DIRECTIONAL ISOLATE"},
    {0x2800, "BRAILLE PATTERN BLANK"},
    {0x3000, "IDEOGRAPHIC SPACE"},
    {0x3164, "HANGUL FILLER"},
    {0xFEFF, "ZERO WIDTH NO-BREAK SPACE"},
    {0xFFA0, "HALFWIDTH HANGUL FILLER"},
};

static int compare(const void *key, const void *row) {
    uint32_t x = *(const uint32_t *)key, y = ((const struct unseen *)row)->code_point;
    return (x > y) - (x < y);
}

/* The number of a variation selector; 0 for any other character. */
static int selector_number(uint32_t c) {
    if (c >= 0xFE00 && c <= 0xFE0F) return (int)(c - 0xFE00) + 1;
    return c >= 0xE0100 && c <= 0xE01EF ? (int)(c - 0xE0100) + 17 : 0;
}

static hb_unicode_general_category_t category_of(uint32_t code_point) {
    return hb_unicode_general_category(hb_unicode_funcs_get_default(), code_point);
}

static bool is_mark(hb_unicode_general_category_t category) {
    return category == HB_UNICODE_GENERAL_CATEGORY_NON_SPACING_MARK ||
           category == HB_UNICODE_GENERAL_CATEGORY_SPACING_MARK ||
           category == HB_UNICODE_GENERAL_CATEGORY_ENCLOSING_MARK;
}

/* Whether the category is one of what shows nothing, or something else on each machine. */
static bool is_hidden(hb_unicode_general_category_t category) {
    switch (category) {
    case HB_UNICODE_GENERAL_CATEGORY_CONTROL:
    case HB_UNICODE_GENERAL_CATEGORY_FORMAT:
    case HB_UNICODE_GENERAL_CATEGORY_UNASSIGNED:
    case HB_UNICODE_GENERAL_CATEGORY_PRIVATE_USE:
    case HB_UNICODE_GENERAL_CATEGORY_SURROGATE:
    case HB_UNICODE_GENERAL_CATEGORY_LINE_SEPARATOR:
    case HB_UNICODE_GENERAL_CATEGORY_PARAGRAPH_SEPARATOR:
    case HB_UNICODE_GENERAL_CATEGORY_SPACE_SEPARATOR: return true;
    default: return false;
    }
}

static const struct unseen *find_unseen(uint32_t code_point) {
    return bsearch(&code_point, unseen, sizeof unseen / sizeof *unseen, sizeof *unseen, compare);
}

bool character_is_seen(uint32_t code_point) {
    if (code_point == ' ') return true;
    return !find_unseen(code_point) && !selector_number(code_point) && !is_hidden(category_of(code_point));
}

void character_describe(uint32_t code_point, char *text, size_t room) {
    char utf8[5] = "";
    unsigned long number = code_point;
    hb_unicode_general_category_t category = category_of(code_point);
    int selector = selector_number(code_point);
    const struct unseen *row = find_unseen(code_point);
    if (row)
        snprintf(text, room, "U+%04lX %s", number, row->name);
    else if (selector)
        snprintf(text, room, "U+%04lX VARIATION SELECTOR-%d", number, selector);
    else if (is_hidden(category))
        snprintf(text, room, "U+%04lX", number);
    else {
        mt_utf8_put(code_point, utf8);
        snprintf(text, room, "“%s%s” (U+%04lX)", is_mark(category) ? DOTTED_CIRCLE : "", utf8, number);
    }
}
