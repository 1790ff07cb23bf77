/* Marks on bases, on parts of ligatures and on marks, and cursive lines, of GPOS. */
#include "anchors/read.h"
#include "fea/writer.h"
#include "layout/value.h"

static void put_anchor(mt_fea_writer *writer, mt_buffer *to, bool has, mt_anchor_point at) {
    if (has)
        mt_fea_print(writer, to, "<anchor %d %d>", mt_value_rounded(at.x), mt_value_rounded(at.y));
    else
        mt_fea_put(writer, to, "<anchor NULL>");
}

/* ---- cursive ------------------------------------------------------------------------------------------- */

static void put_cursive(mt_fea_writer *writer, mt_bytes table, mt_covered covered) {
    mt_fea_put(writer, &writer->lookups, "  pos cursive ");
    mt_fea_glyph(writer, &writer->lookups, covered.glyph);
    for (int side = 0; side < 2; side++) {
        mt_anchor_point at = {0};
        bool has = mt_cursive_anchor(table, covered.index, side, &writer->deltas, &at);
        mt_fea_put(writer, &writer->lookups, " ");
        put_anchor(writer, &writer->lookups, has, at);
    }
    mt_fea_put(writer, &writer->lookups, ";\n");
}

void mt_fea_cursives(mt_fea_writer *writer, const mt_lookup *lookup) {
    mt_fea_each_glyph(writer, lookup, mt_cursive_coverage, put_cursive);
}

/* ---- marks --------------------------------------------------------------------------------------------- */

/* A subtable, and what its classes are called by. */
typedef struct mt_told_attachment {
    mt_attachment_table table;
    int number, subtable;
} mt_told_attachment;

static void put_class(mt_fea_writer *writer, mt_buffer *to, const mt_told_attachment *told, int class) {
    mt_fea_print(writer, to, "@m%d_%d_%d", told->number, told->subtable, class);
}

/* Tells which classes have a mark, and defines these. */
static void list_marks(mt_fea_writer *writer, const mt_told_attachment *told, bool defines, bool *has) {
    mt_covered *covered;
    int count, class;
    mt_anchor_point at;
    mt_buffer *to = &writer->classes;
    writer->status = mt_coverage_list(told->table.mark_coverage, writer->arena, &covered, &count);
    for (int i = 0; i < count && writer->status == MT_OK && mt_fea_spend(writer, 1); i++) {
        if (covered[i].glyph >= writer->source->glyph_count) continue;
        if (!mt_attachment_mark(&told->table, covered[i].index, &writer->deltas, &class, &at)) continue;
        has[class] = true;
        if (!defines) continue;
        mt_fea_put(writer, to, "markClass ");
        mt_fea_glyph(writer, to, covered[i].glyph);
        mt_fea_put(writer, to, " ");
        put_anchor(writer, to, true, at);
        mt_fea_put(writer, to, " ");
        put_class(writer, to, told, class);
        mt_fea_put(writer, to, ";\n");
    }
}

/* The anchors of one component; "<anchor NULL>" where a ligature's has none. */
static bool put_component(mt_fea_writer *writer, const mt_told_attachment *told, int index, int component,
                          const bool *has) {
    bool any = false;
    mt_anchor_point at;
    for (int class = 0; class < told->table.class_count; class ++) {
        if (!has[class] || !mt_fea_spend(writer, 1)) continue;
        if (!mt_attachment_base(&told->table, index, component, class, &writer->deltas, &at)) continue;
        mt_fea_put(writer, &writer->lookups, " ");
        put_anchor(writer, &writer->lookups, true, at);
        mt_fea_put(writer, &writer->lookups, " mark ");
        put_class(writer, &writer->lookups, told, class);
        any = true;
    }
    if (!any) mt_fea_put(writer, &writer->lookups, " <anchor NULL>");
    return any;
}

static void put_base(mt_fea_writer *writer, const mt_told_attachment *told, mt_covered covered,
                     const bool *has) {
    static const char *const words[] = {"base", "ligature", "mark"};
    size_t start = writer->lookups.length;
    int components = mt_attachment_components(&told->table, covered.index);
    bool any = false;
    mt_fea_print(writer, &writer->lookups, "  pos %s ", words[told->table.type - MT_MARK_TO_BASE]);
    mt_fea_glyph(writer, &writer->lookups, covered.glyph);
    for (int i = 0; i < components; i++) {
        if (i) mt_fea_put(writer, &writer->lookups, " ligComponent");
        any = put_component(writer, told, covered.index, i, has) || any;
    }
    mt_fea_put(writer, &writer->lookups, ";\n");
    if (!any) writer->lookups.length = start;
}

void mt_fea_attachments(mt_fea_writer *writer, const mt_lookup *lookup, int number, int subtable,
                        bool defines) {
    mt_covered *bases;
    int count;
    mt_told_attachment told = {.number = number, .subtable = subtable};
    if (!mt_attachment_open(mt_lookup_subtable(lookup, subtable), lookup->type, &told.table)) return;
    bool *has = mt_fea_new(writer, (size_t)told.table.class_count, sizeof *has);
    if (!has) return;
    list_marks(writer, &told, defines, has);
    if (writer->status == MT_OK)
        writer->status = mt_coverage_list(told.table.base_coverage, writer->arena, &bases, &count);
    for (int i = 0; writer->status == MT_OK && i < count && mt_fea_spend(writer, 1); i++)
        if (bases[i].glyph < writer->source->glyph_count) put_base(writer, &told, bases[i], has);
}
