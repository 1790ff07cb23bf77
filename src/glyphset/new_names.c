#include "glyphset/new_names.h"

#include <stdio.h>
#include <string.h>

#include "geometry/limits.h"
#include "source/glyph_names.h"

/* A PostScript name: visible ASCII without the signs that end one (PostScript Language Reference, 3.2.1). */
static bool is_name(const char *name) {
    size_t length = strlen(name);
    if (length == 0 || length > MT_GLYPH_NAME_MAX) return false;
    for (const char *p = name; *p; p++)
        if (*p <= ' ' || *p > '~' || strchr("()<>[]{}/%", *p)) return false;
    return true;
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
        if (name && is_name(name) && claim(&used, name)) names[i] = name;
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
