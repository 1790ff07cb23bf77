/* morphotype specimen: a page on which the variable font of two fonts, or more, is tried out. */
#include "base/memory.h"
#include "base/utf.h"
#include "commands.h"
#include "messages.h"
#include "specimen/specimen.h"
#include "work.h"

/* The text's characters, without its named glyphs, which a page cannot set; from mt_new, NULL when out of memory. */
static char *plain_text(const choices *text) {
    char *plain = mt_new((size_t)text->count * 4 + 1, 1), *end = plain;
    for (int i = 0; plain && i < text->count; i++)
        if (!text->list[i].name) end += mt_utf8_put(text->list[i].code_point, end);
    return plain;
}

static int save(cli_work *work) {
    const cli_options *options = work->options;
    char *text = options->text ? plain_text(&work->text) : NULL;
    if (options->text && !text) return work_fail(work, MT_NO_MEMORY);
    const mt_specimen_request request = {
        .variable = work->variable, .text = text, .made = work_made, .user = work};
    mt_status status = mt_specimen_save(&request, options->output);
    mt_free(text);
    if (status != MT_OK) return work_fail(work, status);
    if (options->verbose) say("%s: %d fonts", options->output, options->font_count);
    return DONE;
}

static int make(cli_work *work) {
    mt_status status = work_warn(work);
    return status == MT_OK ? save(work) : work_fail(work, status);
}

static int check(const cli_options *options) {
    if (!options->output) return misuse(options->command, "-o OUT.html is wanted");
    if (!mt_specimen_is_page(options->output))
        return misuse(options->command, "-o %s: specimen writes .html files", options->output);
    return output_check(options->output);
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

const cli_command specimen_command = {
    .name = "specimen",
    .summary = "a page to try out the variable font of two fonts, or more",
    .synopsis = "FONT FONT [FONT...] -o OUT.html [OPTION...]",
    .text =
        "Makes the font that variable makes, of the same characters, and a page of HTML that has it "
        "in it: a slider and a play button for its axis, a text to type in, its sizes, and all "
        "characters, with those marked that report flags."
        "\n--text is the text that the page begins with, too; with --chars, only that. The page is one file "
        "and fetches nothing.",
    .examples = {{"A page to try the variable font on:", "morphotype specimen A.ttf B.otf -o specimen.html"}},
    .reads = CLI_FONT_FILES,
    .writes = "html",
    .takes = "otcFGELSP01",
    .text_with_chars = true,
    .fonts_min = 2,
    .fonts_max = MT_VARIABLE_FONTS_MAX,
    .run = run,
};
