/* The axis of a variable font: 'fvar', with its named places, 'STAT', where each has the same name, or the axis' part of it, and 'avar', how far the
 * font has got where. */
#include "write/tables.h"

#include <math.h>

#include "sfnt/axis.h"
#include "sfnt/sfnt.h"

enum { AXIS_RECORD = 20, INSTANCE_RECORD = 10 };

static void write_axis(const mt_axis *axis, mt_table *table) {
    mt_table_32(table, axis->tag);
    mt_table_fixed(table, fmin(axis->from, axis->to));
    mt_table_fixed(table, axis->home); /* where the font stands without a setting */
    mt_table_fixed(table, fmax(axis->from, axis->to));
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
    write_axis(&variation->axis, table);
    for (int i = 0; i < variation->named_count; i++) {
        mt_table_16(table, MT_NAME_PLACES + i);
        mt_table_16(table, 0); /* flags */
        mt_table_fixed(table, variation->named[i].value);
        mt_table_16(table, MT_NAME_PLACES + variation->named_count + i); /* postScriptNameID */
    }
}

/* ---- STAT ---------------------------------------------------------------------------------------------- */

enum { NAMED_VALUE = 12, LINKED_VALUE = 16 }; /* bytes of an axis value of format 1, and of 3 */

static bool is_linked(const mt_named_place *place) {
    return place->linked > place->value;
}

/* The upright one's link is the italic one. */
static const mt_named_place slopes[] = {
    [MT_SLOPE_UPRIGHT] = {.value = 0, .elided = true, .linked = 1},
    [MT_SLOPE_ITALIC] = {.value = 1, .linked = 1},
};

static void write_value_offsets(const mt_axis_data *variation, mt_table *table) {
    bool sloped = variation->slope != MT_SLOPE_UNTOLD;
    int at = 2 * (variation->named_count + sloped);
    for (int i = 0; i < variation->named_count; i++) {
        mt_table_16(table, at);
        at += is_linked(&variation->named[i]) ? LINKED_VALUE : NAMED_VALUE;
    }
    if (sloped) mt_table_16(table, at);
}

static void write_value(const mt_named_place *place, int axis, int name, mt_table *table) {
    enum { ELIDABLE = 2 };
    mt_table_16(table, is_linked(place)
                           ? 3
                           : 1); /* format: a name of one value, with the linked style's or without */
    mt_table_16(table, axis);
    mt_table_16(table, place->elided ? ELIDABLE : 0);
    mt_table_16(table, name);
    mt_table_fixed(table, place->value);
    if (is_linked(place)) mt_table_fixed(table, place->linked);
}

static void write_design_axis(uint32_t tag, int name, int ordering, mt_table *table) {
    mt_table_32(table, tag);
    mt_table_16(table, name);
    mt_table_16(table, ordering); /* axisOrdering */
}

void mt_write_stat(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    enum { HEADER = 20, DESIGN_AXIS = 8 };
    const mt_axis_data *variation = data->variation;
    (void)summary;
    if (!variation) return;
    mt_table_32(table, 0x00010001);
    mt_table_16(table, DESIGN_AXIS);
    bool sloped = variation->slope != MT_SLOPE_UNTOLD;
    int names = MT_NAME_PLACES, slope_names = mt_name_slope(variation);
    if (variation->slope == MT_SLOPE_ITALIC) names = slope_names + MT_SLOPE_NAMES;
    mt_table_16(table, 1 + sloped); /* designAxisCount */
    mt_table_32(table, HEADER);
    mt_table_16(table, variation->named_count + sloped);
    mt_table_32(table, HEADER + DESIGN_AXIS * (1 + sloped)); /* where the offsets of the axis values are */
    mt_table_16(table, MT_NAME_STYLE);                       /* elidedFallbackNameID */
    write_design_axis(variation->axis.tag, MT_NAME_AXIS, 0, table);
    if (sloped) write_design_axis(MT_TAG('i', 't', 'a', 'l'), slope_names, 1, table);
    write_value_offsets(variation, table);
    for (int i = 0; i < variation->named_count; i++) write_value(&variation->named[i], 0, names + i, table);
    if (sloped) write_value(&slopes[variation->slope], 1, slope_names + 1, table);
}

/* ---- avar ---------------------------------------------------------------------------------------------- */

/* `sign` is -1 on an axis that goes down. */
static void write_map_point(mt_map_point point, int sign, mt_table *table) {
    mt_table_16(table, sign * mt_axis_place(point.value)); /* fromCoordinate */
    mt_table_16(table, sign * mt_axis_place(point.place)); /* toCoordinate */
}

/* The axis has nothing on the other side of 0, yet each map has an end there. */
void mt_write_avar(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    const mt_axis_data *variation = data->variation;
    const mt_map_point end = {MT_AXIS_END, MT_AXIS_END};
    (void)summary;
    if (!variation || variation->map.count == 0) return;
    int count = variation->map.count;
    mt_table_32(table, 0x00010000);
    mt_table_16(table, 0); /* reserved */
    mt_table_16(table, 1); /* axisCount */
    mt_table_16(table, count + 1);
    if (mt_axis_goes_down(&variation->axis)) {
        for (int i = count - 1; i >= 0; i--) write_map_point(variation->map.points[i], -1, table);
        write_map_point(end, 1, table);
    } else {
        write_map_point(end, -1, table);
        for (int i = 0; i < count; i++) write_map_point(variation->map.points[i], 1, table);
    }
}
