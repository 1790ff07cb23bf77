/* The variable font of two or more fonts: what it goes by. */
#include "blend/variable_job.h"
#include "write/write.h"

#include "save/save.h"

mt_status mt_variable_new(mt_font *const *fonts, int count, const mt_params *params, mt_variable **variable) {
    if (count < 2 || count > MT_VARIABLE_FONTS_MAX) return MT_BAD_PARAMETER;
    mt_variable *made = mt_new(1, sizeof *made);
    mt_font **copy = mt_new((size_t)count, sizeof *copy);
    mt_blend **steps = mt_new((size_t)count - 1, sizeof *steps);
    mt_status status = made && copy && steps ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i + 1 < count && status == MT_OK; i++)
        status = mt_blend_new(fonts[i], fonts[i + 1], params, &steps[i]);
    if (status != MT_OK) {
        for (int i = 0; steps && i + 1 < count; i++) mt_blend_free(steps[i]);
        mt_free(made);
        mt_free(copy);
        mt_free(steps);
        return status;
    }
    for (int i = 0; i < count; i++) copy[i] = fonts[i];
    *made = (mt_variable){.count = count, .fonts = copy, .steps = steps};
    *variable = made;
    return MT_OK;
}

void mt_variable_free(mt_variable *variable) {
    if (!variable) return;
    for (int i = 0; i + 1 < variable->count; i++) mt_blend_free(variable->steps[i]);
    mt_free(variable->steps);
    mt_free(variable->fonts);
    mt_axis_map_free(&variable->map);
    mt_free(variable);
}

void mt_variable_on_failure(mt_variable *variable, mt_glyph_failed call, void *user) {
    for (int i = 0; i + 1 < variable->count; i++) mt_blend_on_failure(variable->steps[i], call, user);
}

void mt_variable_on_progress(mt_variable *variable, mt_progress call, void *user) {
    variable->progress = call;
    variable->progress_user = user;
}

mt_status mt_variable_set_family(mt_variable *variable, const char *name) {
    return mt_blend_set_family(variable->steps[0], name);
}

mt_status mt_variable_set_chars(mt_variable *variable, const uint32_t *code_points, int count) {
    return mt_blend_set_chars(variable->steps[0], code_points, count);
}

void mt_variable_set_glyphs(mt_variable *variable, mt_glyph_set set) {
    mt_blend_set_glyphs(variable->steps[0], set);
}

mt_status mt_variable_set_map(mt_variable *variable, const double *values, const double *places, int count) {
    mt_axis_map map = {0};
    mt_status status = count == 0 ? MT_OK : mt_axis_map_make(values, places, count, &map);
    if (status != MT_OK) return status;
    mt_axis_map_free(&variable->map);
    variable->map = map;
    return MT_OK;
}

const mt_axis_map *mt_variable_map(const mt_variable *variable) {
    return &variable->map;
}

int mt_variable_unblended(const mt_variable *variable) {
    return mt_blend_unblended(variable->steps[0]);
}

mt_status mt_variable_set_hints(mt_variable *variable, const mt_hint_table *table, mt_hint_error *error) {
    mt_status status = MT_OK;
    for (int i = 0; i + 1 < variable->count && status == MT_OK; i++)
        status = mt_blend_set_hints(variable->steps[i], table, error);
    return status;
}

const mt_hint_index *mt_variable_hints(const mt_variable *variable, int step) {
    return mt_blend_hints(variable->steps[step]);
}

mt_status mt_variable_warnings(const mt_variable *variable, mt_warning call, void *user) {
    mt_status status = MT_OK;
    for (int i = 0; i + 1 < variable->count && status == MT_OK; i++)
        status = mt_blend_warnings(variable->steps[i], call, user);
    return status;
}

/* ---- in memory ----------------------------------------------------------------------------------------- */

typedef struct mt_one_font {
    uint8_t *bytes;
    size_t length;
} mt_one_font;

static mt_status keep_bytes(const mt_font_data *data, int index, void *user) {
    mt_one_font *font = user;
    (void)index;
    return mt_font_write(data, &font->bytes, &font->length);
}

mt_status mt_variable_font(mt_variable *variable, uint8_t **bytes, size_t *length) {
    mt_one_font font;
    mt_status status = mt_variable_make(variable, keep_bytes, &font);
    if (status != MT_OK) return status;
    *bytes = font.bytes;
    *length = font.length;
    return MT_OK;
}
