/* Lookups, a block each. Those that contexts call stand before all others, since text must have them first; one that features
 * apply too stands in its own place once more. */
#include <stdio.h>

#include "anchors/read.h"
#include "fea/writer.h"
#include "gsub/gsub.h"

/* ---- names --------------------------------------------------------------------------------------------- */

static bool is_attachment(const mt_fea_table *table, const mt_lookup *lookup) {
    return table->layout.extension == MT_EXTENSION_GPOS && lookup->type >= MT_MARK_TO_BASE &&
           lookup->type <= MT_MARK_TO_MARK;
}

void mt_fea_name(mt_fea_writer *writer, mt_buffer *to, const mt_fea_table *table, int lookup, int part,
                 bool called) {
    mt_lookup from = mt_layout_lookup(&table->layout, lookup);
    mt_fea_print(writer, to, "%s%s_%d", table->prefix, called ? "_called" : "", lookup);
    if (is_attachment(table, &from)) mt_fea_print(writer, to, "_%d", part);
}

void mt_fea_call(mt_fea_writer *writer, mt_buffer *to, const mt_fea_table *table, int lookup) {
    for (int i = 0; i < table->parts[lookup]; i++) {
        mt_fea_put(writer, to, " lookup ");
        mt_fea_name(writer, to, table, lookup, i, true);
    }
}

/* ---- flags --------------------------------------------------------------------------------------------- */

enum { IGNORE_MARKS = 8, PLAIN_FLAGS = 15, CLASS_SHIFT = 8 };

/* The marks that the lookup sees, where it sees some only: of a class, or a set. */
static bool list_seen(mt_fea_writer *writer, const mt_lookup *lookup, uint16_t **glyphs, int *count) {
    int class = lookup->flag >> CLASS_SHIFT;
    if (lookup->mark_set >= 0)
        return mt_fea_coverage_list(writer, mt_fea_mark_set(writer, lookup->mark_set), glyphs, count);
    return mt_fea_class_list(writer, mt_ot_follow(writer->source->gdef, 10), (unsigned)class, glyphs, count);
}

static void put_flags(mt_fea_writer *writer, const mt_lookup *lookup) {
    static const char *const words[] = {"RightToLeft", "IgnoreBaseGlyphs", "IgnoreLigatures", "IgnoreMarks"};
    int flag = lookup->flag & PLAIN_FLAGS, count = 0;
    uint16_t *glyphs;
    mt_buffer *to = &writer->lookups;
    bool some = !(flag & IGNORE_MARKS) && (lookup->mark_set >= 0 || lookup->flag >> CLASS_SHIFT);
    if (some && !list_seen(writer, lookup, &glyphs, &count)) return;
    if (some && count == 0) flag |= IGNORE_MARKS;
    if (!flag && !count) return;
    mt_fea_put(writer, to, "  lookupflag");
    for (int i = 0; i < 4; i++)
        if (flag >> i & 1) mt_fea_print(writer, to, " %s", words[i]);
    if (count) {
        mt_fea_put(writer, to, lookup->mark_set >= 0 ? " UseMarkFilteringSet " : " MarkAttachmentType ");
        if (count == 1) mt_fea_put(writer, to, "[");
        mt_fea_class(writer, to, glyphs, count);
        if (count == 1) mt_fea_put(writer, to, "]");
    }
    mt_fea_put(writer, to, ";\n");
}

/* ---- rules --------------------------------------------------------------------------------------------- */

static void put_rules(mt_fea_writer *writer, const mt_fea_table *table, int number, const mt_lookup *lookup) {
    enum { POS_SINGLE = 1, POS_PAIR, POS_CURSIVE, POS_CONTEXT = 7, POS_CHAIN };
    bool sub = table->layout.extension == MT_EXTENSION_GSUB;
    bool context = sub ? lookup->type == MT_GSUB_CONTEXT || lookup->type == MT_GSUB_CHAIN
                       : lookup->type == POS_CONTEXT || lookup->type == POS_CHAIN;
    if (context)
        mt_fea_contexts(writer, table, number);
    else if (sub)
        mt_fea_substitutions(writer, &table->layout, number);
    else if (lookup->type == POS_SINGLE)
        mt_fea_singles(writer, lookup);
    else if (lookup->type == POS_PAIR)
        mt_fea_pairs(writer, lookup);
    else if (lookup->type == POS_CURSIVE)
        mt_fea_cursives(writer, lookup);
    else
        writer->fea->unsaid++;
}

/* ---- blocks -------------------------------------------------------------------------------------------- */

/* One block, of a subtable of attachments or of all else. False where nothing is in it, and so nothing is written. */
static bool put_block(mt_fea_writer *writer, const mt_fea_table *table, int number, int subtable,
                      bool called) {
    mt_lookup lookup = mt_layout_lookup(&table->layout, number);
    mt_buffer *to = &writer->lookups;
    size_t start = to->length;
    int part = table->parts[number];
    mt_fea_put(writer, to, "lookup ");
    mt_fea_name(writer, to, table, number, part, called);
    mt_fea_put(writer, to, " {\n");
    put_flags(writer, &lookup);
    size_t empty = to->length;
    if (is_attachment(table, &lookup))
        mt_fea_attachments(writer, &lookup, number, subtable, called || !table->called[number]);
    else
        put_rules(writer, table, number, &lookup);
    bool any = to->length > empty;
    mt_fea_put(writer, to, "} ");
    mt_fea_name(writer, to, table, number, part, called);
    mt_fea_put(writer, to, ";\n\n");
    if (!any) to->length = start;
    return any;
}

/* A block for each subtable of attachments, the last one first: of lookups the last decides, of subtables the first. */
static void put_lookup(mt_fea_writer *writer, mt_fea_table *table, int number, bool called) {
    mt_lookup lookup = mt_layout_lookup(&table->layout, number);
    mt_arena_place before = mt_arena_mark(writer->arena);
    int blocks = is_attachment(table, &lookup) ? lookup.subtable_count : 1;
    table->parts[number] = 0;
    for (int i = blocks - 1; i >= 0 && writer->status == MT_OK; i--)
        table->parts[number] += put_block(writer, table, number, i, called);
    mt_arena_rewind(writer->arena, before);
}

/* What a called lookup calls comes before it; none leads back to itself (calls.c). */
static void put_called(mt_fea_writer *writer, mt_fea_table *table, int number, bool *done) {
    if (done[number] || writer->status != MT_OK) return;
    done[number] = true;
    const mt_calls *calls = &table->layout.calls;
    for (int i = calls->first[number]; i < calls->first[number + 1]; i++)
        put_called(writer, table, calls->lookups[i], done);
    put_lookup(writer, table, number, true);
}

/* Where compilers put the features that they make of what is told elsewhere: in the place of the first lookup of each. */
static void put_automatic(mt_fea_writer *writer, const mt_fea_table *table, int number, bool *done) {
    static const uint32_t tags[] = {MT_TAG('k', 'e', 'r', 'n'), MT_TAG('c', 'u', 'r', 's'),
                                    MT_TAG('m', 'a', 'r', 'k'), MT_TAG('m', 'k', 'm', 'k'),
                                    MT_TAG('a', 'b', 'v', 'm'), MT_TAG('b', 'l', 'w', 'm')};
    static const char *const names[] = {"kern", "curs", "mark", "mkmk", "abvm", "blwm"};
    for (int i = 0; i < 6; i++) {
        bool pairs = table->ways[number] == MT_FEA_PAIRS;
        if (done[i] || pairs != (i == 0) || !mt_fea_has_tag(&table->layout, number, tags[i])) continue;
        done[i] = true;
        mt_fea_print(writer, &writer->lookups, "feature %s {\n  # Automatic Code\n} %s;\n\n", names[i],
                     names[i]);
    }
}

void mt_fea_lookups(mt_fea_writer *writer, mt_fea_table *table) {
    int count = table->layout.lookup_count;
    bool *done = mt_fea_new(writer, (size_t)count, sizeof *done), automatic[6] = {0};
    const mt_calls *calls = &table->layout.calls;
    for (int i = 0; i < count && done; i++)
        if (table->applied[i])
            for (int k = calls->first[i]; k < calls->first[i + 1]; k++)
                table->called[calls->lookups[k]] = true;
    for (int i = 0; i < count && done; i++)
        if (table->applied[i])
            for (int k = calls->first[i]; k < calls->first[i + 1]; k++)
                put_called(writer, table, calls->lookups[k], done);
    for (int i = 0; i < count && writer->status == MT_OK; i++) {
        if (!table->applied[i]) continue;
        if (table->ways[i] == MT_FEA_TEXT)
            put_lookup(writer, table, i, false);
        else
            put_automatic(writer, table, i, automatic);
    }
}
