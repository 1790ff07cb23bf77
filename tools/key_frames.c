#include "key_frames.h"

#include "base/file.h"
#include "hints_file.h"
#include "messages.h"
#include "notation.h"
#include "source/spec.h"
#include "work.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

/* ---- FONT=TEXT ----------------------------------------------------------------------------------------- */

/* Cuts `spec`, a copy of the argument, down to its font. Gives the text; NULL where no font stands before any =, with
 * the reason in *status and `spec` as far as it may be one. */
static const char *split(const char *argument, char *spec, mt_status *status) {
    size_t blamed = strcspn(argument, "=");
    *status = MT_NO_FILE;
    for (size_t length = strlen(argument); length > 0; length--) {
        mt_spec parsed;
        if (argument[length] != '=') continue;
        spec[length] = '\0';
        mt_status read = mt_spec_parse(spec, &parsed);
        if (read == MT_OK) {
            mt_spec_clear(&parsed);
            return argument + length + 1;
        }
        if (read == MT_NO_FILE || *status != MT_NO_FILE) continue;
        *status = read; /* the file is there, and what follows it is wrong */
        blamed = length;
    }
    spec[blamed] = '\0';
    return NULL;
}

/* Reads the text of a key frame whose font is open. */
static int read_text(const cli_options *options, int number, const char *text, key_frames *keys) {
    const char *argument = options->fonts[number];
    char name[NOTATION_NAME_MAX + 1];
    notation reader = {.font = keys->list[number].font};
    choices *read = &keys->texts[number];
    mt_status status = MT_OK;
    while (*text && status == MT_OK) {
        mt_choice choice;
        status = notation_next(&reader, &text, &choice, name);
        if (status == MT_OK) status = choices_add(read, &choice);
    }
    notation_close(&reader);
    if (status == MT_BAD_PARAMETER) return misuse(options->command, "%s: not UTF-8", argument);
    if (status == MT_NO_GLYPH) return fail("%s has no glyph /%s", keys->specs[number], name);
    if (status != MT_OK) return fail_status(argument, status);
    keys->list[number].text = (mt_text){read->count, read->list};
    return DONE;
}

/* Opens the font unless a key frame before it has it already. */
static int open_font(const cli_options *options, int number, key_frames *keys) {
    for (int i = 0; i < number; i++)
        if (keys->list[i].font && strcmp(keys->specs[i], keys->specs[number]) == 0) {
            keys->list[number].font = keys->list[i].font;
            return DONE;
        }
    return font_open(options, keys->specs[number], &keys->list[number].font);
}

/* ---- drawings ------------------------------------------------------------------------------------------ */

/* What is left out, with commas. */
static void list_left_out(unsigned left_out, char *line, size_t room) {
    static const char *const kinds[MT_LEFT_KINDS] = {"strokes",
                                                     "gradients and patterns",
                                                     "text",
                                                     "images",
                                                     "filters",
                                                     "masks",
                                                     "clip paths",
                                                     "markers",
                                                     "scripts",
                                                     "rules of style sheets",
                                                     "references to other files",
                                                     "opacity",
                                                     "foreign objects",
                                                     "animations"};
    size_t used = 0;
    *line = '\0';
    for (int i = 0; i < MT_LEFT_KINDS; i++) {
        if (!(left_out >> i & 1) || used >= room) continue;
        snprintf(line + used, room - used, "%s%s", used ? ", " : "", kinds[i]);
        used += strlen(line + used);
    }
}

static int read_drawing(const cli_options *options, int number, const uint8_t *bytes, size_t length,
                        key_frames *keys) {
    const char *path = options->fonts[number], *problem;
    mt_svg_drawing *drawing = &keys->drawings[number];
    char left_out[256];
    mt_status status = mt_svg_read(bytes, length, &keys->arena, drawing, &problem);
    if (status == MT_BAD_DRAWING) return fail("%s: %s", path, problem);
    list_left_out(drawing->left_out, left_out, sizeof left_out);
    if (status == MT_BLANK && *left_out) return fail("%s: nothing is filled; left out: %s", path, left_out);
    if (status == MT_BLANK) return fail("%s: nothing is filled", path);
    if (status != MT_OK) return fail_status(path, status);
    if (*left_out && !options->quiet) say("%s: left out: %s", path, left_out);
    keys->list[number].drawing = drawing;
    return DONE;
}

/* Whether the argument as a whole is a file; only a file is looked into that could not be FONT=TEXT. */
static bool may_be_drawing(const char *argument) {
    struct stat facts;
    return !strchr(argument, '=') || (stat(argument, &facts) == 0 && S_ISREG(facts.st_mode));
}

/* Reads the key frame if it is a drawing; *is_drawing tells. */
static int try_drawing(const cli_options *options, int number, key_frames *keys, bool *is_drawing) {
    const char *argument = options->fonts[number];
    uint8_t *bytes;
    size_t length;
    *is_drawing = false;
    if (!may_be_drawing(argument)) return DONE;
    mt_status status = mt_file_read(argument, MT_SVG_MAX, &bytes, &length);
    if (status != MT_OK) return fail_status(argument, status);
    *is_drawing = mt_svg_looks_so(bytes, length);
    int outcome = *is_drawing ? read_drawing(options, number, bytes, length, keys) : DONE;
    mt_free(bytes);
    return outcome;
}

/* ---- all of them --------------------------------------------------------------------------------------- */

static int read_key(const cli_options *options, int number, key_frames *keys) {
    const char *argument = options->fonts[number];
    char *spec = mt_copy_text(argument);
    mt_status status;
    bool is_drawing;
    keys->specs[number] = spec;
    if (!spec) return fail_status(argument, MT_NO_MEMORY);
    int read = try_drawing(options, number, keys, &is_drawing);
    if (read != DONE || is_drawing) return read;
    if (!strchr(argument, '='))
        return misuse(options->command, "%s: a key frame is FONT=TEXT, or an SVG drawing", argument);
    const char *text = split(argument, spec, &status);
    if (!text) return fail_status(spec, status);
    if (!*text)
        return misuse(options->command, "%s: a key frame is FONT=TEXT, and there is no text", argument);
    int outcome = open_font(options, number, keys);
    return outcome == DONE ? read_text(options, number, text, keys) : outcome;
}

static int read_hints(const cli_options *options, key_frames *keys) {
    mt_font *fonts[MT_VARIABLE_FONTS_MAX];
    for (int i = 0; i < keys->count; i++) {
        fonts[i] = keys->list[i].font;
        if (!fonts[i] && options->hints_file)
            return misuse(options->command, "--hints: hints are for fonts, and %s is a drawing",
                          options->fonts[i]);
    }
    return hints_read(options, fonts, keys->count, &keys->hints);
}

int key_frames_open(const cli_options *options, key_frames *keys) {
    *keys = (key_frames){0};
    int outcome = DONE;
    for (int i = 0; outcome == DONE && i < options->font_count; i++) {
        outcome = read_key(options, i, keys);
        keys->count = i + 1;
    }
    return outcome == DONE ? read_hints(options, keys) : outcome;
}

void key_frames_close(key_frames *keys) {
    for (int i = 0; i < keys->count; i++) {
        bool shared = false;
        for (int k = 0; k < i; k++) shared = shared || keys->list[k].font == keys->list[i].font;
        if (!shared) mt_font_close(keys->list[i].font);
        mt_free(keys->specs[i]);
        choices_free(&keys->texts[i]);
    }
    mt_hint_table_free(keys->hints);
    mt_arena_release(&keys->arena);
}

/* ---- faults -------------------------------------------------------------------------------------------- */

int key_frames_fail(const cli_options *options, const key_frames *keys, const mt_motion_fault *fault,
                    mt_status status) {
    if (status == MT_BAD_HINTS) return hints_fail(options, status, &fault->hint, keys->hints);
    if (fault->key < 0) return fail_status(options->output, status);
    const char *argument = options->fonts[fault->key], *spec = keys->specs[fault->key];
    if (status != MT_NO_GLYPH || fault->lacking < 0) return fail_status(argument, status);
    char name[CHARACTER_NAME_ROOM];
    character_describe(keys->list[fault->key].text.list[fault->lacking].code_point, name, sizeof name);
    return fail("%s lacks %s", spec, name);
}

/* ---- colours ------------------------------------------------------------------------------------------- */

void key_frames_colours(const cli_options *options, const key_frames *keys, mt_colour *colours, int *count) {
    const cli_motion *motion = &options->motion;
    bool alike = true;
    *count = motion->colour_count ? motion->colour_count : keys->count;
    for (int i = 0; i < *count; i++) {
        const mt_svg_drawing *drawing = keys->list[i].drawing;
        colours[i] = motion->colour_count             ? motion->colours[i]
                     : drawing && drawing->one_colour ? drawing->colour
                                                      : (mt_colour){0, 0, 0};
        alike = alike && memcmp(&colours[i], &colours[0], sizeof *colours) == 0;
    }
    if (alike) *count = 1;
}

/* ---- timing -------------------------------------------------------------------------------------------- */

mt_timing key_frames_timing(const cli_options *options) {
    mt_timing timing = options->motion.timing;
    if (!(timing.duration > 0)) timing.duration = options->font_count - 1;
    return timing;
}
