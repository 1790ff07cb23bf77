#include "places_file.h"

#include "base/memory.h"
#include "characters_file.h"
#include "messages.h"
#include "morph/check/reach.h"
#include "numbers.h"
#include "work.h"

#include <stdio.h>
#include <string.h>

typedef struct places_file {
    const cli_options *options;
    mt_font *font;
    notation reader;
    int count, room;
    uint32_t *glyphs;
    double *t, *up;
    int *lines; /* of the font's glyphs, the line that places it; 0: none */
} places_file;

/* ---- one glyph ---------------------------------------------------------------------------------- */

static int fail_at(const places_file *file, int line, const char *what) {
    return fail("%s:%d: %s", file->options->places_file, line, what);
}

static void describe(const mt_choice *choice, char *text, size_t room) {
    if (choice->name)
        snprintf(text, room, "/%.255s", choice->name);
    else
        character_describe(choice->code_point, text, room);
}

static bool make_room(places_file *file) {
    size_t room = (size_t)file->room;
    if (file->count < file->room) return true;
    room = room ? 2 * room : 64;
    uint32_t *glyphs = mt_grow(file->glyphs, room, sizeof *glyphs);
    if (glyphs) file->glyphs = glyphs;
    double *t = mt_grow(file->t, room, sizeof *t);
    if (t) file->t = t;
    double *up = mt_grow(file->up, room, sizeof *up);
    if (up) file->up = up;
    if (glyphs && t && up) file->room = (int)room;
    return glyphs && t && up;
}

static int add_glyph(places_file *file, int line, const mt_choice *choice, mt_at at) {
    char name[320];
    uint32_t glyph = choice->name ? choice->glyph : mt_font_glyph(file->font, choice->code_point);
    describe(choice, name, sizeof name);
    if (!choice->name && glyph == 0)
        return fail("%s:%d: %s has no character %s", file->options->places_file, line,
                    file->options->fonts[0], name);
    if (file->lines[glyph])
        return fail("%s:%d: %s has a place on line %d already", file->options->places_file, line, name,
                    file->lines[glyph]);
    if (!make_room(file)) return fail_status(file->options->places_file, MT_NO_MEMORY);
    file->glyphs[file->count] = glyph;
    file->t[file->count] = at.x;
    file->up[file->count++] = at.y;
    file->lines[glyph] = line;
    return DONE;
}

/* ---- lines -------------------------------------------------------------------------------------- */

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

/* Cuts off a comment, and blanks at the end. */
static void trim(char *line) {
    size_t length = 0;
    while (line[length] && !(line[length] == '#' && (length == 0 || is_blank(line[length - 1])))) length++;
    while (length > 0 && is_blank(line[length - 1])) length--;
    line[length] = '\0';
}

/* Cuts the place off a line that is trimmed; false where it ends with none. */
static bool cut_place(char *line, mt_at *at) {
    size_t start = strlen(line);
    const double least = -MT_REACH_MOST, most = 1 + MT_REACH_MOST;
    while (start > 0 && !is_blank(line[start - 1])) start--;
    if (places_read(line + start, &at->x, &at->y, 1) != 1) return false;
    line[start] = '\0';
    trim(line);
    return *line && at->x >= least && at->x <= most && at->y >= least && at->y <= most;
}

static int add_all(places_file *file, int line, const characters *named, mt_at at) {
    int outcome = DONE;
    for (int i = 0; i < named->order.count && outcome == DONE; i++)
        outcome = add_glyph(file, line, &named->order.list[i], at);
    return outcome;
}

/* A text_line. */
static int read_line(char *line, int number, void *user) {
    places_file *file = user;
    const characters_source source = {&file->reader, file->options->fonts[0], file->options->places_file};
    characters named = {0};
    mt_at at;
    trim(line);
    if (!*line) return DONE;
    if (!cut_place(line, &at))
        return fail_at(file, number, "characters or glyphs are wanted, then T or T,y=T, from -1 to 2");
    if (at.x != at.y && file->options->params.rotation != MT_ROTATION_NONE)
        return fail_at(file, number, "T,y=T and --rotate exclude each other");
    int outcome = characters_add_line(&named, &source, number, line);
    if (outcome == DONE) outcome = add_all(file, number, &named, at);
    characters_free(&named);
    return outcome;
}

/* ---- the file ----------------------------------------------------------------------------------- */

static int read_file(places_file *file, mt_blend *blend) {
    const char *path = file->options->places_file;
    file->lines = mt_new((size_t)mt_font_glyph_count(file->font) + 1, sizeof *file->lines);
    if (!file->lines) return fail_status(path, MT_NO_MEMORY);
    int outcome = text_file_read(path, read_line, file);
    if (outcome != DONE) return outcome;
    if (file->count == 0) return fail("%s: no places", path);
    mt_status status = mt_blend_set_places(blend, file->glyphs, file->t, file->up, file->count);
    return status == MT_OK ? DONE : fail_status(path, status);
}

int places_file_set(const cli_options *options, mt_font *font, mt_blend *blend) {
    places_file file = {.options = options, .font = font, .reader = {.font = font}};
    if (!options->places_file) return DONE;
    int outcome = read_file(&file, blend);
    notation_close(&file.reader);
    mt_free(file.glyphs);
    mt_free(file.t);
    mt_free(file.up);
    mt_free(file.lines);
    return outcome;
}
