/* What the library gives in memory: one glyph of a blend, and whole fonts. */
#include "blend/choice.h"
#include "blend/instances.h"
#include "blend/variable.h"
#include "geometry/limits.h"
#include "morph/between/instance.h"
#include "write/write.h"

/* ---- one glyph ----------------------------------------------------------------------------------------- */

/* Finds both glyphs and prepares them; of a choice by name, its number counts. */
static mt_status prepare(mt_row *row, const mt_choice *choice, mt_arena *arena, mt_glyph_pair *pair) {
    mt_choice_glyphs *glyphs;
    int failed;
    *pair = (mt_glyph_pair){0};
    if (!choice->name) return mt_pair_prepare_char(row, choice->code_point, arena, pair);
    if (choice->glyph >= (uint32_t)mt_font_glyph_count(row->fonts[0])) return MT_NO_GLYPH;
    mt_status status = mt_choices_pair(row, choice, 1, arena, &glyphs, &failed);
    if (status != MT_OK) return status;
    return glyphs->b == MT_NO_PARTNER ? MT_NO_GLYPH
                                      : mt_pair_prepare(row, 0, glyphs->a, glyphs->b, arena, pair);
}

/* Where heights have a T of their own, as near to that place as the pair goes. */
static mt_status draw_pair(const mt_row *row, const mt_glyph_pair *pair, double t, mt_arena *arena,
                           mt_outline *outline, double *advance) {
    const mt_reach ends = {0, 1};
    mt_at asked = mt_row_place(row, t, 0), at;
    mt_status status = mt_pair_stand(pair, ends, asked, &row->params, arena, &at);
    if (status == MT_OK)
        status = mt_morph_outline(&pair->morph, mt_weights_of(at), &row->params, arena, outline);
    if (status == MT_OK) *advance = mt_room_between(&pair->room_a, &pair->room_b, at).advance;
    return status;
}

static mt_status draw_choice(mt_row *row, const mt_choice *choice, double t, const mt_draw *draw, void *user,
                             double *advance) {
    if (!(t >= 0 && t <= 1) || !mt_row_takes_heights(row, 1)) return MT_BAD_PARAMETER;
    mt_arena arena = {0};
    mt_glyph_pair pair;
    mt_outline outline;
    double width;
    mt_status status = prepare(row, choice, &arena, &pair);
    if (status == MT_OK) status = draw_pair(row, &pair, t, &arena, &outline, &width);
    if (status == MT_OK) {
        double scale = (double)mt_row_units(row) / MT_EM;
        mt_outline_draw(&outline, scale, draw, user);
        *advance = width * scale;
    }
    mt_arena_release(&arena);
    return status;
}

mt_status mt_blend_glyph(mt_blend *blend, uint32_t code_point, double t, const mt_draw *draw, void *user,
                         double *advance) {
    return draw_choice(&blend->row, &(mt_choice){.code_point = code_point}, t, draw, user, advance);
}

mt_status mt_blend_glyph_numbered(mt_blend *blend, uint32_t glyph, double t, const mt_draw *draw, void *user,
                                  double *advance) {
    return draw_choice(&blend->row, &(mt_choice){.name = "", .glyph = glyph}, t, draw, user, advance);
}

/* ---- fonts --------------------------------------------------------------------------------------------- */

typedef struct mt_font_bytes {
    uint8_t **bytes;
    size_t *lengths;
    int count;
} mt_font_bytes;

static mt_status keep_bytes(const mt_font_data *data, int index, void *user) {
    mt_font_bytes *fonts = user;
    mt_status status = mt_font_write(data, &fonts->bytes[index], &fonts->lengths[index]);
    if (status == MT_OK) fonts->count++;
    return status;
}

mt_status mt_blend_fonts(mt_blend *blend, const double *t, int count, uint8_t **bytes, size_t *lengths) {
    mt_font_bytes fonts = {bytes, lengths, 0};
    mt_status status = mt_blend_make(blend, t, count, keep_bytes, &fonts);
    while (status != MT_OK && fonts.count > 0) mt_bytes_free(bytes[--fonts.count]);
    return status;
}

mt_status mt_blend_font(mt_blend *blend, double t, uint8_t **bytes, size_t *length) {
    return mt_blend_fonts(blend, &t, 1, bytes, length);
}

/* ---- a variable font ----------------------------------------------------------------------------------- */

mt_status mt_variable_font(mt_variable *variable, uint8_t **bytes, size_t *length) {
    mt_font_bytes font = {bytes, length, 0};
    return mt_variable_make(variable, NULL, keep_bytes, &font);
}
