/* morphotype report: which glyphs between two fonts need a look, as a page or as data. */
#include "commands.h"
#include "messages.h"
#include "report/report.h"
#include "work.h"

#include <stdio.h>
#include <string.h>

static int check(const cli_options *options) {
    mt_report_format format;
    if (!options->output) return misuse(options->command, "-o OUT.html or .json is wanted");
    if (mt_report_format_of(options->output, &format) != MT_OK)
        return misuse(options->command, "-o %s: report writes .html and .json files", options->output);
    return output_check(options->output);
}

/* ---- --fail-on ------------------------------------------------------------------------------------------- */

/* COULD_NOT, said, for a report that --fail-on lets fail. */
static int judge(const cli_options *options, const mt_report *report) {
    char reasons[128] = "";
    bool any = options->fail_flags != 0;
    int count = mt_report_flagged(report, any ? options->fail_flags : MT_FLAG_ALL),
        most = any ? 1 : options->fail_count;
    if (most == 0 || count < most) return DONE;
    for (unsigned flag = 1; flag & MT_FLAG_ALL; flag <<= 1) {
        size_t used = strlen(reasons);
        if (!(options->fail_flags & flag) || !mt_report_flagged(report, flag)) continue;
        snprintf(reasons + used, sizeof reasons - used, "%s%s", used ? ", " : " for ",
                 mt_report_flag_name((mt_report_flag)flag));
    }
    return fail("%s: %d of %d glyph%s flagged%s (--fail-on)", options->output, count, mt_report_count(report),
                mt_report_count(report) == 1 ? "" : "s", reasons);
}

/* ---- the file -------------------------------------------------------------------------------------------- */

static int make(cli_work *work) {
    mt_report *report = NULL;
    mt_status status = mt_report_new(work->blend, &report);
    if (status == MT_OK) status = mt_report_save(report, work->options->output);
    progress_erase(&work->bar);
    int outcome = status == MT_OK ? judge(work->options, report) : work_fail(work, status);
    mt_report_free(report);
    return outcome;
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
    .takes = "otcBELP01",
    .fonts_min = 2,
    .fonts_max = 2,
    .run = run,
};
