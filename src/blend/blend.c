/* The blend of two fonts: what it goes by, and one glyph or whole fonts of it in memory. */
#include "blend/job.h"

#include "blend/metadata.h"
#include "blend/review.h"
#include "geometry/limits.h"
#include "morph/between/instance.h"
#include "morph/model/params.h"
#include "write/write.h"

/* ---- the handle ---------------------------------------------------------------------------------------- */

mt_status mt_blend_new(mt_font *a, mt_font *b, const mt_params *params, mt_blend **blend) {
    mt_status status = mt_params_check(params);
    if (status != MT_OK) return status;
    mt_blend *made = mt_new(1, sizeof *made);
    if (!made) return MT_NO_MEMORY;
    *made = (mt_blend){.a = a, .b = b, .params = *params};
    *blend = made;
    return MT_OK;
}

void mt_blend_free(mt_blend *blend) {
    if (!blend) return;
    mt_hint_index_free(blend->hints);
    mt_free(blend->family);
    mt_free(blend->wanted);
    mt_free(blend);
}

void mt_blend_on_failure(mt_blend *blend, mt_glyph_failed call, void *user) {
    blend->failed = call;
    blend->failed_user = user;
}

void mt_blend_on_progress(mt_blend *blend, mt_progress call, void *user) {
    blend->progress = call;
    blend->progress_user = user;
}

mt_status mt_blend_set_family(mt_blend *blend, const char *name) {
    char *copy = name ? mt_copy_text(name) : NULL;
    if (name && !copy) return MT_NO_MEMORY;
    mt_free(blend->family);
    blend->family = copy;
    return MT_OK;
}

mt_status mt_blend_warnings(const mt_blend *blend, mt_warning call, void *user) {
    return mt_review(blend->a, blend->b, blend->family, call, user);
}

mt_status mt_blend_set_chars(mt_blend *blend, const uint32_t *code_points, int count) {
    uint32_t *copy = count > 0 ? mt_new((size_t)count, sizeof *copy) : NULL;
    if (count > 0 && !copy) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) copy[i] = code_points[i];
    mt_free(blend->wanted);
    blend->wanted = copy;
    blend->wanted_count = count > 0 ? count : 0;
    return MT_OK;
}

void mt_blend_set_glyphs(mt_blend *blend, mt_glyph_set set) {
    blend->set = set;
}

int mt_blend_unblended(const mt_blend *blend) {
    return blend->unblended;
}

mt_status mt_blend_set_hints(mt_blend *blend, const mt_hint_table *table, mt_hint_error *error) {
    mt_hint_index *index = NULL;
    mt_status status = table ? mt_hint_index_new(table, blend->a, blend->b, &index, error) : MT_OK;
    if (status != MT_OK) return status;
    mt_hint_index_free(blend->hints);
    blend->hints = index;
    return MT_OK;
}

const mt_hint_index *mt_blend_hints(const mt_blend *blend) {
    return blend->hints;
}

int mt_blend_units_per_em(const mt_blend *blend) {
    return mt_metadata_units(blend->a, blend->b);
}

/* ---- one glyph ----------------------------------------------------------------------------------------- */

static void draw_contour(const mt_contour *contour, double scale, const mt_draw *draw, void *user) {
    mt_point start = contour->segments[contour->count - 1].end;
    draw->move_to(start.x * scale, start.y * scale, user);
    for (int i = 0; i < contour->count; i++) {
        const mt_segment *s = &contour->segments[i];
        if (s->degree == 1)
            draw->line_to(s->end.x * scale, s->end.y * scale, user);
        else
            draw->quadratic_to(s->control[0].x * scale, s->control[0].y * scale, s->end.x * scale,
                               s->end.y * scale, user);
    }
    draw->close(user);
}

mt_status mt_blend_glyph(mt_blend *blend, uint32_t code_point, double t, const mt_draw *draw, void *user,
                         double *advance) {
    if (!mt_is_place(t)) return MT_BAD_PARAMETER;
    mt_arena arena = {0};
    mt_glyph_pair pair;
    mt_outline outline;
    mt_status status =
        mt_glyph_pair_prepare(blend->a, blend->b, code_point, blend->hints, &blend->params, &arena, &pair);
    if (status == MT_OK)
        status = mt_morph_outline(&pair.morph, mt_weights_at(t), &blend->params, &arena, &outline);
    if (status == MT_OK) {
        double scale = (double)mt_blend_units_per_em(blend) / MT_EM;
        for (int i = 0; i < outline.count; i++) draw_contour(&outline.contours[i], scale, draw, user);
        *advance = mt_mixed_advance(&pair, t) * scale;
    }
    mt_arena_release(&arena);
    return status;
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
