#include "layout/gdef_deltas.h"

/* How far a region's axis reaches at a place, 0 … 1; start, peak and end are 2.14. */
static double axis_scalar(int start, int peak, int end, double at) {
    if (peak == 0 || start > peak || peak > end || (start < 0 && end > 0)) return 1;
    if (at < start || at > end) return 0;
    if (at == peak) return 1;
    return at < peak ? (at - start) / (peak - start) : (end - at) / (end - peak);
}

static double region_scalar(mt_bytes list, int region, const int32_t *place, int axis_count) {
    int axes = (int)mt_ot_u16(list, 0);
    double scalar = 1;
    for (int i = 0; i < axes && scalar != 0; i++) {
        size_t at = 4 + 6 * ((size_t)region * (size_t)axes + (size_t)i);
        double coordinate = i < axis_count ? place[i] / 4.0 : 0; /* 16.16 to 2.14 */
        scalar *=
            axis_scalar(mt_ot_i16(list, at), mt_ot_i16(list, at + 2), mt_ot_i16(list, at + 4), coordinate);
    }
    return scalar;
}

mt_status mt_gdef_deltas_open(mt_bytes gdef, const int32_t *place, int axis_count, mt_arena *arena,
                              mt_gdef_deltas *variations) {
    mt_gdef_deltas made = {0};
    bool has_store = mt_ot_u16(gdef, 0) == 1 && mt_ot_u16(gdef, 2) >= 3;
    if (has_store && axis_count > 0) made.store = mt_ot_follow32(gdef, 14);
    if (mt_ot_u16(made.store, 0) == 1) {
        mt_bytes list = mt_ot_follow32(made.store, 2);
        size_t axes = mt_ot_u16(list, 0);
        made.region_count = mt_ot_fit(list, 4, mt_ot_u16(list, 2), axes ? 6 * axes : 6);
        made.scalars = mt_arena_new(arena, (size_t)made.region_count + 1, sizeof *made.scalars);
        if (!made.scalars) return MT_NO_MEMORY;
        for (int i = 0; i < made.region_count; i++)
            made.scalars[i] = region_scalar(list, i, place, axis_count);
    }
    *variations = made;
    return MT_OK;
}

enum { LONG_WORDS = 0x8000 };

/* A row of deltas: `words` of the first size, the others of the second; 8, 16 or 32 bits. */
static double row_delta(const mt_gdef_deltas *variations, mt_bytes data, size_t row, size_t words,
                        bool wide) {
    double sum = 0;
    size_t regions = mt_ot_u16(data, 4), at = row;
    for (size_t i = 0; i < regions; i++) {
        int size = i < words ? (wide ? 4 : 2) : (wide ? 2 : 1);
        if (!mt_ot_has(data, at, (size_t)size)) return 0;
        int delta = size == 4   ? (int32_t)mt_ot_u32(data, at)
                    : size == 2 ? mt_ot_i16(data, at)
                                : (int8_t)data.bytes[at];
        int region = (int)mt_ot_u16(data, 6 + 2 * i);
        if (region < variations->region_count) sum += variations->scalars[region] * delta;
        at += (size_t)size;
    }
    return sum;
}

double mt_gdef_delta(const mt_gdef_deltas *variations, mt_bytes device) {
    if (!variations->store.length || mt_ot_u16(device, 4) != 0x8000) return 0;
    unsigned outer = mt_ot_u16(device, 0), inner = mt_ot_u16(device, 2);
    if (outer >= mt_ot_u16(variations->store, 6)) return 0;
    mt_bytes data = mt_ot_follow32(variations->store, 8 + 4 * (size_t)outer);
    size_t word_count = mt_ot_u16(data, 2), regions = mt_ot_u16(data, 4);
    bool wide = word_count & LONG_WORDS;
    size_t words = word_count & (LONG_WORDS - 1u);
    if (inner >= mt_ot_u16(data, 0) || words > regions) return 0;
    size_t length = (words + regions) * (wide ? 2 : 1);
    return row_delta(variations, data, 6 + 2 * regions + length * inner, words, wide);
}
