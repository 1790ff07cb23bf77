/* Fonts of a blend in memory, read by HarfBuzz: text shaped, measured and drawn with Cairo. */
#include "picture/typeset.h"

#include "base/memory.h"
#include "blend/instances.h"
#include "write/write.h"

/* ---- glyphs as Cairo paths ----------------------------------------------------------------------------- */

static void move_to(hb_draw_funcs_t *draw, void *cairo, hb_draw_state_t *state, float x, float y,
                    void *user) {
    (void)draw, (void)state, (void)user;
    cairo_move_to(cairo, x, y);
}

static void line_to(hb_draw_funcs_t *draw, void *cairo, hb_draw_state_t *state, float x, float y,
                    void *user) {
    (void)draw, (void)state, (void)user;
    cairo_line_to(cairo, x, y);
}

static void cubic_to(hb_draw_funcs_t *draw, void *cairo, hb_draw_state_t *state, float x1, float y1, float x2,
                     float y2, float x, float y, void *user) {
    (void)draw, (void)state, (void)user;
    cairo_curve_to(cairo, x1, y1, x2, y2, x, y);
}

static void close_path(hb_draw_funcs_t *draw, void *cairo, hb_draw_state_t *state, void *user) {
    (void)draw, (void)state, (void)user;
    cairo_close_path(cairo);
}

/* Without a quadratic function HarfBuzz raises quadratics to cubics, which are what Cairo has. */
static hb_draw_funcs_t *make_draw_funcs(void) {
    hb_draw_funcs_t *draw = hb_draw_funcs_create();
    hb_draw_funcs_set_move_to_func(draw, move_to, NULL, NULL);
    hb_draw_funcs_set_line_to_func(draw, line_to, NULL, NULL);
    hb_draw_funcs_set_cubic_to_func(draw, cubic_to, NULL, NULL);
    hb_draw_funcs_set_close_path_func(draw, close_path, NULL, NULL);
    return draw;
}

static void add_glyph(const mt_typeset *instance, uint32_t glyph, cairo_t *cairo, double x, double y,
                      double size) {
    cairo_save(cairo);
    cairo_translate(cairo, x, y);
    cairo_scale(cairo, size / instance->units, -size / instance->units);
    hb_font_get_glyph_shape(instance->font, glyph, instance->draw, cairo);
    cairo_restore(cairo);
}

static void fill(cairo_t *cairo) {
    cairo_set_fill_rule(cairo, CAIRO_FILL_RULE_WINDING);
    cairo_fill(cairo);
}

void mt_glyph_draw(const mt_typeset *instance, uint32_t glyph, cairo_t *cairo, double x, double y,
                   double size) {
    cairo_new_path(cairo);
    add_glyph(instance, glyph, cairo, x, y, size);
    fill(cairo);
}

/* ---- instances ----------------------------------------------------------------------------------------- */

static void read_extents(mt_typeset *instance) {
    hb_font_extents_t extents = {0};
    hb_font_get_h_extents(instance->font, &extents);
    instance->ascent = extents.ascender / instance->units;
    instance->descent = -extents.descender / instance->units;
}

/* HarfBuzz gives an empty object, not NULL, when it runs out of memory. */
static mt_status open_bytes(mt_typeset *instance, size_t length) {
    if (length > UINT32_MAX) return MT_TOO_LARGE;
    hb_blob_t *blob =
        hb_blob_create((const char *)instance->bytes, (unsigned)length, HB_MEMORY_MODE_READONLY, NULL, NULL);
    hb_face_t *face = hb_face_create(blob, 0);
    instance->units = hb_face_get_upem(face);
    instance->font = hb_font_create(face);
    instance->draw = make_draw_funcs();
    bool made =
        blob != hb_blob_get_empty() && face != hb_face_get_empty() && instance->font != hb_font_get_empty();
    hb_face_destroy(face);
    hb_blob_destroy(blob);
    return made ? MT_OK : MT_NO_MEMORY;
}

static void close_instance(mt_typeset *instance) {
    hb_font_destroy(instance->font);
    hb_draw_funcs_destroy(instance->draw);
    mt_bytes_free(instance->bytes);
}

void mt_typesets_free(mt_typeset *instances, int count) {
    if (instances) mt_free(instances->firsts);
    for (int i = 0; instances && i < count; i++) close_instance(&instances[i]);
    mt_free(instances);
}

/* Instances in the making. */
typedef struct maker {
    const mt_blend *blend;
    const double *at;
    mt_typeset *list;
    int count;
} maker;

/* The same for all instances. Of several glyphs that come from one, the first is its own (charset.h). */
static mt_status list_firsts(const maker *making, const mt_font_data *data) {
    size_t room = (size_t)mt_font_glyph_count(making->blend->row.fonts[0]) + 1;
    mt_first_glyph *firsts = mt_new(room, sizeof *firsts);
    if (!firsts) return MT_NO_MEMORY;
    for (int i = 0; i < data->glyph_count; i++) {
        mt_first_glyph *first = &firsts[data->origins[i].glyph];
        if (!first->kept) *first = (mt_first_glyph){true, (uint32_t)i, data->origins[i].code_point};
    }
    making->list[0].firsts = firsts;
    return MT_OK;
}

/* An mt_font_ready. */
static mt_status keep(const mt_font_data *data, int index, void *user) {
    const maker *making = user;
    mt_typeset *instance = &making->list[index];
    size_t length;
    mt_status status = index == 0 ? list_firsts(making, data) : MT_OK;
    if (status == MT_OK) status = mt_font_write(data, &instance->bytes, &length);
    if (status != MT_OK) return status;
    instance->firsts = making->list[0].firsts;
    instance->at = mt_row_place(&making->blend->row, making->at[index], index);
    status = open_bytes(instance, length);
    if (status == MT_OK) read_extents(instance);
    return status;
}

mt_status mt_typesets_new(mt_blend *blend, const mt_choice *choices, int choice_count, const double *at,
                          int count, mt_fonts_made made, void *user, mt_typeset **instances) {
    maker making = {blend, at, mt_new((size_t)count, sizeof *making.list), count};
    uint32_t glyph;
    mt_status status = making.list ? mt_row_choose(&blend->row, choices, choice_count) : MT_NO_MEMORY;
    if (status == MT_OK) status = mt_blend_make(blend, at, count, keep, &making);
    for (int i = 0; i < choice_count && status == MT_OK; i++)
        if (!mt_typeset_glyph(making.list, &choices[i], &glyph)) status = MT_NO_GLYPH;
    if (status == MT_OK && made) status = made(user);
    if (status == MT_OK)
        *instances = making.list;
    else
        mt_typesets_free(making.list, count);
    return status;
}

bool mt_typeset_glyph(const mt_typeset *instance, const mt_choice *choice, uint32_t *glyph) {
    if (!choice->name) return hb_font_get_nominal_glyph(instance->font, choice->code_point, glyph);
    *glyph = instance->firsts[choice->glyph].number;
    return instance->firsts[choice->glyph].kept;
}
/* ---- measures ------------------------------------------------------------------------------------------ */

mt_extents mt_glyph_extents(const mt_typeset *instance, uint32_t glyph) {
    hb_glyph_extents_t ink = {0};
    double units = instance->units;
    hb_font_get_glyph_extents(instance->font, glyph, &ink); /* its height runs downwards: negative */
    return (mt_extents){.left = ink.x_bearing / units,
                        .right = (ink.x_bearing + ink.width) / units,
                        .bottom = (ink.y_bearing + ink.height) / units,
                        .top = ink.y_bearing / units,
                        .advance = hb_font_get_glyph_h_advance(instance->font, glyph) / units};
}
