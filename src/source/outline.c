/* Glyph outlines, exactly onto the grid.
 *
 * FreeType gives integer font units. Decomposed with a shift of one bit, the on-curve points that a TrueType
 * outline implies half-way between two off-curve ones are whole numbers too, so that rounding happens once:
 * on the way to the grid. */
#include "source/handle.h"

#include FT_ADVANCES_H
#include FT_OUTLINE_H

#include "geometry/limits.h"

enum { SHIFT = 1 };

typedef struct mt_pen {
    int64_t units;        /* of the shifted em */
    mt_outline *outline;  /* contours in use */
    mt_segment *segments; /* room for all of them */
    int contour_room, segment_room;
    mt_point start, at;
    mt_status status;
} mt_pen;

/* Rounds halves up, so that the result moves with the outline. */
static int64_t floor_divide(int64_t a, int64_t b) {
    return a / b - (a % b < 0);
}

static bool to_grid(mt_pen *pen, const FT_Vector *from, mt_point *to) {
    int64_t limit = (MT_COORD_MAX / MT_EM + 1) * pen->units;
    bool fits = from->x >= -limit && from->x <= limit && from->y >= -limit && from->y <= limit;
    int64_t x = fits ? floor_divide(2 * (int64_t)from->x * MT_EM + pen->units, 2 * pen->units) : INT64_MAX;
    int64_t y = fits ? floor_divide(2 * (int64_t)from->y * MT_EM + pen->units, 2 * pen->units) : INT64_MAX;
    if (x < -MT_COORD_MAX || x > MT_COORD_MAX || y < -MT_COORD_MAX || y > MT_COORD_MAX) {
        pen->status = MT_TOO_LARGE;
        return false;
    }
    *to = (mt_point){(int32_t)x, (int32_t)y};
    return true;
}

static mt_contour *current(const mt_pen *pen) {
    return &pen->outline->contours[pen->outline->count - 1];
}

/* Adds a segment to the current contour unless all of it is one point. Non-zero stops FreeType. */
static int add(mt_pen *pen, mt_segment segment) {
    bool still = mt_point_equal(segment.end, pen->at);
    for (int i = 0; i < segment.degree - 1; i++) still = still && mt_point_equal(segment.control[i], pen->at);
    if (still) return 0;
    if (pen->outline->count == 0 || pen->segment_room == 0) {
        pen->status = MT_BAD_GLYPH;
        return 1;
    }
    pen->segment_room--;
    *pen->segments++ = segment;
    current(pen)->count++;
    pen->at = segment.end;
    return 0;
}

/* Ends the current contour: closes it with a line where it is open, drops it where it has no segment. */
static int finish_contour(mt_pen *pen) {
    if (pen->outline->count == 0) return 0;
    if (add(pen, (mt_segment){.degree = 1, .end = pen->start}) != 0) return 1;
    if (current(pen)->count == 0) pen->outline->count--;
    return 0;
}

/* ---- FreeType's callbacks ------------------------------------------------------------------------------ */

static int move_to(const FT_Vector *to, void *user) {
    mt_pen *pen = user;
    if (finish_contour(pen) != 0) return 1;
    if (pen->outline->count == pen->contour_room) {
        pen->status = MT_BAD_GLYPH;
        return 1;
    }
    if (!to_grid(pen, to, &pen->start)) return 1;
    pen->at = pen->start;
    pen->outline->contours[pen->outline->count++] = (mt_contour){.segments = pen->segments};
    return 0;
}

static int line_to(const FT_Vector *to, void *user) {
    mt_pen *pen = user;
    mt_segment segment = {.degree = 1};
    return to_grid(pen, to, &segment.end) ? add(pen, segment) : 1;
}

static int conic_to(const FT_Vector *control, const FT_Vector *to, void *user) {
    mt_pen *pen = user;
    mt_segment segment = {.degree = 2};
    bool fits = to_grid(pen, control, &segment.control[0]) && to_grid(pen, to, &segment.end);
    return fits ? add(pen, segment) : 1;
}

static int cubic_to(const FT_Vector *control0, const FT_Vector *control1, const FT_Vector *to, void *user) {
    mt_pen *pen = user;
    mt_segment segment = {.degree = 3};
    bool fits = to_grid(pen, control0, &segment.control[0]) && to_grid(pen, control1, &segment.control[1]) &&
                to_grid(pen, to, &segment.end);
    return fits ? add(pen, segment) : 1;
}

/* ---- a glyph ------------------------------------------------------------------------------------------- */

/* Each point starts at most one segment and each contour is closed by at most one more, so that the room is
 * known. */
static mt_status decompose(FT_Outline *drawn, int64_t units, mt_arena *arena, mt_outline *outline) {
    mt_pen pen = {.units = units << SHIFT, .outline = outline, .status = MT_OK};
    *outline = (mt_outline){0};
    if (drawn->n_contours <= 0 || drawn->n_points <= 0) return MT_OK;
    pen.contour_room = drawn->n_contours;
    pen.segment_room = drawn->n_points + drawn->n_contours;
    outline->contours = mt_arena_new(arena, (size_t)pen.contour_room, sizeof *outline->contours);
    pen.segments = mt_arena_new(arena, (size_t)pen.segment_room, sizeof *pen.segments);
    if (!outline->contours || !pen.segments) return MT_NO_MEMORY;
    const FT_Outline_Funcs calls = {move_to, line_to, conic_to, cubic_to, SHIFT, 0};
    FT_Error error = FT_Outline_Decompose(drawn, &calls, &pen);
    if (error == 0) error = finish_contour(&pen);
    return pen.status != MT_OK ? pen.status : error ? MT_BAD_GLYPH : MT_OK;
}

enum { FLAGS = FT_LOAD_NO_SCALE | FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP | FT_LOAD_IGNORE_TRANSFORM };

typedef struct mt_load {
    uint32_t glyph;
    FT_Fixed advance; /* with FT_LOAD_NO_SCALE, whole font units */
} mt_load;

/* The advance of hmtx and HVAR, not of a reference whose metrics the glyph uses: that is what text is set
 * with. */
static mt_status load(mt_font *font, void *user) {
    mt_load *wanted = user;
    if (FT_Get_Advance(font->face, wanted->glyph, FLAGS, &wanted->advance) != 0) return MT_BAD_GLYPH;
    mt_status status = mt_font_load(font, wanted->glyph, FLAGS);
    if (status != MT_OK) return status;
    return font->face->glyph->format == FT_GLYPH_FORMAT_OUTLINE ? MT_OK : MT_BAD_GLYPH;
}

static mt_status load_advance(mt_font *font, void *user) {
    mt_load *wanted = user;
    return FT_Get_Advance(font->face, wanted->glyph, FLAGS, &wanted->advance) == 0 ? MT_OK : MT_BAD_GLYPH;
}

mt_status mt_font_advance(mt_font *font, uint32_t glyph, double *advance) {
    mt_load wanted = {.glyph = glyph};
    const mt_composed *composed = mt_font_composed(font, glyph);
    if (!font->face) return MT_NO_MEMORY;
    mt_status status = composed ? MT_OK : mt_font_guard(font, load_advance, &wanted);
    if (composed) wanted.advance = composed->advance;
    if (status == MT_OK) *advance = (double)wanted.advance * MT_EM / font->units;
    return status;
}

mt_status mt_font_outline(mt_font *font, uint32_t glyph, mt_arena *arena, mt_outline *outline,
                          double *advance) {
    mt_load wanted = {.glyph = glyph};
    mt_outline read;
    const mt_composed *composed = mt_font_composed(font, glyph);
    if (!font->face) return MT_NO_MEMORY;
    mt_status status = composed ? MT_OK : mt_font_guard(font, load, &wanted);
    if (composed)
        status = mt_composed_outline(font, composed, arena, &read);
    else if (status == MT_OK)
        status = decompose(&font->face->glyph->outline, font->units, arena, &read);
    if (composed) wanted.advance = composed->advance;
    if (status != MT_OK) return status;
    *outline = read;
    *advance = (double)wanted.advance * MT_EM / font->units;
    return MT_OK;
}

static bool is_blank(const FT_Outline *drawn) {
    for (int c = 0, i = 0; c < drawn->n_contours; c++)
        for (int first = i; i <= drawn->contours[c]; i++)
            if (drawn->points[i].x != drawn->points[first].x || drawn->points[i].y != drawn->points[first].y)
                return false;
    return true;
}

static mt_status is_composed_blank(mt_font *font, const mt_composed *composed, bool *blank) {
    mt_arena arena = {0};
    mt_outline outline;
    mt_status status = mt_composed_outline(font, composed, &arena, &outline);
    *blank = status == MT_OK && outline.count == 0;
    mt_arena_release(&arena);
    return status;
}

mt_status mt_font_is_blank(mt_font *font, uint32_t glyph, bool *blank) {
    mt_load wanted = {.glyph = glyph};
    const mt_composed *composed = mt_font_composed(font, glyph);
    *blank = false;
    if (!font->face) return MT_NO_MEMORY;
    mt_status status =
        composed ? is_composed_blank(font, composed, blank) : mt_font_guard(font, load, &wanted);
    if (!composed && status == MT_OK) *blank = is_blank(&font->face->glyph->outline);
    return status == MT_NO_MEMORY ? status : MT_OK;
}
