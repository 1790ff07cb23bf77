/* morphotype variable: one font that holds all between two fonts, or between more of them in a row. */
#include "base/memory.h"
#include "commands.h"
#include "family.h"
#include "looks.h"
#include "messages.h"
#include "report/report.h"
#include "save/designspace.h"
#include "save/save.h"
#include "sources.h"
#include "work.h"

/* The variable fonts of a run: one, or a family's uprights and italics. */
typedef struct variables {
    int count;
    cli_work works[2];
    mt_report_figures figures[2]; /* of a family */
} variables;

/* ---- making -------------------------------------------------------------------------------------------- */

/* When all fonts are made; an mt_saving's call. */
static mt_status all_made(void *user) {
    variables *all = user;
    mt_status status = MT_OK;
    for (int i = 0; i < all->count && status == MT_OK; i++) {
        cli_work *work = &all->works[i];
        status = work_made(work);
        bool judged = status == MT_OK && work->options->own_stops && !work->options->quiet;
        if (judged) work->stopped = looks_say(work, &all->figures[i]) != DONE;
        if (judged && work->stopped) status = MT_NO_MEMORY;
    }
    return status;
}

/* Says what went wrong with one of them. */
static int fail_all(variables *all, mt_status status, int failed) {
    for (int i = 0; i < all->count; i++)
        if (all->works[i].stopped) return COULD_NOT;
    return work_fail(&all->works[failed > 0 ? failed : 0], status);
}

static int save(variables *all) {
    const char *paths[2];
    mt_variable *list[2];
    mt_sink sinks[2];
    const mt_sink *also[2] = {NULL, NULL};
    size_t lengths[2];
    int failed, unsaid = 0;
    for (int i = 0; i < all->count; i++) {
        const cli_options *options = all->works[i].options;
        paths[i] = options->output;
        list[i] = all->works[i].variable;
        sinks[i] = mt_report_sink(&all->figures[i]);
        if (options->own_stops && !options->quiet) also[i] = &sinks[i];
    }
    const mt_saving saving = {.count = all->count,
                              .paths = paths,
                              .made = all_made,
                              .user = all,
                              .lengths = lengths,
                              .unsaid = &unsaid};
    mt_status status = mt_variables_save_when(list, also, &saving, &failed);
    if (status != MT_OK) return fail_all(all, status, failed);
    work_say_unsaid(all->works[0].options, unsaid);
    for (int i = 0; i < all->count; i++) {
        const cli_options *options = all->works[i].options;
        if (options->verbose)
            say("%s: %d fonts, %zu bytes", options->output, options->font_count, lengths[i]);
        work_say_proved(&all->works[i]);
    }
    return DONE;
}

static int make(variables *all) {
    for (int i = 0; i < all->count; i++) {
        mt_status status = work_warn(&all->works[i]);
        if (status != MT_OK) return work_fail(&all->works[i], status);
    }
    return save(all);
}

/* Begins one after the other; they are to be ended by `end_all` either way. */
static int begin(cli_options *const *list, int count, variables *all) {
    int outcome = DONE;
    *all = (variables){0};
    for (int i = 0; i < count && outcome == DONE; i++)
        outcome = work_begin_variable(list[i], &all->works[all->count++]);
    return outcome;
}

static void end_all(variables *all) {
    for (int i = 0; i < all->count; i++) {
        work_end(&all->works[i]);
        mt_report_figures_free(&all->figures[i]);
    }
}

static int run_all(cli_options *const *list, int count) {
    variables all;
    int outcome = begin(list, count, &all);
    if (outcome == DONE) outcome = make(&all);
    end_all(&all);
    return outcome;
}

/* ---- checking ------------------------------------------------------------------------------------------ */

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

/* The italics' file is told of, since its name was not given. */
static int run_family(const cli_options *options) {
    family made;
    cli_options *const list[] = {&made.list[0], &made.list[1]};
    int outcome = family_read(options, &made);
    if (outcome == DONE && made.count > 1) outcome = check(list[1]);
    if (outcome == DONE && made.count > 1) outcome = sources_spare(options, list[1]->output);
    if (outcome == DONE) outcome = run_all(list, made.count);
    if (outcome == DONE && made.count > 1 && !options->quiet)
        say("%s: the italics, %d fonts", list[1]->output, list[1]->font_count);
    family_free(&made);
    return outcome;
}

static int run(cli_options *options) {
    int outcome = check(options);
    if (outcome != DONE) return outcome;
    return options->own_stops ? run_family(options) : run_all(&options, 1);
}

const cli_command variable_command = {
    .name = "variable",
    .summary = "one variable font from any two fonts, or more",
    .synopsis = "FONT FONT [FONT...] -o OUT.ttf|woff2|designspace [OPTION...]",
    .text =
        "Makes one font with an axis, MORF, from 0 (the first font, and the default) to 100 (the "
        "last); fonts in between are evenly spaced on it. It has every character that all of the "
        "fonts have, or of those that --text or --chars names. With --glyphs first the first font "
        "alone counts for this, and what the others lack stays as it is in the first."
        "\nA glyph that cannot be blended is named on stderr; it switches half-way from the one "
        "font's own outline to the other's. OUT.designspace is a document; its masters are UFOs in "
        "OUT-masters."
        "\nWith --avar 25:10,50:40 the axis shows at 25 what it shows at 10 without, at 50 what at "
        "40; in between it is even, and the ends stay. --axis wght=400..900 makes it the weight "
        "axis, named by weights."
        "\n--axis wght alone makes a family one font: each font stands at its own weight (or width with "
        "wdth, slant with slnt), in whatever order they are given, and the named places are named as the "
        "fonts are. Without a setting it is the Regular, where there is one. Italics among the fonts make "
        "a second file, OUT-Italic.ttf, and both are linked. --stops 100,400,900 says where each stands. "
        "Glyphs that need a look are named.",
    .examples = {{"One font from the first to the second:",
                  "morphotype variable A.ttf B.otf -o Variable.ttf"},
                 {"With a weight axis:",
                  "morphotype variable A.ttf B.otf --axis wght=400..900 --family Between -o Between.ttf"},
                 {"A family, each font at a weight of its own:",
                  "morphotype variable A.ttf B.otf --axis wght --stops 400,900 -o Family.ttf"},
                 {"Its masters, for an editor or fontmake:",
                  "morphotype variable A.ttf B.otf -o Variable.designspace"}},
    .reads = CLI_FONT_FILES,
    .writes = "ttf woff2 designspace",
    .takes = "otcFYGELXxASPQ01",
    .fonts_min = 2,
    .fonts_max = MT_VARIABLE_FONTS_MAX,
    .run = run,
};
