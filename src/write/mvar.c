/* Font-wide figures along the axis (OpenType spec, "MVAR"). */
#include <math.h>

#include "layout/lookup_builder.h"
#include "sfnt/sfnt.h"
#include "sfnt/var_store.h"
#include "write/varying.h"

void mt_varying_caret(mt_metrics *stops, int stop_count) {
    double rise = 0;
    for (int i = 0; i < stop_count; i++) rise = fmax(rise, stops[i].caret_rise);
    for (int i = 0; i < stop_count; i++) stops[i].caret_rise = rise;
}

void mt_varying_lines(mt_metrics *stops, int stop_count) {
    for (int i = 0; i < stop_count; i++) {
        mt_metrics *stop = &stops[i];
        bool typo = stop->use_typo_metrics;
        stop->typo_ascender = stop->hhea_ascender = typo ? stop->typo_ascender : stop->hhea_ascender;
        stop->typo_descender = stop->hhea_descender = typo ? stop->typo_descender : stop->hhea_descender;
        stop->typo_line_gap = stop->hhea_line_gap = typo ? stop->typo_line_gap : stop->hhea_line_gap;
        stop->use_typo_metrics = true;
    }
}

/* ---- the figures --------------------------------------------------------------------------------------- */

typedef struct mt_figure {
    uint32_t tag;
    size_t place;     /* in mt_metrics */
    bool is_unsigned; /* its field has no sign */
    bool vertical;    /* it is of vhea */
} mt_figure;

/* By tag. */
static const mt_figure figures[] = {
    {MT_TAG('c', 'p', 'h', 't'), offsetof(mt_metrics, cap_height), false, false},
    {MT_TAG('h', 'a', 's', 'c'), offsetof(mt_metrics, typo_ascender), false, false},
    {MT_TAG('h', 'c', 'l', 'a'), offsetof(mt_metrics, win_ascent), true, false},
    {MT_TAG('h', 'c', 'l', 'd'), offsetof(mt_metrics, win_descent), true, false},
    {MT_TAG('h', 'c', 'o', 'f'), offsetof(mt_metrics, caret_offset), false, false},
    {MT_TAG('h', 'c', 'r', 'n'), offsetof(mt_metrics, caret_run), false, false},
    {MT_TAG('h', 'c', 'r', 's'), offsetof(mt_metrics, caret_rise), false, false},
    {MT_TAG('h', 'd', 's', 'c'), offsetof(mt_metrics, typo_descender), false, false},
    {MT_TAG('h', 'l', 'g', 'p'), offsetof(mt_metrics, typo_line_gap), false, false},
    {MT_TAG('s', 'b', 'x', 'o'), offsetof(mt_metrics, subscript_offset[0]), false, false},
    {MT_TAG('s', 'b', 'x', 's'), offsetof(mt_metrics, subscript_size[0]), false, false},
    {MT_TAG('s', 'b', 'y', 'o'), offsetof(mt_metrics, subscript_offset[1]), false, false},
    {MT_TAG('s', 'b', 'y', 's'), offsetof(mt_metrics, subscript_size[1]), false, false},
    {MT_TAG('s', 'p', 'x', 'o'), offsetof(mt_metrics, superscript_offset[0]), false, false},
    {MT_TAG('s', 'p', 'x', 's'), offsetof(mt_metrics, superscript_size[0]), false, false},
    {MT_TAG('s', 'p', 'y', 'o'), offsetof(mt_metrics, superscript_offset[1]), false, false},
    {MT_TAG('s', 'p', 'y', 's'), offsetof(mt_metrics, superscript_size[1]), false, false},
    {MT_TAG('s', 't', 'r', 'o'), offsetof(mt_metrics, strikeout_position), false, false},
    {MT_TAG('s', 't', 'r', 's'), offsetof(mt_metrics, strikeout_size), false, false},
    {MT_TAG('u', 'n', 'd', 'o'), offsetof(mt_metrics, underline_position), false, false},
    {MT_TAG('u', 'n', 'd', 's'), offsetof(mt_metrics, underline_thickness), false, false},
    {MT_TAG('v', 'a', 's', 'c'), offsetof(mt_metrics, vhea_ascender), false, true},
    {MT_TAG('v', 'd', 's', 'c'), offsetof(mt_metrics, vhea_descender), false, true},
    {MT_TAG('v', 'l', 'g', 'p'), offsetof(mt_metrics, vhea_line_gap), false, true},
    {MT_TAG('x', 'h', 'g', 't'), offsetof(mt_metrics, x_height), false, false},
};

enum { FIGURE_COUNT = sizeof figures / sizeof *figures };

/* As the field has it. */
static int32_t figure_of(const mt_metrics *metrics, const mt_figure *figure) {
    const double *value = (const double *)((const char *)metrics + figure->place);
    double low = figure->is_unsigned ? 0 : INT16_MIN, high = figure->is_unsigned ? UINT16_MAX : INT16_MAX;
    return isnan(*value) ? 0 : (int32_t)fmin(fmax(floor(*value + 0.5), low), high);
}

/* ---- the table ----------------------------------------------------------------------------------------- */

/* Writes a record of each figure that varies, and counts them. */
static mt_status write_records(const mt_metrics *metrics, mt_var_store *store, mt_table *records,
                               int *count) {
    *count = 0;
    for (int i = 0; i < FIGURE_COUNT; i++) {
        int32_t values[MT_STOPS_MAX];
        uint32_t index;
        if (figures[i].vertical && !metrics[0].vertical) continue;
        for (int k = 0; k < store->stops.count; k++) values[k] = figure_of(&metrics[k], &figures[i]);
        mt_status status = mt_var_store_add(store, values, &index);
        if (status != MT_OK) return status;
        if (index == MT_NO_VARIATION) continue;
        mt_table_32(records, figures[i].tag);
        mt_table_32(records, index);
        ++*count;
    }
    return MT_OK;
}

static mt_status write_table(const mt_var_store *store, const mt_table *records, int count, mt_table *table) {
    enum { HEADER = 12, RECORD = 8 };
    mt_table_32(table, 0x00010000);
    mt_table_16(table, 0); /* reserved */
    mt_table_16(table, RECORD);
    mt_table_16(table, count);
    mt_table_16(table, HEADER + RECORD * count);
    mt_table_bytes(table, records->bytes, records->length);
    table->failed |= records->failed;
    return mt_var_store_write(store, table);
}

mt_status mt_mvar_write(const mt_metrics *metrics, const mt_stops *stops, mt_arena *arena, mt_bytes *mvar) {
    mt_var_store store = mt_var_store_make(stops);
    mt_table records = {0}, table = {0};
    mt_bytes made = {0};
    int count;
    mt_status status = write_records(metrics, &store, &records, &count);
    if (status == MT_OK && count) status = write_table(&store, &records, count, &table);
    if (status == MT_OK && count) status = mt_table_keep(&table, arena, &made);
    mt_table_free(&records);
    mt_table_free(&table);
    mt_var_store_free(&store);
    if (status == MT_OK) *mvar = made;
    return status;
}
