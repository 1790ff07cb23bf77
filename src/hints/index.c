#include "hints/index.h"

#include <stdlib.h>

#include "base/memory.h"
#include "geometry/limits.h"

/* One hint, until hints[] has it. */
typedef struct mt_index_entry {
    uint32_t a, b;
    int line;
    mt_hint hint;
} mt_index_entry;

/* A pair of glyphs that has hints: hints[first] … hints[first + count - 1]. */
typedef struct mt_hinted {
    uint32_t a, b;
    int first, count;
} mt_hinted;

struct mt_hint_index {
    int count;
    mt_hinted *pairs; /* by a, then b */
    mt_hint *hints;
};

/* ---- the grid ------------------------------------------------------------------------------------------ */

/* From 16.16 font units; halves up, as outlines are rounded. */
static int64_t to_grid(int32_t value, int units) {
    int64_t over = (int64_t)value * MT_EM * 2 + (int64_t)units * 65536, under = (int64_t)units * 65536 * 2;
    return over / under - (over % under < 0);
}

static bool scale(mt_hint_place place, const mt_font *font, mt_point *point) {
    int64_t x = to_grid(place.x, mt_font_units(font)), y = to_grid(place.y, mt_font_units(font));
    if (x < -MT_COORD_MAX || x > MT_COORD_MAX || y < -MT_COORD_MAX || y > MT_COORD_MAX) return false;
    *point = (mt_point){(int32_t)x, (int32_t)y};
    return true;
}

/* ---- the index ----------------------------------------------------------------------------------------- */

static mt_status bad(int line, const char *reason, mt_hint_error *error) {
    if (error) *error = (mt_hint_error){line, reason};
    return MT_BAD_HINTS;
}

/* Fills entries[] with the hints for characters that both fonts have. */
static mt_status gather(const mt_hint_table *table, const mt_font *a, const mt_font *b,
                        mt_index_entry *entries, int *count, mt_hint_error *error) {
    *count = 0;
    for (int i = 0; i < table->count; i++) {
        const mt_hint_line *line = &table->lines[i];
        mt_index_entry entry = {.line = line->line, .hint.kind = line->kind};
        entry.a = mt_font_glyph(a, line->code_point);
        entry.b = mt_font_glyph(b, line->code_point);
        if (entry.a == 0 || entry.b == 0) continue;
        if (!scale(line->a, a, &entry.hint.a)) return bad(line->line, "over 32 em in the first font", error);
        if (!scale(line->b, b, &entry.hint.b)) return bad(line->line, "over 32 em in the second font", error);
        entries[(*count)++] = entry;
    }
    return MT_OK;
}

static int by_glyphs(const void *a, const void *b) {
    const mt_index_entry *x = a, *y = b;
    if (x->a != y->a) return x->a < y->a ? -1 : 1;
    if (x->b != y->b) return x->b < y->b ? -1 : 1;
    return (x->line > y->line) - (x->line < y->line);
}

/* Lays sorted entries out by pairs. */
static mt_status group(const mt_index_entry *entries, int count, mt_hint_index *index, mt_hint_error *error) {
    mt_hinted *pair = NULL;
    for (int i = 0; i < count; i++) {
        const mt_index_entry *entry = &entries[i];
        if (!pair || pair->a != entry->a || pair->b != entry->b) {
            pair = &index->pairs[index->count++];
            *pair = (mt_hinted){.a = entry->a, .b = entry->b, .first = i};
        }
        if (pair->count == MT_GLYPH_HINTS_MAX) return bad(entry->line, "too many hints for one glyph", error);
        index->hints[i] = entry->hint;
        pair->count++;
    }
    return MT_OK;
}

static mt_status fill(const mt_hint_table *table, const mt_font *a, const mt_font *b, mt_index_entry *entries,
                      mt_hint_index *index, mt_hint_error *error) {
    int count;
    mt_status status = gather(table, a, b, entries, &count, error);
    if (status != MT_OK) return status;
    if (count > 0) qsort(entries, (size_t)count, sizeof *entries, by_glyphs);
    return group(entries, count, index, error);
}

mt_status mt_hint_index_new(const mt_hint_table *table, const mt_font *a, const mt_font *b,
                            mt_hint_index **index, mt_hint_error *error) {
    size_t count = (size_t)table->count;
    mt_hint_index *made = mt_new(1, sizeof *made);
    mt_index_entry *entries = mt_new(count, sizeof *entries);
    if (made) made->pairs = mt_new(count, sizeof *made->pairs);
    if (made) made->hints = mt_new(count, sizeof *made->hints);
    bool had = made && entries && made->pairs && made->hints;
    mt_status status = had ? fill(table, a, b, entries, made, error) : MT_NO_MEMORY;
    mt_free(entries);
    if (status == MT_OK)
        *index = made;
    else
        mt_hint_index_free(made);
    return status;
}

void mt_hint_index_free(mt_hint_index *index) {
    if (!index) return;
    mt_free(index->pairs);
    mt_free(index->hints);
    mt_free(index);
}

static int at_glyphs(const void *key, const void *pair) {
    const mt_hinted *x = key, *y = pair;
    if (x->a != y->a) return x->a < y->a ? -1 : 1;
    return (x->b > y->b) - (x->b < y->b);
}

mt_hints mt_hint_index_find(const mt_hint_index *index, uint32_t a, uint32_t b) {
    if (!index) return (mt_hints){0, NULL};
    mt_hinted key = {.a = a, .b = b};
    const mt_hinted *found =
        bsearch(&key, index->pairs, (size_t)index->count, sizeof *index->pairs, at_glyphs);
    return found ? (mt_hints){found->count, index->hints + found->first} : (mt_hints){0, NULL};
}
