/* GDEF: classes of glyphs; sets of marks, which lookups name. */
#include "fea/writer.h"

mt_bytes mt_fea_mark_set(const mt_fea_writer *writer, int set) {
    mt_bytes gdef = writer->source->gdef;
    if (mt_ot_u16(gdef, 0) != 1 || mt_ot_u16(gdef, 2) < 2 || set < 0) return (mt_bytes){0};
    mt_bytes sets = mt_ot_follow(gdef, 12);
    int count = mt_ot_fit(sets, 4, mt_ot_u16(sets, 2), 4);
    return set < count ? mt_ot_follow32(sets, 4 + 4 * (size_t)set) : (mt_bytes){0};
}

/* `bases` are bases where GDEF has no class for them. */
void mt_fea_gdef(mt_fea_writer *writer, const bool *bases) {
    enum { BASE = 1, LIGATURE, MARK, PART, CLASSES };
    static const int order[] = {BASE, LIGATURE, MARK, PART};
    mt_bytes classes = mt_ot_follow(writer->source->gdef, 4);
    mt_buffer *to = &writer->features;
    uint16_t *glyphs = mt_fea_new(writer, (size_t)writer->source->glyph_count, sizeof *glyphs);
    if (!classes.length || !glyphs) return;
    mt_fea_put(writer, to, "table GDEF {\n  GlyphClassDef ");
    for (int i = 0; i < CLASSES - 1; i++) {
        int count = 0;
        for (int g = 0; g < writer->source->glyph_count; g++) {
            int class = (int)mt_class_find(classes, (uint32_t)g);
            if (class == 0 && bases[g]) class = BASE;
            if (class == order[i]) glyphs[count++] = (uint16_t)g;
        }
        if (i) mt_fea_put(writer, to, ", ");
        if (count == 1) mt_fea_put(writer, to, "[");
        if (count) mt_fea_class(writer, to, glyphs, count);
        if (count == 1) mt_fea_put(writer, to, "]");
    }
    mt_fea_put(writer, to, ";\n} GDEF;\n\n");
}
