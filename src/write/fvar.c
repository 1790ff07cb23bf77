/* The axis of a variable font: 'fvar', with its named places, 'STAT', where each has the same name, and 'avar', how far the
 * font has got where. */
#include "write/tables.h"

#include "sfnt/axis.h"
#include "sfnt/sfnt.h"

enum { AXIS_RECORD = 20, INSTANCE_RECORD = 8 };

static void write_axis(const mt_axis_data *variation, mt_table *table) {
    mt_table_32(table, variation->tag);
    mt_table_fixed(table, variation->least);
    mt_table_fixed(table, variation->least); /* where the font stands without a setting */
    mt_table_fixed(table, variation->most);
    mt_table_16(table, 0); /* flags: users see the axis */
    mt_table_16(table, MT_NAME_AXIS);
}

void mt_write_fvar(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    enum { AXES_OFFSET = 16 };
    const mt_axis_data *variation = data->variation;
    (void)summary;
    if (!variation) return;
    mt_table_32(table, 0x00010000);
    mt_table_16(table, AXES_OFFSET);
    mt_table_16(table, 2); /* reserved */
    mt_table_16(table, 1); /* axisCount */
    mt_table_16(table, AXIS_RECORD);
    mt_table_16(table, variation->named_count);
    mt_table_16(table, INSTANCE_RECORD);
    write_axis(variation, table);
    for (int i = 0; i < variation->named_count; i++) {
        mt_table_16(table, MT_NAME_PLACES + i);
        mt_table_16(table, 0); /* flags */
        mt_table_fixed(table, variation->named[i].value);
    }
}

void mt_write_stat(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    enum { HEADER = 20, DESIGN_AXIS = 8, AXIS_VALUE = 12, OFFSET = 2 };
    const mt_axis_data *variation = data->variation;
    (void)summary;
    if (!variation) return;
    int count = variation->named_count;
    mt_table_32(table, 0x00010001);
    mt_table_16(table, DESIGN_AXIS);
    mt_table_16(table, 1); /* designAxisCount */
    mt_table_32(table, HEADER);
    mt_table_16(table, count);
    mt_table_32(table, HEADER + DESIGN_AXIS); /* where the offsets of the axis values are */
    mt_table_16(table, MT_NAME_STYLE);        /* elidedFallbackNameID */
    mt_table_32(table, variation->tag);
    mt_table_16(table, MT_NAME_AXIS);
    mt_table_16(table, 0); /* axisOrdering */
    for (int i = 0; i < count; i++) mt_table_16(table, count * OFFSET + i * AXIS_VALUE);
    for (int i = 0; i < count; i++) {
        mt_table_16(table, 1); /* format: a name of one value */
        mt_table_16(table, 0); /* axisIndex */
        mt_table_16(table, 0); /* flags */
        mt_table_16(table, MT_NAME_PLACES + i);
        mt_table_fixed(table, variation->named[i].value);
    }
}

static void write_map_point(mt_map_point point, mt_table *table) {
    mt_table_16(table, mt_axis_place(point.value)); /* fromCoordinate */
    mt_table_16(table, mt_axis_place(point.place)); /* toCoordinate */
}

void mt_write_avar(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    const mt_axis_data *variation = data->variation;
    (void)summary;
    if (!variation || variation->map.count == 0) return;
    mt_table_32(table, 0x00010000);
    mt_table_16(table, 0); /* reserved */
    mt_table_16(table, 1); /* axisCount */
    mt_table_16(table, variation->map.count + 1);
    /* The axis has nothing under 0, yet each map has this. */
    write_map_point((mt_map_point){-MT_AXIS_END, -MT_AXIS_END}, table);
    for (int i = 0; i < variation->map.count; i++) write_map_point(variation->map.points[i], table);
}
