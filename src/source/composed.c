/* Composed glyphs: what several glyphs of a font draw together. They are numbered behind all that a font can have, and kept
 * until it is closed, so that whatever reads glyphs reads them as any other. */
#include "source/handle.h"

#include <string.h>

#include "geometry/limits.h"

enum { COMPOSED_MAX = 8192 }; /* in a font: Devanagari has a few hundred */

/* ---- numbers ------------------------------------------------------------------------------------------- */

static bool same(const mt_composed *x, const mt_composed *y) {
    size_t size = (size_t)x->parts.count * sizeof *x->parts.list;
    if (x->advance != y->advance || x->like != y->like || x->parts.count != y->parts.count) return false;
    return size == 0 || memcmp(x->parts.list, y->parts.list, size) == 0;
}

static bool is_of_font(const mt_font *font, const mt_composed *composed) {
    uint32_t count = (uint32_t)mt_font_glyph_count(font);
    for (int i = 0; i < composed->parts.count; i++)
        if (composed->parts.list[i].glyph >= count) return false;
    return composed->like < count;
}

static mt_status add(mt_font *font, const mt_composed *composed) {
    mt_composed *list =
        mt_grow_list(font->composed, font->composed_count, &font->composed_room, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    font->composed = list;
    mt_composed *made = &list[font->composed_count];
    *made = *composed;
    made->parts.list = mt_new((size_t)composed->parts.count + 1, sizeof *made->parts.list);
    if (!made->parts.list) return MT_NO_MEMORY;
    for (int i = 0; i < composed->parts.count; i++) made->parts.list[i] = composed->parts.list[i];
    font->composed_count++;
    return MT_OK;
}

mt_status mt_font_compose(mt_font *font, const mt_composed *composed, uint32_t *glyph) {
    int i = 0;
    while (i < font->composed_count && !same(&font->composed[i], composed)) i++;
    if (!is_of_font(font, composed)) return MT_BAD_GLYPH;
    if (i == COMPOSED_MAX) return MT_TOO_LARGE;
    mt_status status = i == font->composed_count ? add(font, composed) : MT_OK;
    if (status == MT_OK) *glyph = MT_COMPOSED_FIRST + (uint32_t)i;
    return status;
}

const mt_composed *mt_font_composed(const mt_font *font, uint32_t glyph) {
    bool has = glyph >= MT_COMPOSED_FIRST && glyph - MT_COMPOSED_FIRST < (uint32_t)font->composed_count;
    return has ? &font->composed[glyph - MT_COMPOSED_FIRST] : NULL;
}

void mt_font_free_composed(mt_font *font) {
    for (int i = 0; i < font->composed_count; i++) mt_free(font->composed[i].parts.list);
    mt_free(font->composed);
}

/* ---- drawings ------------------------------------------------------------------------------------------ */

static mt_status move_point(mt_point *point, int64_t dx, int64_t dy) {
    int64_t x = point->x + dx, y = point->y + dy;
    if (x < -MT_COORD_MAX || x > MT_COORD_MAX || y < -MT_COORD_MAX || y > MT_COORD_MAX) return MT_TOO_LARGE;
    *point = (mt_point){(int32_t)x, (int32_t)y};
    return MT_OK;
}

/* Every contour has segments of its own. */
static mt_status move(mt_outline *outline, int64_t dx, int64_t dy) {
    mt_status status = MT_OK;
    for (int i = 0; i < outline->count; i++)
        for (int k = 0; k < outline->contours[i].count && status == MT_OK; k++) {
            mt_segment *segment = &outline->contours[i].segments[k];
            status = move_point(&segment->end, dx, dy);
            for (int c = 0; c < segment->degree - 1 && status == MT_OK; c++)
                status = move_point(&segment->control[c], dx, dy);
        }
    return status;
}

/* A length of the font's to the grid, halves up, as outlines are rounded. */
static int64_t to_grid(const mt_font *font, int length) {
    int64_t over = 2 * (int64_t)length * MT_EM + font->units, under = 2 * (int64_t)font->units;
    return over / under - (over % under < 0);
}

static mt_status read_part(mt_font *font, const mt_reference *part, mt_arena *arena, mt_outline *outline) {
    double advance;
    mt_status status = mt_font_outline(font, part->glyph, arena, outline, &advance);
    return status == MT_OK ? move(outline, to_grid(font, part->dx), to_grid(font, part->dy)) : status;
}

mt_status mt_composed_outline(mt_font *font, const mt_composed *composed, mt_arena *arena,
                              mt_outline *outline) {
    mt_outline *parts = mt_arena_new(arena, (size_t)composed->parts.count + 1, sizeof *parts);
    mt_outline made = {0};
    mt_status status = parts ? MT_OK : MT_NO_MEMORY;
    int count = 0;
    for (int i = 0; i < composed->parts.count && status == MT_OK; i++) {
        status = read_part(font, &composed->parts.list[i], arena, &parts[i]);
        count += status == MT_OK ? parts[i].count : 0;
    }
    if (status != MT_OK) return status;
    made.contours = mt_arena_new(arena, (size_t)count + 1, sizeof *made.contours);
    if (!made.contours) return MT_NO_MEMORY;
    for (int i = 0; i < composed->parts.count; i++)
        for (int k = 0; k < parts[i].count; k++) made.contours[made.count++] = parts[i].contours[k];
    *outline = made;
    return MT_OK;
}
