/* morphotype sheet: a grid of characters × places between two fonts. */
#include "base/memory.h"
#include "commands.h"
#include "messages.h"
#include "picture/canvas.h"
#include "picture/picture.h"
#include "sources.h"
#include "work.h"

#include <stdio.h>
#include <string.h>

#define STEPS 6
#define SIZE 72.0

/* "Family Style"; from mt_new, NULL when out of memory. */
static char *font_title(const mt_font *font) {
    const char *family = mt_font_family(font), *style = mt_font_style(font);
    size_t room = strlen(family) + strlen(style) + 2;
    char *title = mt_new(room, 1);
    if (title) snprintf(title, room, "%s %s", family, style);
    return title;
}

static mt_status save(cli_work *work, const char *title_a, const char *title_b) {
    const cli_options *options = work->options;
    mt_sheet sheet = {.choices = work->chosen.order.list,
                      .count = work->chosen.order.count,
                      .at = options->at,
                      .step_count = options->at_count,
                      .size = options->size > 0 ? options->size : SIZE,
                      .rows_per_page = options->rows,
                      .title_a = title_a,
                      .title_b = title_b,
                      .made = work_made,
                      .user = work};
    return mt_sheet_save(work->blend, &sheet, options->output);
}

static int draw(cli_work *work) {
    char *title_a = font_title(work->fonts[0]), *title_b = font_title(work->fonts[1]);
    mt_status status = title_a && title_b ? save(work, title_a, title_b) : MT_NO_MEMORY;
    mt_free(title_a);
    mt_free(title_b);
    return status == MT_OK ? DONE : work_fail(work, status);
}

static int check(const cli_options *options) {
    mt_format format;
    if (!options->output) return misuse(options->command, "-o OUT.pdf, .png or .svg is wanted");
    if (mt_format_of(options->output, &format) != MT_OK)
        return misuse(options->command, "-o %s: sheet writes .pdf, .png and .svg files", options->output);
    if (!options->text && !options->chars_file)
        return misuse(options->command, "--text TEXT or --chars FILE is wanted");
    return DONE;
}

static int run(cli_options *options) {
    cli_work work;
    int outcome = check(options);
    if (outcome == DONE) outcome = output_check(options->output);
    if (outcome == DONE) outcome = sources_spare_numbered(options, options->output, 0);
    if (outcome == DONE) outcome = options_spread(options, STEPS);
    if (outcome != DONE) return outcome;
    outcome = work_begin(options, &work);
    if (outcome == DONE) outcome = draw(&work);
    work_end(&work);
    return outcome;
}

const cli_command sheet_command = {
    .name = "sheet",
    .summary = "a grid of characters and places between two fonts, page by page",
    .synopsis = "FONT FONT --chars FILE|--text TEXT -o OUT.pdf|png|svg [OPTION...]",
    .text = "Draws each character or glyph, a row each, at 6 places, or at those of --steps or --at. A "
            "PDF holds all pages; the pages of PNG and SVG are OUT.png, OUT-2.png and so on."
            "\n--text wants all of its characters in both fonts; of --chars those are left out that one "
            "font lacks.",
    .examples = {{"Some letters at five places:",
                  "morphotype sheet A.ttf B.otf --text type --steps 5 -o sheet.pdf"}},
    .reads = CLI_FONT_FILES,
    .writes = "pdf png svg",
    .takes = "oantczpSLP01@",
    .at_up = true,
    .fonts_min = 2,
    .fonts_max = 2,
    .run = run,
};
