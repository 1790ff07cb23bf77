#include "source/glyph_names.h"

#include <stdio.h>
#include <string.h>

#include "geometry/limits.h"
#include "source/handle.h"

/* ---- a font's own -------------------------------------------------------------------------------------- */

typedef struct mt_name_reading {
    mt_arena *arena;
    int count;
    const char **names; /* NULL when the font has none */
    mt_status status;
} mt_name_reading;

/* Whether the name is one of these words and a number, which some programs give to all glyphs. */
static bool tells_number(const char *name) {
    static const char *const words[] = {"glyph", "gid", "cid", "index", "g"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        size_t length = strlen(words[i]);
        if (strncmp(name, words[i], length) != 0) continue;
        const char *rest = name + length;
        if (*rest && rest[strspn(rest, "0123456789")] == '\0') return true;
    }
    return false;
}

static mt_status keep_name(mt_name_reading *reading, int glyph, const char *name) {
    if (!*name || tells_number(name)) return MT_OK;
    size_t length = strlen(name) + 1;
    char *copy = mt_arena_new(reading->arena, length, 1);
    if (!copy) return MT_NO_MEMORY;
    reading->names[glyph] = memcpy(copy, name, length);
    return MT_OK;
}

static mt_status read_names(mt_font *font, void *user) {
    mt_name_reading *reading = user;
    char name[256];
    if (!FT_HAS_GLYPH_NAMES(font->face)) return MT_OK;
    reading->names = mt_arena_new(reading->arena, (size_t)reading->count + 1, sizeof *reading->names);
    mt_status status = reading->names ? MT_OK : MT_NO_MEMORY;
    for (int i = 0; i < reading->count && status == MT_OK; i++)
        if (FT_Get_Glyph_Name(font->face, (FT_UInt)i, name, sizeof name) == 0)
            status = keep_name(reading, i, name);
    return status;
}

mt_status mt_font_glyph_names(mt_font *font, mt_arena *arena, const char ***names) {
    mt_name_reading reading = {.arena = arena, .count = mt_font_glyph_count(font)};
    if (!font->face) return MT_NO_MEMORY;
    mt_status status = mt_font_guard(font, read_names, &reading);
    if (status == MT_OK) *names = reading.names;
    return status;
}

/* ---- the new font's ------------------------------------------------------------------------------------ */

/* Letters, digits, dots and underscores; a digit or a dot does not come first. */
static bool is_safe(const char *name) {
    static const char safe[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._";
    size_t length = strlen(name);
    if (length > MT_GLYPH_NAME_MAX || strspn(name, safe) != length) return false;
    return !strchr("0123456789.", *name);
}

/* Names in use, by their hashes: a table with open addressing, at most half full. */
typedef struct mt_used_names {
    size_t room; /* a power of two */
    const char **names;
} mt_used_names;

/* FNV-1a. */
static uint32_t hash(const char *name) {
    uint32_t value = 2166136261u;
    for (; *name; name++) value = (value ^ (uint8_t)*name) * 16777619u;
    return value;
}

/* Whether the name was free; it is not any more. */
static bool claim(mt_used_names *used, const char *name) {
    size_t at = hash(name) & (used->room - 1);
    for (; used->names[at]; at = (at + 1) & (used->room - 1))
        if (strcmp(used->names[at], name) == 0) return false;
    used->names[at] = name;
    return true;
}

/* Gives the glyph its character's name, or the name of its number, which no other has. */
static mt_status make_name(const mt_charset *charset, int glyph, mt_used_names *used, mt_arena *arena,
                           const char **name) {
    const mt_pairing *pairing = &charset->glyphs[glyph];
    const char *format = pairing->code_point <= 0xFFFF ? "uni%04X" : "u%05X";
    char *made = mt_arena_new(arena, 16, 1);
    if (!made) return MT_NO_MEMORY;
    snprintf(made, 16, format, (unsigned)pairing->code_point);
    if (!pairing->mapped || !claim(used, made)) {
        snprintf(made, 16, "glyph%05d", glyph);
        claim(used, made);
    }
    *name = made;
    return MT_OK;
}

static mt_status make_names(const mt_charset *charset, const char *const *own, mt_arena *arena,
                            const char **names) {
    mt_used_names used = {.room = 256};
    while (used.room < 2 * (size_t)charset->glyph_count) used.room *= 2;
    used.names = mt_arena_new(arena, used.room, sizeof *used.names);
    if (!used.names) return MT_NO_MEMORY;
    names[0] = ".notdef";
    claim(&used, names[0]);
    for (int i = 1; i < charset->primary_count; i++) {
        const char *name = own[charset->glyphs[i].a];
        if (name && is_safe(name) && claim(&used, name)) names[i] = name;
    }
    mt_status status = MT_OK;
    for (int i = 0; i < charset->glyph_count && status == MT_OK; i++)
        if (!names[i]) status = make_name(charset, i, &used, arena, &names[i]);
    return status;
}

mt_status mt_glyph_names_make(mt_font *a, const mt_charset *charset, mt_arena *arena, const char ***names) {
    const char **own, **made;
    mt_status status = mt_font_glyph_names(a, arena, &own);
    *names = NULL;
    if (status != MT_OK || !own) return status;
    made = mt_arena_new(arena, (size_t)charset->glyph_count, sizeof *made);
    status = made ? make_names(charset, own, arena, made) : MT_NO_MEMORY;
    if (status == MT_OK) *names = made;
    return status;
}
