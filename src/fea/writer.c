#include "fea/writer.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* ---- text ---------------------------------------------------------------------------------------------- */

static void add(mt_fea_writer *writer, mt_buffer *to, const char *text, size_t length) {
    if (writer->status != MT_OK || !mt_fea_spend(writer, (int64_t)length)) return;
    writer->status = mt_buffer_add(to, text, length);
}

void mt_fea_put(mt_fea_writer *writer, mt_buffer *to, const char *text) {
    add(writer, to, text, strlen(text));
}

void mt_fea_print(mt_fea_writer *writer, mt_buffer *to, const char *format, ...) {
    char text[128];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    mt_fea_put(writer, to, text);
}

bool mt_fea_spend(mt_fea_writer *writer, int64_t steps) {
    writer->left = steps <= writer->left ? writer->left - steps : 0;
    return writer->left > 0;
}

void *mt_fea_new(mt_fea_writer *writer, size_t count, size_t size) {
    void *made = writer->status == MT_OK ? mt_arena_new(writer->arena, count + 1, size) : NULL;
    if (!made && writer->status == MT_OK) writer->status = MT_NO_MEMORY;
    return made;
}

/* ---- glyphs -------------------------------------------------------------------------------------------- */

/* Words of the language, which a name is told from by a backslash before it. */
static bool is_word(const char *name) {
    static const char words[] =
        " anchor anchorDef anon anonymous by contour contourpoint cursive device enum enumerate excludeDFLT "
        "exclude_dflt "
        "feature featureNames from ignore IgnoreBaseGlyphs IgnoreLigatures IgnoreMarks include includeDFLT "
        "include_dflt language languagesystem lookup lookupflag mark MarkAttachmentType markClass name NULL "
        "nameid parameters pos position required reversesub RightToLeft rsub script sizemenuname sub "
        "substitute subtable table useExtension UseMarkFilteringSet valueRecordDef base ligature "
        "ligComponent "
        "cvParameters FeatUILabelNameID Character ";
    size_t length = strlen(name);
    for (const char *at = strstr(words, name); at; at = strstr(at + 1, name))
        if (at[-1] == ' ' && at[length] == ' ') return true;
    return false;
}

void mt_fea_glyph(mt_fea_writer *writer, mt_buffer *to, int glyph) {
    if (glyph >= writer->source->glyph_count) glyph = 0;
    const char *name = writer->source->names[glyph];
    if (is_word(name)) mt_fea_put(writer, to, "\\");
    mt_fea_put(writer, to, name);
}

static void define(mt_fea_writer *writer, const uint16_t *glyphs, int count, int number) {
    mt_fea_print(writer, &writer->classes, "@c%d = [", number);
    for (int i = 0; i < count; i++) {
        if (i) mt_fea_put(writer, &writer->classes, " ");
        mt_fea_glyph(writer, &writer->classes, glyphs[i]);
    }
    mt_fea_put(writer, &writer->classes, "];\n");
}

/* Which of the interned lists that is; -1 where that is told by `status`. */
static int find_list(mt_fea_writer *writer, const uint16_t *glyphs, int count) {
    int at = -1;
    for (int i = 0; i < count && writer->status == MT_OK; i++) {
        const int32_t row[] = {at, glyphs[i]};
        writer->status = mt_intern(&writer->lists, row, &at);
    }
    return writer->status == MT_OK ? at : -1;
}

/* The number of the list's class, counted from 1. */
static int *class_number(mt_fea_writer *writer, int list) {
    if (list >= writer->class_room) {
        int room = list < 512 ? 1024 : 2 * list;
        int *grown = mt_grow(writer->class_of, (size_t)room, sizeof *grown);
        if (!grown) {
            writer->status = MT_NO_MEMORY;
            return NULL;
        }
        memset(grown + writer->class_room, 0, (size_t)(room - writer->class_room) * sizeof *grown);
        writer->class_of = grown;
        writer->class_room = room;
    }
    return &writer->class_of[list];
}

void mt_fea_class(mt_fea_writer *writer, mt_buffer *to, const uint16_t *glyphs, int count) {
    if (!mt_fea_spend(writer, count)) return;
    if (count == 1) {
        mt_fea_glyph(writer, to, glyphs[0]);
        return;
    }
    int list = find_list(writer, glyphs, count);
    int *number = list >= 0 ? class_number(writer, list) : NULL;
    if (!number) return;
    if (!*number) {
        *number = ++writer->class_count;
        define(writer, glyphs, count, *number);
    }
    mt_fea_print(writer, to, "@c%d", *number);
}

bool mt_fea_class_list(mt_fea_writer *writer, mt_bytes class_def, unsigned number, uint16_t **glyphs,
                       int *count) {
    int all = writer->source->glyph_count;
    *count = 0;
    *glyphs = mt_fea_spend(writer, all) ? mt_fea_new(writer, (size_t)all, sizeof **glyphs) : NULL;
    if (!*glyphs) return false;
    for (int i = 0; i < all; i++)
        if (mt_class_find(class_def, (uint32_t)i) == number) (*glyphs)[(*count)++] = (uint16_t)i;
    return true;
}

bool mt_fea_coverage_list(mt_fea_writer *writer, mt_bytes coverage, uint16_t **glyphs, int *count) {
    mt_covered *covered;
    int all;
    *count = 0;
    if (writer->status != MT_OK) return false;
    writer->status = mt_coverage_list(coverage, writer->arena, &covered, &all);
    if (writer->status != MT_OK || !mt_fea_spend(writer, all)) return false;
    *glyphs = mt_fea_new(writer, (size_t)all, sizeof **glyphs);
    for (int i = 0; i < all && *glyphs; i++)
        if (covered[i].glyph < writer->source->glyph_count) (*glyphs)[(*count)++] = covered[i].glyph;
    return *glyphs != NULL;
}

void mt_fea_each_glyph(mt_fea_writer *writer, const mt_lookup *lookup,
                       mt_bytes (*coverage_of)(mt_bytes table),
                       void (*put)(mt_fea_writer *writer, mt_bytes table, mt_covered covered)) {
    bool *taken = mt_fea_new(writer, (size_t)writer->source->glyph_count, sizeof *taken);
    for (int i = 0; i < lookup->subtable_count && taken && writer->status == MT_OK; i++) {
        mt_covered *covered;
        int count;
        mt_bytes table = mt_lookup_subtable(lookup, i);
        writer->status = mt_coverage_list(coverage_of(table), writer->arena, &covered, &count);
        for (int k = 0; writer->status == MT_OK && k < count && mt_fea_spend(writer, 1); k++) {
            int glyph = covered[k].glyph;
            if (glyph >= writer->source->glyph_count || taken[glyph]) continue;
            taken[glyph] = true;
            put(writer, table, covered[k]);
        }
    }
}
