/* morphotype inspect: how characters are cut and matched, as a picture or as data. */
#include "base/file.h"
#include "commands.h"
#include "hints_file.h"
#include "messages.h"
#include "pairs_file.h"
#include "picture/canvas.h"
#include "picture/picture.h"
#include "work.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#define SIZE 320.0

typedef struct inspection {
    const cli_options *options;
    mt_font *fonts[2]; /* the second NULL where there is one */
    mt_given_pairs pairs;
    characters chosen;
    choices text;
    glyph_notes unblended;
    mt_row row; /* of these fonts; all zero until it is open */
    mt_inspection what;
} inspection;

static bool ends_in(const char *path, const char *extension) {
    const char *dot = strrchr(path, '.');
    return dot && strcasecmp(dot, extension) == 0;
}

/* How an inspection becomes bytes: as data, or as a page. */
typedef mt_status (*inspection_made)(mt_row *row, const mt_inspection *what, uint8_t **bytes, size_t *length,
                                     int *failed);

/* Says what went wrong, at a character or glyph or, under 0, with the output or both fonts. */
static int fail_at(const inspection *this, int failed, const char *output, mt_status status) {
    char name[MT_CHOICE_LABEL_ROOM], fonts[8192];
    if (failed < 0 && status != MT_ENDLESS_LOOKUPS) return fail_status(output, status);
    work_name(this->options, fonts, sizeof fonts);
    if (failed < 0) return fail_status(fonts, status);
    const mt_choice *choice = &this->what.choices[failed];
    if (choice->name)
        mt_choice_label(choice, name);
    else
        character_describe(choice->code_point, name, sizeof name);
    return fail("%s: %s: %s", fonts, name, mt_status_text(status));
}

static int write_picture(inspection *this) {
    int failed;
    const char *output = this->options->output;
    mt_status status = mt_inspect_save(&this->row, &this->what, output, &failed);
    return status == MT_OK ? DONE : fail_at(this, failed, output, status);
}

/* Into a file, or to stdout where `path` is NULL. */
static int write_bytes(inspection *this, inspection_made make, const char *path) {
    uint8_t *bytes;
    size_t length;
    int failed;
    mt_status status = make(&this->row, &this->what, &bytes, &length, &failed);
    if (status != MT_OK) return fail_at(this, failed, path ? path : "stdout", status);
    int outcome = DONE;
    if (path) {
        status = mt_file_write(path, bytes, length);
        if (status != MT_OK) outcome = fail_status(path, status);
    } else {
        fwrite(bytes, 1, length, stdout); /* main looks whether stdout took it all */
    }
    mt_bytes_free(bytes);
    return outcome;
}

static int write_output(inspection *this) {
    const cli_options *options = this->options;
    const char *output = options->output;
    if (!output) return write_bytes(this, mt_inspect_json, NULL);
    if (ends_in(output, ".json")) return write_bytes(this, mt_inspect_json, output);
    int outcome =
        ends_in(output, ".html") ? write_bytes(this, mt_inspect_page_make, output) : write_picture(this);
    return outcome == DONE && options->json ? write_bytes(this, mt_inspect_json, NULL) : outcome;
}

/* An mt_idle_hint_noted. */
static void say_idle(int choice, int line, void *user) {
    const inspection *this = user;
    char label[MT_CHOICE_LABEL_ROOM];
    mt_choice_label(&this->what.choices[choice], label);
    say("%s:%d: %s: the hint changes nothing", this->options->hints_file, line, label);
}

static int say_idle_hints(inspection *this) {
    int failed;
    if (!this->options->hints_file || this->options->quiet || this->row.font_count < 2) return DONE;
    mt_status status = mt_inspect_idle_hints(&this->row, &this->what, say_idle, this, &failed);
    return status == MT_OK ? DONE : fail_at(this, failed, this->options->hints_file, status);
}

static int check(const cli_options *options) {
    mt_format format;
    if (!options->output && !options->json) return misuse(options->command, "-o OUT.svg or --json is wanted");
    const char *output = options->output;
    bool page = output && ends_in(output, ".html");
    if (output && !page && !ends_in(output, ".json") && mt_format_of(output, &format) != MT_OK)
        return misuse(options->command, "-o %s: inspect writes .html, .svg, .png, .pdf and .json files",
                      output);
    if (page && !options->fonts[1]) return misuse(options->command, "-o %s: a page wants two fonts", output);
    if (!options->text && !options->chars_file)
        return misuse(options->command, "--text TEXT or --chars FILE is wanted");
    return options->output ? output_check(options->output) : DONE;
}

/* With one font, hints have nothing to say; their file has to be right all the same. */
static int set_hints(inspection *this) {
    mt_hint_table *table;
    mt_hint_error error;
    int outcome = hints_read(this->options, this->fonts, this->row.font_count, &table);
    if (outcome != DONE) return outcome;
    mt_status status = mt_row_set_hints(&this->row, table, &error);
    if (status == MT_BAD_HINTS) outcome = hints_fail(this->options, status, &error, table);
    if (status != MT_OK && status != MT_BAD_HINTS)
        outcome = fail_at(this, -1, this->options->hints_file, status);
    mt_hint_table_free(table);
    return outcome;
}

static int open_row(inspection *this, int count) {
    mt_status status = mt_row_open(this->fonts, count, &this->options->params, &this->row);
    if (status == MT_OK) status = mt_row_set_pairs(&this->row, this->pairs.glyphs, this->pairs.count);
    if (status != MT_OK) return fail_status(this->options->command, status);
    this->row.kept = glyph_notes_add;
    this->row.kept_user = &this->unblended;
    return set_hints(this);
}

static int run(cli_options *options) {
    inspection this = {.options = options};
    int outcome = check(options), count = options->fonts[1] ? 2 : 1;
    if (outcome == DONE) outcome = fonts_open(options, this.fonts);
    if (outcome == DONE) outcome = pairs_file_read(options, this.fonts, &this.pairs);
    if (outcome == DONE)
        outcome = characters_choose(options, this.fonts, count, &this.pairs, &this.chosen, &this.text);
    if (outcome == DONE) outcome = open_row(&this, count);
    this.what = (mt_inspection){.choices = this.chosen.order.list,
                                .count = this.chosen.order.count,
                                .size = options->size > 0 ? options->size : SIZE};
    if (outcome == DONE) outcome = write_output(&this);
    if (outcome == DONE) outcome = say_idle_hints(&this);
    if (outcome == DONE && !options->quiet) glyph_notes_say_unblended(&this.unblended, options);
    glyph_notes_free(&this.unblended);
    mt_row_close(&this.row);
    for (int i = 0; i < 2; i++) mt_font_close(this.fonts[i]);
    mt_given_pairs_free(&this.pairs);
    characters_free(&this.chosen);
    choices_free(&this.text);
    return outcome;
}

const cli_command inspect_command = {
    .name = "inspect",
    .summary = "components, convex pieces and links: how characters are matched",
    .synopsis = "FONT [FONT] --text TEXT [-o OUT.html|svg|png|pdf|json] [--json] [OPTION...]",
    .text = "Shows the components of each character or glyph by colour, its convex pieces, and the links "
            "between the pieces of both fonts. With --json the same comes as data: on stdout, or in OUT "
            "when that ends in .json. A page (.html) shows two fonts' glyphs side by side with what goes "
            "with what; a click on each makes a hint for --hints.",
    .examples = {{"How a letter is cut and matched, as a picture:",
                  "morphotype inspect A.ttf B.otf --text B -o inspect.svg"},
                 {"A page on which hints are made by pointing:",
                  "morphotype inspect A.ttf B.otf --text B -o inspect.html"},
                 {"The same as data:", "morphotype inspect A.ttf B.otf --text B --json"}},
    .reads = CLI_FONT_FILES,
    .writes = "html svg png pdf json",
    .takes = "otczJP",
    .fonts_min = 1,
    .fonts_max = 2,
    .run = run,
};
