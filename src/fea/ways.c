/* How the lookups of GPOS are told. Elsewhere are those which compilers make anew from pairs and anchors as they are: the kerning
 * of Latin text; marks, where GDEF has the classes that compilers go by; one lookup of cursive lines that run as those of Arabic. */
#include "anchors/read.h"
#include "fea/writer.h"
#include "layout/lookup_groups.h"

/* ---- pairs --------------------------------------------------------------------------------------------- */

/* The system that Latin text is set by, as gpos/positions.c has it; -1 where there is none at all. */
static int plain_system(const mt_layout *layout) {
    int best = layout->system_count ? 0 : -1;
    for (int i = 1; i < layout->system_count; i++) {
        const mt_system *nearest = &layout->systems[best], *other = &layout->systems[i];
        if (mt_latin_rank(other->script, other->language) < mt_latin_rank(nearest->script, nearest->language))
            best = i;
    }
    return best;
}

static void choose_pairs(mt_fea_table *table) {
    int lookups[MT_SYSTEM_LOOKUPS_MAX];
    int count = mt_system_lookups(&table->layout, plain_system(&table->layout), MT_TAG('k', 'e', 'r', 'n'),
                                  MT_LOOKUP_PAIR, lookups, MT_SYSTEM_LOOKUPS_MAX);
    for (int i = 0; i < count; i++) table->ways[lookups[i]] = MT_FEA_PAIRS;
}

/* ---- anchors ------------------------------------------------------------------------------------------- */

enum { LIGATURE_CLASS = 2, MARK_CLASS = 3 };

/* Whether all glyphs of the coverage have the class in GDEF. */
static bool all_are(mt_fea_writer *writer, mt_bytes coverage, unsigned class) {
    uint16_t *glyphs;
    int count;
    mt_bytes classes = mt_ot_follow(writer->source->gdef, 4);
    if (!mt_fea_coverage_list(writer, coverage, &glyphs, &count)) return false;
    for (int i = 0; i < count; i++)
        if (mt_class_find(classes, glyphs[i]) != class) return false;
    return true;
}

static bool is_by_anchors(mt_fea_writer *writer, const mt_lookup *lookup) {
    for (int i = 0; i < lookup->subtable_count; i++) {
        mt_attachment_table table;
        if (!mt_attachment_open(mt_lookup_subtable(lookup, i), lookup->type, &table)) continue;
        if (!all_are(writer, table.mark_coverage, MARK_CLASS)) return false;
        bool ligatures = lookup->type == MT_MARK_TO_LIGATURE;
        if (ligatures && !all_are(writer, table.base_coverage, LIGATURE_CLASS)) return false;
        bool marks = lookup->type == MT_MARK_TO_MARK;
        if (marks && !all_are(writer, table.base_coverage, MARK_CLASS)) return false;
    }
    return true;
}

static bool is_mark_feature(const mt_layout *layout, int lookup) {
    static const uint32_t tags[] = {MT_TAG('m', 'a', 'r', 'k'), MT_TAG('m', 'k', 'm', 'k'),
                                    MT_TAG('a', 'b', 'v', 'm'), MT_TAG('b', 'l', 'w', 'm')};
    for (int i = 0; i < 4; i++)
        if (mt_fea_has_tag(layout, lookup, tags[i])) return true;
    return false;
}

static void choose_marks(mt_fea_writer *writer, mt_fea_table *table) {
    for (int i = 0; i < table->layout.lookup_count; i++) {
        mt_lookup lookup = mt_layout_lookup(&table->layout, i);
        if (lookup.type < MT_MARK_TO_BASE || lookup.type > MT_MARK_TO_MARK) continue;
        mt_arena_place before = mt_arena_mark(writer->arena);
        if (is_mark_feature(&table->layout, i) && is_by_anchors(writer, &lookup))
            table->ways[i] = MT_FEA_ANCHORS;
        mt_arena_rewind(writer->arena, before);
    }
}

static void choose_cursive(mt_fea_table *table) {
    enum { RIGHT_TO_LEFT = 1, IGNORE_MARKS = 8 };
    int found = -1, count = 0;
    for (int i = 0; i < table->layout.lookup_count; i++) {
        mt_lookup lookup = mt_layout_lookup(&table->layout, i);
        if (lookup.type != MT_CURSIVE || !table->applied[i]) continue;
        count++;
        bool named = mt_fea_has_tag(&table->layout, i, MT_TAG('c', 'u', 'r', 's'));
        if (named && lookup.flag == (RIGHT_TO_LEFT | IGNORE_MARKS)) found = i;
    }
    if (count == 1 && found >= 0) table->ways[found] = MT_FEA_ANCHORS;
}

void mt_fea_choose_ways(mt_fea_writer *writer, mt_fea_table *table) {
    if (!table->ways) return;
    if (writer->source->kerns) choose_pairs(table);
    if (mt_ot_follow(writer->source->gdef, 4).length) choose_marks(writer, table);
    choose_cursive(table);
}
