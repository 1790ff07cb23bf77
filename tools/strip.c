/* morphotype strip: a text at several places between two fonts. */
#include "commands.h"
#include "messages.h"
#include "picture/canvas.h"
#include "picture/picture.h"
#include "work.h"

#define STEPS 8
#define SIZE 96.0

static int draw(cli_work *work) {
    const cli_options *options = work->options;
    mt_strip strip = {.text = work->text.list,
                      .length = work->text.count,
                      .at = options->at,
                      .step_count = options->at_count,
                      .size = options->size > 0 ? options->size : SIZE,
                      .labels = !options->no_labels,
                      .made = work_made,
                      .user = work};
    mt_status status = mt_strip_save(work->blend, &strip, options->output);
    return status == MT_OK ? DONE : work_fail(work, status);
}

static int check(const cli_options *options) {
    mt_format format;
    if (!options->output) return misuse(options->command, "-o OUT.png, .svg or .pdf is wanted");
    if (mt_format_of(options->output, &format) != MT_OK)
        return misuse(options->command, "-o %s: strip writes .png, .svg and .pdf files", options->output);
    if (!options->text) return misuse(options->command, "--text TEXT is wanted");
    return DONE;
}

static int run(cli_options *options) {
    cli_work work;
    int outcome = check(options);
    if (outcome == DONE) outcome = output_check(options->output);
    if (outcome == DONE) outcome = options_spread(options, STEPS);
    if (outcome != DONE) return outcome;
    outcome = work_begin(options, &work);
    if (outcome == DONE) outcome = draw(&work);
    work_end(&work);
    return outcome;
}

const cli_command strip_command = {
    .name = "strip",
    .summary = "a text at several places between two fonts, as a picture",
    .synopsis = "FONT FONT --text TEXT -o OUT.png|svg|pdf [OPTION...]",
    .text = "Draws the text at 8 places, or at those of --steps or --at, with T under each. A short text "
            "has its steps side by side, one wider than three em has them below one another. Each --text "
            "is a line.",
    .examples = {{"A text at five places, side by side:",
                  "morphotype strip A.ttf B.otf --text type --steps 5 -o strip.png"}},
    .reads = CLI_FONT_FILES,
    .writes = "png svg pdf",
    .takes = "oantzlSLP01@",
    .at_up = true,
    .fonts_min = 2,
    .fonts_max = 2,
    .run = run,
};
