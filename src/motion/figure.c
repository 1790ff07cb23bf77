#include "motion/figure.h"

#include <math.h>

#include "geometry/layers.h"
#include "geometry/limits.h"
#include "motion/shaped_line.h"

typedef struct mt_reading {
    mt_font *font;
    double tolerance;
    mt_arena *arena;
    const mt_text *text;
    uint32_t *codes; /* one for each of the text; of a glyph by its name 0 */
    mt_shaped_line line;
} mt_reading;

/* ---- the line ------------------------------------------------------------------------------------------ */

static mt_status read_codes(mt_reading *reading, int *lacking) {
    const mt_text *text = reading->text;
    reading->codes = mt_arena_new(reading->arena, (size_t)text->count + 1, sizeof *reading->codes);
    if (!reading->codes) return MT_NO_MEMORY;
    if (text->count > MT_LINE_MAX) return MT_TOO_LARGE;
    for (int i = 0; i < text->count; i++) {
        const mt_choice *choice = &text->list[i];
        if (choice->name) continue;
        reading->codes[i] = choice->code_point;
        if (mt_font_glyph(reading->font, choice->code_point) != 0) continue;
        *lacking = i;
        return MT_NO_GLYPH;
    }
    return MT_OK;
}

/* Adds what stands on a line by itself to the end of the line; its text begins at `first`. */
static mt_status add_line(mt_reading *reading, const mt_shaped_line *more, int first) {
    mt_shaped_line *line = &reading->line;
    if (more->count > MT_LINE_MAX - line->count) return MT_TOO_LARGE;
    for (int i = 0; i < more->count; i++) {
        mt_line_glyph glyph = more->glyphs[i];
        glyph.first += first;
        glyph.x += line->advance;
        line->glyphs[line->count++] = glyph;
    }
    line->advance += more->advance;
    return MT_OK;
}

static mt_status add_glyph(mt_reading *reading, int at) {
    mt_line_glyph glyph = {.glyph = reading->text->list[at].glyph, .count = 1};
    mt_shaped_line alone = {1, &glyph, 0};
    mt_status status = mt_font_advance(reading->font, glyph.glyph, &alone.advance);
    return status == MT_OK ? add_line(reading, &alone, at) : status;
}

static mt_status add_characters(mt_reading *reading, int first, int end) {
    mt_shaped_line shaped;
    mt_status status =
        mt_shape_line(reading->font, reading->codes + first, end - first, reading->arena, &shaped);
    return status == MT_OK ? add_line(reading, &shaped, first) : status;
}

/* Characters next to one another are shaped together; glyphs by their names stand as they are. */
static mt_status set_line(mt_reading *reading) {
    const mt_text *text = reading->text;
    mt_status status = MT_OK;
    reading->line.glyphs = mt_arena_new(reading->arena, MT_LINE_MAX, sizeof *reading->line.glyphs);
    if (!reading->line.glyphs) return MT_NO_MEMORY;
    for (int i = 0, end; i < text->count && status == MT_OK; i = end) {
        for (end = i; end < text->count && !text->list[end].name;) end++;
        if (end > i)
            status = add_characters(reading, i, end);
        else
            status = add_glyph(reading, end++);
    }
    return status;
}

/* ---- parts --------------------------------------------------------------------------------------------- */

static mt_point moved(mt_point p, mt_point by) {
    return (mt_point){p.x + by.x, p.y + by.y};
}

static void add_outline(const mt_outline *more, mt_point by, mt_outline *all) {
    for (int i = 0; i < more->count; i++) {
        mt_contour contour = more->contours[i];
        for (int k = 0; k < contour.count; k++) {
            mt_segment *s = &contour.segments[k];
            s->control[0] = moved(s->control[0], by);
            s->control[1] = moved(s->control[1], by);
            s->end = moved(s->end, by);
        }
        all->contours[all->count++] = contour;
    }
}

/* The outlines of a cluster's glyphs together, about the origin of the first. */
static mt_status read_drawing(const mt_reading *reading, int first, int count, mt_outline *drawing) {
    const mt_line_glyph *glyphs = &reading->line.glyphs[first];
    mt_outline *outlines = mt_arena_new(reading->arena, (size_t)count, sizeof *outlines);
    if (!outlines) return MT_NO_MEMORY;
    size_t contours = 1;
    for (int i = 0; i < count; i++) {
        double advance;
        mt_status status =
            mt_font_outline(reading->font, glyphs[i].glyph, reading->arena, &outlines[i], &advance);
        if (status != MT_OK) return status;
        contours += (size_t)outlines[i].count;
    }
    *drawing = (mt_outline){0, mt_arena_new(reading->arena, contours, sizeof *drawing->contours)};
    if (!drawing->contours) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        double x = glyphs[i].x - glyphs[0].x, y = glyphs[i].y - glyphs[0].y;
        if (!(fabs(x) <= MT_COORD_MAX && fabs(y) <= MT_COORD_MAX)) return MT_TOO_LARGE;
        add_outline(&outlines[i], (mt_point){(int32_t)lround(x), (int32_t)lround(y)}, drawing);
    }
    return MT_OK;
}

static mt_status read_part(const mt_reading *reading, int first, int count, mt_figure_part *part) {
    const mt_line_glyph *glyph = &reading->line.glyphs[first];
    bool by_name = reading->text->list[glyph->first].name != NULL;
    *part = (mt_figure_part){.glyph = count == 1 ? glyph->glyph : MT_SEVERAL_GLYPHS,
                             .text = by_name ? NULL : reading->codes + glyph->first,
                             .text_length = glyph->count,
                             .place = {glyph->x - reading->line.advance / 2, glyph->y}};
    mt_layer *layer = mt_arena_new(reading->arena, 1, sizeof *layer);
    if (!layer) return MT_NO_MEMORY;
    part->drawing = (mt_layers){1, layer};
    mt_status status = read_drawing(reading, first, count, &layer->outline);
    return status == MT_OK
               ? mt_outline_shape(&layer->outline, reading->tolerance, reading->arena, &part->shape)
               : status;
}

/* A part for each cluster, those without ink left out. */
static mt_status read_parts(const mt_reading *reading, mt_figure *figure) {
    const mt_shaped_line *line = &reading->line;
    mt_figure made = {0, mt_arena_new(reading->arena, (size_t)line->count + 1, sizeof *made.parts),
                      line->advance};
    if (!made.parts) return MT_NO_MEMORY;
    for (int i = 0, end; i < line->count; i = end) {
        for (end = i + 1; end < line->count && line->glyphs[end].first == line->glyphs[i].first;) end++;
        mt_status status = read_part(reading, i, end - i, &made.parts[made.count]);
        if (status != MT_OK) return status;
        made.count += made.parts[made.count].shape.count > 0;
    }
    if (made.count == 0) return MT_BLANK;
    *figure = made;
    return MT_OK;
}

mt_status mt_figure_read(mt_font *font, const mt_text *text, double tolerance, mt_arena *arena,
                         mt_figure *figure, int *lacking) {
    mt_reading reading = {.font = font, .tolerance = tolerance, .arena = arena, .text = text};
    mt_status status = read_codes(&reading, lacking);
    if (status == MT_OK) status = set_line(&reading);
    return status == MT_OK ? read_parts(&reading, figure) : status;
}

mt_status mt_figure_of_drawing(const mt_svg_drawing *drawing, double tolerance, mt_arena *arena,
                               mt_figure *figure) {
    mt_figure_part *part = mt_arena_new(arena, 1, sizeof *part);
    if (!part) return MT_NO_MEMORY;
    *part = (mt_figure_part){.glyph = MT_SEVERAL_GLYPHS, .drawing = drawing->layers, .apart = true};
    mt_status status = mt_layers_shape(&drawing->layers, tolerance, arena, &part->shape);
    if (status == MT_OK && part->shape.count == 0) status = MT_BLANK;
    if (status == MT_OK) *figure = (mt_figure){1, part, MT_EM};
    return status;
}

/* ---- several parts as one ------------------------------------------------------------------------------ */

/* Adds the rings of a part, moved. */
static mt_status add_rings(const mt_figure_part *part, mt_point by, mt_arena *arena, mt_rings *all) {
    mt_rings own;
    mt_status status = mt_shape_rings(&part->shape, arena, &own);
    for (int i = 0; i < own.count && status == MT_OK; i++) {
        mt_ring *moved = &all->rings[all->count++];
        status = mt_ring_new(arena, own.rings[i].count, moved);
        for (int k = 0; k < own.rings[i].count && status == MT_OK; k++) {
            mt_point p = own.rings[i].points[k];
            double x = (double)p.x + by.x, y = (double)p.y + by.y;
            if (!(fabs(x) <= MT_COORD_MAX && fabs(y) <= MT_COORD_MAX)) return MT_TOO_LARGE;
            moved->points[k] = (mt_point){(int32_t)x, (int32_t)y};
            moved->marks[k] = own.rings[i].marks[k];
        }
    }
    return status;
}

mt_status mt_group_parts(const mt_figure *figure, int first, int count, mt_arena *arena,
                         mt_figure_part *group) {
    const mt_figure_part *parts = &figure->parts[first];
    size_t rings = 0;
    for (int i = 0; i < count; i++) rings += (size_t)mt_shape_ring_count(&parts[i].shape);
    mt_rings all = {0, mt_arena_new(arena, rings, sizeof *all.rings)};
    mt_figure_part made = {.glyph = MT_SEVERAL_GLYPHS, .place = parts[0].place};
    if (!all.rings) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) {
        double x = parts[i].place.x - made.place.x, y = parts[i].place.y - made.place.y;
        if (!(fabs(x) <= MT_COORD_MAX && fabs(y) <= MT_COORD_MAX)) return MT_TOO_LARGE;
        mt_status status =
            add_rings(&parts[i], (mt_point){(int32_t)lround(x), (int32_t)lround(y)}, arena, &all);
        if (status != MT_OK) return status;
    }
    mt_status status = mt_union(&all, MT_NONZERO, arena, &made.shape);
    if (status == MT_OK) *group = made;
    return status;
}
