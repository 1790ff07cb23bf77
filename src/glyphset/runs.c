#include "glyphset/runs.h"

/* A drawing is a row of numbers: the glyph that it is like, its advance, how many parts it has; then each part's glyph, and how
 * far it is moved. Numbers of font units. */
enum { LIKE, ADVANCE, COUNT, PARTS, WIDTH = PARTS + 3 * MT_RUN_PARTS };

/* Farther no writing moves a glyph, in font units. */
enum { FAR = 1 << 24, DOTTED_CIRCLE = 0x25CC };

void mt_runs_open(mt_shaper *shaper, mt_inks *inks, mt_runs *runs) {
    *runs = (mt_runs){shaper, inks, {.width = WIDTH}};
}

void mt_runs_free(mt_runs *runs) {
    mt_interned_free(&runs->drawings);
}

/* ---- places -------------------------------------------------------------------------------------------- */

/* How far from the run's left end a glyph's place in the line is. */
static int64_t pen_at(const mt_shaped_text *shaped, mt_run run, unsigned glyph) {
    int64_t pen = 0;
    unsigned from = shaped->backward ? glyph + 1 : run.start, to = shaped->backward ? run.end : glyph;
    for (unsigned i = from; i < to; i++) pen += shaped->at[i].x_advance;
    return pen;
}

bool mt_run_is_mark(const mt_shaper *shaper, const mt_shaped_text *shaped, mt_run run) {
    for (unsigned i = run.start; i < run.end; i++)
        if (!mt_shaper_is_mark(shaper, shaped->glyphs[i].codepoint)) return false;
    return true;
}

/* The first glyph that is no mark, where there is one. */
static unsigned find_base(const mt_shaper *shaper, const mt_shaped_text *shaped, mt_run run) {
    unsigned i = run.start;
    while (i < run.end && mt_shaper_is_mark(shaper, shaped->glyphs[i].codepoint)) i++;
    return i < run.end ? i : run.start;
}

/* Where the drawing has its origin. */
static void find_origin(const mt_runs *runs, const mt_shaped_text *shaped, mt_run run, int room,
                        int64_t origin[2]) {
    origin[0] = room == MT_RUN_WHOLE ? 0 : pen_at(shaped, run, (unsigned)room);
    origin[1] = 0;
    if (!mt_run_is_mark(runs->shaper, shaped, run)) return;
    origin[0] = pen_at(shaped, run, run.start) + shaped->at[run.start].x_offset;
    origin[1] = shaped->at[run.start].y_offset;
}

/* ---- drawings ------------------------------------------------------------------------------------------ */

static bool is_near(int64_t distance) {
    return distance > -FAR && distance < FAR;
}

/* HarfBuzz puts a dotted circle under a mark that stands alone, where the font has one. */
static bool has_circle(const mt_runs *runs, const mt_shaped_text *shaped, mt_run run) {
    uint32_t circle = mt_font_glyph(runs->inks->font, DOTTED_CIRCLE);
    for (unsigned i = run.start; i < run.end && circle; i++)
        if (shaped->glyphs[i].codepoint == circle) return true;
    return false;
}

/* Whether it is near enough. */
static bool add_part(const mt_shaped_text *shaped, mt_run run, unsigned glyph, const int64_t origin[2],
                     int32_t *row) {
    int64_t dx = pen_at(shaped, run, glyph) + shaped->at[glyph].x_offset - origin[0];
    int64_t dy = shaped->at[glyph].y_offset - origin[1];
    if (!is_near(dx) || !is_near(dy)) return false;
    int32_t *part = row + PARTS + 3 * row[COUNT]++;
    part[0] = (int32_t)shaped->glyphs[glyph].codepoint;
    part[1] = (int32_t)dx;
    part[2] = (int32_t)dy;
    return true;
}

static bool fill_row(const mt_runs *runs, const mt_shaped_text *shaped, mt_run run, int room, int32_t *row) {
    int64_t origin[2], advance = 0;
    unsigned like = room == MT_RUN_WHOLE ? find_base(runs->shaper, shaped, run) : (unsigned)room;
    find_origin(runs, shaped, run, room, origin);
    bool near = true;
    for (unsigned i = run.start; i < run.end && near; i++) {
        if (room == MT_RUN_WHOLE || i == (unsigned)room) advance += shaped->at[i].x_advance;
        if (!mt_inks_blank(runs->inks, shaped->glyphs[i].codepoint))
            near = add_part(shaped, run, i, origin, row);
    }
    row[LIKE] = (int32_t)shaped->glyphs[like].codepoint;
    row[ADVANCE] = (int32_t)advance;
    return near && is_near(advance);
}

/* The number of the glyph that is the drawing by itself, where there is one. */
static uint32_t find_glyph(const mt_runs *runs, const int32_t *row) {
    const int32_t *part = row + PARTS;
    bool one = row[COUNT] == 1 && part[1] == 0 && part[2] == 0;
    uint32_t glyph = one ? (uint32_t)part[0] : (uint32_t)row[LIKE];
    bool blank = row[COUNT] == 0 && mt_inks_blank(runs->inks, glyph);
    return (one || blank) && mt_shaper_advance(runs->shaper, glyph) == row[ADVANCE] ? glyph : MT_NO_DRAWING;
}

static mt_status number_row(mt_runs *runs, const int32_t *row, uint32_t *number) {
    int index;
    *number = find_glyph(runs, row);
    if (*number != MT_NO_DRAWING) return MT_OK;
    mt_status status = mt_intern(&runs->drawings, row, &index);
    if (status == MT_OK) *number = MT_COMPOSED_FIRST + (uint32_t)index;
    return status;
}

mt_status mt_runs_add(mt_runs *runs, const mt_shaped_text *shaped, mt_run run, int room, uint32_t *number) {
    int32_t row[WIDTH] = {0};
    *number = MT_NO_DRAWING;
    if (run.end - run.start > MT_RUN_PARTS || has_circle(runs, shaped, run)) return MT_OK;
    return fill_row(runs, shaped, run, room, row) ? number_row(runs, row, number) : MT_OK;
}

mt_status mt_runs_add_blank(mt_runs *runs, const mt_shaped_text *shaped, unsigned room, uint32_t *number) {
    int32_t row[WIDTH] = {0};
    row[LIKE] = (int32_t)shaped->glyphs[room].codepoint;
    row[ADVANCE] = shaped->at[room].x_advance;
    return number_row(runs, row, number);
}

mt_status mt_runs_compose(const mt_runs *runs, uint32_t *number) {
    mt_reference parts[MT_RUN_PARTS];
    if (*number < MT_COMPOSED_FIRST) return MT_OK;
    const int32_t *row = mt_interned_row(&runs->drawings, (int)(*number - MT_COMPOSED_FIRST));
    mt_composed composed = {{row[COUNT], parts}, row[ADVANCE], (uint32_t)row[LIKE]};
    for (int i = 0; i < row[COUNT]; i++) {
        const int32_t *part = row + PARTS + 3 * i;
        parts[i] = (mt_reference){(uint32_t)part[0], part[1], part[2]};
    }
    mt_status status = mt_font_compose(runs->inks->font, &composed, number);
    if (status != MT_OK) *number = MT_NO_DRAWING;
    return status == MT_NO_MEMORY ? status : MT_OK;
}
