/* Fonts of a blend in memory, read by HarfBuzz: text shaped, measured and drawn with Cairo. */
#include "picture/typeset.h"

#include "base/memory.h"

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

/* Takes over the fonts' bytes, also when it fails. */
static mt_status open_fonts(uint8_t **bytes, const size_t *lengths, int count, mt_typeset *instances) {
    mt_status status = MT_OK;
    for (int i = 0; i < count; i++) instances[i] = (mt_typeset){.bytes = bytes[i]};
    for (int i = 0; i < count && status == MT_OK; i++) status = open_bytes(&instances[i], lengths[i]);
    for (int i = 0; i < count && status == MT_OK; i++) read_extents(&instances[i]);
    return status;
}

mt_status mt_typesets_new(mt_blend *blend, const uint32_t *code_points, int char_count, const double *at,
                          int count, mt_fonts_made made, void *user, mt_typeset **instances) {
    mt_typeset *list = mt_new((size_t)count, sizeof *list);
    uint8_t **bytes = mt_new((size_t)count, sizeof *bytes);
    size_t *lengths = mt_new((size_t)count, sizeof *lengths);
    uint32_t glyph;
    mt_status status = list && bytes && lengths ? MT_OK : MT_NO_MEMORY;
    if (status == MT_OK) status = mt_blend_set_chars(blend, code_points, char_count);
    if (status == MT_OK) status = mt_blend_fonts(blend, at, count, bytes, lengths);
    if (status == MT_OK) status = open_fonts(bytes, lengths, count, list);
    mt_free(bytes);
    mt_free(lengths);
    for (int i = 0; i < char_count && status == MT_OK; i++)
        if (!mt_typeset_glyph(list, code_points[i], &glyph)) status = MT_NO_GLYPH;
    if (status == MT_OK && made) status = made(user);
    if (status == MT_OK)
        *instances = list;
    else
        mt_typesets_free(list, count);
    return status;
}

void mt_typesets_free(mt_typeset *instances, int count) {
    for (int i = 0; instances && i < count; i++) close_instance(&instances[i]);
    mt_free(instances);
}

bool mt_typeset_glyph(const mt_typeset *instance, uint32_t code_point, uint32_t *glyph) {
    return hb_font_get_nominal_glyph(instance->font, code_point, glyph);
}

/* ---- measures ------------------------------------------------------------------------------------------ */

static void widen(mt_extents *all, mt_extents one) {
    if (one.left < all->left) all->left = one.left;
    if (one.right > all->right) all->right = one.right;
    if (one.bottom < all->bottom) all->bottom = one.bottom;
    if (one.top > all->top) all->top = one.top;
}

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

/* ---- lines of text ------------------------------------------------------------------------------------- */

/* A glyph of a shaped line and its place, font units, y upwards. */
typedef struct placed {
    uint32_t glyph;
    double x, y;
} placed;

/* Steps through a shaped line: the glyph at `index`, with the pen before it in *pen and after it on return. */
static placed place(const mt_line *line, unsigned index, double *pen) {
    const hb_glyph_info_t *info = hb_buffer_get_glyph_infos(line->buffer, NULL);
    const hb_glyph_position_t *position = hb_buffer_get_glyph_positions(line->buffer, NULL);
    placed glyph = {info[index].codepoint, *pen + position[index].x_offset, position[index].y_offset};
    *pen += position[index].x_advance;
    return glyph;
}

static void measure(const mt_typeset *instance, mt_line *line) {
    double pen = 0;
    mt_extents all = {0};
    for (unsigned i = 0; i < hb_buffer_get_length(line->buffer); i++) {
        placed at = place(line, i, &pen);
        mt_extents ink = mt_glyph_extents(instance, at.glyph);
        double x = at.x / instance->units, y = at.y / instance->units;
        widen(&all, (mt_extents){ink.left + x, ink.right + x, ink.bottom + y, ink.top + y, 0});
    }
    all.advance = pen / instance->units;
    if (all.right < all.advance) all.right = all.advance;
    line->extents = all;
}

mt_status mt_line_shape(const mt_typeset *instance, const char *utf8, int length, mt_line *line) {
    *line = (mt_line){.buffer = hb_buffer_create()};
    hb_buffer_add_utf8(line->buffer, utf8, length, 0, length);
    hb_buffer_guess_segment_properties(line->buffer);
    hb_shape(instance->font, line->buffer, NULL, 0);
    if (!hb_buffer_allocation_successful(line->buffer)) {
        mt_line_free(line);
        return MT_NO_MEMORY;
    }
    measure(instance, line);
    return MT_OK;
}

void mt_line_free(mt_line *line) {
    hb_buffer_destroy(line->buffer);
    line->buffer = NULL;
}

void mt_line_draw(const mt_typeset *instance, const mt_line *line, cairo_t *cairo, double x, double y,
                  double size) {
    double pen = 0, scale = size / instance->units;
    for (unsigned i = 0; i < hb_buffer_get_length(line->buffer); i++) {
        placed at = place(line, i, &pen);
        mt_glyph_draw(instance, at.glyph, cairo, x + at.x * scale, y - at.y * scale, size);
    }
}
