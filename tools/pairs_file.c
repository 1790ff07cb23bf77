#include "pairs_file.h"

#include "base/file.h"
#include "base/lines.h"
#include "base/memory.h"
#include "base/utf.h"
#include "messages.h"
#include "source/glyph_names.h"
#include "work.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#define FILE_MAX ((size_t)1 << 24) /* bytes: every glyph of a font, with room for comments */
#define WORD_SHOWN 80              /* bytes of a word in a message */

typedef struct pairs_file {
    const cli_options *options;
    mt_font *const *fonts;
    mt_name_index names[MT_VARIABLE_FONTS_MAX]; /* of each font, from when it is asked for one */
    bool indexed[MT_VARIABLE_FONTS_MAX];
    mt_arena arena;
    int line; /* from 1 */
    int count, room;
    uint32_t *glyphs; /* rows, as mt_given_pairs_make takes them */
    int *lines;       /* of the first font's glyphs, the line that pairs it; 0: none */
} pairs_file;

/* ---- messages ----------------------------------------------------------------------------------- */

static int fail_at(const pairs_file *file, const char *what) {
    return fail("%s:%d: %s", file->options->pairs_file, file->line, what);
}

static int fail_lacking(const pairs_file *file, int font, const char *what, const char *word) {
    return fail("%s:%d: %s has no %s%.*s", file->options->pairs_file, file->line, file->options->fonts[font],
                what, WORD_SHOWN, word);
}

/* ---- glyphs ------------------------------------------------------------------------------------- */

/* U+ and up to six hexadecimal digits. */
static bool read_code_point(const char *word, uint32_t *code_point) {
    size_t length = strlen(word + 2);
    if (length == 0 || length > 6 || strspn(word + 2, "0123456789abcdefABCDEF") != length) return false;
    *code_point = (uint32_t)strtoul(word + 2, NULL, 16);
    return true;
}

static int find_by_code_point(const pairs_file *file, int font, const char *word, uint32_t *glyph) {
    uint32_t code_point;
    if (!read_code_point(word, &code_point)) return fail_at(file, "a code point is written U+E001");
    *glyph = mt_font_glyph(file->fonts[font], code_point);
    return *glyph ? DONE : fail_lacking(file, font, "glyph for ", word);
}

static int find_by_name(pairs_file *file, int font, const char *name, uint32_t *glyph) {
    if (!file->indexed[font]) {
        mt_status status = mt_name_index_make(file->fonts[font], &file->arena, &file->names[font]);
        if (status != MT_OK) return fail_status(file->options->pairs_file, status);
        file->indexed[font] = true;
    }
    if (file->names[font].count == 0)
        return fail_lacking(file, font, "names of glyphs: ", "code points are wanted");
    *glyph = mt_name_index_find(&file->names[font], name);
    return *glyph ? DONE : fail_lacking(file, font, "glyph /", name);
}

static int find_glyph(pairs_file *file, int font, const char *word, uint32_t *glyph) {
    bool is_code = (word[0] == 'U' || word[0] == 'u') && word[1] == '+';
    if (is_code) return find_by_code_point(file, font, word, glyph);
    return find_by_name(file, font, word + (word[0] == '/'), glyph);
}

/* ---- lines -------------------------------------------------------------------------------------- */

static uint32_t *add_row(pairs_file *file) {
    size_t width = (size_t)file->options->font_count;
    uint32_t *glyphs = mt_grow_list(file->glyphs, file->count, &file->room, width * sizeof *glyphs);
    if (!glyphs) return NULL;
    file->glyphs = glyphs;
    return glyphs + width * (size_t)file->count++;
}

static int read_line(pairs_file *file, char *line) {
    const char *words[MT_VARIABLE_FONTS_MAX];
    const int wanted = file->options->font_count;
    if (!mt_utf8_is_valid(line, strlen(line))) return fail_at(file, "not UTF-8 text");
    int count = mt_words_split(line, words, wanted);
    if (count == 0) return DONE;
    if (count != wanted)
        return fail("%s:%d: %d glyph%s instead of %d, one for each font", file->options->pairs_file,
                    file->line, count, count == 1 ? "" : "s", wanted);
    uint32_t *row = add_row(file);
    if (!row) return fail_status(file->options->pairs_file, MT_NO_MEMORY);
    for (int i = 0; i < wanted; i++) {
        int outcome = find_glyph(file, i, words[i], &row[i]);
        if (outcome != DONE) return outcome;
        if (i == 0 && file->lines[row[0]])
            return fail("%s:%d: %.*s is paired on line %d already", file->options->pairs_file, file->line,
                        WORD_SHOWN, words[i], file->lines[row[0]]);
    }
    file->lines[row[0]] = file->line;
    return DONE;
}

/* `text` is cut into lines and words in place. */
static int read_lines(pairs_file *file, char *text, size_t length) {
    mt_lines lines = mt_lines_of(text, length);
    bool whole;
    for (char *line; (line = mt_lines_next(&lines, &whole));) {
        file->line = lines.number;
        int outcome = whole ? read_line(file, line) : fail_at(file, "not UTF-8 text");
        if (outcome != DONE) return outcome;
    }
    return file->count ? DONE : fail("%s: no pairs", file->options->pairs_file);
}

/* ---- the file ----------------------------------------------------------------------------------- */

static int read_bytes(const char *path, char **text, size_t *length) {
    uint8_t *bytes;
    errno = 0;
    mt_status status = mt_file_read(path, FILE_MAX, &bytes, length);
    if (status != MT_OK) return fail_status(path, status);
    *text = mt_grow(bytes, *length + 1, 1);
    if (!*text) {
        mt_free(bytes);
        return fail_status(path, MT_NO_MEMORY);
    }
    (*text)[*length] = '\0';
    return DONE;
}

static int make_pairs(pairs_file *file, char *text, size_t length, mt_given_pairs *pairs) {
    const cli_options *options = file->options;
    file->lines =
        mt_arena_new(&file->arena, (size_t)mt_font_glyph_count(file->fonts[0]) + 1, sizeof *file->lines);
    if (!file->lines) return fail_status(options->pairs_file, MT_NO_MEMORY);
    int outcome = read_lines(file, text, length);
    if (outcome != DONE) return outcome;
    mt_status status =
        mt_given_pairs_make(file->glyphs, file->count, file->fonts, options->font_count, pairs);
    return status == MT_OK ? DONE : fail_status(options->pairs_file, status);
}

int pairs_file_read(const cli_options *options, mt_font *const *fonts, mt_given_pairs *pairs) {
    char *text;
    size_t length;
    *pairs = (mt_given_pairs){0};
    if (!options->pairs_file) return DONE;
    int outcome = read_bytes(options->pairs_file, &text, &length);
    if (outcome != DONE) return outcome;
    pairs_file file = {.options = options, .fonts = fonts};
    outcome = make_pairs(&file, text, length, pairs);
    mt_free(file.glyphs);
    mt_arena_release(&file.arena);
    mt_free(text);
    return outcome;
}
