/* Anchors as a font has them (OpenType spec, "GPOS": lookup types 3 to 6). The mark attachment subtables are
 * alike: marks with a class and an anchor each, and for each base, component of a ligature, or mark that
 * bears marks, an anchor for each class. All three are bases here. */
#pragma once

#include "layout/gdef_deltas.h"
#include "layout/ot.h"
#include "sfnt/sfnt.h"

enum {
    MT_CURSIVE = 3,
    MT_MARK_TO_BASE = 4,
    MT_MARK_TO_LIGATURE = 5,
    MT_MARK_TO_MARK = 6,
};

/* Font units; a variable font's deltas are added. */
typedef struct mt_anchor_point {
    double x, y;
} mt_anchor_point;

/* Types 4, 5 and 6. */
typedef struct mt_attachment_table {
    int type, class_count;
    mt_bytes mark_coverage, base_coverage, marks, bases;
} mt_attachment_table;

/* False for a subtable that is of no format known or lacks a part. */
bool mt_attachment_open(mt_bytes subtable, int type, mt_attachment_table *table);

/* The class and the anchor of the mark at a place of the mark coverage; false when it has none. */
bool mt_attachment_mark(const mt_attachment_table *table, int index, const mt_gdef_deltas *variations,
                        int *mark_class, mt_anchor_point *point);

/* How many components the base at a place of the base coverage has; 1 for what is no ligature, 0 for an index
 * that is out of range. */
int mt_attachment_components(const mt_attachment_table *table, int index);

/* The anchor of a base's component for a class; false when it has none. */
bool mt_attachment_base(const mt_attachment_table *table, int index, int component, int mark_class,
                        const mt_gdef_deltas *variations, mt_anchor_point *point);

/* Type 3: the coverage of a subtable, empty when it is of no format known, and the anchor at a place of the
 * coverage where the line enters the glyph (side 0) or leaves it (side 1); false when it has none. */
mt_bytes mt_cursive_coverage(mt_bytes subtable);
bool mt_cursive_anchor(mt_bytes subtable, int index, int side, const mt_gdef_deltas *variations,
                       mt_anchor_point *point);
