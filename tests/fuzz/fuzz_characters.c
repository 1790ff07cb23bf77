/* A file of characters to the set of them, and the same bytes as a text of the command line to characters and glyphs. */
#include "fuzz.h"

#include <stdlib.h>
#include <string.h>

#include "base/memory.h"
#include "characters_file.h"

static void read_text(const char *text, notation *reader) {
    mt_choice choice;
    char name[NOTATION_NAME_MAX + 1];
    for (const char *at = text; *at;) {
        const char *before = at;
        if (notation_next(reader, &at, &choice, name) != MT_OK) return;
        fuzz_require(at > before && at <= text + strlen(text));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    static mt_font *font; /* stays open */
    if (!font) font = fuzz_own_font("MorphotypeDemo-Sans.ttf");
    notation of_file = {.font = font}, of_text = {.font = font};
    characters set = {0};
    (void)characters_add_file(&set, fuzz_file(bytes, length), &of_file, "a font");
    characters_free(&set);
    notation_close(&of_file);
    char *text = malloc(length + 1);
    fuzz_require(text);
    if (length) memcpy(text, bytes, length);
    text[length] = '\0';
    read_text(text, &of_text);
    notation_close(&of_text);
    free(text);
    return 0;
}
