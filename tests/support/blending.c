#include "support/blending.h"

#include <hb-ot.h>
#include <math.h>

#include "blend/metadata.h"
#include "gpos/gpos.h"
#include "sfnt/sfnt.h"
#include "support/check.h"
#include "support/fonts.h"
#include "support/gpos.h"
#include "support/sample.h"
#include "support/shaping.h"
#include "support/varying.h"
#include "write/varying.h"
#include "write/write.h"

/* ---- blends -------------------------------------------------------------------------------------------- */

mt_test_end mt_test_open_end(const char *path, const char *spec, float weight) {
    mt_test_end end = {0};
    mt_font_close(mt_test_font(path));
    mt_assert_ok(mt_font_open(spec, &end.font));
    end.shaping = mt_shaping_open(path, weight);
    return end;
}

mt_status mt_test_font_glyphs(const mt_charset *charsets, int font_count, mt_arena *arena,
                              mt_font_glyphs *glyphs) {
    mt_font_glyphs made = {.font_count = font_count, .glyph_count = charsets->glyph_count};
    for (int k = 0; k < font_count; k++) {
        const mt_charset *charset = &charsets[k ? k - 1 : 0];
        uint32_t *of = mt_arena_new(arena, (size_t)made.glyph_count, sizeof *of);
        if (!of) return MT_NO_MEMORY;
        for (int i = 0; i < made.glyph_count; i++) of[i] = k ? charset->glyphs[i].b : charset->glyphs[i].a;
        made.of[k] = of;
    }
    *glyphs = made;
    return MT_OK;
}

mt_status mt_test_positions(mt_font *const *fonts, const mt_charset *charsets, int count, int units,
                            mt_arena *arena, mt_positions **positions) {
    mt_font_glyphs glyphs;
    mt_status status = mt_test_font_glyphs(charsets, count, arena, &glyphs);
    return status == MT_OK ? mt_positions_prepare(fonts, &glyphs, units, arena, positions) : status;
}

void mt_test_blend_prepare(mt_test_blend *blend) {
    mt_font *fonts[] = {blend->ends[0].font, blend->ends[1].font};
    mt_assert_ok(mt_test_positions(fonts, &blend->charset, 2, blend->units, blend->arena, &blend->positions));
}

mt_test_blend mt_test_blend_of(mt_test_end a, mt_test_end b, mt_arena *arena) {
    mt_test_blend blend = {.arena = arena, .ends = {a, b}, .units = mt_metadata_units(a.font, b.font)};
    mt_assert_ok(mt_charset_make(a.font, b.font, &(mt_charset_request){0}, arena, &blend.charset));
    mt_test_blend_prepare(&blend);
    return blend;
}

void mt_test_blend_close(mt_test_blend *blend) {
    for (int s = 0; s < 2; s++) {
        hb_font_destroy(blend->ends[s].shaping);
        mt_font_close(blend->ends[s].font);
    }
}

/* Units of the new font in one of HarfBuzz's for a source. */
static double scale_of(const mt_test_blend *blend, int s) {
    int x, y;
    hb_font_get_scale(blend->ends[s].shaping, &x, &y);
    return (double)blend->units / x;
}

/* The glyphs' advances at t, in the order of the charset. */
static uint16_t *advances_at(const mt_test_blend *blend, double t) {
    int count = blend->charset.glyph_count;
    uint16_t *advances = mt_arena_new(blend->arena, (size_t)count, sizeof *advances);
    assert_non_null(advances);
    for (int i = 0; i < count; i++) {
        mt_pairing glyph = blend->charset.glyphs[i];
        double a = scale_of(blend, 0) * hb_font_get_glyph_h_advance(blend->ends[0].shaping, glyph.a);
        double b = scale_of(blend, 1) * hb_font_get_glyph_h_advance(blend->ends[1].shaping, glyph.b);
        advances[i] = (uint16_t)floor((1 - t) * a + t * b + 0.5);
    }
    return advances;
}

/* GDEF with the first font's classes. */
static mt_bytes gdef_of(const mt_test_blend *blend) {
    int count = blend->charset.glyph_count;
    uint16_t *classes = mt_arena_new(blend->arena, (size_t)count, sizeof *classes);
    hb_face_t *first = hb_font_get_face(blend->ends[0].shaping);
    assert_non_null(classes);
    for (int i = 0; i < count; i++)
        classes[i] = (uint16_t)hb_ot_layout_get_glyph_class(first, blend->charset.glyphs[i].a);
    return mt_test_gdef(classes, count, blend->arena);
}

static mt_test_place place_of(const mt_test_blend *blend, double t, mt_bytes font, size_t gpos_length) {
    return (mt_test_place){.blend = blend,
                           .t = t,
                           .font = mt_shaping_font(font.bytes, font.length),
                           .buffer = hb_buffer_create(),
                           .gpos_length = gpos_length};
}

mt_test_place mt_test_place_at(const mt_test_blend *blend, double t) {
    mt_bytes gpos;
    mt_assert_ok(mt_positions_write(blend->positions, mt_font_at_t(t), blend->arena, &gpos));
    mt_bytes font = mt_test_layout_font(&blend->charset, blend->units, advances_at(blend, t), gdef_of(blend),
                                        gpos, (mt_test_varying){0}, blend->arena);
    return place_of(blend, t, font, gpos.length);
}

/* HVAR of both ends' advances. */
static mt_bytes hvar_of(const mt_test_blend *blend) {
    int count = blend->charset.glyph_count;
    mt_glyf *ends[2];
    mt_bytes hvar;
    for (int s = 0; s < 2; s++) {
        const uint16_t *advances = advances_at(blend, s);
        ends[s] = mt_arena_new(blend->arena, (size_t)count, sizeof *ends[s]);
        assert_non_null(ends[s]);
        for (int i = 0; i < count; i++) ends[s][i].advance = advances[i];
    }
    const mt_stops stops = mt_stops_even(2);
    mt_assert_ok(mt_hvar_write(ends, &stops, count, blend->arena, &hvar));
    return hvar;
}

mt_test_place mt_test_varying_place_at(const mt_test_blend *blend, double t) {
    mt_bytes gpos, gdef;
    mt_test_varying varying = {mt_test_fvar(blend->arena), hvar_of(blend)};
    mt_assert_ok(mt_test_write_varying(blend->positions, 2, gdef_of(blend), blend->arena, &gpos, &gdef));
    mt_bytes font = mt_test_layout_font(&blend->charset, blend->units, advances_at(blend, 0), gdef, gpos,
                                        varying, blend->arena);
    mt_test_place place = place_of(blend, t, font, gpos.length);
    mt_test_place_on_axis(place.font, t);
    return place;
}

void mt_test_place_close(mt_test_place *place) {
    hb_font_destroy(place->font);
    hb_buffer_destroy(place->buffer);
}

/* ---- comparing ----------------------------------------------------------------------------------------- */

/* The width of a text, in what the font's scale is in. */
static double width_of(const mt_test_place *place, hb_font_t *font, const uint32_t *text, int length) {
    hb_buffer_t *buffer = place->buffer;
    double width = 0;
    unsigned count;
    hb_buffer_clear_contents(buffer);
    hb_buffer_add_codepoints(buffer, text, length, 0, length);
    hb_buffer_guess_segment_properties(buffer);
    hb_shape(font, buffer, &place->feature, place->feature.tag ? 1 : 0);
    const hb_glyph_position_t *positions = hb_buffer_get_glyph_positions(buffer, &count);
    for (unsigned i = 0; i < count; i++) width += positions[i].x_advance;
    return width;
}

static double plain_width(const mt_test_place *place, const uint32_t *text, int length) {
    double width = 0;
    for (int i = 0; i < length; i++) {
        hb_codepoint_t glyph;
        assert_true(hb_font_get_nominal_glyph(place->font, text[i], &glyph));
        width += hb_font_get_glyph_h_advance(place->font, glyph);
    }
    return width;
}

void mt_test_compare(mt_test_place *place, const uint32_t *text, int length) {
    const mt_test_blend *blend = place->blend;
    double widths[2];
    int scale, y;
    for (int s = 0; s < 2; s++)
        widths[s] = scale_of(blend, s) * width_of(place, blend->ends[s].shaping, text, length);
    hb_font_get_scale(place->font, &scale, &y);
    double unit = (double)scale / blend->units, width = width_of(place, place->font, text, length);
    double wanted = (1 - place->t) * widths[0] + place->t * widths[1];
    double off = fabs(width / unit - wanted) / length;
    place->worst = fmax(place->worst, off);
    place->kerned += width != plain_width(place, text, length);
    if (off <= 1) return;
    for (int i = 0; i < length; i++) print_error("U+%04X ", (unsigned)text[i]);
    fail_msg("%g instead of %g", width / unit, wanted);
}

/* ---- sources ------------------------------------------------------------------------------------------- */

mt_bytes mt_test_one_lookup(uint32_t script, uint32_t feature, int type, const mt_bytes *subtables, int count,
                            mt_arena *arena) {
    mt_member member = {0, feature};
    mt_shared_system system = {script, MT_LANGUAGE_DEFAULT, {-1, -1}, 0};
    mt_systems systems = {1, &system};
    mt_lookup_builder lookup = {.type = type,
                                .mark_set = -1,
                                .member_count = 1,
                                .members = &member,
                                .subtable_count = count,
                                .subtables = subtables};
    mt_lookup_builders made = {0};
    mt_bytes gpos;
    mt_assert_ok(mt_lookup_builders_add(&made, &lookup, arena));
    mt_assert_ok(mt_gpos_write(&systems, &made, arena, &gpos));
    return gpos;
}

void mt_test_save_blank(const char *path, int units, uint32_t first, int count, uint32_t tag, mt_bytes table,
                        mt_arena *arena) {
    mt_font_data data = {
        .units = units,
        .glyph_count = count + 1,
        .char_count = count,
        .metrics = {.underline_thickness = 50, .weight_class = 400, .width_class = 5},
        .family = "Blank",
        .style = "Regular",
        .unique_id = "blank",
    };
    data.glyphs = mt_arena_new(arena, (size_t)count + 1, sizeof *data.glyphs);
    data.chars = mt_arena_new(arena, (size_t)count, sizeof *data.chars);
    assert_true(data.glyphs && data.chars);
    for (int i = 0; i <= count; i++) data.glyphs[i].advance = 500;
    for (int i = 0; i < count; i++) data.chars[i] = (mt_char){first + (uint32_t)i, (uint16_t)(i + 1)};
    if (table.length) data.extras[data.extra_count++] = (mt_extra_table){tag, table};
    uint8_t *bytes;
    size_t length;
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    mt_sample_save(path, bytes, length);
    mt_bytes_free(bytes);
}
