#include "anchors/read.h"

/* Formats 1, 2 (the number of a contour's point is for hinted outlines: its coordinates are taken) and 3. */
static bool read_anchor(mt_bytes anchor, const mt_gdef_deltas *variations, mt_anchor_point *point) {
    unsigned format = mt_ot_u16(anchor, 0);
    if (format < 1 || format > 3 || !mt_ot_has(anchor, 2, 4)) return false;
    *point = (mt_anchor_point){mt_ot_i16(anchor, 2), mt_ot_i16(anchor, 4)};
    if (format == 3) {
        point->x += mt_gdef_delta(variations, mt_ot_follow(anchor, 6));
        point->y += mt_gdef_delta(variations, mt_ot_follow(anchor, 8));
    }
    return true;
}

/* ---- marks --------------------------------------------------------------------------------------------- */

bool mt_attachment_open(mt_bytes subtable, int type, mt_attachment_table *table) {
    *table = (mt_attachment_table){
        .type = type,
        .class_count = (int)mt_ot_u16(subtable, 6),
        .mark_coverage = mt_ot_follow(subtable, 2),
        .base_coverage = mt_ot_follow(subtable, 4),
        .marks = mt_ot_follow(subtable, 8),
        .bases = mt_ot_follow(subtable, 10),
    };
    return mt_ot_u16(subtable, 0) == 1 && table->mark_coverage.length && table->base_coverage.length &&
           table->marks.length && table->bases.length;
}

bool mt_attachment_mark(const mt_attachment_table *table, int index, const mt_gdef_deltas *variations,
                        int *mark_class, mt_anchor_point *point) {
    if (index < 0 || index >= mt_ot_fit(table->marks, 2, mt_ot_u16(table->marks, 0), 4)) return false;
    size_t at = 2 + 4 * (size_t)index;
    int found = (int)mt_ot_u16(table->marks, at);
    if (found >= table->class_count) return false;
    *mark_class = found;
    return read_anchor(mt_ot_follow(table->marks, at + 2), variations, point);
}

/* ---- bases --------------------------------------------------------------------------------------------- */

/* How many bases lie within the array: rows of anchors, or one offset for each ligature. */
static int base_count(const mt_attachment_table *table) {
    size_t size = table->type == MT_MARK_TO_LIGATURE ? 2 : 2 * (size_t)table->class_count;
    return size ? mt_ot_fit(table->bases, 2, mt_ot_u16(table->bases, 0), size) : 0;
}

static int component_count(const mt_attachment_table *table, mt_bytes ligature) {
    size_t size = 2 * (size_t)table->class_count;
    return size ? mt_ot_fit(ligature, 2, mt_ot_u16(ligature, 0), size) : 0;
}

int mt_attachment_components(const mt_attachment_table *table, int index) {
    if (index < 0 || index >= base_count(table)) return 0;
    if (table->type != MT_MARK_TO_LIGATURE) return 1;
    return component_count(table, mt_ot_follow(table->bases, 2 + 2 * (size_t)index));
}

bool mt_attachment_base(const mt_attachment_table *table, int index, int component, int mark_class,
                        const mt_gdef_deltas *variations, mt_anchor_point *point) {
    if (component < 0 || component >= mt_attachment_components(table, index)) return false;
    if (mark_class < 0 || mark_class >= table->class_count) return false;
    bool ligature = table->type == MT_MARK_TO_LIGATURE;
    mt_bytes rows = ligature ? mt_ot_follow(table->bases, 2 + 2 * (size_t)index) : table->bases;
    size_t row = (size_t)(ligature ? component : index);
    size_t at = 2 + 2 * (row * (size_t)table->class_count + (size_t)mark_class);
    return read_anchor(mt_ot_follow(rows, at), variations, point);
}

/* ---- cursive ------------------------------------------------------------------------------------------- */

mt_bytes mt_cursive_coverage(mt_bytes subtable) {
    return mt_ot_u16(subtable, 0) == 1 ? mt_ot_follow(subtable, 2) : (mt_bytes){0};
}

bool mt_cursive_anchor(mt_bytes subtable, int index, int side, const mt_gdef_deltas *variations,
                       mt_anchor_point *point) {
    if (index < 0 || index >= mt_ot_fit(subtable, 6, mt_ot_u16(subtable, 4), 4)) return false;
    size_t at = 6 + 4 * (size_t)index + 2 * (size_t)side;
    return read_anchor(mt_ot_follow(subtable, at), variations, point);
}
