/* morphotype variable: one font that holds all between two fonts, or between more of them in a row. */
#include "base/memory.h"
#include "commands.h"
#include "messages.h"
#include "save/designspace.h"
#include "save/save.h"
#include "sources.h"
#include "work.h"

static int save(cli_work *work) {
    const cli_options *options = work->options;
    size_t length;
    int failed;
    const mt_saving saving = {
        .count = 1, .paths = &options->output, .made = work_made, .user = work, .lengths = &length};
    mt_status status = mt_variable_save_when(work->variable, &saving, &failed);
    if (status != MT_OK) return work_fail(work, status);
    if (options->verbose) say("%s: %d fonts, %zu bytes", options->output, options->font_count, length);
    work_say_proved(work);
    return DONE;
}

static int make(cli_work *work) {
    mt_status status = work_warn(work);
    return status == MT_OK ? save(work) : work_fail(work, status);
}

/* No source is in the folder of a designspace's masters, which is replaced. */
static int spare_masters(const cli_options *options) {
    char *folder = mt_designspace_folder(options->output);
    int outcome = folder ? sources_spare(options, folder) : fail_status(options->output, MT_NO_MEMORY);
    mt_free(folder);
    return outcome;
}

static int check(const cli_options *options) {
    mt_font_format format;
    if (!options->output) return misuse(options->command, "-o OUT.ttf|woff2|designspace is wanted");
    if (!mt_font_format_of(options->output, &format) || format == MT_FONT_UFO)
        return misuse(options->command, "-o %s: variable writes .ttf, .woff2 and .designspace",
                      options->output);
    if (options->style_count > 1) return misuse(options->command, "--style: one name is wanted");
    mt_status status = mt_save_check(options->output);
    if (status != MT_OK) return fail_status(options->output, status);
    int outcome = format == MT_FONT_DESIGNSPACE ? spare_masters(options) : DONE;
    return outcome == DONE ? directory_check(options->output) : outcome;
}

static int run(cli_options *options) {
    cli_work work;
    int outcome = check(options);
    if (outcome != DONE) return outcome;
    outcome = work_begin_variable(options, &work);
    if (outcome == DONE) outcome = make(&work);
    work_end(&work);
    return outcome;
}

const cli_command variable_command = {
    .name = "variable",
    .summary = "one variable font from any two fonts, or more",
    .synopsis = "FONT FONT [FONT...] -o OUT.ttf|woff2|designspace [OPTION...]",
    .text = "Makes one font with an axis, MORF, from 0 (the first font, and the default) to 100 (the "
            "last); fonts in between are evenly spaced on it. It has every character that all of the "
            "fonts have, or of those that --text or --chars names. With --glyphs first the first font "
            "alone counts for this, and what the others lack stays as it is in the first."
            "\nA glyph that cannot be blended is named on stderr; it switches half-way from the one "
            "font's own outline to the other's. OUT.designspace is a document; its masters are UFOs in "
            "OUT-masters."
            "\nWith --avar 25:10,50:40 the axis shows at 25 what it shows at 10 without, at 50 what at "
            "40; in between it is even, and the ends stay. --axis wght=400..900 makes it the weight "
            "axis, named by weights.",
    .examples = {{"One font from the first to the second:",
                  "morphotype variable A.ttf B.otf -o Variable.ttf"},
                 {"With a weight axis:",
                  "morphotype variable A.ttf B.otf --axis wght=400..900 --family Between -o Between.ttf"},
                 {"Its masters, for an editor or fontmake:",
                  "morphotype variable A.ttf B.otf -o Variable.designspace"}},
    .reads = CLI_FONT_FILES,
    .writes = "ttf woff2 designspace",
    .takes = "otcFYGELXASP",
    .fonts_min = 2,
    .fonts_max = MT_VARIABLE_FONTS_MAX,
    .run = run,
};
