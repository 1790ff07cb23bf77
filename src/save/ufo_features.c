/* A UFO's features.fea, and the anchors that belong to it. */
#include "save/ufo_parts.h"

static mt_bytes find_table(const mt_font_data *data, uint32_t tag) {
    for (int i = 0; i < data->extra_count; i++)
        if (data->extras[i].tag == tag) return data->extras[i].data;
    return (mt_bytes){0};
}

mt_status mt_ufo_features(const mt_font_data *data, const mt_ufo_glyphs *glyphs, mt_arena *arena,
                          mt_fea *fea) {
    const mt_fea_source source = {.gsub = find_table(data, MT_TAG('G', 'S', 'U', 'B')),
                                  .gpos = find_table(data, MT_TAG('G', 'P', 'O', 'S')),
                                  .gdef = find_table(data, MT_TAG('G', 'D', 'E', 'F')),
                                  .glyph_count = data->glyph_count,
                                  .names = glyphs->names,
                                  .place = data->layout_place,
                                  .kerns = data->kerning && data->kerning->pair_count > 0};
    return mt_fea_make(&source, arena, fea);
}
