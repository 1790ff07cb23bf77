#include "source/reserved.h"

#include <string.h>

/* ---- words --------------------------------------------------------------------------------------------- */

static char lower(char c) {
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

/* Letters and digits of ASCII, and every byte of another character. */
static bool is_word(char c) {
    c = lower(c);
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (unsigned char)c >= 0x80;
}

static const char *skip_gap(const char *text) {
    while (*text && !is_word(*text)) text++;
    return text;
}

/* Whether the text goes on with these words and then with no letter. */
static bool starts_with(const char *text, const char *words) {
    for (words = skip_gap(words); *words; text++, words++) {
        if (!is_word(*words)) {
            if (is_word(*text)) return false;
            words = skip_gap(words);
            text = skip_gap(text);
            if (!*words) return true;
        }
        if (lower(*text) != lower(*words)) return false;
    }
    return !is_word(*text);
}

bool mt_name_holds(const char *name, const char *words) {
    if (!*skip_gap(words)) return false;
    for (name = skip_gap(name); *name; name = skip_gap(name)) {
        if (starts_with(name, words)) return true;
        while (is_word(*name)) name++;
    }
    return false;
}

const char *mt_reserved_in(const mt_reserved *reserved, const char *name) {
    for (int i = 0; i < reserved->count; i++)
        if (mt_name_holds(name, reserved->names[i])) return reserved->names[i];
    return NULL;
}

const char *mt_find_phrase(const char *text, const char *phrase) {
    for (; *text; text++) {
        size_t i = 0;
        while (phrase[i] && lower(text[i]) == phrase[i]) i++;
        if (!phrase[i]) return text;
    }
    return NULL;
}

/* ---- names in a licence -------------------------------------------------------------------------------- */

static mt_status add(const char *from, size_t length, mt_arena *arena, mt_reserved *reserved) {
    while (length && from[length - 1] == ' ') length--;
    if (length == 0 || reserved->count == MT_RESERVED_MAX) return MT_OK;
    char *name = mt_arena_new(arena, length + 1, 1);
    if (!name) return MT_NO_MEMORY;
    memcpy(name, from, length);
    reserved->names[reserved->count++] = name;
    return MT_OK;
}

/* The length of the quotation mark that the text starts with; 0 where it starts with none. */
static size_t quote_length(const char *text) {
    static const char *const marks[] = {"\"", "'", "\u2018", "\u2019", "\u201C", "\u201D"};
    for (size_t i = 0; i < sizeof marks / sizeof *marks; i++)
        if (strncmp(text, marks[i], strlen(marks[i])) == 0) return strlen(marks[i]);
    return 0;
}

/* A full stop, or the end of the text. */
static bool ends_sentence(const char *text) {
    return !*text || (*text == '.' && (!text[1] || text[1] == ' '));
}

/* Every name in quotation marks up to the end of the sentence. */
static mt_status add_quoted(const char *text, mt_arena *arena, mt_reserved *reserved) {
    const char *start = NULL;
    for (; !ends_sentence(text); text++) {
        size_t mark = quote_length(text);
        if (mark == 0) continue;
        mt_status status = start ? add(start, (size_t)(text - start), arena, reserved) : MT_OK;
        if (status != MT_OK) return status;
        text += mark - 1;
        start = start ? NULL : text + 1;
    }
    return MT_OK;
}

/* The text after "Reserved Font Name": of one name or of several, with a colon or without. */
static const char *skip_heading(const char *text) {
    if (strncmp(text, "(s)", 3) == 0)
        text += 3;
    else if (lower(*text) == 's')
        text++;
    while (*text == ' ' || *text == ':') text++;
    return text;
}

static mt_status add_after_heading(const char *text, mt_arena *arena, mt_reserved *reserved) {
    const char *end = text = skip_heading(text);
    if (quote_length(text)) return add_quoted(text, arena, reserved);
    while (!ends_sentence(end) && !strchr(",;<(", *end)) end++;
    return add(text, (size_t)(end - text), arena, reserved);
}

static mt_status add_from(const char *text, mt_arena *arena, mt_reserved *reserved) {
    static const char heading[] = "with reserved font name", others[] = "names not containing";
    mt_status status = MT_OK;
    for (const char *at = text; at && (at = mt_find_phrase(at, heading)) && status == MT_OK;) {
        at += sizeof heading - 1;
        status = add_after_heading(at, arena, reserved);
    }
    for (const char *at = text; at && (at = mt_find_phrase(at, others)) && status == MT_OK;) {
        at += sizeof others - 1;
        status = add_quoted(at, arena, reserved);
    }
    return status;
}

mt_status mt_reserved_find(const mt_font *font, mt_arena *arena, mt_reserved *reserved) {
    mt_names names;
    mt_reserved found = {0};
    mt_font_names(font, &names);
    if (names.family) found.names[found.count++] = names.family;
    mt_status status = add_from(names.copyright, arena, &found);
    if (status == MT_OK) status = add_from(names.license, arena, &found);
    if (status == MT_OK) *reserved = found;
    return status;
}
