#include "support/code_points.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int read_file(const char *path, int most, uint32_t *chars) {
    char line[4096];
    int made = 0;
    FILE *file = fopen(path, "r");
    if (!file) return -1;
    while (fgets(line, sizeof line, file)) {
        if (line[0] == '#') continue;
        for (const unsigned char *p = (const unsigned char *)line; *p && made < most; p++) {
            if (*p >= 0xE0)
                chars[made++] = *p & 0x0F;
            else if (*p >= 0xC0)
                chars[made++] = *p & 0x1F;
            else if (*p >= 0x80 && made > 0)
                chars[made - 1] = chars[made - 1] << 6 | (*p & 0x3F);
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
