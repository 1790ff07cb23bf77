#include "pointing/idle_hints.h"

#include <string.h>

static bool are_same_segments(const mt_segment *p, const mt_segment *q) {
    if (p->degree != q->degree || !mt_point_equal(p->end, q->end)) return false;
    for (int i = 0; i < p->degree - 1; i++)
        if (!mt_point_equal(p->control[i], q->control[i])) return false;
    return true;
}

static bool are_same_contours(const mt_contour *p, const mt_contour *q) {
    if (p->count != q->count) return false;
    for (int i = 0; i < p->count; i++)
        if (!are_same_segments(&p->segments[i], &q->segments[i])) return false;
    return true;
}

static bool are_same_links(const mt_links *p, const mt_links *q) {
    if (p->count != q->count) return false;
    for (int i = 0; i < p->count; i++)
        if (mt_link_compare(&p->links[i], &q->links[i]) != 0) return false;
    return true;
}

/* Whether two morphs of the same glyphs move alike. */
static bool are_same(const mt_morph *p, const mt_morph *q) {
    if (p->contour_count != q->contour_count || !are_same_links(&p->links, &q->links)) return false;
    for (int i = 0; i < p->contour_count; i++) {
        const mt_contour_pair *one = &p->contours[i], *other = &q->contours[i];
        if (!are_same_contours(&one->a, &other->a) || !are_same_contours(&one->b, &other->b) ||
            !mt_point_equal(one->displacement, other->displacement))
            return false;
    }
    return true;
}

/* All hints but the one at `left_out`. */
static mt_hints without(mt_hints hints, int left_out, mt_hint *room) {
    memcpy(room, hints.hints, (size_t)left_out * sizeof *room);
    memcpy(room + left_out, hints.hints + left_out + 1, (size_t)(hints.count - left_out - 1) * sizeof *room);
    return (mt_hints){hints.count - 1, room};
}

mt_status mt_pair_find_idle_hints(mt_row *row, int step, uint32_t a, uint32_t b, const mt_glyph_pair *pair,
                                  mt_arena *arena, bool **idle) {
    mt_hints hints = mt_hint_index_find(row->hints[step], a, b);
    *idle = NULL;
    if (hints.count == 0) return MT_OK;
    bool *found = mt_arena_new(arena, (size_t)hints.count, sizeof *found);
    mt_hint *others = mt_arena_new(arena, (size_t)hints.count, sizeof *others);
    if (!found || !others) return MT_NO_MEMORY;
    mt_arena_place before = mt_arena_mark(arena);
    for (int i = 0; i < hints.count; i++) {
        mt_glyph_pair tried;
        mt_hints rest = without(hints, i, others);
        mt_status status = mt_pair_prepare_by(row, step, a, b, &rest, arena, &tried);
        if (status == MT_NO_MEMORY) return status;
        found[i] = status == MT_OK && are_same(&pair->morph, &tried.morph);
        mt_arena_rewind(arena, before);
    }
    *idle = found;
    return MT_OK;
}
