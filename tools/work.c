#include "work.h"

#include "axis_hint.h"
#include "base/file.h"
#include "base/memory.h"
#include "blend/pair.h"
#include "characters_file.h"
#include "glyphset/font_pair.h"
#include "hints_file.h"
#include "messages.h"
#include "pairs_file.h"
#include "places_file.h"
#include "source/font.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define NAME_ROOM 8192
#define RANGES_MOST 12 /* ranges in a summary line */

/* ---- files and fonts ---------------------------------------------------------------------------- */

int fail_status(const char *what, mt_status status) {
    bool of_system = status == MT_NO_FILE || status == MT_CANNOT_WRITE;
    if (of_system && errno) return fail("%s: %s: %s", what, mt_status_text(status), strerror(errno));
    return fail("%s: %s", what, mt_status_text(status));
}

int directory_check(const char *path) {
    const char *slash = strrchr(path, '/');
    char *directory = slash ? mt_copy_text(path) : mt_copy_text(".");
    if (!directory) return fail_status(path, MT_NO_MEMORY);
    if (slash) directory[slash == path ? 1 : slash - path] = '\0';
    bool writable = access(directory, W_OK | X_OK) == 0;
    mt_free(directory);
    return writable ? DONE : fail_status(path, MT_CANNOT_WRITE);
}

int output_check(const char *path) {
    mt_status status = mt_file_check(path);
    return status == MT_OK ? directory_check(path) : fail_status(path, status);
}

int font_open(const cli_options *options, const char *spec, mt_font **font) {
    errno = 0;
    mt_status status = mt_font_open(spec, font);
    if (status == MT_BAD_FEATURE) return misuse(options->command, "%s: %s", spec, mt_status_text(status));
    if (status == MT_NO_AXIS) {
        char hint[AXIS_HINT_ROOM];
        axis_hint(spec, hint);
        return fail("%s: %s%s", spec, mt_status_text(status), hint);
    }
    if (status != MT_OK) return fail_status(spec, status);
    if (options->no_layout) mt_font_drop_layout(*font);
    return DONE;
}

int fonts_open(const cli_options *options, mt_font **fonts) {
    int outcome = DONE;
    for (int i = 0; i < options->font_count && outcome == DONE; i++)
        outcome = font_open(options, options->fonts[i], &fonts[i]);
    return outcome;
}

void work_name(const cli_options *options, char *text, size_t room) {
    int count = options->font_count;
    size_t used = 0;
    *text = '\0';
    for (int i = 0; i < count && used < room; i++) {
        const char *before = i == 0 ? "" : i + 1 < count ? ", " : " and ";
        snprintf(text + used, room - used, "%s%s", before, options->fonts[i]);
        used += strlen(text + used);
    }
}

/* ---- characters --------------------------------------------------------------------------------- */

/* Fonts and what pairs them, as far as characters go. */
typedef struct char_source {
    const cli_options *options;
    mt_font *const *fonts;
    int count;
    const mt_given_pairs *pairs;
} char_source;

static bool has_char(const char_source *source, int font, uint32_t code_point) {
    return mt_given_glyph(source->pairs, source->fonts, font, code_point) != 0;
}

/* Adds "FONT lacks A (U+0041), B (U+0042)" to a line, where the font lacks any. */
static void add_lacking(const char_source *source, int font, const characters *wanted, char *line,
                        size_t room) {
    const char *spec = source->options->fonts[font];
    int lacking = 0;
    size_t used = strlen(line);
    for (int i = 0; i < wanted->count; i++) {
        char name[CHARACTER_NAME_ROOM];
        if (has_char(source, font, wanted->list[i])) continue;
        character_describe(wanted->list[i], name, sizeof name);
        if (lacking == 0) snprintf(line + used, room - used, "%s%s lacks %s", used ? "; " : "", spec, name);
        if (lacking > 0 && lacking < RANGES_MOST) snprintf(line + used, room - used, ", %s", name);
        used += strlen(line + used);
        lacking++;
    }
    if (lacking > RANGES_MOST) snprintf(line + used, room - used, " and %d more", lacking - RANGES_MOST);
}

static int read_text(const cli_options *options, notation *reader, characters *chosen, choices *text) {
    char name[NOTATION_NAME_MAX + 1];
    mt_status status = MT_OK;
    for (const char *at = options->text; *at && status == MT_OK;) {
        mt_choice choice;
        status = notation_next(reader, &at, &choice, name);
        if (status == MT_NO_GLYPH) return fail("--text: %s has no glyph /%s", options->fonts[0], name);
        bool ends_line = status == MT_OK && !choice.name && choice.code_point == '\n';
        if (status == MT_OK) status = choices_add(text, &choice);
        if (status == MT_OK && !ends_line) status = characters_add_choice(chosen, &choice);
    }
    if (status == MT_BAD_PARAMETER) return fail_status("--text", status);
    return status == MT_OK ? DONE : fail_status(options->fonts[0], status);
}

/* A text is wanted whole. */
static int choose_text(const char_source *source, notation *reader, characters *chosen, choices *text) {
    const cli_options *options = source->options;
    char line[NAME_ROOM] = "";
    int outcome = read_text(options, reader, chosen, text);
    if (outcome != DONE) return outcome;
    if (chosen->order.count == 0) return misuse(options->command, "--text: no characters");
    for (int i = 0; i < source->count; i++) add_lacking(source, i, chosen, line, sizeof line);
    return *line ? fail("%s", line) : DONE;
}

static void say_characters(const cli_options *options, characters *set, const char *where,
                           const char *what_becomes) {
    char ranges[512];
    if (options->quiet || set->count == 0) return;
    characters_describe(set, RANGES_MOST, ranges, sizeof ranges);
    say("%d character%s %s, %s: %s", set->count, set->count == 1 ? "" : "s", where, what_becomes, ranges);
}

/* Of a file, those that all fonts have, or the one that is asked. */
static int choose_file(const char_source *source, notation *reader, characters *chosen) {
    const cli_options *options = source->options;
    const int count = source->count;
    characters wanted = {0}, left_out = {0};
    const char *everyone = count > 2 ? "all fonts" : "both fonts";
    char where[NAME_ROOM];
    snprintf(where, sizeof where, "not in %s", everyone);
    if (count == 1) snprintf(where, sizeof where, "not in %s", options->fonts[0]);
    int outcome = characters_add_file(&wanted, options->chars_file, reader, options->fonts[0]);
    mt_status status = MT_OK;
    for (int i = 0; outcome == DONE && status == MT_OK && i < wanted.order.count; i++) {
        const mt_choice *choice = &wanted.order.list[i];
        bool everywhere = true;
        for (int k = 0; k < count && !choice->name; k++)
            everywhere = everywhere && has_char(source, k, choice->code_point);
        status = characters_add_choice(everywhere ? chosen : &left_out, choice);
    }
    if (status != MT_OK) outcome = fail_status(options->chars_file, status);
    if (outcome == DONE && chosen->order.count == 0)
        outcome = fail("%s: none of its %d characters is in %s", options->chars_file, wanted.count,
                       count > 1 ? everyone : options->fonts[0]);
    if (outcome == DONE) say_characters(options, &left_out, where, "left out");
    characters_free(&wanted);
    characters_free(&left_out);
    return outcome;
}

int characters_choose(const cli_options *options, mt_font *const *fonts, int count,
                      const mt_given_pairs *pairs, characters *chosen, choices *text) {
    const char_source source = {options, fonts, count, pairs};
    notation reader = {.font = fonts[0]};
    if (!options->text && !options->chars_file) return DONE;
    int outcome = options->text ? choose_text(&source, &reader, chosen, text) : DONE;
    if (outcome == DONE && options->chars_file) outcome = choose_file(&source, &reader, chosen);
    notation_close(&reader);
    return outcome;
}

/* Whether a glyph of the font goes with others by a given pair. */
static bool is_given(const mt_given_pairs *pairs, int font, uint32_t glyph) {
    for (int i = 0; i < pairs->count; i++)
        if (pairs->glyphs[i * pairs->font_count + font] == glyph) return true;
    return false;
}

/* Whether what the font has for a character is in the new font: all fonts have the character, or a pair is given. */
static bool is_shared(const char_source *source, int font, uint32_t code_point) {
    bool everywhere = true;
    for (int k = 0; k < source->count; k++)
        everywhere = everywhere && mt_font_mapped_glyph(source->fonts[k], code_point) != 0;
    return everywhere || is_given(source->pairs, font, mt_font_mapped_glyph(source->fonts[font], code_point));
}

/* Those of the font that another one lacks. */
static mt_status find_unshared(const char_source *source, int font, characters *all, characters *unshared) {
    mt_status status = characters_add_font(all, source->fonts[font]);
    for (int i = 0; status == MT_OK && i < all->count; i++)
        if (!is_shared(source, font, all->list[i])) status = characters_add(unshared, all->list[i]);
    return status;
}

/* What not all fonts have is left out, but for the first's with --glyphs first. */
static void say_unshared(const cli_options *options, int font, characters *unshared) {
    char where[NAME_ROOM];
    bool kept = options->glyphs == MT_GLYPHS_FIRST && font == 0;
    snprintf(where, sizeof where, options->font_count > 2 ? "of %s not in all fonts" : "only in %s",
             options->fonts[font]);
    say_characters(options, unshared, where, kept ? "kept as they are" : "left out");
}

/* A whole font: tells what not all fonts have. MT_NOTHING_SHARED when that is everything. */
static mt_status summarise(const cli_work *work) {
    const cli_options *options = work->options;
    const char_source source = {options, work->fonts, options->font_count, &work->pairs};
    mt_status status = MT_OK;
    for (int i = 0; i < options->font_count && status == MT_OK; i++) {
        characters all = {0}, unshared = {0};
        status = find_unshared(&source, i, &all, &unshared);
        if (status == MT_OK && unshared.count == all.count) status = MT_NOTHING_SHARED;
        if (status == MT_OK) say_unshared(options, i, &unshared);
        characters_free(&all);
        characters_free(&unshared);
    }
    return status;
}

/* ---- glyphs that could not be blended ----------------------------------------------------------- */

int work_failures(cli_work *work) {
    const cli_options *options = work->options;
    progress_erase(&work->bar);
    if (!options->quiet) glyph_notes_say_unblended(&work->unblended, options);
    if (!options->quiet) glyph_notes_say_cut_short(&work->cut_short, options);
    if (!options->quiet) glyph_notes_say_held(&work->held, options);
    if (!options->quiet || options->strict) glyph_notes_say_failures(&work->failures, options);
    int count = work->failures.count;
    if (work->failures.lost || work->unblended.lost || work->cut_short.lost || work->held.lost)
        return fail("%s", mt_status_text(MT_NO_MEMORY));
    if (!options->strict || count == 0) return DONE;
    return fail("%d glyph%s could not be blended; nothing written (--strict)", count, count == 1 ? "" : "s");
}

/* Names the font that is to blame, where one is by itself; all of them otherwise. */
static void name_fonts(const cli_work *work, mt_status status, char *name, size_t room) {
    for (int i = 0; status == MT_ENDLESS_LOOKUPS && i < work->options->font_count; i++) {
        if (!mt_font_is_endless(work->fonts[i])) continue;
        snprintf(name, room, "%s", work->options->fonts[i]);
        return;
    }
    work_name(work->options, name, room);
}

int work_fail(cli_work *work, mt_status status) {
    char name[NAME_ROOM];
    bool of_output = status == MT_CANNOT_WRITE || status == MT_UNKNOWN_FORMAT || status == MT_TOO_LARGE;
    progress_erase(&work->bar);
    if (work->stopped) return COULD_NOT;
    if (of_output) return fail_status(work->options->output, status);
    name_fonts(work, status, name, sizeof name);
    return fail_status(name, status);
}

/* ---- the blend ---------------------------------------------------------------------------------- */

static void explain(const cli_work *work) {
    if (!work->options->verbose) return;
    for (int i = 0; i < work->options->font_count; i++)
        say("%s: %s %s", work->options->fonts[i], mt_font_family(work->fonts[i]),
            mt_font_style(work->fonts[i]));
}

static int set_hints(cli_work *work) {
    mt_hint_table *table;
    mt_hint_error error;
    int outcome = hints_read(work->options, work->fonts, work->options->font_count, &table);
    if (outcome != DONE) return outcome;
    mt_status status = work->variable ? mt_variable_set_hints(work->variable, table, &error)
                                      : mt_blend_set_hints(work->blend, table, &error);
    if (status == MT_BAD_HINTS) outcome = hints_fail(work->options, status, &error, table);
    if (status != MT_OK && status != MT_BAD_HINTS) outcome = work_fail(work, status);
    mt_hint_table_free(table);
    return outcome;
}

/* Says how much each font leans more than the one before. */
static mt_status explain_slant(const cli_work *work, mt_row *row) {
    if (!work->options->verbose) return MT_OK;
    mt_status status = mt_row_find_leans(row);
    for (int i = 0; status == MT_OK && i + 1 < row->font_count; i++)
        if (row->leans[i] != 0)
            say("%s: leans %.1f degrees more than %s", work->options->fonts[i + 1], row->leans[i],
                work->options->fonts[i]);
    return status;
}

void work_say_unsaid(const cli_options *options, int unsaid) {
    const char *s = unsaid == 1 ? "" : "s";
    if (unsaid > 0 && !options->quiet)
        say("%s: features.fea has no words for %d rule%s, lookup%s or feature%s of the layout, and leaves %s "
            "out",
            options->output, unsaid, s, s, s, unsaid == 1 ? "it" : "them");
}

void work_say_proved(const cli_work *work) {
    const mt_row *row = work->variable ? &work->variable->row : &work->blend->row;
    const char *of = row->font_count > 2 ? ", counted between every two fonts" : "";
    if (work->options->verbose && row->prepared > 0)
        say("topology proved for every T of %d out of %d glyphs%s", row->proved, row->prepared, of);
}

/* The characters and glyphs chosen; of a whole font, tells what not all fonts have. */
static mt_status choose(cli_work *work) {
    const characters *chosen = &work->chosen;
    mt_row *row = work->variable ? &work->variable->row : &work->blend->row;
    mt_status status = explain_slant(work, row);
    if (status != MT_OK || chosen->order.count == 0) return status == MT_OK ? summarise(work) : status;
    return mt_row_choose(row, chosen->order.list, chosen->order.count);
}

static int make_blend(cli_work *work) {
    const cli_options *options = work->options;
    mt_status status = mt_blend_new(work->fonts[0], work->fonts[1], &options->params, &work->blend);
    if (status == MT_OK) status = mt_blend_set_pairs(work->blend, work->pairs.glyphs, work->pairs.count);
    if (status == MT_OK && set_hints(work) != DONE) return COULD_NOT;
    if (status == MT_OK) mt_blend_set_glyphs(work->blend, options->glyphs);
    if (status == MT_OK) mt_blend_set_curves(work->blend, options->curves);
    if (status == MT_OK) mt_blend_set_cache(work->blend, work->cache);
    if (status == MT_OK) mt_blend_set_alternates(work->blend, options->alternates);
    if (status == MT_OK && options->family) status = mt_blend_set_family(work->blend, options->family);
    if (status == MT_OK) status = mt_blend_set_styles(work->blend, options->styles, options->style_count);
    if (status == MT_OK && options->own_heights)
        status = mt_blend_set_heights(work->blend, options->at_up, options->at_count);
    if (status == MT_OK && places_file_set(options, work->fonts[0], work->blend) != DONE) return COULD_NOT;
    if (status == MT_OK) status = choose(work);
    if (status != MT_OK) return work_fail(work, status);
    mt_blend_on_glyph_failure(work->blend, glyph_notes_add, &work->failures);
    mt_blend_on_unblended(work->blend, glyph_notes_add, &work->unblended);
    mt_blend_on_cut_short(work->blend, glyph_notes_add, &work->cut_short);
    mt_blend_on_held(work->blend, glyph_notes_add, &work->held);
    mt_blend_on_progress(work->blend, progress_draw, &work->bar);
    return DONE;
}

static mt_status set_stops(const cli_work *work) {
    const cli_options *options = work->options;
    mt_variable_set_italic(work->variable, options->has_italic);
    return mt_variable_set_stops(work->variable, options->axis_tag, options->stops);
}

static int make_variable(cli_work *work) {
    const cli_options *options = work->options;
    mt_status status = mt_variable_new(work->fonts, options->font_count, &options->params, &work->variable);
    if (status == MT_OK)
        status = mt_variable_set_pairs(work->variable, work->pairs.glyphs, work->pairs.count);
    if (status == MT_OK && set_hints(work) != DONE) return COULD_NOT;
    if (status == MT_OK) mt_variable_set_glyphs(work->variable, options->glyphs);
    if (status == MT_OK) mt_variable_set_curves(work->variable, options->curves);
    if (status == MT_OK) mt_variable_set_cache(work->variable, work->cache);
    if (status == MT_OK) mt_variable_set_alternates(work->variable, options->alternates);
    if (status == MT_OK && options->family) status = mt_variable_set_family(work->variable, options->family);
    if (status == MT_OK && options->style_count)
        status = mt_variable_set_style(work->variable, options->styles[0]);
    if (status == MT_OK && options->own_stops) status = set_stops(work);
    if (status == MT_OK && *options->axis_tag && !options->own_stops)
        status =
            mt_variable_set_axis(work->variable, options->axis_tag, options->axis_from, options->axis_to);
    if (status == MT_OK)
        status =
            mt_variable_set_map(work->variable, options->map_values, options->map_places, options->map_count);
    if (status == MT_OK) status = choose(work);
    if (status != MT_OK) return work_fail(work, status);
    mt_variable_on_glyph_failure(work->variable, glyph_notes_add, &work->failures);
    mt_variable_on_unblended(work->variable, glyph_notes_add, &work->unblended);
    mt_variable_on_cut_short(work->variable, glyph_notes_add, &work->cut_short);
    mt_variable_on_progress(work->variable, progress_draw, &work->bar);
    return DONE;
}

static int open_cache(const cli_options *options, mt_cache **cache) {
    if (!options->cache) return DONE;
    errno = 0;
    mt_status status = mt_cache_open(options->cache, options->cache_bytes, cache);
    return status == MT_OK ? DONE : fail_status(options->cache, status);
}

/* With --verbose, how much there was in the cache. */
static void say_cache(const cli_work *work) {
    if (!work->cache || !work->options->verbose) return;
    mt_cache_counts counts = mt_cache_count(work->cache);
    char lost[64] = "";
    if (counts.lost) snprintf(lost, sizeof lost, ", of which %d could not be kept", counts.lost);
    say("%s: %d glyph%s taken, %d made%s", work->options->cache, counts.found, counts.found == 1 ? "" : "s",
        counts.made, lost);
}

/* Opens the fonts and chooses the characters. */
static int open_fonts(const cli_options *options, cli_work *work) {
    *work = (cli_work){.options = options, .bar = progress_begin(options->quiet, "glyphs")};
    int outcome = open_cache(options, &work->cache);
    if (outcome == DONE) outcome = fonts_open(options, work->fonts);
    if (outcome == DONE) explain(work);
    int asked = options->glyphs == MT_GLYPHS_FIRST ? 1 : options->font_count;
    if (outcome == DONE) outcome = pairs_file_read(options, work->fonts, &work->pairs);
    if (outcome != DONE) return outcome;
    return characters_choose(options, work->fonts, asked, &work->pairs, &work->chosen, &work->text);
}

int work_begin(const cli_options *options, cli_work *work) {
    int outcome = open_fonts(options, work);
    return outcome == DONE ? make_blend(work) : outcome;
}

int work_begin_variable(const cli_options *options, cli_work *work) {
    int outcome = open_fonts(options, work);
    return outcome == DONE ? make_variable(work) : outcome;
}

/* An mt_warning. */
static void warn(const char *line, void *user) {
    (void)user;
    say("%s", line);
}

/* An mt_left_out_noted; is called before the first glyph is made. */
static void say_left_out(int glyphs, const char *features, void *user) {
    (void)user;
    say("%d glyph%s left out that text has to ask for (%s): --alternates keeps %s", glyphs,
        glyphs == 1 ? "" : "s", features, glyphs == 1 ? "it" : "them");
}

mt_status work_warn(const cli_work *work) {
    if (work->options->quiet) return MT_OK;
    if (work->variable) {
        mt_variable_on_left_out(work->variable, say_left_out, NULL);
        return mt_variable_warnings(work->variable, warn, NULL);
    }
    mt_blend_on_left_out(work->blend, say_left_out, NULL);
    return mt_blend_warnings(work->blend, warn, NULL);
}

mt_status work_made(void *user) {
    cli_work *work = user;
    work->stopped = work_failures(work) != DONE;
    return work->stopped ? MT_BAD_GEOMETRY : MT_OK;
}

void work_end(cli_work *work) {
    progress_erase(&work->bar);
    mt_blend_free(work->blend);
    mt_variable_free(work->variable);
    say_cache(work);
    mt_cache_close(work->cache);
    for (int i = 0; i < work->options->font_count; i++) mt_font_close(work->fonts[i]);
    characters_free(&work->chosen);
    mt_given_pairs_free(&work->pairs);
    choices_free(&work->text);
    glyph_notes_free(&work->failures);
    glyph_notes_free(&work->unblended);
    glyph_notes_free(&work->cut_short);
    glyph_notes_free(&work->held);
}
