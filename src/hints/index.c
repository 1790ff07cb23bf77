#include "hints/index.h"

#include <stdlib.h>

#include "base/memory.h"
#include "geometry/limits.h"

/* The two glyphs that a hint is for, and where it stands. */
typedef struct mt_hint_key {
    uint32_t a, b;
    int line;
    mt_hint hint; /* until hints[] has it */
} mt_hint_key;

struct mt_hint_index {
    int count;
    mt_hint_key *keys; /* by a, then b, then line */
    mt_hint *hints;    /* of each key */
};

/* The fonts of a row, of which two neighbours count, and what a person has paired. */
typedef struct mt_hint_fonts {
    mt_font *const *list;
    int step;
    const mt_given_pairs *pairs;
    const mt_hint_glyphs *named; /* of the lines by name */
} mt_hint_fonts;

/* ---- the grid ------------------------------------------------------------------------------------------ */

/* From 16.16 font units; halves up, as outlines are rounded. */
static int64_t to_grid(int32_t value, int units) {
    int64_t over = (int64_t)value * MT_EM * 2 + (int64_t)units * 65536, under = (int64_t)units * 65536 * 2;
    return over / under - (over % under < 0);
}

static bool scale(mt_hint_place place, const mt_font *font, mt_point *point) {
    int64_t x = to_grid(place.x, mt_font_units_per_em(font)),
            y = to_grid(place.y, mt_font_units_per_em(font));
    if (x < -MT_COORD_MAX || x > MT_COORD_MAX || y < -MT_COORD_MAX || y > MT_COORD_MAX) return false;
    *point = (mt_point){(int32_t)x, (int32_t)y};
    return true;
}

/* ---- the index ----------------------------------------------------------------------------------------- */

static mt_status bad(int line, const char *reason, mt_hint_error *error) {
    if (error) *error = (mt_hint_error){line, reason};
    return MT_BAD_HINTS;
}

/* Both fonts' glyphs for a line; false where they have not both. */
static bool find_glyphs(const mt_hint_fonts *fonts, const mt_hint_table *table, int i, mt_hint_key *key) {
    const mt_hint_line *line = &table->lines[i];
    if (line->name) {
        const mt_hint_glyphs *glyphs = &fonts->named[i - table->character_count];
        key->a = glyphs->a;
        key->b = glyphs->b;
        return glyphs->paired;
    }
    key->a = mt_given_glyph(fonts->pairs, fonts->list, fonts->step, line->code_point);
    key->b = mt_given_glyph(fonts->pairs, fonts->list, fonts->step + 1, line->code_point);
    return key->a && key->b;
}

/* Fills keys[] with the hints for glyphs that both fonts have. */
static mt_status gather(const mt_hint_fonts *fonts, const mt_hint_table *table, mt_hint_index *index,
                        mt_hint_error *error) {
    const mt_font *a = fonts->list[fonts->step], *b = fonts->list[fonts->step + 1];
    for (int i = 0; i < table->count; i++) {
        const mt_hint_line *line = &table->lines[i];
        mt_hint_key key = {.line = line->line, .hint.kind = line->kind};
        if (!find_glyphs(fonts, table, i, &key)) continue;
        if (!scale(line->a, a, &key.hint.a)) return bad(line->line, "over 32 em in the first font", error);
        if (!scale(line->b, b, &key.hint.b)) return bad(line->line, "over 32 em in the second font", error);
        index->keys[index->count++] = key;
    }
    return MT_OK;
}

static int by_glyphs(const void *p, const void *q) {
    const mt_hint_key *x = p, *y = q;
    if (x->a != y->a) return x->a < y->a ? -1 : 1;
    if (x->b != y->b) return x->b < y->b ? -1 : 1;
    return (x->line > y->line) - (x->line < y->line);
}

static bool are_for_the_same(const mt_hint_key *x, const mt_hint_key *y) {
    return x->a == y->a && x->b == y->b;
}

static mt_status fill(const mt_hint_fonts *fonts, const mt_hint_table *table, mt_hint_index *index,
                      mt_hint_error *error) {
    mt_status status = gather(fonts, table, index, error);
    if (status != MT_OK) return status;
    if (index->count > 0) qsort(index->keys, (size_t)index->count, sizeof *index->keys, by_glyphs);
    for (int i = 0; i < index->count; i++) {
        const mt_hint_key *key = &index->keys[i];
        if (i >= MT_GLYPH_HINTS_MAX && are_for_the_same(key, key - MT_GLYPH_HINTS_MAX))
            return bad(key->line, "too many hints for one glyph", error);
        index->hints[i] = key->hint;
    }
    return MT_OK;
}

mt_status mt_hint_index_new(const mt_hint_table *table, const mt_hint_glyphs *named, mt_font *const *fonts,
                            int step, const mt_given_pairs *pairs, mt_hint_index **index,
                            mt_hint_error *error) {
    const mt_hint_fonts between = {fonts, step, pairs, named};
    size_t count = (size_t)table->count;
    mt_hint_index *made = mt_new(1, sizeof *made);
    if (made) made->keys = mt_new(count, sizeof *made->keys);
    if (made) made->hints = mt_new(count, sizeof *made->hints);
    bool had = made && made->keys && made->hints;
    mt_status status = had ? fill(&between, table, made, error) : MT_NO_MEMORY;
    if (status == MT_OK)
        *index = made;
    else
        mt_hint_index_free(made);
    return status;
}

void mt_hint_index_free(mt_hint_index *index) {
    if (!index) return;
    mt_free(index->keys);
    mt_free(index->hints);
    mt_free(index);
}

mt_hints mt_hint_index_find(const mt_hint_index *index, uint32_t a, uint32_t b) {
    const mt_hint_key key = {.a = a, .b = b, .line = -1};
    int first = 0, end = index ? index->count : 0, count = 0;
    while (first < end) {
        int middle = first + (end - first) / 2;
        if (by_glyphs(&index->keys[middle], &key) < 0)
            first = middle + 1;
        else
            end = middle;
    }
    while (index && first + count < index->count && are_for_the_same(&index->keys[first + count], &key))
        count++;
    return count ? (mt_hints){count, index->hints + first} : (mt_hints){0, NULL};
}

int mt_hint_index_line(const mt_hint_index *index, const mt_hint *hint) {
    return index->keys[hint - index->hints].line;
}
