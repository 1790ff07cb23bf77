#include "math/table/math_table.h"

#include <stdlib.h>

/* All lists are ascending by the glyph that their items begin with. */
static int by_glyph(const void *key, const void *item) {
    uint32_t glyph = *(const uint32_t *)key, other = *(const uint16_t *)item;
    return (glyph > other) - (glyph < other);
}

static const void *find(const void *list, int count, size_t size, uint32_t glyph) {
    return count ? bsearch(&glyph, list, (size_t)count, size, by_glyph) : NULL;
}

const mt_math_value *mt_math_value_find(const mt_math_values *values, uint32_t glyph) {
    return find(values->list, values->count, sizeof *values->list, glyph);
}

const mt_math_glyph_kerns *mt_math_kerns_find(const mt_math_kerns *kerns, uint32_t glyph) {
    return find(kerns->list, kerns->count, sizeof *kerns->list, glyph);
}

const mt_math_construction *mt_math_construction_find(const mt_math_constructions *constructions,
                                                      uint32_t glyph) {
    return find(constructions->list, constructions->count, sizeof *constructions->list, glyph);
}

bool mt_math_same_assembly(const mt_math_construction *one, const mt_math_construction *other) {
    if (!one->has_assembly || !other->has_assembly || one->part_count != other->part_count) return false;
    for (int i = 0; i < one->part_count; i++)
        if ((one->parts[i].flags & 1) != (other->parts[i].flags & 1)) return false;
    return true;
}
