#include "fea/fea.h"

#include "fea/writer.h"
#include "layout/open.h"
#include "sfnt/axis.h"

/* Steps, and bytes of text: more than the largest fonts need, and little enough to be written. */
#define WORK_MAX ((int64_t)1 << 30)

static void open_table(mt_fea_writer *writer, mt_bytes bytes, int extension, mt_fea_table *table) {
    bool sub = extension == MT_EXTENSION_GSUB;
    *table = (mt_fea_table){.verb = sub ? "sub" : "pos", .prefix = sub ? "gsub" : "gpos"};
    if (writer->status == MT_OK)
        writer->status = mt_layout_open(bytes, extension, writer->arena, &table->layout);
    if (writer->status != MT_OK) return;
    size_t count = (size_t)table->layout.lookup_count;
    table->ways = mt_fea_new(writer, count, sizeof *table->ways);
    table->applied = mt_fea_new(writer, count, sizeof *table->applied);
    table->called = mt_fea_new(writer, count, sizeof *table->called);
    table->parts = mt_fea_new(writer, count, sizeof *table->parts);
    if (writer->status == MT_OK) mt_fea_mark_applied(writer, table);
}

static void write_all(mt_fea_writer *writer) {
    mt_fea_table gsub, gpos;
    bool *bases = mt_fea_new(writer, (size_t)writer->source->glyph_count, sizeof *bases);
    open_table(writer, writer->source->gsub, MT_EXTENSION_GSUB, &gsub);
    open_table(writer, writer->source->gpos, MT_EXTENSION_GPOS, &gpos);
    if (writer->status != MT_OK) return;
    mt_fea_choose_ways(writer, &gpos);
    mt_fea_systems(writer, &gpos.layout);
    mt_fea_anchors(writer, &gpos, bases);
    mt_fea_gdef(writer, bases);
    mt_fea_lookups(writer, &gsub);
    mt_fea_lookups(writer, &gpos);
    mt_fea_features(writer, &gsub);
    mt_fea_features(writer, &gpos);
}

/* What the text has not, in its first line. */
static void tell_unsaid(mt_fea_writer *writer, mt_buffer *text) {
    if (writer->fea->unsaid > 0)
        mt_fea_print(writer, text,
                     "# Left out, since features.fea has no words for them: %d rules, lookups or features\n",
                     writer->fea->unsaid);
}

static void join(mt_fea_writer *writer, mt_buffer *text) {
    tell_unsaid(writer, text);
    const mt_buffer *const parts[] = {&writer->systems, &writer->classes, &writer->lookups,
                                      &writer->features};
    for (int i = 0; i < 4 && writer->status == MT_OK; i++)
        writer->status = mt_buffer_add(text, parts[i]->bytes, parts[i]->length);
}

mt_status mt_fea_make(const mt_fea_source *source, mt_arena *arena, mt_fea *fea) {
    mt_fea made = {0};
    const int32_t place = source->place * 4; /* 16.16 of 2.14 */
    mt_fea_writer writer = {
        .source = source, .arena = arena, .lists = {.width = 2}, .fea = &made, .left = WORK_MAX};
    writer.status = mt_gdef_deltas_open(source->gdef, &place, 1, arena, &writer.deltas);
    if (writer.status == MT_OK) write_all(&writer);
    if (writer.status == MT_OK && writer.left == 0) writer.status = MT_TOO_LARGE;
    join(&writer, &made.text);
    mt_buffer_free(&writer.systems);
    mt_buffer_free(&writer.classes);
    mt_buffer_free(&writer.lookups);
    mt_buffer_free(&writer.features);
    mt_interned_free(&writer.lists);
    mt_free(writer.class_of);
    if (writer.status != MT_OK) mt_buffer_free(&made.text);
    if (writer.status == MT_OK) *fea = made;
    return writer.status;
}
