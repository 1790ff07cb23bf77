#include "notation.h"

#include "base/utf.h"

#include <string.h>

static bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\0';
}

/* How many bytes of a name follow a slash. */
static size_t name_length(const char *name) {
    size_t length = 0;
    while (!is_blank(name[length]) && name[length] != '/') length++;
    return length;
}

/* Whether . or _ stand inside of the name: no word of a text looks so. */
static bool is_suffixed(const char *name, size_t length) {
    for (size_t i = 1; i + 1 < length; i++)
        if (name[i] == '.' || name[i] == '_') return true;
    return false;
}

static mt_status take_character(notation *reader, const char **at, mt_choice *choice) {
    uint32_t code_point;
    reader->after_word = !is_blank(**at);
    if (!mt_utf8_next(at, &code_point)) return MT_BAD_PARAMETER;
    *choice = (mt_choice){.code_point = code_point};
    return MT_OK;
}

/* Copies as much of the name as there is room for, in whole characters. */
static void copy_name(const char *from, size_t length, char name[NOTATION_NAME_MAX + 1]) {
    if (length > NOTATION_NAME_MAX)
        for (length = NOTATION_NAME_MAX; length > 0 && ((unsigned char)from[length] & 0xc0) == 0x80;)
            length--;
    memcpy(name, from, length);
    name[length] = '\0';
}

void notation_close(notation *reader) {
    mt_naming_close(reader->naming);
}

static mt_status find(notation *reader, const char *at, size_t length, mt_choice *choice) {
    uint32_t glyph;
    if (!mt_utf8_is_valid(at, length)) return MT_BAD_PARAMETER;
    mt_status status = reader->naming ? MT_OK : mt_naming_open(reader->font, &reader->naming);
    if (status == MT_OK) status = mt_naming_find(reader->naming, at, length, &glyph);
    if (status == MT_OK) *choice = (mt_choice){.name = at, .glyph = glyph};
    return status;
}

/* Moves past a name, and past one blank that ends it within the line. */
static void pass_name(notation *reader, const char **at, size_t length) {
    *at += 1 + length;
    if (**at == ' ' || **at == '\t') (*at)++;
    reader->after_word = false;
}

/* Two slashes where a name could stand: one of them says that none follows. */
static mt_status take_slash(notation *reader, const char **at, mt_choice *choice) {
    const char *name = *at + 2;
    mt_status status = find(reader, name, name_length(name), choice);
    if (status == MT_NO_MEMORY) return status;
    if (status == MT_OK) (*at)++;
    return take_character(reader, at, choice);
}

mt_status notation_next(notation *reader, const char **at, mt_choice *choice,
                        char name[NOTATION_NAME_MAX + 1]) {
    const char *after = *at + 1;
    if (**at != '/') return take_character(reader, at, choice);
    if (*after == '/' && !reader->after_word) return take_slash(reader, at, choice);
    size_t length = name_length(after);
    if (length == 0 || (reader->after_word && !is_suffixed(after, length)))
        return take_character(reader, at, choice);
    mt_status status = find(reader, after, length, choice);
    if (status == MT_NO_GLYPH && reader->after_word) return take_character(reader, at, choice);
    copy_name(after, length, name);
    choice->name = name;
    if (status == MT_OK) pass_name(reader, at, length);
    return status;
}
