#include "options.h"

#include "base/memory.h"
#include "base/utf.h"
#include "commands.h"
#include "help.h"
#include "messages.h"
#include "numbers.h"
#include "picture/picture.h"
#include "report/report.h"
#include "sfnt/axis_map.h"
#include "sfnt/axis_names.h"
#include "suggest.h"

#include <getopt.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- one option --------------------------------------------------------------------------------- */

#define GO_ON (-1)

static int no_memory(void) {
    return fail("%s", mt_status_text(MT_NO_MEMORY));
}

static int refuse_at(const cli_command *command, const char *argument) {
    return misuse(command->name, "--at %s: numbers from %g to %g are wanted%s", argument,
                  0 - command->at_past, 1 + command->at_past,
                  command->at_up ? ", each with or without ,y= and another one" : "");
}

static int read_at(const cli_command *command, cli_options *options, const char *argument) {
    int room = 1;
    for (const char *p = argument; *p; p++) room += *p == ',';
    mt_free(options->at);
    mt_free(options->at_up);
    options->at = mt_new((size_t)room, sizeof *options->at);
    options->at_up = mt_new((size_t)room, sizeof *options->at_up);
    if (!options->at || !options->at_up) return no_memory();
    options->at_count = places_read(argument, options->at, options->at_up, room);
    options->own_heights = false;
    if (options->at_count > MT_STEPS_MAX)
        return misuse(options->command, "--at: at most %d places", MT_STEPS_MAX);
    bool good = options->at_count > 0;
    double least = 0 - command->at_past, most = 1 + command->at_past;
    for (int i = 0; i < options->at_count; i++) {
        double t = options->at[i], up = options->at_up[i];
        good = good && t >= least && t <= most && up >= least && up <= most;
        options->own_heights = options->own_heights || t != up;
    }
    good = good && (command->at_up || !options->own_heights);
    return good ? GO_ON : refuse_at(command, argument);
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

static int refuse_axis(const cli_options *options, const char *argument) {
    static const char *const registered[] = {"wght", "wdth", "slnt", "ital", "opsz"};
    char tag[SUGGEST_MOST + 1] = "", hint[SUGGEST_ROOM];
    strncat(tag, argument, SUGGEST_MOST);
    tag[strcspn(tag, "=")] = '\0';
    suggestion nearest = suggest_for(tag);
    for (size_t i = 0; i < sizeof registered / sizeof *registered; i++) suggest(&nearest, registered[i]);
    if (nearest.distance == 0) nearest.word = NULL; /* the numbers are wrong */
    return misuse(options->command,
                  "--axis %s: TAG=FROM..TO is wanted, such as wght=400..900: a registered tag or four "
                  "capitals, and two numbers that the axis may have%s",
                  argument, suggest_text(&nearest, "", hint));
}

/* TAG alone: fonts stand where they say, or where --stops does. Whether the axis may be one depends on where that is. */
static int read_family_axis(cli_options *options, const char *argument) {
    uint32_t tag = 0;
    const double plain = mt_axis_tag_read(argument, &tag) ? mt_axis_plain(tag) : NAN;
    mt_axis axis = {.tag = tag, .from = isnan(plain) ? 1 : plain};
    axis.to = axis.from + 1;
    if (strlen(argument) != 4 || !mt_axis_is_valid(&axis)) return refuse_axis(options, argument);
    memcpy(options->axis_tag, argument, 4);
    options->own_stops = true;
    return GO_ON;
}

/* TAG=FROM..TO */
static int read_axis(const cli_command *command, cli_options *options, const char *argument) {
    char from[32] = "";
    mt_axis axis = {0};
    const char *is = strchr(argument, '='), *dots = is ? strstr(is, "..") : NULL;
    options->own_stops = false;
    if (!is && strchr(command->takes, 'x')) return read_family_axis(options, argument);
    bool whole = is == argument + 4 && dots && (size_t)(dots - is) < sizeof from;
    if (whole) strncat(from, is + 1, (size_t)(dots - is) - 1);
    whole = whole && number_read(from, &axis.from) && number_read(dots + 2, &axis.to);
    for (int i = 0; whole && i < 4; i++) axis.tag = axis.tag << 8 | (uint8_t)argument[i];
    if (!whole || !mt_axis_is_valid(&axis)) return refuse_axis(options, argument);
    memcpy(options->axis_tag, argument, 4);
    options->axis_from = axis.from;
    options->axis_to = axis.to;
    return GO_ON;
}

/* As many as fonts that a row may have. */
static int read_stops(cli_options *options, const char *argument) {
    mt_free(options->stops);
    options->stops = mt_new(MT_VARIABLE_FONTS_MAX, sizeof *options->stops);
    if (!options->stops) return no_memory();
    options->stop_count = numbers_read(argument, options->stops, MT_VARIABLE_FONTS_MAX);
    if (options->stop_count > 0) return GO_ON;
    return misuse(options->command, "--stops %s: numbers with commas between them are wanted, one a font",
                  argument);
}

static int read_glyphs(cli_options *options, const char *argument) {
    bool both = strcmp(argument, "both") == 0;
    options->glyphs = both ? MT_GLYPHS_BOTH : MT_GLYPHS_FIRST;
    if (both || strcmp(argument, "first") == 0) return GO_ON;
    return misuse(options->command, "--glyphs %s: both or first is wanted", argument);
}

static int read_curves(cli_options *options, const char *argument) {
    bool cubic = strcmp(argument, "cubic") == 0;
    options->curves = cubic ? MT_CURVES_CUBIC : MT_CURVES_QUADRATIC;
    if (cubic || strcmp(argument, "quadratic") == 0) return GO_ON;
    return misuse(options->command, "--curves %s: cubic or quadratic is wanted", argument);
}

/* The flag of a name, of which `length` bytes are given; 0 for any other. */
static unsigned find_flag(const char *name, size_t length) {
    for (unsigned flag = 1; flag & MT_FLAG_ALL; flag <<= 1) {
        const char *known = mt_report_flag_name((mt_report_flag)flag);
        if (strlen(known) == length && strncmp(known, name, length) == 0) return flag;
    }
    return 0;
}

/* "failed, components … or ink", and what else may stand there. */
static int refuse_fail_on(const cli_options *options, const char *argument) {
    char names[128] = "";
    for (unsigned flag = 1; flag & MT_FLAG_ALL; flag <<= 1) {
        size_t used = strlen(names);
        const char *before = flag == 1 ? "" : flag << 1 & MT_FLAG_ALL ? ", " : " and ";
        snprintf(names + used, sizeof names - used, "%s%s", before,
                 mt_report_flag_name((mt_report_flag)flag));
    }
    return misuse(options->command, "--fail-on %s: a number from 1 on is wanted, or some of %s with commas",
                  argument, names);
}

/* N, or REASON[,REASON...] */
static int read_fail_on(cli_options *options, const char *argument) {
    double number;
    options->fail_flags = 0;
    options->fail_count = 0;
    if (number_read(argument, &number)) {
        bool good = number >= 1 && number <= INT_MAX && number == floor(number);
        options->fail_count = good ? (int)number : 0;
        return good ? GO_ON : refuse_fail_on(options, argument);
    }
    for (const char *at = argument;; at++) {
        size_t length = strcspn(at, ",");
        unsigned flag = find_flag(at, length);
        if (!flag) return refuse_fail_on(options, argument);
        options->fail_flags |= flag;
        at += length;
        if (!*at) return GO_ON;
    }
}

static int read_method(cli_options *options, const char *argument) {
    bool joint = strcmp(argument, "joint") == 0;
    options->params.method = joint ? MT_METHOD_JOINT : MT_METHOD_PAPER;
    if (joint || strcmp(argument, "paper") == 0) return GO_ON;
    return misuse(options->command, "--method %s: joint or paper is wanted", argument);
}

static int read_cache_size(cli_options *options, const char *argument) {
    double gigabytes = 0;
    int outcome = read_double(options, "cache-size", argument, 0.01, 10000, &gigabytes);
    if (outcome == GO_ON) options->cache_bytes = (uint64_t)(gigabytes * 1e9);
    return outcome;
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
    case 'g': return read_double(options, "effort", argument, 0.01, 100, &params->effort);
    default: return read_int(options, "jobs", argument, 1, 1024, &params->threads);
    }
}

static int read_option(const cli_command *command, cli_options *options, char letter, const char *argument) {
    switch (letter) {
    case 'o': return options->output = argument, GO_ON;
    case 'Z': return options->format = argument, GO_ON;
    case 'a': return read_at(command, options, argument);
    case 'n': return read_int(options, "steps", argument, 2, MT_STEPS_MAX, &options->steps);
    case 't': return read_text(options, argument);
    case 'c': return options->chars_file = argument, GO_ON;
    case 'z': return read_double(options, "size", argument, MT_SIZE_MIN, MT_SIZE_MAX, &options->size);
    case 'p': return read_int(options, "rows", argument, 1, 10000, &options->rows);
    case 'l': return options->no_labels = true, GO_ON;
    case 'F': return read_family(options, argument);
    case 'Y': return read_styles(options, argument);
    case 'X': return read_axis(command, options, argument);
    case 'x': return read_stops(options, argument);
    case 'G': return read_glyphs(options, argument);
    case 'Q': return read_curves(options, argument);
    case 'E': return options->alternates = true, GO_ON;
    case 'L': return options->no_layout = true, GO_ON;
    case 'A': return read_map(options, argument);
    case 'P': return options->pairs_file = argument, GO_ON;
    case 'H': return options->hints_file = argument, GO_ON;
    case '@': return options->places_file = argument, GO_ON;
    case 'B': return read_fail_on(options, argument);
    case '0': return options->cache = argument, GO_ON;
    case '1': return read_cache_size(options, argument);
    case 'J': return options->json = true, GO_ON;
    case 'S': return options->strict = true, GO_ON;
    case 'q': return options->quiet = true, GO_ON;
    case 'v': return options->verbose = true, GO_ON;
    case 'h': return help_command(command);
    case 'V': return help_version();
    case 'M':
    case 'T':
    case 'f':
    case 'w':
    case 'r':
    case 'm':
    case 's':
    case 'R':
    case 'I':
    case 'g':
    case 'j': return read_param(options, letter, argument);
    case 'i':
    case 'u':
    case 'W': return solid_read(command->name, letter, argument, &options->solid) ? GO_ON : WRONG_USAGE;
    default: return motion_read(command->name, letter, argument, &options->motion) ? GO_ON : WRONG_USAGE;
    }
}

/* ---- the command line --------------------------------------------------------------------------- */

/* getopt's tables of the command's options. */
static void make_tables(const cli_command *command, struct option *longs, char *shorts) {
    *shorts++ = ':'; /* a missing argument is told from an unknown option */
    for (const option_row *row = option_rows; row->name; row++) {
        if (!option_is_taken(row, command)) continue;
        int wants = row->argument ? required_argument : no_argument;
        *longs++ = (struct option){row->name, wants, NULL, row->letter};
        if (row->is_short) *shorts++ = row->letter;
        if (row->is_short && row->argument) *shorts++ = ':';
    }
    *longs = (struct option){0};
    *shorts = '\0';
}

/* The options that a beginning may stand for, where they are several: "--steps, --style". */
static void list_meant(const cli_command *command, const char *name, char *text, size_t room) {
    size_t used = 0;
    *text = '\0';
    for (const option_row *row = option_rows; row->name; row++) {
        if (!option_is_taken(row, command) || strncmp(row->name, name, strlen(name)) != 0) continue;
        snprintf(text + used, room - used, "%s--%s", used ? ", " : "", row->name);
        used += strlen(text + used);
    }
}

/* The command's option of a name that is near; if it has none, another command's of this very name. */
static int refuse_long(const cli_command *command, const char *argument) {
    char name[SUGGEST_MOST + 1] = "", meant[512], hint[SUGGEST_ROOM];
    strncat(name, argument + 2, SUGGEST_MOST);
    name[strcspn(name, "=")] = '\0';
    suggestion nearest = suggest_for(name);
    for (const option_row *row = option_rows; row->name; row++) {
        bool taken = option_is_taken(row, command);
        if (taken) suggest(&nearest, row->name);
        if (taken && strcmp(row->name, name) == 0)
            return misuse(command->name, "--%s takes no argument", name);
    }
    list_meant(command, name, meant, sizeof meant);
    if (*name && *meant) return misuse(command->name, "--%s may be any of %s", name, meant);
    for (int i = 0; commands[i]; i++)
        for (const option_row *row = option_rows; row->name; row++)
            if (option_is_taken(row, commands[i]) && strcmp(row->name, name) == 0)
                return misuse(command->name, "--%s is no option of %s, but of %s", name, command->name,
                              commands[i]->name);
    return misuse(command->name, "%s is no option of %s%s", argument, command->name,
                  suggest_text(&nearest, "--", hint));
}

static int refuse(const cli_command *command, int letter, const char *argument) {
    if (letter == ':') return misuse(command->name, "%s wants an argument", argument);
    if (strncmp(argument, "--", 2) == 0) return refuse_long(command, argument);
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

/* Options that exclude each other. */
static int check_together(const cli_command *command, const cli_options *options) {
    const struct {
        bool first, second;
        const char *names[2];
    } pairs[] = {
        {options->at_count, options->steps, {"--at", "--steps"}},
        {options->text && !command->text_with_chars, options->chars_file, {"--text", "--chars"}},
        {options->alternates, options->no_layout, {"--alternates", "--no-layout"}},
        {options->quiet, options->verbose, {"--quiet", "--verbose"}},
        {options->own_heights, options->params.rotation != MT_ROTATION_NONE, {"--at T,y=T", "--rotate"}},
        {options->own_stops, options->map_count, {"--axis TAG", "--avar"}},
        {options->own_stops, options->style_count, {"--axis TAG", "--style"}},
    };
    if (options->stop_count && !options->own_stops)
        return misuse(options->command, "--stops: --axis TAG is wanted with it, without FROM..TO");
    if (options->cache_bytes && !options->cache)
        return misuse(options->command, "--cache-size: --cache DIR is wanted with it");
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++)
        if (pairs[i].first && pairs[i].second)
            return misuse(options->command, "%s and %s exclude each other", pairs[i].names[0],
                          pairs[i].names[1]);
    return GO_ON;
}

int options_read(const cli_command *command, int argc, char **argv, cli_options *options) {
    struct option longs[OPTION_ROOM];
    char shorts[2 * OPTION_ROOM];
    int letter, outcome = GO_ON;
    *options = (cli_options){.command = command->name,
                             .params = mt_params_default(),
                             .motion = motion_defaults(),
                             .solid = solid_defaults()};
    make_tables(command, longs, shorts);
    opterr = 0;
    optind = 1;
    while (outcome == GO_ON && (letter = getopt_long(argc, argv, shorts, longs, NULL)) != -1) {
        bool known = letter != '?' && letter != ':';
        outcome = known ? read_option(command, options, (char)letter, optarg)
                        : refuse(command, letter, argv[optind - 1]);
    }
    if (outcome == GO_ON) outcome = check_together(command, options);
    return outcome == GO_ON ? read_fonts(command, argc - optind, argv + optind, options) : outcome;
}

void options_free(cli_options *options) {
    mt_free(options->at);
    mt_free(options->at_up);
    mt_free(options->map_values);
    mt_free(options->map_places);
    mt_free(options->stops);
    mt_free(options->styles);
    mt_free(options->style_text);
    mt_free(options->text);
}

int options_spread(cli_options *options, int steps) {
    if (options->at_count) return DONE;
    if (options->steps) steps = options->steps;
    options->at = mt_new((size_t)steps, sizeof *options->at);
    options->at_up = mt_new((size_t)steps, sizeof *options->at_up);
    if (!options->at || !options->at_up) return no_memory();
    for (int i = 0; i < steps; i++)
        options->at[i] = options->at_up[i] = steps == 1 ? 0.5 : (double)i / (steps - 1);
    options->at_count = steps;
    return DONE;
}
