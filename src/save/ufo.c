/* The files of a UFO. */
#include "save/ufo.h"

#include <stdio.h>
#include <string.h>

#include "save/ufo_parts.h"
#include "write/tables.h"

/* Ends the document, writes it where that goes, and frees it. */
static mt_status save(mt_folder *folder, const char *name, mt_xml *xml) {
    const char *text;
    size_t length;
    mt_status status = mt_xml_end(xml, &text, &length);
    if (status == MT_OK) status = mt_folder_add_file(folder, name, text, length);
    mt_xml_free(xml);
    return status;
}

/* ---- property lists --------------------------------------------------------------------------------------- */

static mt_status write_meta(mt_folder *folder) {
    mt_xml xml = mt_xml_begin();
    mt_plist_open(&xml, "dict");
    mt_plist_string(&xml, "creator", "Morphotype " MORPHOTYPE_VERSION);
    mt_plist_integer(&xml, "formatVersion", 3);
    mt_plist_close(&xml);
    return save(folder, MT_UFO_MARK, &xml);
}

static mt_status write_info(const mt_font_data *data, mt_folder *folder) {
    mt_xml xml = mt_xml_begin();
    mt_ufo_info(data, &xml);
    return save(folder, "fontinfo.plist", &xml);
}

/* One layer, the default one. */
static mt_status write_layers(mt_folder *folder) {
    mt_xml xml = mt_xml_begin();
    mt_plist_open(&xml, "array");
    mt_plist_group(&xml, NULL, "array");
    mt_plist_string(&xml, NULL, "public.default");
    mt_plist_string(&xml, NULL, "glyphs");
    mt_xml_close(&xml);
    mt_plist_close(&xml);
    return save(folder, "layercontents.plist", &xml);
}

/* Glyphs of characters with a variation selector after them, also where they are the character's own, by selector. */
static void put_variants(const mt_font_data *data, const mt_ufo_glyphs *glyphs, mt_xml *xml) {
    mt_plist_group(xml, "public.unicodeVariationSequences", "dict");
    for (int i = 0; i < data->variant_count; i++) {
        const mt_char_variation *variant = &data->variants[i];
        char selector[16], character[16];
        snprintf(selector, sizeof selector, "%04X", (unsigned)variant->selector);
        snprintf(character, sizeof character, "%04X", (unsigned)variant->code_point);
        bool first = i == 0 || variant[-1].selector != variant->selector;
        bool last = i == data->variant_count - 1 || variant[1].selector != variant->selector;
        if (first) mt_plist_group(xml, selector, "dict");
        mt_plist_string(xml, character, glyphs->names[variant->glyph]);
        if (last) mt_xml_close(xml);
    }
    mt_xml_close(xml);
}

/* What the font calls those glyphs that have other names here. */
static void put_old_names(const mt_font_data *data, const mt_ufo_glyphs *glyphs, mt_xml *xml) {
    bool any = false;
    for (int i = 0; i < data->glyph_count && glyphs->old_names; i++) {
        if (strcmp(glyphs->names[i], glyphs->old_names[i]) == 0) continue;
        if (!any) mt_plist_group(xml, "public.postscriptNames", "dict");
        any = true;
        mt_plist_string(xml, glyphs->names[i], glyphs->old_names[i]);
    }
    if (any) mt_xml_close(xml);
}

static mt_status write_lib(const mt_font_data *data, const mt_ufo_glyphs *glyphs, mt_folder *folder) {
    mt_xml xml = mt_xml_begin();
    mt_plist_open(&xml, "dict");
    mt_plist_group(&xml, "public.glyphOrder", "array");
    for (int i = 0; i < data->glyph_count; i++) mt_plist_string(&xml, NULL, glyphs->names[i]);
    mt_xml_close(&xml);
    put_old_names(data, glyphs, &xml);
    if (data->variant_count) put_variants(data, glyphs, &xml);
    mt_plist_close(&xml);
    return save(folder, "lib.plist", &xml);
}

static mt_status write_kerning(const mt_kerning *of, const mt_ufo_glyphs *glyphs, mt_arena *arena,
                               mt_folder *folder) {
    mt_ufo_kerning kerning;
    if (!of || of->pair_count == 0) return MT_OK;
    mt_status status = mt_ufo_kerning_make(of, glyphs, arena, &kerning);
    if (status != MT_OK) return status;
    mt_xml groups = mt_xml_begin();
    mt_ufo_groups(&kerning, glyphs, &groups);
    status = save(folder, "groups.plist", &groups);
    if (status != MT_OK) return status;
    mt_xml pairs = mt_xml_begin();
    mt_ufo_pairs(&kerning, glyphs, &pairs);
    return save(folder, "kerning.plist", &pairs);
}

/* ---- glyphs ----------------------------------------------------------------------------------------------- */

static mt_status write_contents(const mt_ufo_glyphs *glyphs, const char *const *files, int count,
                                mt_folder *folder) {
    mt_xml xml = mt_xml_begin();
    mt_plist_open(&xml, "dict");
    for (int i = 0; i < count; i++) mt_plist_string(&xml, glyphs->names[i], files[i]);
    mt_plist_close(&xml);
    return save(folder, "glyphs/contents.plist", &xml);
}

static mt_status write_glyph(const mt_font_data *data, const mt_ufo_glyphs *glyphs, const mt_fea *fea,
                             int glyph, const char *file, mt_folder *folder) {
    char name[512];
    mt_xml xml = mt_xml_begin();
    mt_ufo_glif(data, glyphs, fea, glyph, &xml);
    snprintf(name, sizeof name, "glyphs/%s", file);
    return save(folder, name, &xml);
}

static mt_status write_glyphs(const mt_font_data *data, const mt_ufo_glyphs *glyphs, const mt_fea *fea,
                              mt_arena *arena, mt_folder *folder) {
    const char **files;
    mt_status status = mt_folder_add_folder(folder, "glyphs");
    if (status == MT_OK) status = mt_ufo_file_names(glyphs->names, data->glyph_count, arena, &files);
    if (status == MT_OK) status = write_contents(glyphs, files, data->glyph_count, folder);
    for (int i = 0; i < data->glyph_count && status == MT_OK; i++)
        status = write_glyph(data, glyphs, fea, i, files[i], folder);
    return status;
}

/* As mt_font_write does. */
static mt_status check(const mt_font_data *data, mt_arena *arena) {
    mt_status status = mt_font_data_check(data);
    if (status != MT_OK) return status;
    mt_extent *extents = mt_arena_new(arena, (size_t)data->glyph_count, sizeof *extents);
    return extents ? mt_extents_fill(data->glyphs, data->glyph_count, extents) : MT_NO_MEMORY;
}

mt_status mt_ufo_write(const mt_font_data *data, mt_folder *folder, int *unsaid) {
    mt_arena arena = {0};
    mt_ufo_glyphs glyphs;
    mt_fea fea = {0};
    mt_status status = check(data, &arena);
    if (status == MT_OK) status = mt_ufo_glyphs_make(data, &arena, &glyphs);
    if (status == MT_OK) status = write_meta(folder);
    if (status == MT_OK) status = write_info(data, folder);
    if (status == MT_OK) status = write_layers(folder);
    if (status == MT_OK) status = write_lib(data, &glyphs, folder);
    if (status == MT_OK) status = write_kerning(data->kerning, &glyphs, &arena, folder);
    if (status == MT_OK) status = mt_ufo_features(data, &glyphs, &arena, &fea);
    if (status == MT_OK && fea.text.length)
        status = mt_folder_add_file(folder, "features.fea", fea.text.bytes, fea.text.length);
    if (status == MT_OK) status = write_glyphs(data, &glyphs, &fea, &arena, folder);
    if (fea.unsaid > *unsaid) *unsaid = fea.unsaid;
    mt_buffer_free(&fea.text);
    mt_arena_release(&arena);
    return status;
}
