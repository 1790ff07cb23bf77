/* The sheet: a grid of characters, or glyphs, × steps over as many pages as it takes.
 *
 *     T = 0: Sans Bold                 1 / 3
 *     T = 1: Serif Book
 *               T = 0   T = 0.5   T = 1
 *     U+0041      A        A        A
 *     U+0042      B        B        B
 */
#include "base/file_set.h"
#include "base/memory.h"
#include "picture/canvas.h"
#include "picture/label.h"
#include "picture/picture.h"
#include "picture/typeset.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Shares of a cell's side. */
#define MARGIN 0.5
#define EM 0.7     /* how large a glyph is drawn */
#define INSET 0.04 /* kept free inside a cell */
/* Shares of a label's height. */
#define LINE 1.8
#define GUTTER 1.5 /* between the code points and the cells */
#define HEADING_MOST 16.0

#define A4_PROPORTION 1.4142135623730951

typedef struct sheet_page {
    const mt_sheet *sheet;
    mt_typeset *instances;
    int rows; /* on a full page */
    int pages;
    double label_height; /* picture units, as all that follows */
    double heading;      /* width of the code points' column */
    double header;       /* height of the titles and the T */
    double width, height;
} sheet_page;

/* ---- the layout ---------------------------------------------------------------------------------------- */

/* Names longer than HEADING_MOST are drawn smaller. */
static double widest_heading(const mt_sheet *sheet, double height) {
    char text[MT_CHOICE_LABEL_ROOM];
    double width = 0;
    for (int i = 0; i < sheet->count; i++) {
        mt_choice_label(&sheet->choices[i], text);
        width = fmax(width, mt_label_width(text, height));
    }
    return fmin(width, HEADING_MOST * height);
}

static int rows_of_a_page(const sheet_page *page) {
    const mt_sheet *sheet = page->sheet;
    double room = page->width * A4_PROPORTION - 2 * MARGIN * sheet->size - page->header;
    int rows = sheet->rows_per_page > 0 ? sheet->rows_per_page : (int)fmax(1, room / sheet->size);
    return rows < sheet->count ? rows : sheet->count;
}

static void lay_out(sheet_page *page) {
    const mt_sheet *sheet = page->sheet;
    double margins = 2 * MARGIN * sheet->size;
    page->label_height = mt_label_height(sheet->size);
    page->heading = widest_heading(sheet, page->label_height) + GUTTER * page->label_height;
    page->header = 4 * LINE * page->label_height;
    page->width = margins + page->heading + sheet->step_count * sheet->size;
    page->rows = rows_of_a_page(page);
    page->height = margins + page->header + page->rows * sheet->size;
    page->pages = (sheet->count + page->rows - 1) / page->rows;
}

/* ---- the drawing --------------------------------------------------------------------------------------- */

static void draw_title(const sheet_page *page, cairo_t *cairo, int t, const char *name, double right,
                       double y) {
    double left = MARGIN * page->sheet->size, height = page->label_height,
           label = mt_label_width("T = 0: ", height) + height / 2;
    mt_label_draw(cairo, t == 0 ? "T = 0:" : "T = 1:", left, y, height);
    if (name)
        mt_label_draw(cairo, name, left + label, y, mt_label_fitting(name, height, right - left - label));
}

static void draw_header(const sheet_page *page, cairo_t *cairo, int number) {
    const mt_sheet *sheet = page->sheet;
    char text[32];
    double height = page->label_height, line = LINE * height, margin = MARGIN * sheet->size,
           y = margin + height;
    snprintf(text, sizeof text, "%d / %d", number + 1, page->pages);
    double right = page->width - margin - mt_label_width(text, height);
    mt_label_draw(cairo, text, right, y, height);
    draw_title(page, cairo, 0, sheet->title_a, right - height, y);
    draw_title(page, cairo, 1, sheet->title_b, right - height, y + line);
    for (int i = 0; i < sheet->step_count; i++) {
        mt_label_at(page->instances[i].at, text, sizeof text);
        double x = margin + page->heading + (i + 0.5) * sheet->size;
        mt_label_draw_centred(cairo, text, x, margin + page->header - 0.5 * line,
                              mt_label_fitting(text, height, sheet->size * 0.9));
    }
}

static void draw_grid(const sheet_page *page, cairo_t *cairo, int rows) {
    double size = page->sheet->size, top = MARGIN * size + page->header, left = MARGIN * size + page->heading;
    double right = left + page->sheet->step_count * size;
    cairo_save(cairo);
    cairo_set_source_rgb(cairo, 0.8, 0.8, 0.8);
    cairo_set_line_width(cairo, fmax(0.5, size / 200));
    for (int i = 0; i <= rows; i++) {
        cairo_move_to(cairo, left, top + i * size);
        cairo_line_to(cairo, right, top + i * size);
    }
    for (int i = 0; i <= page->sheet->step_count; i++) {
        cairo_move_to(cairo, left + i * size, top);
        cairo_line_to(cairo, left + i * size, top + rows * size);
    }
    cairo_stroke(cairo);
    cairo_restore(cairo);
}

/* The box, about the origin, of a character's ink and advances at all steps, em. */
static mt_extents row_extents(const sheet_page *page, int index) {
    mt_extents row = {0};
    for (int i = 0; i < page->sheet->step_count; i++) {
        uint32_t glyph;
        if (!mt_typeset_glyph(&page->instances[i], &page->sheet->choices[index], &glyph)) continue;
        mt_extents one = mt_glyph_extents(&page->instances[i], glyph);
        row.left = fmin(row.left, one.left);
        row.right = fmax(row.right, fmax(one.right, one.advance));
        row.bottom = fmin(row.bottom, one.bottom);
        row.top = fmax(row.top, one.top);
    }
    return row;
}

/* The size of an em in which a row's glyphs fit their cells. */
static double row_em(double size, mt_extents row) {
    double extent = fmax(row.right - row.left, row.top - row.bottom);
    return fmin(EM * size, extent > 0 ? (1 - 2 * INSET) * size / extent : EM * size);
}

/* Baselines are those of the font, unless ink would leave the cell. */
static double row_baseline(const mt_typeset *instance, double size, double em, mt_extents row) {
    double baseline = size / 2 + (instance->ascent - instance->descent) / 2 * em;
    baseline = fmax(baseline, INSET * size + row.top * em);
    return fmin(baseline, (1 - INSET) * size + row.bottom * em);
}

static void draw_row(const sheet_page *page, cairo_t *cairo, int index, double top) {
    char text[MT_CHOICE_LABEL_ROOM];
    const mt_choice *choice = &page->sheet->choices[index];
    double size = page->sheet->size, left = MARGIN * size, height = page->label_height;
    mt_extents row = row_extents(page, index);
    double em = row_em(size, row), baseline = top + row_baseline(page->instances, size, em, row);
    mt_choice_label(choice, text);
    mt_label_draw(cairo, text, left, top + (size + height) / 2,
                  mt_label_fitting(text, height, HEADING_MOST * height));
    left += page->heading;
    for (int i = 0; i < page->sheet->step_count; i++, left += size) {
        uint32_t glyph;
        if (!mt_typeset_glyph(&page->instances[i], choice, &glyph)) continue;
        mt_extents one = mt_glyph_extents(&page->instances[i], glyph);
        double middle = (fmin(0, one.left) + fmax(one.right, one.advance)) / 2;
        mt_glyph_draw(&page->instances[i], glyph, cairo, left + size / 2 - middle * em, baseline, em);
    }
}

static void draw_page(const sheet_page *page, cairo_t *cairo, int number) {
    const mt_sheet *sheet = page->sheet;
    int first = number * page->rows,
        rows = sheet->count - first < page->rows ? sheet->count - first : page->rows;
    draw_header(page, cairo, number);
    draw_grid(page, cairo, rows);
    for (int i = 0; i < rows; i++) {
        double top = MARGIN * sheet->size + page->header + i * sheet->size;
        draw_row(page, cairo, first + i, top);
    }
}

/* ---- the files ----------------------------------------------------------------------------------------- */

static mt_status save_pages_in_one(const sheet_page *page, mt_format format, const char *path) {
    mt_canvas canvas;
    mt_status status = mt_canvas_open(format, page->width, page->height, &canvas);
    if (status != MT_OK) return status;
    for (int i = 0; i < page->pages; i++) {
        if (i > 0) mt_canvas_next_page(&canvas);
        draw_page(page, canvas.cairo, i);
    }
    status = mt_canvas_save(&canvas, path);
    mt_canvas_close(&canvas);
    return status;
}

typedef struct page_file {
    char *path;
    mt_buffer bytes;
} page_file;

/* `path` for the first page, then NAME-2.png and so on; from mt_new, NULL when out of memory. */
static char *page_path(const char *path, int number) {
    if (number == 0) return mt_copy_text(path);
    size_t room = strlen(path) + 16;
    int stem = (int)(strrchr(path, '.') - path);
    char *name = mt_new(room, 1);
    if (name) snprintf(name, room, "%.*s-%d%s", stem, path, number + 1, path + stem);
    return name;
}

static mt_status draw_file(const sheet_page *page, mt_format format, const char *path, int number,
                           page_file *file) {
    mt_canvas canvas;
    file->path = page_path(path, number);
    if (!file->path) return MT_NO_MEMORY;
    mt_status status = mt_canvas_open(format, page->width, page->height, &canvas);
    if (status != MT_OK) return status;
    draw_page(page, canvas.cairo, number);
    status = mt_canvas_finish(&canvas, &file->bytes);
    mt_canvas_close(&canvas);
    return status;
}

/* All or none. */
static mt_status write_files(const page_file *files, int count) {
    mt_file_set set;
    int failed;
    mt_status status = mt_file_set_begin(files[0].path, &set);
    if (status != MT_OK) return status;
    for (int i = 0; status == MT_OK && i < count; i++)
        status = mt_file_set_add(&set, files[i].path, files[i].bytes.bytes, files[i].bytes.length);
    if (status == MT_OK) status = mt_file_set_place(&set, &failed);
    mt_file_set_free(&set);
    return status;
}

/* None is written before all are drawn. */
static mt_status save_pages_apart(const sheet_page *page, mt_format format, const char *path) {
    page_file *files = mt_new((size_t)page->pages, sizeof *files);
    mt_status status = files ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; status == MT_OK && i < page->pages; i++)
        status = draw_file(page, format, path, i, &files[i]);
    if (status == MT_OK) status = write_files(files, page->pages);
    for (int i = 0; files && i < page->pages; i++) {
        mt_free(files[i].path);
        mt_buffer_free(&files[i].bytes);
    }
    mt_free(files);
    return status;
}

/* ---- the sheet ----------------------------------------------------------------------------------------- */

static bool in_range(const mt_sheet *sheet) {
    return sheet->step_count >= 1 && sheet->step_count <= MT_STEPS_MAX && sheet->count >= 1 &&
           sheet->rows_per_page >= 0 && sheet->size >= MT_SIZE_MIN && sheet->size <= MT_SIZE_MAX;
}

mt_status mt_sheet_save(mt_blend *blend, const mt_sheet *sheet, const char *path) {
    mt_format format;
    mt_status status = mt_format_of(path, &format);
    if (status != MT_OK) return status;
    if (!in_range(sheet)) return MT_BAD_PARAMETER;
    sheet_page page = {.sheet = sheet};
    status = mt_typesets_new(blend, sheet->choices, sheet->count, sheet->at, sheet->step_count, sheet->made,
                             sheet->user, &page.instances);
    if (status == MT_OK) {
        lay_out(&page);
        status = format == MT_FORMAT_PDF ? save_pages_in_one(&page, format, path)
                                         : save_pages_apart(&page, format, path);
    }
    mt_typesets_free(page.instances, sheet->step_count);
    return status;
}
