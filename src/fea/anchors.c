/* Attachment as anchors of glyphs: each class of each subtable has a name of its own, whose order is that of the lookups. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "anchors/read.h"
#include "fea/writer.h"
#include "layout/value.h"

enum { BASE_CLASS = 1, LIGATURE_CLASS = 2, MARK_CLASS = 3, IGNORE_LIGATURES = 4 };

static mt_fea_anchor *add(mt_fea_writer *writer, int glyph, mt_anchor_point at) {
    mt_fea *fea = writer->fea;
    if (writer->status != MT_OK || glyph >= writer->source->glyph_count || !mt_fea_spend(writer, 1))
        return NULL;
    mt_fea_anchor *grown = mt_arena_grow_list(writer->arena, fea->anchors, fea->anchor_count,
                                              &writer->anchor_room, sizeof *grown);
    if (!grown) {
        writer->status = MT_NO_MEMORY;
        return NULL;
    }
    fea->anchors = grown;
    mt_fea_anchor *made = &fea->anchors[fea->anchor_count++];
    *made =
        (mt_fea_anchor){.glyph = (uint16_t)glyph, .x = mt_value_rounded(at.x), .y = mt_value_rounded(at.y)};
    return made;
}

/* ---- marks --------------------------------------------------------------------------------------------- */

/* A subtable. */
typedef struct mt_anchored_table {
    mt_attachment_table table;
    int flag;
    int first; /* the number of its class 0 */
    bool *bases;
} mt_anchored_table;

static const char *word_of(const mt_anchored_table *from) {
    return from->table.type == MT_MARK_TO_MARK ? "mkmk" : "mark";
}

static void add_marks(mt_fea_writer *writer, const mt_anchored_table *from) {
    mt_covered *covered;
    int count, class;
    mt_anchor_point at;
    writer->status = mt_coverage_list(from->table.mark_coverage, writer->arena, &covered, &count);
    for (int i = 0; i < count && writer->status == MT_OK; i++) {
        if (!mt_attachment_mark(&from->table, covered[i].index, &writer->deltas, &class, &at)) continue;
        mt_fea_anchor *made = add(writer, covered[i].glyph, at);
        if (made) snprintf(made->name, sizeof made->name, "_%s%03d", word_of(from), from->first + class);
    }
}

/* Of one part of a base: 0 where the base has none, else its number. */
static void add_part(mt_fea_writer *writer, const mt_anchored_table *from, mt_covered base, int component,
                     int part) {
    for (int class = 0; class < from->table.class_count; class ++) {
        mt_anchor_point at;
        if (!mt_attachment_base(&from->table, base.index, component, class, &writer->deltas, &at)) continue;
        mt_fea_anchor *made = add(writer, base.glyph, at);
        if (!made) return;
        int length = snprintf(made->name, sizeof made->name, "%s%03d", word_of(from), from->first + class);
        if (part) snprintf(made->name + length, sizeof made->name - (size_t)length, "_%d", part);
    }
}

/* A ligature that takes marks as one base does so by its first part: marks of any other go there too. */
static void add_base(mt_fea_writer *writer, const mt_anchored_table *from, mt_covered base) {
    unsigned class = mt_class_find(mt_ot_follow(writer->source->gdef, 4), base.glyph);
    bool on_base = from->table.type == MT_MARK_TO_BASE, ligature = class == LIGATURE_CLASS;
    if (on_base && (class == MARK_CLASS || (ligature && (from->flag & IGNORE_LIGATURES)))) return;
    if (base.glyph < writer->source->glyph_count) from->bases[base.glyph] = true;
    int parts = mt_attachment_components(&from->table, base.index);
    for (int i = 0; i < parts; i++) add_part(writer, from, base, i, ligature ? i + 1 : 0);
}

/* The last subtable first: of a lookup's subtables the first decides, of lookups, which these become, the last. */
static void add_attachments(mt_fea_writer *writer, const mt_lookup *lookup, bool *bases, int *number) {
    for (int i = lookup->subtable_count - 1; i >= 0 && writer->status == MT_OK; i--) {
        mt_covered *covered;
        int count;
        mt_anchored_table from = {.flag = lookup->flag, .first = *number, .bases = bases};
        if (!mt_attachment_open(mt_lookup_subtable(lookup, i), lookup->type, &from.table)) continue;
        add_marks(writer, &from);
        if (writer->status == MT_OK)
            writer->status = mt_coverage_list(from.table.base_coverage, writer->arena, &covered, &count);
        for (int k = 0; writer->status == MT_OK && k < count; k++) add_base(writer, &from, covered[k]);
        *number += from.table.class_count;
    }
}

/* ---- cursive ------------------------------------------------------------------------------------------- */

static void add_cursive(mt_fea_writer *writer, mt_bytes table, bool *taken) {
    static const char *const names[] = {"entry", "exit"};
    mt_covered *covered;
    int count;
    writer->status = mt_coverage_list(mt_cursive_coverage(table), writer->arena, &covered, &count);
    for (int i = 0; i < count && writer->status == MT_OK; i++) {
        int glyph = covered[i].glyph;
        if (glyph >= writer->source->glyph_count || taken[glyph]) continue;
        taken[glyph] = true;
        for (int side = 0; side < 2; side++) {
            mt_anchor_point at;
            if (!mt_cursive_anchor(table, covered[i].index, side, &writer->deltas, &at)) continue;
            mt_fea_anchor *made = add(writer, glyph, at);
            if (made) strcpy(made->name, names[side]);
        }
    }
}

static void add_cursives(mt_fea_writer *writer, const mt_lookup *lookup) {
    bool *taken = mt_fea_new(writer, (size_t)writer->source->glyph_count, sizeof *taken);
    for (int i = 0; i < lookup->subtable_count && taken && writer->status == MT_OK; i++)
        add_cursive(writer, mt_lookup_subtable(lookup, i), taken);
}

/* ---- all ----------------------------------------------------------------------------------------------- */

static int compare(const void *a, const void *b) {
    const mt_fea_anchor *p = a, *q = b;
    if (p->glyph != q->glyph) return p->glyph < q->glyph ? -1 : 1;
    return strcmp(p->name, q->name);
}

void mt_fea_anchors(mt_fea_writer *writer, const mt_fea_table *table, bool *bases) {
    int number = 1;
    for (int i = 0; i < table->layout.lookup_count && writer->status == MT_OK; i++) {
        mt_lookup lookup = mt_layout_lookup(&table->layout, i);
        if (table->ways[i] != MT_FEA_ANCHORS || !table->applied[i]) continue;
        if (lookup.type == MT_CURSIVE)
            add_cursives(writer, &lookup);
        else
            add_attachments(writer, &lookup, bases, &number);
    }
    mt_fea *fea = writer->fea;
    if (fea->anchor_count) qsort(fea->anchors, (size_t)fea->anchor_count, sizeof *fea->anchors, compare);
}
