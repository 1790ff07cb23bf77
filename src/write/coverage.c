/* What a font covers, in the bits of OS/2 (OpenType spec, "OS/2": ulUnicodeRange and ulCodePageRange). */
#include "write/tables.h"

#include <stdlib.h>

static int compare_chars(const void *a, const void *b) {
    uint32_t first = ((const mt_char *)a)->code_point, second = ((const mt_char *)b)->code_point;
    return (first > second) - (first < second);
}

bool mt_has_char(const mt_char *chars, int count, uint32_t code_point) {
    mt_char key = {code_point, 0};
    return count && bsearch(&key, chars, (size_t)count, sizeof *chars, compare_chars) != NULL;
}

static void set_bit(uint32_t *bits, int bit) {
    bits[bit / 32] |= 1u << bit % 32;
}

/* ---- Unicode ranges ------------------------------------------------------------------------------------ */

enum { BEYOND_BMP = 57 };

/* The blocks of each bit, ascending; neighbours of one bit are taken together. */
static const struct {
    uint32_t first, last;
    int bit;
} ranges[] = {
    {0x0000, 0x007F, 0},     {0x0080, 0x00FF, 1},     {0x0100, 0x017F, 2},     {0x0180, 0x024F, 3},
    {0x0250, 0x02AF, 4},     {0x02B0, 0x02FF, 5},     {0x0300, 0x036F, 6},     {0x0370, 0x03FF, 7},
    {0x0400, 0x052F, 9},     {0x0530, 0x058F, 10},    {0x0590, 0x05FF, 11},    {0x0600, 0x06FF, 13},
    {0x0700, 0x074F, 71},    {0x0750, 0x077F, 13},    {0x0780, 0x07BF, 72},    {0x07C0, 0x07FF, 14},
    {0x0900, 0x097F, 15},    {0x0980, 0x09FF, 16},    {0x0A00, 0x0A7F, 17},    {0x0A80, 0x0AFF, 18},
    {0x0B00, 0x0B7F, 19},    {0x0B80, 0x0BFF, 20},    {0x0C00, 0x0C7F, 21},    {0x0C80, 0x0CFF, 22},
    {0x0D00, 0x0D7F, 23},    {0x0D80, 0x0DFF, 73},    {0x0E00, 0x0E7F, 24},    {0x0E80, 0x0EFF, 25},
    {0x0F00, 0x0FFF, 70},    {0x1000, 0x109F, 74},    {0x10A0, 0x10FF, 26},    {0x1100, 0x11FF, 28},
    {0x1200, 0x139F, 75},    {0x13A0, 0x13FF, 76},    {0x1400, 0x167F, 77},    {0x1680, 0x169F, 78},
    {0x16A0, 0x16FF, 79},    {0x1700, 0x177F, 84},    {0x1780, 0x17FF, 80},    {0x1800, 0x18AF, 81},
    {0x1900, 0x194F, 93},    {0x1950, 0x197F, 94},    {0x1980, 0x19DF, 95},    {0x19E0, 0x19FF, 80},
    {0x1A00, 0x1A1F, 96},    {0x1B00, 0x1B7F, 27},    {0x1B80, 0x1BBF, 112},   {0x1C00, 0x1C4F, 113},
    {0x1C50, 0x1C7F, 114},   {0x1D00, 0x1DBF, 4},     {0x1DC0, 0x1DFF, 6},     {0x1E00, 0x1EFF, 29},
    {0x1F00, 0x1FFF, 30},    {0x2000, 0x206F, 31},    {0x2070, 0x209F, 32},    {0x20A0, 0x20CF, 33},
    {0x20D0, 0x20FF, 34},    {0x2100, 0x214F, 35},    {0x2150, 0x218F, 36},    {0x2190, 0x21FF, 37},
    {0x2200, 0x22FF, 38},    {0x2300, 0x23FF, 39},    {0x2400, 0x243F, 40},    {0x2440, 0x245F, 41},
    {0x2460, 0x24FF, 42},    {0x2500, 0x257F, 43},    {0x2580, 0x259F, 44},    {0x25A0, 0x25FF, 45},
    {0x2600, 0x26FF, 46},    {0x2700, 0x27BF, 47},    {0x27C0, 0x27EF, 38},    {0x27F0, 0x27FF, 37},
    {0x2800, 0x28FF, 82},    {0x2900, 0x297F, 37},    {0x2980, 0x2AFF, 38},    {0x2B00, 0x2BFF, 37},
    {0x2C00, 0x2C5F, 97},    {0x2C60, 0x2C7F, 29},    {0x2C80, 0x2CFF, 8},     {0x2D00, 0x2D2F, 26},
    {0x2D30, 0x2D7F, 98},    {0x2D80, 0x2DDF, 75},    {0x2DE0, 0x2DFF, 9},     {0x2E00, 0x2E7F, 31},
    {0x2E80, 0x2FDF, 59},    {0x2FF0, 0x2FFF, 59},    {0x3000, 0x303F, 48},    {0x3040, 0x309F, 49},
    {0x30A0, 0x30FF, 50},    {0x3100, 0x312F, 51},    {0x3130, 0x318F, 52},    {0x3190, 0x319F, 59},
    {0x31A0, 0x31BF, 51},    {0x31C0, 0x31EF, 61},    {0x31F0, 0x31FF, 50},    {0x3200, 0x32FF, 54},
    {0x3300, 0x33FF, 55},    {0x3400, 0x4DBF, 59},    {0x4DC0, 0x4DFF, 99},    {0x4E00, 0x9FFF, 59},
    {0xA000, 0xA4CF, 83},    {0xA500, 0xA63F, 12},    {0xA640, 0xA69F, 9},     {0xA700, 0xA71F, 5},
    {0xA720, 0xA7FF, 29},    {0xA800, 0xA82F, 100},   {0xA840, 0xA87F, 53},    {0xA880, 0xA8DF, 115},
    {0xA900, 0xA92F, 116},   {0xA930, 0xA95F, 117},   {0xAA00, 0xAA5F, 118},   {0xAC00, 0xD7AF, 56},
    {0xE000, 0xF8FF, 60},    {0xF900, 0xFAFF, 61},    {0xFB00, 0xFB4F, 62},    {0xFB50, 0xFDFF, 63},
    {0xFE00, 0xFE0F, 91},    {0xFE10, 0xFE1F, 65},    {0xFE20, 0xFE2F, 64},    {0xFE30, 0xFE4F, 65},
    {0xFE50, 0xFE6F, 66},    {0xFE70, 0xFEFF, 67},    {0xFF00, 0xFFEF, 68},    {0xFFF0, 0xFFFF, 69},
    {0x10000, 0x1013F, 101}, {0x10140, 0x1018F, 102}, {0x10190, 0x101CF, 119}, {0x101D0, 0x101FF, 120},
    {0x10280, 0x102DF, 121}, {0x10300, 0x1032F, 85},  {0x10330, 0x1034F, 86},  {0x10380, 0x1039F, 103},
    {0x103A0, 0x103DF, 104}, {0x10400, 0x1044F, 87},  {0x10450, 0x1047F, 105}, {0x10480, 0x104AF, 106},
    {0x10800, 0x1083F, 107}, {0x10900, 0x1091F, 58},  {0x10920, 0x1093F, 121}, {0x10A00, 0x10A5F, 108},
    {0x12000, 0x1247F, 110}, {0x1D000, 0x1D24F, 88},  {0x1D300, 0x1D35F, 109}, {0x1D360, 0x1D37F, 111},
    {0x1D400, 0x1D7FF, 89},  {0x1F000, 0x1F09F, 122}, {0x20000, 0x2A6DF, 59},  {0x2F800, 0x2FA1F, 61},
    {0xE0000, 0xE007F, 92},  {0xE0100, 0xE01EF, 91},  {0xF0000, 0xFFFFD, 90},  {0x100000, 0x10FFFD, 90},
};

/* One pass over the characters and the blocks, both ascending. A bit is set by any character of its blocks. */
void mt_unicode_ranges(const mt_char *chars, int count, uint32_t bits[4]) {
    const size_t range_count = sizeof ranges / sizeof *ranges;
    for (int i = 0; i < 4; i++) bits[i] = 0;
    size_t r = 0;
    for (int i = 0; i < count; i++) {
        uint32_t c = chars[i].code_point;
        while (r < range_count && ranges[r].last < c) r++;
        if (r < range_count && ranges[r].first <= c) set_bit(bits, ranges[r].bit);
        if (c > 0xFFFF) set_bit(bits, BEYOND_BMP);
    }
}

/* ---- code pages ---------------------------------------------------------------------------------------- */

/* A code page counts as covered when the font has these of its characters, which few other pages have. */
static const struct {
    int bit;
    uint32_t samples[3]; /* 0: none */
} pages[] = {
    {0, {0x00E9, 0x00F1, 0x00F8}},  /* 1252, Latin 1: é ñ ø */
    {1, {0x0151, 0x0142, 0x010D}},  /* 1250, Latin 2: ő ł č */
    {2, {0x0416, 0x0436, 0x044F}},  /* 1251, Cyrillic: Ж ж я */
    {3, {0x03A9, 0x03C9, 0x03AC}},  /* 1253, Greek: Ω ω ά */
    {4, {0x011F, 0x0130, 0x015F}},  /* 1254, Turkish: ğ İ ş */
    {5, {0x05D0, 0x05EA, 0}},       /* 1255, Hebrew: alef, tav */
    {6, {0x0627, 0x064A, 0}},       /* 1256, Arabic: alef, yeh */
    {7, {0x0117, 0x0173, 0x013C}},  /* 1257, Baltic: ė ų ļ */
    {8, {0x01A1, 0x01B0, 0x20AB}},  /* 1258, Vietnamese: ơ ư ₫ */
    {16, {0x0E01, 0x0E2E, 0}},      /* 874, Thai: ko kai, ho nokhuk */
    {17, {0x3042, 0x30A2, 0x50CD}}, /* 932, Japanese: あ ア 働 */
    {18, {0x4EEC, 0x8FD9, 0x56FD}}, /* 936, simplified Chinese: 们 这 国 */
    {19, {0xAC00, 0xD558, 0}},      /* 949, Korean: 가 하 */
    {20, {0x5011, 0x9019, 0x570B}}, /* 950, traditional Chinese: 們 這 國 */
};

enum { SYMBOL_PAGE = 31 };

void mt_code_pages(const mt_char *chars, int count, bool is_symbol, uint32_t bits[2]) {
    bits[0] = bits[1] = 0;
    for (size_t i = 0; i < sizeof pages / sizeof *pages; i++) {
        bool covered = true;
        for (int s = 0; s < 3 && pages[i].samples[s]; s++)
            covered = covered && mt_has_char(chars, count, pages[i].samples[s]);
        if (covered) set_bit(bits, pages[i].bit);
    }
    if (is_symbol) set_bit(bits, SYMBOL_PAGE);
    if (bits[0] == 0) set_bit(bits, 0); /* a font of no page at all is not offered by some applications */
}
