#include "support/code_points.h"

#include <ft2build.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include FT_FREETYPE_H

static bool is_continuation(unsigned char byte) {
    return byte >= 0x80 && byte < 0xC0;
}

static int read_file(const char *path, int most, uint32_t *chars) {
    char line[4096];
    int made = 0;
    FILE *file = fopen(path, "r");
    if (!file) return -1;
    while (fgets(line, sizeof line, file)) {
        if (line[0] == '#') continue;
        for (const unsigned char *p = (const unsigned char *)line; *p; p++) {
            if (is_continuation(*p) && made > 0)
                chars[made - 1] = chars[made - 1] << 6 | (*p & 0x3F);
            else if (*p >= 0xC0 && made == most)
                break;
            else if (*p >= 0xC0)
                chars[made++] = *p & (*p >= 0xE0 ? 0x0F : 0x1F);
        }
    }
    fclose(file);
    return made;
}

/* How many characters of FILE:COUNT were read; -1 where that is wrong. */
static int read_count(const char *argument, const char *colon, int most, uint32_t *chars) {
    char path[4096];
    int wanted = atoi(colon + 1);
    if (wanted > most || (size_t)(colon - argument) >= sizeof path) return -1;
    memcpy(path, argument, (size_t)(colon - argument));
    path[colon - argument] = '\0';
    return read_file(path, wanted, chars);
}

int mt_test_code_points(int count, char **arguments, uint32_t *chars, int most) {
    int made = 0;
    for (int i = 0; i < count; i++) {
        unsigned first, last;
        const char *colon = strrchr(arguments[i], ':');
        if (colon) {
            int read = read_count(arguments[i], colon, most - made, chars + made);
            if (read < 0) return -1;
            made += read;
            continue;
        }
        if (sscanf(arguments[i], "%x-%x", &first, &last) != 2) return -1;
        for (unsigned c = first; c <= last && made < most; c++) chars[made++] = c;
    }
    return made;
}

/* Opens FILE or FILE#FACE. */
static FT_Face open_face(FT_Library library, const char *font) {
    char path[4096];
    FT_Face face;
    const char *number = strchr(font, '#');
    snprintf(path, sizeof path, "%.*s", (int)strcspn(font, "#"), font);
    return FT_New_Face(library, path, number ? atol(number + 1) : 0, &face) == 0 ? face : NULL;
}

int mt_test_count_in_both(const char *a, const char *b, const uint32_t *code_points, int count) {
    FT_Library library;
    int found = 0;
    if (FT_Init_FreeType(&library) != 0) return -1;
    FT_Face in_a = open_face(library, a), in_b = open_face(library, b);
    for (int i = 0; in_a && in_b && i < count; i++)
        found += FT_Get_Char_Index(in_a, code_points[i]) && FT_Get_Char_Index(in_b, code_points[i]);
    bool opened = in_a && in_b;
    FT_Done_FreeType(library);
    return opened ? found : -1;
}
