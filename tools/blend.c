/* morphotype blend: fonts between two fonts. All of them are made before the first is written. */
#include "commands.h"
#include "font/file.h"
#include "geometry/memory.h"
#include "messages.h"
#include "numbers.h"
#include "work.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

/* Fonts in memory, as many as there are T. */
typedef struct products {
    int count;
    char **paths;
    uint8_t **bytes;
    size_t *lengths;
} products;

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

static mt_status make(cli_work *work, products *made) {
    const cli_options *options = work->options;
    size_t count = (size_t)options->at_count;
    made->paths = mt_new(count, sizeof *made->paths);
    made->bytes = mt_new(count, sizeof *made->bytes);
    made->lengths = mt_new(count, sizeof *made->lengths);
    if (!made->paths || !made->bytes || !made->lengths) return MT_NO_MEMORY;
    made->count = options->at_count;
    for (int i = 0; i < made->count; i++) {
        made->paths[i] = path_of(options, i);
        if (!made->paths[i]) return MT_NO_MEMORY;
    }
    mt_status status = mt_blend_fonts(work->blend, options->at, made->count, made->bytes, made->lengths);
    if (status != MT_OK)
        memset(made->bytes, 0, count * sizeof *made->bytes); /* none of them is ours to free */
    return status;
}

/* All or none: those written go again when one cannot be. */
static int write_files(const cli_options *options, const products *made) {
    for (int i = 0; i < made->count; i++) {
        mt_status status = mt_file_write(made->paths[i], made->bytes[i], made->lengths[i]);
        if (status == MT_OK) continue;
        fail_status(made->paths[i], status);
        while (i-- > 0) unlink(made->paths[i]);
        return COULD_NOT;
    }
    for (int i = 0; options->verbose && i < made->count; i++)
        say("%s: T = %g, %zu bytes", made->paths[i], options->at[i], made->lengths[i]);
    return DONE;
}

static void free_products(products *made) {
    for (int i = 0; i < made->count; i++) {
        mt_free(made->paths[i]);
        mt_bytes_free(made->bytes[i]);
    }
    mt_free(made->paths);
    mt_free(made->bytes);
    mt_free(made->lengths);
}

/* An mt_warning. */
static void warn(const char *line, void *user) {
    (void)user;
    say("%s", line);
}

static int blend(cli_work *work) {
    products made = {0};
    mt_status status = work->options->quiet ? MT_OK : mt_blend_warnings(work->blend, warn, NULL);
    if (status == MT_OK) status = make(work, &made);
    int outcome = status == MT_OK ? work_failures(work) : work_fail(work, status);
    if (outcome == DONE) outcome = write_files(work->options, &made);
    free_products(&made);
    return outcome;
}

static int check(const cli_options *options) {
    if (!options->output) return misuse(options->command, "-o OUT.ttf is wanted");
    const char *dot = strrchr(options->output, '.');
    if (!dot || strcasecmp(dot, ".ttf") != 0)
        return misuse(options->command, "-o %s: blend writes .ttf files", options->output);
    for (int i = 0; i < options->at_count; i++)
        for (int k = 0; k < i; k++)
            if (options->at[i] == options->at[k])
                return misuse(options->command, "--at: %g stands there twice", options->at[i]);
    return DONE;
}

static int run(cli_options *options) {
    cli_work work;
    int outcome = check(options);
    if (outcome == DONE) outcome = output_check(options->output);
    if (outcome == DONE) outcome = options_spread(options, 1);
    if (outcome != DONE) return outcome;
    outcome = work_begin(options, &work);
    if (outcome == DONE) outcome = blend(&work);
    work_end(&work);
    return outcome;
}

const cli_command blend_command = {
    .name = "blend",
    .summary = "a font between two fonts",
    .help = "usage: morphotype blend FONT FONT -o OUT.ttf [--at T[,T...]] [OPTION...]\n"
            "\n"
            "Makes the font at T (0.5 without --at) of every character that both fonts have, or of those "
            "that --text\n"
            "or --chars names. Several T make several fonts: OUT-0.25.ttf, OUT-0.5.ttf and so on. --text "
            "wants all of\n"
            "its characters in both fonts; of --chars those are left out that one font lacks. A glyph that "
            "cannot be\n"
            "blended is named on stderr, and the nearer font's own outline stands in for it.\n",
    .takes = "oatcFS",
    .fonts_min = 2,
    .fonts_max = 2,
    .run = run,
};
