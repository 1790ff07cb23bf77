#include "source/glyph_names.h"

#include <stdlib.h>
#include <string.h>

#include "source/handle.h"

typedef struct mt_name_reading {
    mt_arena *arena;
    bool numbers_too; /* names that tell a number */
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
    if (!*name || (!reading->numbers_too && tells_number(name))) return MT_OK;
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

static mt_status read(mt_font *font, mt_name_reading *reading) {
    reading->count = mt_font_glyph_count(font);
    return font->face ? mt_font_guard(font, read_names, reading) : MT_NO_MEMORY;
}

mt_status mt_font_glyph_names(mt_font *font, mt_arena *arena, const char ***names) {
    mt_name_reading reading = {.arena = arena};
    mt_status status = read(font, &reading);
    if (status == MT_OK) *names = reading.names;
    return status;
}

/* ---- by name ------------------------------------------------------------------------------------------- */

static int by_name(const void *p, const void *q) {
    const mt_named_glyph *x = p, *y = q;
    int order = strcmp(x->name, y->name);
    return order ? order : (x->glyph > y->glyph) - (x->glyph < y->glyph);
}

void mt_name_index_sort(mt_name_index *index) {
    if (index->count) qsort(index->list, (size_t)index->count, sizeof *index->list, by_name);
}

mt_status mt_name_index_make(mt_font *font, mt_arena *arena, mt_name_index *index) {
    mt_name_reading reading = {.arena = arena, .numbers_too = true};
    mt_name_index made = {0};
    mt_status status = read(font, &reading);
    if (status != MT_OK) return status;
    made.list = mt_arena_new(arena, (size_t)reading.count + 1, sizeof *made.list);
    if (!made.list) return MT_NO_MEMORY;
    for (int i = 0; i < reading.count && reading.names; i++)
        if (reading.names[i]) made.list[made.count++] = (mt_named_glyph){reading.names[i], (uint32_t)i};
    mt_name_index_sort(&made);
    *index = made;
    return MT_OK;
}

uint32_t mt_name_index_find(const mt_name_index *index, const char *name) {
    const mt_named_glyph key = {name, 0};
    int low = 0, high = index->count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (by_name(&index->list[middle], &key) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low < index->count && strcmp(index->list[low].name, name) == 0 ? index->list[low].glyph : 0;
}
