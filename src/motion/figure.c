#include "motion/figure.h"

#include <math.h>
#include <string.h>

#include "base/utf.h"
#include "blend/pair.h"
#include "geometry/limits.h"
#include "motion/shaped_line.h"
#include "source/glyph_names.h"

typedef struct mt_reading {
    mt_font *font;
    double tolerance;
    mt_arena *arena;
    const uint32_t *codes; /* NULL for glyphs by their names */
    mt_shaped_line line;
} mt_reading;

/* ---- the line ------------------------------------------------------------------------------------------ */

static mt_status read_text(mt_reading *reading, const char *text, const char **lacking) {
    int count = 0;
    uint32_t *codes = mt_arena_new(reading->arena, strlen(text) + 1, sizeof *codes);
    if (!codes) return MT_NO_MEMORY;
    while (*text) {
        const char *at = text;
        if (!mt_utf8_next(&text, &codes[count])) return MT_BAD_PARAMETER;
        if (mt_font_glyph(reading->font, codes[count++]) != 0) continue;
        *lacking = at;
        return MT_NO_GLYPH;
    }
    reading->codes = codes;
    return count > MT_LINE_MAX ? MT_TOO_LARGE
                               : mt_shape_line(reading->font, codes, count, reading->arena, &reading->line);
}

/* The number of the glyph with this name; 0 and false where there is none. */
static bool find_name(const char *const *names, int count, const char *name, size_t length, uint32_t *glyph) {
    for (int i = 0; names && i < count; i++) {
        if (!names[i] || strlen(names[i]) != length || memcmp(names[i], name, length) != 0) continue;
        *glyph = (uint32_t)i;
        return true;
    }
    return false;
}

/* Each after a slash. */
static mt_status read_names(mt_reading *reading, const char *text, const char **lacking) {
    const char **names;
    mt_status status = mt_font_glyph_names(reading->font, reading->arena, &names);
    mt_shaped_line line = {0, mt_arena_new(reading->arena, strlen(text), sizeof *line.glyphs), 0};
    if (status != MT_OK || !line.glyphs) return status == MT_OK ? MT_NO_MEMORY : status;
    while (*text) {
        size_t length = strcspn(text + 1, "/");
        double advance;
        mt_line_glyph *glyph = &line.glyphs[line.count];
        *glyph = (mt_line_glyph){.first = line.count, .count = 1, .x = line.advance};
        *lacking = text;
        if (!find_name(names, mt_font_glyph_count(reading->font), text + 1, length, &glyph->glyph))
            return MT_NO_GLYPH;
        status = mt_font_advance(reading->font, glyph->glyph, &advance);
        if (status == MT_OK && ++line.count > MT_LINE_MAX) status = MT_TOO_LARGE;
        if (status != MT_OK) return status;
        line.advance += advance;
        text += 1 + length;
    }
    reading->line = line;
    return MT_OK;
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
    *part = (mt_figure_part){.glyph = count == 1 ? glyph->glyph : MT_SEVERAL_GLYPHS,
                             .text = reading->codes ? reading->codes + glyph->first : NULL,
                             .text_length = glyph->count,
                             .place = {glyph->x - reading->line.advance / 2, glyph->y}};
    mt_status status = read_drawing(reading, first, count, &part->drawing);
    return status == MT_OK
               ? mt_outline_shape(&part->drawing, reading->tolerance, reading->arena, &part->shape)
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

mt_status mt_figure_read(mt_font *font, const char *text, double tolerance, mt_arena *arena,
                         mt_figure *figure, const char **lacking) {
    mt_reading reading = {.font = font, .tolerance = tolerance, .arena = arena};
    bool slash = text[0] == '/' && text[1], by_name = slash && text[1] != '/';
    mt_status status =
        by_name ? read_names(&reading, text, lacking) : read_text(&reading, text + (slash ? 1 : 0), lacking);
    return status == MT_OK ? read_parts(&reading, figure) : status;
}
