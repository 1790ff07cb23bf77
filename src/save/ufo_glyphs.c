/* The code points and the names of a UFO's glyphs. */
#include <stdio.h>
#include <string.h>

#include "save/ufo_parts.h"

/* The characters sorted by glyph. */
static mt_status collect_code_points(const mt_font_data *data, mt_arena *arena, mt_ufo_glyphs *glyphs) {
    int count = data->glyph_count;
    glyphs->starts = mt_arena_new(arena, (size_t)count + 2, sizeof *glyphs->starts);
    glyphs->code_points = mt_arena_new(arena, (size_t)data->char_count, sizeof *glyphs->code_points);
    if (!glyphs->starts || !glyphs->code_points) return MT_NO_MEMORY;
    int *next = glyphs->starts + 1; /* becomes starts once each has moved past its own */
    for (int i = 0; i < data->char_count; i++) next[data->chars[i].glyph + 1]++;
    for (int i = 0; i < count; i++) next[i + 1] += next[i];
    for (int i = 0; i < data->char_count; i++)
        glyphs->code_points[next[data->chars[i].glyph]++] = data->chars[i].code_point;
    return MT_OK;
}

/* Of a glyph of a font without names: uni4E00, u1F600 (Adobe Glyph List Specification, section 2), .notdef, or glyph00042. */
static mt_status make_name(const mt_ufo_glyphs *glyphs, int glyph, mt_arena *arena, const char **name) {
    enum { ROOM = 16 };
    char *text = mt_arena_new(arena, ROOM, 1);
    if (!text) return MT_NO_MEMORY;
    bool mapped = glyphs->starts[glyph] < glyphs->starts[glyph + 1];
    unsigned code_point = mapped ? glyphs->code_points[glyphs->starts[glyph]] : 0;
    if (glyph == 0)
        snprintf(text, ROOM, ".notdef");
    else if (mapped)
        snprintf(text, ROOM, "%s%04X", code_point > 0xFFFF ? "u" : "uni", code_point);
    else
        snprintf(text, ROOM, "glyph%05d", glyph);
    *name = text;
    return MT_OK;
}

/* ---- plain names ------------------------------------------------------------------------------------------- */

/* A byte that feature files have in names too. */
static bool is_plain(char byte, bool first) {
    bool letter = (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '.' || byte == '_';
    return letter || (!first && byte >= '0' && byte <= '9');
}

static bool is_plain_name(const char *name) {
    for (const char *p = name; *p; p++)
        if (!is_plain(*p, p == name)) return false;
    return *name != '\0';
}

static bool is_used(const mt_ufo_glyphs *glyphs, int count, const char *name) {
    for (int i = 0; i < count; i++)
        if (glyphs->names[i] && strcmp(glyphs->names[i], name) == 0) return true;
    return false;
}

/* The name with an underscore for what is not plain and, where another glyph is called so, a number behind. */
static mt_status make_plain(const mt_ufo_glyphs *glyphs, int count, int glyph, mt_arena *arena) {
    const char *name = glyphs->names[glyph];
    size_t length = strlen(name), start = length && is_plain(name[0], true) ? 0 : 1, room = length + 16;
    char *text = mt_arena_new(arena, room, 1);
    if (!text) return MT_NO_MEMORY;
    text[0] = '_';
    for (size_t i = 0; i < length; i++) text[start + i] = is_plain(name[i], false) ? name[i] : '_';
    for (int i = 2; is_used(glyphs, count, text); i++)
        snprintf(text + start + length, room - start - length, ".%d", i);
    glyphs->names[glyph] = text;
    return MT_OK;
}

static mt_status make_all_plain(const mt_font_data *data, mt_arena *arena, mt_ufo_glyphs *glyphs) {
    mt_status status = MT_OK;
    glyphs->old_names = data->glyph_names;
    for (int i = 0; i < data->glyph_count && status == MT_OK; i++)
        if (!is_plain_name(glyphs->names[i])) status = make_plain(glyphs, data->glyph_count, i, arena);
    return status;
}

mt_status mt_ufo_glyphs_make(const mt_font_data *data, mt_arena *arena, mt_ufo_glyphs *glyphs) {
    mt_ufo_glyphs made = {.names = mt_arena_new(arena, (size_t)data->glyph_count, sizeof *made.names)};
    if (!made.names) return MT_NO_MEMORY;
    mt_status status = collect_code_points(data, arena, &made);
    for (int i = 0; i < data->glyph_count && status == MT_OK; i++) {
        if (data->glyph_names)
            made.names[i] = data->glyph_names[i];
        else
            status = make_name(&made, i, arena, &made.names[i]);
    }
    if (status == MT_OK) status = make_all_plain(data, arena, &made);
    if (status == MT_OK) *glyphs = made;
    return status;
}
