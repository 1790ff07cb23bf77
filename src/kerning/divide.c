/* Glyphs by class, then by place: each run of alike ones is a new class. Class 0 is still that of glyphs that no font adjusts, where
 * the font is. */
#include "kerning/divide.h"

#include <stdlib.h>
#include <string.h>

typedef struct mt_classed {
    int of, glyph;
    mt_at at;
} mt_classed;

static int order_of(double p, double q) {
    return (p > q) - (p < q);
}

static int by_class(const void *p, const void *q) {
    const mt_classed *x = p, *y = q;
    int order = x->of - y->of;
    if (!order) order = order_of(x->at.x, y->at.x);
    if (!order) order = order_of(x->at.y, y->at.y);
    return order ? order : x->glyph - y->glyph;
}

static mt_classed *sorted(const mt_pair_classes *classes, int glyph_count, const mt_places *places,
                          mt_arena *arena) {
    mt_classed *list = mt_arena_new(arena, (size_t)glyph_count + 1, sizeof *list);
    for (int i = 0; list && i < glyph_count; i++)
        list[i] = (mt_classed){classes->of[i], i, places->glyphs[i]};
    if (list) qsort(list, (size_t)glyph_count, sizeof *list, by_class);
    return list;
}

static bool is_alike(const mt_classed *p, const mt_classed *q) {
    return p->of == q->of && mt_at_equal(p->at, q->at);
}

/* Other classes without glyphs are left out. */
static mt_status divide(const mt_pairs *pairs, const mt_pair_classes *classes, const mt_places *places,
                        mt_arena *arena, mt_pair_classes *divided, const mt_at **at) {
    size_t fonts = (size_t)pairs->font_count, room = (size_t)pairs->glyph_count + 1;
    const mt_classed *list = sorted(classes, pairs->glyph_count, places, arena);
    mt_at *of_classes = mt_arena_new(arena, room, sizeof *of_classes);
    *divided = (mt_pair_classes){.count = 1,
                                 .in_fonts = mt_arena_new(arena, room * fonts, sizeof(int)),
                                 .of = mt_arena_new(arena, room, sizeof(uint16_t))};
    if (!list || !of_classes || !divided->in_fonts || !divided->of) return MT_NO_MEMORY;
    memcpy(divided->in_fonts, classes->in_fonts, fonts * sizeof(int));
    of_classes[0] = places->at[0];
    for (int i = 0; i < pairs->glyph_count; i++) {
        if (list[i].of == 0 && mt_at_equal(list[i].at, places->at[0])) continue;
        if (i == 0 || !is_alike(&list[i - 1], &list[i])) {
            memcpy(divided->in_fonts + fonts * (size_t)divided->count,
                   classes->in_fonts + fonts * (size_t)list[i].of, fonts * sizeof(int));
            of_classes[divided->count++] = list[i].at;
        }
        divided->of[list[i].glyph] = (uint16_t)(divided->count - 1);
    }
    *at = of_classes;
    return MT_OK;
}

mt_status mt_pairs_divide(const mt_pairs *pairs, const mt_places *places, mt_arena *arena,
                          mt_divided_pairs *divided) {
    mt_divided_pairs made = {.pairs = *pairs};
    mt_status status = MT_OK;
    if (places->glyphs) status = divide(pairs, &pairs->left, places, arena, &made.pairs.left, &made.left);
    if (status == MT_OK && places->glyphs)
        status = divide(pairs, &pairs->right, places, arena, &made.pairs.right, &made.right);
    if (status != MT_OK) return status;
    if (places->glyphs && (int64_t)made.pairs.left.count * made.pairs.right.count > MT_PAIR_CELLS_MAX)
        return MT_TOO_LARGE;
    *divided = made;
    return MT_OK;
}
