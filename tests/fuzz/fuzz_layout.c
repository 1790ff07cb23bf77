/* A font's layout tables to the substitutions and positions of a new font, at one place and varying. */
#include "fuzz.h"

#include "glyphset/charset.h"
#include "gpos/positions.h"
#include "gsub/gsub.h"
#include "layout/gdef.h"
#include "source/font.h"

static void cut_substitutions(mt_font *font, mt_arena *arena) {
    mt_gsub gsub;
    mt_bytes cut;
    if (mt_gsub_open(font, arena, &gsub) != MT_OK) return;
    bool *kept = mt_arena_new(arena, (size_t)gsub.glyph_count + 1, sizeof *kept);
    fuzz_require(kept);
    for (int i = 0; i < gsub.glyph_count; i++) kept[i] = i % 5 != 4;
    (void)mt_gsub_cut(&gsub, kept, arena, &cut);
}

static void write_positions(mt_font *const fonts[2], mt_arena *arena) {
    mt_row_glyphs glyphs;
    mt_positions *positions;
    mt_bytes gpos, gdef, none = {0};
    if (mt_row_glyphs_make(fonts, 2, &(mt_charset_request){0}, arena, &glyphs) != MT_OK) return;
    if (mt_positions_prepare(fonts, &glyphs.fonts, 1000, arena, &positions) != MT_OK) return;
    (void)mt_positions_write(positions, mt_font_at_t(0.5), arena, &gpos);
    const mt_stops stops = mt_stops_even(2);
    mt_var_store store = mt_var_store_make(&stops);
    if (mt_positions_write_varying(positions, &store, arena, &gpos) == MT_OK)
        (void)mt_gdef_vary(none, &store, arena, &gdef);
    mt_var_store_free(&store);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    static mt_font *own; /* stays open */
    if (!own) own = fuzz_own_font("MorphotypeDemo-Sans.ttf");
    mt_font *font = fuzz_font(bytes, length);
    mt_arena arena = {0};
    if (!font) return 0;
    mt_arena_bound(&arena, &(mt_allowance){INT64_MAX, (size_t)256 << 20, NULL});
    cut_substitutions(font, &arena);
    write_positions((mt_font *[]){font, own}, &arena);
    write_positions((mt_font *[]){own, font}, &arena);
    mt_arena_release(&arena);
    mt_font_close(font);
    return 0;
}
