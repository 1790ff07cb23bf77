/* The strip: a text at several T, as the paper's figure 3 shows its blends.
 *
 *     short text: steps side by side         long text: steps below one another
 *
 *      AB     AB     AB                       A longer line of text
 *      cd     cd     cd                       T = 0
 *     T = 0  T = 0.5 T = 1                    A longer line of text
 *                                             T = 0.5
 */
#include "base/memory.h"
#include "picture/canvas.h"
#include "picture/label.h"
#include "picture/picture.h"
#include "picture/typeset.h"

/* A text with a line wider than this many em is long. */
#define SHORT_LINE 3.0
/* Distances, em. */
#define MARGIN 0.35
#define GAP 0.3        /* between steps */
#define LABEL_GAP 0.12 /* between the text and its label */

typedef struct strip_page {
    const mt_strip *strip;
    int line_count;
    mt_typeset *instances;  /* one a step */
    mt_line *lines;         /* line_count a step */
    double ascent, descent; /* of every line at every step, em */
    double step_width;      /* picture units, as all that follows */
    double step_height;     /* with the label */
    double label_height;    /* 0 without labels */
    bool stacked;           /* a long text */
} strip_page;

/* ---- the text ------------------------------------------------------------------------------------------ */

static bool ends_line(const mt_choice *choice) {
    return !choice->name && choice->code_point == '\n';
}

static int count_lines(const mt_strip *strip) {
    int lines = 1;
    for (int i = 0; i + 1 < strip->length; i++) lines += ends_line(&strip->text[i]);
    return lines;
}

/* Makes the fonts, of the text's characters and glyphs alone. */
static mt_status make_instances(mt_blend *blend, const mt_strip *strip, mt_typeset **instances) {
    mt_choice *choices = mt_new((size_t)strip->length + 1, sizeof *choices);
    int count = 0;
    if (!choices) return MT_NO_MEMORY;
    for (int i = 0; i < strip->length; i++)
        if (!ends_line(&strip->text[i])) choices[count++] = strip->text[i];
    mt_status status = count ? mt_typesets_new(blend, choices, count, strip->at, strip->step_count,
                                               strip->made, strip->user, instances)
                             : MT_BAD_PARAMETER;
    mt_free(choices);
    return status;
}

static mt_status shape_step(strip_page *page, int step) {
    const mt_choice *text = page->strip->text, *end = text + page->strip->length;
    for (int i = 0; i < page->line_count; i++) {
        int length = 0;
        while (text + length < end && !ends_line(&text[length])) length++;
        if (length > MT_PICTURE_SIDE_MAX) return MT_TOO_LARGE;
        mt_status status =
            mt_line_shape(&page->instances[step], text, length, &page->lines[step * page->line_count + i]);
        if (status != MT_OK) return status;
        text += length;
        if (text < end) text++;
    }
    return MT_OK;
}

/* ---- the layout ---------------------------------------------------------------------------------------- */

static double larger(double a, double b) {
    return a > b ? a : b;
}

/* What one step needs for its widest and highest line, so that all lines and all steps stand on common
 * baselines. */
static double measure_lines(strip_page *page) {
    double width = 0;
    for (int step = 0; step < page->strip->step_count; step++) {
        page->ascent = larger(page->ascent, page->instances[step].ascent);
        page->descent = larger(page->descent, page->instances[step].descent);
    }
    for (int i = 0; i < page->strip->step_count * page->line_count; i++) {
        mt_extents extents = page->lines[i].extents;
        page->ascent = larger(page->ascent, extents.top);
        page->descent = larger(page->descent, -extents.bottom);
        width = larger(width, extents.right - extents.left);
    }
    return width;
}

static double widest_label(const strip_page *page, double height) {
    char label[32];
    double width = 0;
    for (int i = 0; i < page->strip->step_count; i++) {
        mt_label_at(page->instances[i].at, label, sizeof label);
        width = larger(width, mt_label_width(label, height));
    }
    return width;
}

static void lay_out(strip_page *page) {
    const mt_strip *strip = page->strip;
    double width = measure_lines(page);
    page->stacked = width > SHORT_LINE;
    page->label_height = strip->labels ? mt_label_height(strip->size) : 0;
    page->step_width = larger(width * strip->size, widest_label(page, page->label_height));
    page->step_height = page->line_count * (page->ascent + page->descent) * strip->size;
    if (strip->labels) page->step_height += page->label_height + LABEL_GAP * strip->size;
}

/* The page's size for this many columns and rows of steps. */
static mt_status open_canvas(const strip_page *page, mt_format format, mt_canvas *canvas) {
    double size = page->strip->size;
    int steps = page->strip->step_count, columns = page->stacked ? 1 : steps,
        rows = page->stacked ? steps : 1;
    double width = 2 * MARGIN * size + columns * page->step_width + (columns - 1) * GAP * size;
    double height = 2 * MARGIN * size + rows * page->step_height + (rows - 1) * GAP * size;
    return mt_canvas_open(format, width, height, canvas);
}

/* ---- the drawing --------------------------------------------------------------------------------------- */

static void draw_label(const strip_page *page, int step, cairo_t *cairo, double left, double baseline) {
    char label[32];
    mt_label_at(page->instances[step].at, label, sizeof label);
    if (page->stacked)
        mt_label_draw(cairo, label, left, baseline, page->label_height);
    else
        mt_label_draw_centred(cairo, label, left + page->step_width / 2, baseline, page->label_height);
}

static void draw_step(const strip_page *page, int step, cairo_t *cairo, double left, double top) {
    double size = page->strip->size;
    for (int i = 0; i < page->line_count; i++) {
        const mt_line *line = &page->lines[step * page->line_count + i];
        mt_extents extents = line->extents;
        double slack = page->stacked ? 0 : (page->step_width - (extents.right - extents.left) * size) / 2;
        double baseline = top + (i * (page->ascent + page->descent) + page->ascent) * size;
        mt_line_draw(&page->instances[step], line, cairo, left + slack - extents.left * size, baseline, size);
    }
    if (page->strip->labels) draw_label(page, step, cairo, left, top + page->step_height);
}

static void draw_steps(const strip_page *page, cairo_t *cairo) {
    double size = page->strip->size, left = MARGIN * size, top = MARGIN * size;
    for (int step = 0; step < page->strip->step_count; step++) {
        draw_step(page, step, cairo, left, top);
        if (page->stacked)
            top += page->step_height + GAP * size;
        else
            left += page->step_width + GAP * size;
    }
}

static mt_status draw_page(strip_page *page, mt_format format, const char *path) {
    mt_canvas canvas = {0};
    mt_status status = MT_OK;
    for (int step = 0; status == MT_OK && step < page->strip->step_count; step++)
        status = shape_step(page, step);
    if (status != MT_OK) return status;
    lay_out(page);
    status = open_canvas(page, format, &canvas);
    if (status != MT_OK) return status;
    draw_steps(page, canvas.cairo);
    status = mt_canvas_save(&canvas, path);
    mt_canvas_close(&canvas);
    return status;
}

static void free_lines(strip_page *page) {
    for (int i = 0; page->lines && i < page->strip->step_count * page->line_count; i++)
        mt_line_free(&page->lines[i]);
    mt_free(page->lines);
}

static bool in_range(const mt_strip *strip) {
    return strip->step_count >= 1 && strip->step_count <= MT_STEPS_MAX && strip->size >= MT_SIZE_MIN &&
           strip->size <= MT_SIZE_MAX && strip->length <= MT_TEXT_MAX;
}

mt_status mt_strip_save(mt_blend *blend, const mt_strip *strip, const char *path) {
    mt_format format;
    mt_status status = mt_format_of(path, &format);
    if (status != MT_OK) return status;
    if (!in_range(strip)) return MT_BAD_PARAMETER;
    strip_page page = {.strip = strip, .line_count = count_lines(strip)};
    page.lines = mt_new((size_t)strip->step_count * (size_t)page.line_count, sizeof *page.lines);
    status = page.lines ? make_instances(blend, strip, &page.instances) : MT_NO_MEMORY;
    if (status == MT_OK) status = draw_page(&page, format, path);
    free_lines(&page);
    mt_typesets_free(page.instances, strip->step_count);
    return status;
}
