/* morphotype report: which glyphs between two fonts need a look, as a page or as data. */
#include "commands.h"
#include "messages.h"
#include "report/report.h"
#include "work.h"

static int check(const cli_options *options) {
    mt_report_format format;
    if (!options->output) return misuse(options->command, "-o OUT.html or .json is wanted");
    if (mt_report_format_of(options->output, &format) != MT_OK)
        return misuse(options->command, "-o %s: report writes .html and .json files", options->output);
    return output_check(options->output);
}

static int make(cli_work *work) {
    mt_status status = mt_report_save(&work->blend->row, work->options->output);
    return status == MT_OK ? DONE : work_fail(work, status);
}

static int run(cli_options *options) {
    cli_work work;
    int outcome = check(options);
    if (outcome != DONE) return outcome;
    outcome = work_begin(options, &work);
    if (outcome == DONE) outcome = make(&work);
    work_end(&work);
    return outcome;
}

const cli_command report_command = {
    .name = "report",
    .summary = "which glyphs between two fonts need a look, and why",
    .synopsis = "FONT FONT -o OUT.html|json [OPTION...]",
    .text = "Measures every glyph that blend makes of the same characters, ligatures and other forms "
            "too, at 17 places, and lists them, the worst first, by what an eye would stumble over: ink "
            "that strays, clots, ink out of range, parts and holes that come or go. The page shows "
            "strips."
            "\n--text wants all of its characters in both fonts; of --chars those are left out that one "
            "font lacks. A glyph that cannot be blended is in the report. A glyph without a character "
            "has its name: /f_i.",
    .examples = {{"A page with the glyphs that need a look:",
                  "morphotype report A.ttf B.otf -o report.html"}},
    .reads = CLI_FONT_FILES,
    .writes = "html json",
    .takes = "otcELP",
    .fonts_min = 2,
    .fonts_max = 2,
    .run = run,
};
