/* morphotype blend: fonts between two fonts. All of them are made before the first is put in its place. */
#include "commands.h"
#include "morph/check/reach.h"
#include "messages.h"
#include "outputs.h"
#include "save/save.h"
#include "sources.h"
#include "work.h"

#include <stdio.h>
#include <string.h>

static void say_made(const cli_options *options, int i, const outputs *named) {
    char up[40] = "";
    if (options->at_up[i] != options->at[i]) snprintf(up, sizeof up, ",y=%g", options->at_up[i]);
    say("%s: T = %g%s, %zu bytes", named->paths[i], options->at[i], up, named->lengths[i]);
}

static int save(cli_work *work, const outputs *named) {
    const cli_options *options = work->options;
    int failed, unsaid = 0;
    const mt_saving saving = {.t = options->at,
                              .count = named->count,
                              .paths = (const char *const *)named->paths,
                              .made = work_made,
                              .user = work,
                              .lengths = named->lengths,
                              .unsaid = &unsaid};
    mt_status status = mt_blend_save_when(work->blend, &saving, &failed);
    if (status != MT_OK && failed >= 0) {
        progress_erase(&work->bar);
        return fail_status(named->paths[failed], status);
    }
    if (status != MT_OK) return work_fail(work, status);
    work_say_unsaid(options, unsaid);
    for (int i = 0; options->verbose && i < named->count; i++) say_made(options, i, named);
    work_say_proved(work);
    return DONE;
}

static int check_outputs(const cli_options *options, const outputs *named) {
    int outcome = DONE;
    for (int i = 0; outcome == DONE && i < named->count; i++) {
        mt_status status = mt_save_check(named->paths[i]);
        outcome = status == MT_OK ? directory_check(named->paths[i]) : fail_status(named->paths[i], status);
        if (outcome == DONE) outcome = sources_spare(options, named->paths[i]);
    }
    return outcome;
}

static int make(cli_work *work, const outputs *named) {
    mt_status status = work_warn(work);
    return status == MT_OK ? save(work, named) : work_fail(work, status);
}

static int blend(cli_options *options, const outputs *named) {
    cli_work work;
    int outcome = check_outputs(options, named);
    if (outcome != DONE) return outcome;
    outcome = work_begin(options, &work);
    if (outcome == DONE) outcome = make(&work, named);
    work_end(&work);
    return outcome;
}

static int check(const cli_options *options) {
    mt_font_format format;
    if (!options->output) return misuse(options->command, "-o OUT.ttf|woff2|ufo is wanted");
    if (!mt_font_format_of(options->output, &format) || format == MT_FONT_DESIGNSPACE)
        return misuse(options->command, "-o %s: blend writes .ttf, .woff2 and .ufo", options->output);
    int places = options->at_count ? options->at_count : 1;
    if (options->style_count && options->style_count != places)
        return misuse(options->command, "--style: %d name%s for %d font%s", options->style_count,
                      options->style_count == 1 ? "" : "s", places, places == 1 ? "" : "s");
    return outputs_check_places(options);
}

static int run(cli_options *options) {
    outputs named = {0};
    int outcome = check(options);
    if (outcome == DONE) outcome = options_spread(options, 1);
    if (outcome != DONE) return outcome;
    mt_status status = outputs_name(options, &named);
    outcome = status == MT_OK ? blend(options, &named) : fail_status(options->output, status);
    outputs_free(&named);
    return outcome;
}

const cli_command blend_command = {
    .name = "blend",
    .summary = "a font between two fonts",
    .synopsis = "FONT FONT -o OUT.ttf|woff2|ufo [--at T[,T...]] [OPTION...]",
    .text = "Makes the font at T (0.5 without --at) of every character that both fonts have, or of those "
            "that --text or --chars names. Several T make several fonts: OUT-0.25.ttf, OUT-0.5.ttf and "
            "so on."
            "\n--text wants all of its characters in both fonts; of --chars those are left out that one "
            "font lacks. With --glyphs first the first font alone counts for all this, and what the "
            "second lacks stays as it is in the first."
            "\nA glyph that cannot be blended is named on stderr, and the nearer font's own outline "
            "stands in for it. OUT.ufo is a directory; one that is there already is replaced when it is "
            "a UFO."
            "\nPast the ends, from -1 to 2, each glyph goes on as it came, as far as it keeps its parts and "
            "holes: those that stay short are named.",
    .examples = {{"A font half-way:", "morphotype blend A.ttf B.otf -o Between.ttf"},
                 {"Three fonts, Between-0.25.ttf, Between-0.5.ttf and Between-0.75.ttf:",
                  "morphotype blend A.ttf B.otf --at 0.25,0.5,0.75 -o Between.ttf"},
                 {"A font of these letters, for the web:",
                  "morphotype blend A.ttf B.otf --text type --family Between -o Between.woff2"}},
    .reads = CLI_FONT_FILES,
    .writes = "ttf woff2 ufo",
    .takes = "oatcFYGELSPQ01@",
    .at_up = true,
    .at_past = MT_REACH_MOST,
    .fonts_min = 2,
    .fonts_max = 2,
    .run = run,
};
