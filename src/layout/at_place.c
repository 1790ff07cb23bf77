/* GSUB or GPOS as it is at one place on the axes (OpenType spec, "FeatureVariations table"). The new table is a header, a list
 * of features, and behind them the old table, whose scripts and lookups the header leads to. */
#include "layout/at_place.h"

#include "layout/lookup_builder.h"
#include "layout/ot.h"

enum { HEADER = 10 };

/* ---- the features that hold ---------------------------------------------------------------------------- */

/* 'fvar' coordinates in conditions have 14 bits after the point. */
static bool holds(mt_bytes condition, const int32_t *place, int axis_count) {
    unsigned axis = mt_ot_u16(condition, 2);
    if (mt_ot_u16(condition, 0) != 1 || axis >= (unsigned)axis_count) return false;
    int32_t at = (place[axis] + 2) >> 2;
    return at >= mt_ot_i16(condition, 4) && at <= mt_ot_i16(condition, 6);
}

static bool all_hold(mt_bytes set, const int32_t *place, int axis_count) {
    unsigned wanted = mt_ot_u16(set, 0);
    int count = mt_ot_fit(set, 2, wanted, 4);
    for (int i = 0; i < count; i++)
        if (!holds(mt_ot_follow32(set, 2 + 4 * (size_t)i), place, axis_count)) return false;
    return count == (int)wanted;
}

/* The FeatureTableSubstitution of the first set of conditions that holds; empty when none does. */
static mt_bytes find_alternates(mt_bytes table, const int32_t *place, int axis_count) {
    bool varies = mt_ot_u16(table, 2) >= 1 && axis_count > 0;
    mt_bytes variations = varies ? mt_ot_follow32(table, HEADER) : (mt_bytes){0};
    uint32_t all = mt_ot_u32(variations, 4);
    int count = mt_ot_fit(variations, 8, all < 65536 ? all : 65536, 8);
    for (int i = 0; i < count; i++) {
        size_t at = 8 + 8 * (size_t)i;
        bool always = mt_ot_u32(variations, at) == 0; /* a set of no conditions */
        if (always || all_hold(mt_ot_follow32(variations, at), place, axis_count))
            return mt_ot_follow32(variations, at + 4);
    }
    return (mt_bytes){0};
}

static mt_bytes find_feature(mt_bytes features, mt_bytes alternates, int index) {
    int count = mt_ot_fit(alternates, 6, mt_ot_u16(alternates, 4), 6);
    for (int i = 0; i < count; i++) {
        size_t at = 6 + 6 * (size_t)i;
        if ((int)mt_ot_u16(alternates, at) == index) return mt_ot_follow32(alternates, at + 2);
    }
    return mt_ot_follow(features, 6 + 6 * (size_t)index);
}

/* ---- the table ----------------------------------------------------------------------------------------- */

/* Without parameters (offset 0). */
static void write_feature(mt_table *table, mt_bytes feature) {
    int count = mt_ot_fit(feature, 4, mt_ot_u16(feature, 2), 2);
    mt_table_16(table, 0);
    mt_table_16(table, count);
    for (int i = 0; i < count; i++) mt_table_16(table, (int)mt_ot_u16(feature, 4 + 2 * (size_t)i));
}

/* False when its offsets are too large. */
static bool write_features(mt_table *list, mt_bytes features, mt_bytes alternates) {
    int count = mt_ot_fit(features, 2, mt_ot_u16(features, 0), 6);
    mt_table bodies = {0};
    size_t start = 2 + 6 * (size_t)count, end = start;
    mt_table_16(list, count);
    for (int i = 0; i < count && end <= UINT16_MAX && !bodies.failed; i++) {
        mt_table_32(list, mt_ot_u32(features, 2 + 6 * (size_t)i));
        mt_table_16(list, (int)end);
        write_feature(&bodies, find_feature(features, alternates, i));
        end = start + bodies.length;
    }
    mt_table_bytes(list, bodies.bytes, bodies.length);
    list->failed |= bodies.failed;
    mt_table_free(&bodies);
    return end <= UINT16_MAX;
}

mt_status mt_layout_place(mt_bytes table, const int32_t *place, int axis_count, mt_arena *arena,
                          mt_bytes *placed) {
    mt_table list = {0}, made = {0};
    size_t scripts = mt_ot_u16(table, 4), lookups = mt_ot_u16(table, 8);
    *placed = (mt_bytes){0};
    if (mt_ot_u16(table, 0) != 1 || !scripts || !lookups) return MT_OK;
    mt_bytes features = mt_ot_follow(table, 6);
    bool fits = write_features(&list, features, find_alternates(table, place, axis_count));
    size_t before = HEADER + list.length;
    mt_table_32(&made, 0x00010000);
    mt_table_16(&made, (int)(before + scripts));
    mt_table_16(&made, HEADER);
    mt_table_16(&made, (int)(before + lookups));
    mt_table_bytes(&made, list.bytes, list.length);
    mt_table_bytes(&made, table.bytes, table.length);
    made.failed |= list.failed;
    mt_table_free(&list);
    fits = fits && before + scripts <= UINT16_MAX && before + lookups <= UINT16_MAX;
    if (fits || made.failed) return mt_table_keep(&made, arena, placed);
    mt_table_free(&made);
    return MT_OK;
}
