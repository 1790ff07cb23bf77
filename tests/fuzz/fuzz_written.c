/* A font blended with another, and what is written read back: a font whose glyphs all have outlines. */
#include "fuzz.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "source/font.h"

enum { GLYPHS = 16 }; /* of a font, at most, so that each run is short */

static char folder[] = "/tmp/morphotype-fuzz-XXXXXX";

static void remove_folder(void) {
    rmdir(folder);
}

static const char *output(void) {
    static char path[sizeof folder + 16];
    if (path[0]) return path;
    fuzz_require(mkdtemp(folder));
    atexit(remove_folder);
    snprintf(path, sizeof path, "%s/out.ttf", folder);
    return path;
}

static void read_back(const char *path) {
    mt_font *font;
    mt_arena arena = {0};
    mt_status opened = mt_font_open(path, &font);
    fuzz_require(unlink(path) == 0);
    fuzz_require(opened == MT_OK);
    for (int i = 0; i < mt_font_glyph_count(font); i++) {
        mt_outline outline;
        double advance;
        fuzz_require(mt_font_outline(font, (uint32_t)i, &arena, &outline, &advance) == MT_OK);
        mt_arena_reset(&arena);
    }
    mt_arena_release(&arena);
    mt_font_close(font);
}

static mt_status blend(mt_font *a, mt_font *b, const mt_params *params, const char *path) {
    mt_blend *made;
    mt_status status = mt_blend_new(a, b, params, &made);
    if (status != MT_OK) return status;
    status = mt_blend_save(made, 0.5, path);
    mt_blend_free(made);
    return status;
}

static mt_status vary(mt_font *a, mt_font *b, const mt_params *params, const char *path) {
    mt_variable *made;
    mt_status status = mt_variable_new((mt_font *[]){a, b}, 2, params, &made);
    if (status != MT_OK) return status;
    status = mt_variable_save(made, path);
    mt_variable_free(made);
    return status;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    static mt_font *own; /* stays open */
    if (!own) own = fuzz_own_font("MorphotypeDemo-Sans.ttf");
    mt_font *font = fuzz_font(bytes, length);
    if (!font) return 0;
    mt_params params = mt_params_default();
    params.effort = 0.01;
    params.threads = 1;
    bool small = mt_font_glyph_count(font) <= GLYPHS;
    if (small && blend(font, own, &params, output()) == MT_OK) read_back(output());
    if (small && vary(own, font, &params, output()) == MT_OK) read_back(output());
    mt_font_close(font);
    return 0;
}
