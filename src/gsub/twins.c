#include "gsub/gsub.h"

#include <string.h>

/* The first substitution whose first input is not before the glyph. */
static int find_first(const mt_gsub_subtable *subtable, int count, unsigned glyph) {
    int low = 0, high = count;
    while (low < high) {
        int middle = low + (high - low) / 2;
        if (subtable->list[middle].glyphs[0] < glyph)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* How many substitutions the twins have; with `list`, they are added there, behind the others. */
static mt_status list_twins(const mt_gsub_subtable *subtable, const mt_twin *twins, int count,
                            mt_arena *arena, mt_substitution *list, int *added) {
    *added = 0;
    for (int i = 0; i < count; i++) {
        int at = find_first(subtable, subtable->count, twins[i].like);
        for (; at < subtable->count && subtable->list[at].glyphs[0] == twins[i].like; at++, ++*added) {
            const mt_substitution *from = &subtable->list[at];
            size_t glyphs = (size_t)from->inputs + from->outputs;
            if (!list) continue;
            uint16_t *copy = mt_arena_new(arena, glyphs, sizeof *copy);
            if (!copy) return MT_NO_MEMORY;
            memcpy(copy, from->glyphs, glyphs * sizeof *copy);
            copy[0] = twins[i].glyph;
            list[subtable->count + *added] = (mt_substitution){copy, from->inputs, from->outputs};
        }
    }
    return MT_OK;
}

static mt_status extend(mt_gsub_subtable *subtable, const mt_twin *twins, int count, mt_arena *arena) {
    int more;
    mt_status status = list_twins(subtable, twins, count, arena, NULL, &more);
    if (status != MT_OK || more == 0) return status;
    mt_substitution *list = mt_arena_new(arena, (size_t)subtable->count + (size_t)more, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    memcpy(list, subtable->list, (size_t)subtable->count * sizeof *list);
    status = list_twins(subtable, twins, count, arena, list, &more);
    subtable->list = list;
    subtable->count += more;
    return status;
}

mt_status mt_gsub_add_twins(mt_gsub *gsub, const mt_twin *twins, int count, mt_arena *arena) {
    mt_status status = MT_OK;
    for (int i = 0; i < gsub->layout.lookup_count; i++) {
        mt_gsub_lookup *lookup = &gsub->lookups[i];
        for (int k = 0; k < lookup->subtable_count && status == MT_OK; k++)
            status = extend(&lookup->subtables[k], twins, count, arena);
    }
    return status;
}
