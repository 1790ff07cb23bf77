#include "glyphset/match.h"

#include <stdlib.h>
#include <string.h>

#include "source/glyph_names.h"

typedef struct mt_named {
    const char *name;
    uint32_t glyph;
} mt_named;

/* Of glyphs that share a name, which is against the rules, the first counts. */
static int by_name(const void *p, const void *q) {
    const mt_named *x = p, *y = q;
    int order = strcmp(x->name, y->name);
    return order ? order : (x->glyph > y->glyph) - (x->glyph < y->glyph);
}

/* The names of B's free glyphs, in order; gives how many. */
static int list_free(const mt_glyph_match *match, const char *const *names, mt_named *list) {
    int count = 0;
    for (int i = 0; i < match->count_b; i++)
        if (names[i] && !match->taken[i]) list[count++] = (mt_named){names[i], (uint32_t)i};
    if (count) qsort(list, (size_t)count, sizeof *list, by_name);
    return count;
}

static const mt_named *find(const mt_named *list, int count, const char *name) {
    int low = 0, high = count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (strcmp(list[middle].name, name) < 0)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && strcmp(list[low].name, name) == 0 ? &list[low] : NULL;
}

mt_status mt_match_names(mt_glyph_match *match, mt_font *a, mt_font *b, mt_arena *arena) {
    const char **names_a, **names_b;
    mt_status status = mt_font_glyph_names(a, arena, &names_a);
    if (status == MT_OK) status = mt_font_glyph_names(b, arena, &names_b);
    if (status != MT_OK || !names_a || !names_b) return status;
    mt_named *list = mt_arena_new(arena, (size_t)match->count_b + 1, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    int count = list_free(match, names_b, list);
    for (int i = 0; i < match->count_a; i++) {
        const mt_named *found = names_a[i] ? find(list, count, names_a[i]) : NULL;
        if (found && !match->taken[found->glyph]) mt_match_form(match, (uint32_t)i, found->glyph, 0);
    }
    return MT_OK;
}
