#include "options.h"

#include "base/memory.h"
#include "base/utf.h"
#include "messages.h"
#include "numbers.h"
#include "picture/picture.h"
#include "sfnt/axis_map.h"
#include "sfnt/axis_names.h"

#include <getopt.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Where an option has no short name of its own on the command line, its letter here is only its name in this
 * program. */
typedef struct option_row {
    char letter;
    bool is_short; /* -x too */
    const char *name, *argument;
    const char *help;
} option_row;

/* The letters that every command takes stand in COMMON. */
#define COMMON "fjqvhMTwrmsRIH"

static const option_row rows[] = {
    {'o', true, "output", "FILE", "the file to write"},
    {'a', false, "at", "T[,T...]", "places from 0 (the first font) to 1 (the second)"},
    {'n', false, "steps", "N", "N evenly spaced places, both fonts among them (2 ... 1000)"},
    {'t', false, "text", "TEXT", "the text, UTF-8, with glyphs as /NAME; again for another line"},
    {'c', false, "chars", "FILE", "characters, code points, ranges U+4E00-4E2F, glyphs /NAME; # comments"},
    {'z', false, "size", "SIZE", "pixels (points in SVG and PDF) an em, or a cell of a sheet"},
    {'p', false, "rows", "N", "rows on a page; without it, as many as A4's proportions take"},
    {'l', false, "no-labels", NULL, "leave out the T under each step"},
    {'F', false, "family", "NAME", "the new font's family name"},
    {'Y', false, "style", "NAME[,NAME...]", "the new font's style, such as SemiBold Italic; one for each T"},
    {'G', false, "glyphs", "both|first",
     "those of both fonts, or all of the first's, unblended where need be"},
    {'E', false, "alternates", NULL, "keep forms that text asks for (small capitals ...) of --text, --chars"},
    {'L', false, "no-layout", NULL, "characters alone: no substitutions, kerning or marks of either font"},
    {'X', false, "axis", "TAG=FROM..TO", "the axis, and what users set for the first font and for the last"},
    {'A', false, "avar", "V:P[,V:P...]", "at V on the axis the font stands at P, both from 0 to 100"},
    {'J', false, "json", NULL, "data: on stdout, or into FILE when that ends in .json"},
    {'D', false, "duration", "SECONDS", "of a play, without what it holds; a second from one to the next"},
    {'U', false, "fps", "N", "frames a second (1 ... 240); without it, 30"},
    {'e', false, "ease", "EASE", "ease-in-out, another name of CSS, or cubic-bezier(X1,Y1,X2,Y2)"},
    {'O', false, "ease-over", "each|whole", "ease from each to the next, or from the first to the last"},
    {'d', false, "hold", "SECONDS", "that each key frame stays (0 ... 60)"},
    {'N', false, "loop", "N|forever", "how often it plays; forever without it"},
    {'y', false, "yoyo", NULL, "back again the way it came"},
    {'C', false, "canvas", "WxH", "of so many pixels, with the drawing in its middle"},
    {'k', false, "color", "COLOR[,COLOR...]", "of the drawing, or from the first to the last, or of each"},
    {'b', false, "background", "COLOR|none", "white without it"},
    {'K', false, "css", NULL, "SVG that moves by CSS, not by SMIL"},
    {'S', false, "strict", NULL, "a glyph that cannot be blended is an error, not a line on stderr"},
    {'M', false, "method", "joint|paper", "align boundaries where it goes, or map pieces throughout"},
    {'T', false, "tolerance", "E", "flattening error bound, 1/1000 em (0.05 ... 10)"},
    {'f', false, "fit", "E", "curve fitting error bound, 1/1000 em (0.05 ... 10)"},
    {'w', false, "weights", "W1,W2,W3", "place, area and box in matching components; sum 1"},
    {'r', false, "rounds", "N", "of the relaxation (0 ... 1000)"},
    {'m', false, "threshold", "X", "matches weaker than X times the best count as none (0 ... 1)"},
    {'s', false, "one-scale", NULL, "match pieces with one scale for both axes, as the paper prints it"},
    {'R', false, "rotate", "DEGREES|auto", "turn while blending; auto finds the angle of each glyph"},
    {'I', false, "slant", "DEGREES|auto",
     "by how much the second font leans more than the first; auto measures it"},
    {'P', false, "pairs", "FILE", "glyphs that go together, by name or code point, one a font on a line"},
    {'H', false, "hints", "FILE", "which parts and places of both fonts' glyphs go together"},
    {'j', true, "jobs", "N", "threads (1 ... 1024); without it, one a core"},
    {'q', true, "quiet", NULL, "say nothing but errors"},
    {'v', true, "verbose", NULL, "say what is done, and of each glyph by itself"},
    {'h', true, "help", NULL, "show this"},
};
#define ROW_COUNT ((int)(sizeof rows / sizeof rows[0]))

static bool takes(const cli_command *command, char letter) {
    return strchr(COMMON, letter) || strchr(command->takes, letter);
}

static int print_help(const cli_command *command) {
    printf("%s\n", command->help);
    for (int i = 0; i < ROW_COUNT; i++) {
        const option_row *row = &rows[i];
        char name[64], letter[8] = "    ";
        if (!takes(command, row->letter)) continue;
        if (row->is_short) snprintf(letter, sizeof letter, "-%c, ", row->letter);
        snprintf(name, sizeof name, "%s%s", row->name, row->argument ? " " : "");
        printf("  %s--%s%-*s %s\n", letter, name, 26 - (int)strlen(name), row->argument ? row->argument : "",
               row->help);
    }
    return DONE;
}

/* ---- one option --------------------------------------------------------------------------------- */

#define GO_ON (-1)

static int no_memory(void) {
    return fail("%s", mt_status_text(MT_NO_MEMORY));
}

static int read_at(cli_options *options, const char *argument) {
    int room = 1;
    for (const char *p = argument; *p; p++) room += *p == ',';
    if (room > MT_STEPS_MAX) return misuse(options->command, "--at: at most %d places", MT_STEPS_MAX);
    mt_free(options->at);
    options->at = mt_new((size_t)room, sizeof *options->at);
    if (!options->at) return no_memory();
    options->at_count = numbers_read(argument, options->at, room);
    bool good = options->at_count > 0;
    for (int i = 0; i < options->at_count; i++) good = good && options->at[i] >= 0 && options->at[i] <= 1;
    return good ? GO_ON : misuse(options->command, "--at %s: numbers from 0 to 1 are wanted", argument);
}

/* Whether the library takes the map. */
static int check_map(const cli_options *options, const char *argument) {
    mt_axis_map map;
    mt_status status = options->map_count > 0 ? mt_axis_map_make(options->map_values, options->map_places,
                                                                 options->map_count, &map)
                                              : MT_BAD_PARAMETER;
    if (status == MT_NO_MEMORY) return no_memory();
    if (status != MT_OK)
        return misuse(options->command,
                      "--avar %s: VALUE:PLACE pairs from 0:0 to 100:100 are wanted, each VALUE over the last "
                      "by 0.01 or more, no PLACE under the last",
                      argument);
    mt_axis_map_free(&map);
    return GO_ON;
}

static int read_map(cli_options *options, const char *argument) {
    int room = 1;
    for (const char *p = argument; *p; p++) room += *p == ',';
    mt_free(options->map_values);
    mt_free(options->map_places);
    options->map_values = mt_new((size_t)room, sizeof *options->map_values);
    options->map_places = mt_new((size_t)room, sizeof *options->map_places);
    if (!options->map_values || !options->map_places) return no_memory();
    options->map_count = pairs_read(argument, options->map_values, options->map_places, room);
    return check_map(options, argument);
}

/* Adds a line to the text. */
static int read_text(cli_options *options, const char *argument) {
    uint32_t code_point;
    for (const char *p = argument; *p;)
        if (!mt_utf8_next(&p, &code_point)) return misuse(options->command, "--text: not UTF-8");
    size_t before = options->text ? strlen(options->text) + 1 : 0, length = strlen(argument) + 1;
    char *text = mt_grow(options->text, before + length, 1);
    if (!text) return no_memory();
    if (before) text[before - 1] = '\n';
    memcpy(text + before, argument, length);
    options->text = text;
    return GO_ON;
}

static int read_double(const cli_options *options, const char *name, const char *argument, double min,
                       double max, double *value) {
    if (number_read(argument, value) && *value >= min && *value <= max) return GO_ON;
    return misuse(options->command, "--%s %s: a number from %g to %g is wanted", name, argument, min, max);
}

static int read_int(const cli_options *options, const char *name, const char *argument, int min, int max,
                    int *value) {
    double number;
    bool good = number_read(argument, &number) && number >= min && number <= max && number == (int)number;
    if (!good)
        return misuse(options->command, "--%s %s: a whole number from %d to %d is wanted", name, argument,
                      min, max);
    *value = (int)number;
    return GO_ON;
}

static int read_weights(cli_options *options, const char *argument) {
    double *w = options->params.weights;
    bool good = numbers_read(argument, w, 3) == 3 && w[0] >= 0 && w[1] >= 0 && w[2] >= 0;
    if (good && fabs(w[0] + w[1] + w[2] - 1) < 1e-6) return GO_ON;
    return misuse(options->command, "--weights %s: three numbers that add up to 1 are wanted", argument);
}

static int read_rotation(cli_options *options, const char *argument) {
    options->params.rotation = strcmp(argument, "auto") == 0 ? MT_ROTATION_FOUND : MT_ROTATION_GIVEN;
    if (options->params.rotation == MT_ROTATION_FOUND) return GO_ON;
    return read_double(options, "rotate", argument, -360, 360, &options->params.degrees);
}

static int read_slant(cli_options *options, const char *argument) {
    options->params.slant = strcmp(argument, "auto") == 0 ? MT_SLANT_FOUND : MT_SLANT_GIVEN;
    if (options->params.slant == MT_SLANT_FOUND) return GO_ON;
    return read_double(options, "slant", argument, -45, 45, &options->params.lean);
}

static int read_family(cli_options *options, const char *argument) {
    uint32_t code_point;
    const char *p = argument;
    while (*p && mt_utf8_next(&p, &code_point)) continue;
    if (*p || !*argument) return misuse(options->command, "--family: a name in UTF-8 is wanted");
    options->family = argument;
    return GO_ON;
}

/* Cuts the names at their commas, in place. */
static int read_styles(cli_options *options, const char *argument) {
    uint32_t code_point;
    int room = 1;
    for (const char *p = argument; *p;) {
        if (!mt_utf8_next(&p, &code_point)) return misuse(options->command, "--style: not UTF-8");
        room += code_point == ',';
    }
    mt_free(options->style_text);
    mt_free(options->styles);
    options->style_text = mt_copy_text(argument);
    options->styles = mt_new((size_t)room, sizeof *options->styles);
    if (!options->style_text || !options->styles) return no_memory();
    options->style_count = 0;
    for (char *name = options->style_text, *end; name; name = end) {
        end = strchr(name, ',');
        if (end) *end++ = '\0';
        if (!*name)
            return misuse(options->command, "--style %s: a name, or one for each T, is wanted", argument);
        options->styles[options->style_count++] = name;
    }
    return GO_ON;
}

/* TAG=FROM..TO */
static int read_axis(cli_options *options, const char *argument) {
    char from[32] = "";
    mt_axis axis = {0};
    const char *is = strchr(argument, '='), *dots = is ? strstr(is, "..") : NULL;
    bool whole = is == argument + 4 && dots && (size_t)(dots - is) < sizeof from;
    if (whole) strncat(from, is + 1, (size_t)(dots - is) - 1);
    whole = whole && number_read(from, &axis.from) && number_read(dots + 2, &axis.to);
    for (int i = 0; whole && i < 4; i++) axis.tag = axis.tag << 8 | (uint8_t)argument[i];
    if (!whole || !mt_axis_is_valid(&axis))
        return misuse(options->command,
                      "--axis %s: TAG=FROM..TO is wanted, such as wght=400..900: a registered tag or four "
                      "capitals, and two numbers that the axis may have",
                      argument);
    memcpy(options->axis_tag, argument, 4);
    options->axis_from = axis.from;
    options->axis_to = axis.to;
    return GO_ON;
}

static int read_glyphs(cli_options *options, const char *argument) {
    bool both = strcmp(argument, "both") == 0;
    options->glyphs = both ? MT_GLYPHS_BOTH : MT_GLYPHS_FIRST;
    if (both || strcmp(argument, "first") == 0) return GO_ON;
    return misuse(options->command, "--glyphs %s: both or first is wanted", argument);
}

static int read_method(cli_options *options, const char *argument) {
    bool joint = strcmp(argument, "joint") == 0;
    options->params.method = joint ? MT_METHOD_JOINT : MT_METHOD_PAPER;
    if (joint || strcmp(argument, "paper") == 0) return GO_ON;
    return misuse(options->command, "--method %s: joint or paper is wanted", argument);
}

/* The options of the engine. */
static int read_param(cli_options *options, char letter, const char *argument) {
    mt_params *params = &options->params;
    switch (letter) {
    case 'M': return read_method(options, argument);
    case 'T': return read_double(options, "tolerance", argument, 0.05, 10, &params->tolerance);
    case 'f': return read_double(options, "fit", argument, 0.05, 10, &params->fit);
    case 'w': return read_weights(options, argument);
    case 'r': return read_int(options, "rounds", argument, 0, 1000, &params->rounds);
    case 'm': return read_double(options, "threshold", argument, 0, 1, &params->threshold);
    case 's': return params->one_scale = true, GO_ON;
    case 'R': return read_rotation(options, argument);
    case 'I': return read_slant(options, argument);
    default: return read_int(options, "jobs", argument, 1, 1024, &params->threads);
    }
}

static int read_option(const cli_command *command, cli_options *options, char letter, const char *argument) {
    switch (letter) {
    case 'o': return options->output = argument, GO_ON;
    case 'a': return read_at(options, argument);
    case 'n': return read_int(options, "steps", argument, 2, MT_STEPS_MAX, &options->steps);
    case 't': return read_text(options, argument);
    case 'c': return options->chars_file = argument, GO_ON;
    case 'z': return read_double(options, "size", argument, MT_SIZE_MIN, MT_SIZE_MAX, &options->size);
    case 'p': return read_int(options, "rows", argument, 1, 10000, &options->rows);
    case 'l': return options->no_labels = true, GO_ON;
    case 'F': return read_family(options, argument);
    case 'Y': return read_styles(options, argument);
    case 'X': return read_axis(options, argument);
    case 'G': return read_glyphs(options, argument);
    case 'E': return options->alternates = true, GO_ON;
    case 'L': return options->no_layout = true, GO_ON;
    case 'A': return read_map(options, argument);
    case 'P': return options->pairs_file = argument, GO_ON;
    case 'H': return options->hints_file = argument, GO_ON;
    case 'J': return options->json = true, GO_ON;
    case 'S': return options->strict = true, GO_ON;
    case 'q': return options->quiet = true, GO_ON;
    case 'v': return options->verbose = true, GO_ON;
    case 'h': return print_help(command);
    case 'M':
    case 'T':
    case 'f':
    case 'w':
    case 'r':
    case 'm':
    case 's':
    case 'R':
    case 'I':
    case 'j': return read_param(options, letter, argument);
    default: return motion_read(command->name, letter, argument, &options->motion) ? GO_ON : WRONG_USAGE;
    }
}

/* ---- the command line --------------------------------------------------------------------------- */

/* getopt's tables of the command's options. */
static void make_tables(const cli_command *command, struct option *longs, char *shorts) {
    *shorts++ = ':'; /* a missing argument is told from an unknown option */
    for (int i = 0; i < ROW_COUNT; i++) {
        if (!takes(command, rows[i].letter)) continue;
        int wants = rows[i].argument ? required_argument : no_argument;
        *longs++ = (struct option){rows[i].name, wants, NULL, rows[i].letter};
        if (rows[i].is_short) *shorts++ = rows[i].letter;
        if (rows[i].is_short && rows[i].argument) *shorts++ = ':';
    }
    *longs = (struct option){0};
    *shorts = '\0';
}

static int refuse(const cli_command *command, int letter, const char *argument) {
    if (letter == ':') return misuse(command->name, "%s wants an argument", argument);
    if (strncmp(argument, "--", 2) == 0)
        return misuse(command->name, "%s is no option of %s", argument, command->name);
    return misuse(command->name, "-%c is no option of %s", optopt, command->name);
}

static int read_fonts(const cli_command *command, int count, char **names, cli_options *options) {
    if (count < command->fonts_min)
        return misuse(command->name, "%s",
                      command->fonts_min == 1 ? "a font is wanted" : "two fonts are wanted");
    if (count > command->fonts_max)
        return misuse(command->name, "%s is one argument too many", names[command->fonts_max]);
    if (count < 2 && options->pairs_file) return misuse(command->name, "--pairs: two fonts are wanted");
    for (int i = 0; i < count; i++) options->fonts[i] = names[i];
    options->font_count = count;
    return GO_ON;
}

int options_read(const cli_command *command, int argc, char **argv, cli_options *options) {
    struct option longs[ROW_COUNT + 1];
    char shorts[2 * ROW_COUNT + 2];
    int letter, outcome = GO_ON;
    *options =
        (cli_options){.command = command->name, .params = mt_params_default(), .motion = motion_defaults()};
    make_tables(command, longs, shorts);
    opterr = 0;
    optind = 1;
    while (outcome == GO_ON && (letter = getopt_long(argc, argv, shorts, longs, NULL)) != -1) {
        bool known = letter != '?' && letter != ':';
        outcome = known ? read_option(command, options, (char)letter, optarg)
                        : refuse(command, letter, argv[optind - 1]);
    }
    if (outcome == GO_ON && options->at_count && options->steps)
        outcome = misuse(command->name, "--at and --steps exclude each other");
    if (outcome == GO_ON && options->text && options->chars_file)
        outcome = misuse(command->name, "--text and --chars exclude each other");
    if (outcome == GO_ON && options->alternates && options->no_layout)
        outcome = misuse(command->name, "--alternates and --no-layout exclude each other");
    return outcome == GO_ON ? read_fonts(command, argc - optind, argv + optind, options) : outcome;
}

void options_free(cli_options *options) {
    mt_free(options->at);
    mt_free(options->map_values);
    mt_free(options->map_places);
    mt_free(options->styles);
    mt_free(options->style_text);
    mt_free(options->text);
}

int options_spread(cli_options *options, int steps) {
    if (options->at_count) return DONE;
    if (options->steps) steps = options->steps;
    options->at = mt_new((size_t)steps, sizeof *options->at);
    if (!options->at) return no_memory();
    for (int i = 0; i < steps; i++) options->at[i] = steps == 1 ? 0.5 : (double)i / (steps - 1);
    options->at_count = steps;
    return DONE;
}
