/* morphotype blend: fonts between two fonts. All of them are made before the first is put in its place. */
#include "base/memory.h"
#include "commands.h"
#include "messages.h"
#include "numbers.h"
#include "save/save.h"
#include "work.h"

#include <stdio.h>
#include <string.h>

/* Where the fonts go, as many as there are T. */
typedef struct outputs {
    int count;
    char **paths;
    size_t *lengths; /* bytes, once they are written */
} outputs;

/* OUT.ttf, or OUT-0.25.ttf where there are several; from mt_new, NULL when out of memory. */
static char *path_of(const cli_options *options, int index) {
    char t[32];
    if (options->at_count == 1) return mt_copy_text(options->output);
    size_t room = strlen(options->output) + sizeof t + 1;
    int stem = (int)(strrchr(options->output, '.') - options->output);
    char *path = mt_new(room, 1);
    number_write(options->at[index], t);
    if (path) snprintf(path, room, "%.*s-%s%s", stem, options->output, t, options->output + stem);
    return path;
}

static mt_status name_outputs(const cli_options *options, outputs *named) {
    size_t count = (size_t)options->at_count;
    named->paths = mt_new(count, sizeof *named->paths);
    named->lengths = mt_new(count, sizeof *named->lengths);
    if (!named->paths || !named->lengths) return MT_NO_MEMORY;
    named->count = options->at_count;
    for (int i = 0; i < named->count; i++) {
        named->paths[i] = path_of(options, i);
        if (!named->paths[i]) return MT_NO_MEMORY;
    }
    return MT_OK;
}

static void free_outputs(outputs *named) {
    for (int i = 0; i < named->count; i++) mt_free(named->paths[i]);
    mt_free(named->paths);
    mt_free(named->lengths);
}

static int save(cli_work *work, const outputs *named) {
    const cli_options *options = work->options;
    int failed;
    const mt_saving saving = {.t = options->at,
                              .count = named->count,
                              .paths = (const char *const *)named->paths,
                              .made = work_made,
                              .user = work,
                              .lengths = named->lengths};
    mt_status status = mt_blend_save_when(work->blend, &saving, &failed);
    if (status != MT_OK && failed >= 0) {
        progress_erase(&work->bar);
        return fail_status(named->paths[failed], status);
    }
    if (status != MT_OK) return work_fail(work, status);
    for (int i = 0; options->verbose && i < named->count; i++)
        say("%s: T = %g, %zu bytes", named->paths[i], options->at[i], named->lengths[i]);
    return DONE;
}

static int check_outputs(const outputs *named) {
    int outcome = DONE;
    for (int i = 0; outcome == DONE && i < named->count; i++) {
        mt_status status = mt_save_check(named->paths[i]);
        outcome = status == MT_OK ? directory_check(named->paths[i]) : fail_status(named->paths[i], status);
    }
    return outcome;
}

static int make(cli_work *work, const outputs *named) {
    mt_status status = work_warn(work);
    return status == MT_OK ? save(work, named) : work_fail(work, status);
}

static int blend(cli_options *options, const outputs *named) {
    cli_work work;
    int outcome = check_outputs(named);
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
    for (int i = 0; i < options->at_count; i++)
        for (int k = 0; k < i; k++)
            if (options->at[i] == options->at[k])
                return misuse(options->command, "--at: %g stands there twice", options->at[i]);
    return DONE;
}

static int run(cli_options *options) {
    outputs named = {0};
    int outcome = check(options);
    if (outcome == DONE) outcome = options_spread(options, 1);
    if (outcome != DONE) return outcome;
    mt_status status = name_outputs(options, &named);
    outcome = status == MT_OK ? blend(options, &named) : fail_status(options->output, status);
    free_outputs(&named);
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
            "a UFO.",
    .examples = {{"A font half-way:", "morphotype blend A.ttf B.otf -o Between.ttf"},
                 {"Three fonts, Between-0.25.ttf, Between-0.5.ttf and Between-0.75.ttf:",
                  "morphotype blend A.ttf B.otf --at 0.25,0.5,0.75 -o Between.ttf"},
                 {"A font of these letters, for the web:",
                  "morphotype blend A.ttf B.otf --text Type --family Between -o Between.woff2"}},
    .reads = CLI_FONT_FILES,
    .writes = "ttf woff2 ufo",
    .takes = "oatcFYGELSP",
    .fonts_min = 2,
    .fonts_max = 2,
    .run = run,
};
