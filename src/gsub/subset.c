#include "gsub/subset.h"

#include <hb-subset.h>
#include <string.h>

#include "layout/lookup_builder.h"
#include "layout/tidy.h"
#include "sfnt/layout_face.h"
#include "sfnt/sfnt.h"

/* ---- what goes in -------------------------------------------------------------------------------------- */

/* GDEF without attachment points, carets and variations (OpenType spec, "GDEF header"): offsets at 6, 8 and 14. */
static mt_status plain_gdef(mt_bytes gdef, mt_arena *arena, mt_bytes *plain) {
    unsigned minor = mt_ot_u16(gdef, 2);
    *plain = (mt_bytes){0};
    if (mt_ot_u16(gdef, 0) != 1 || !mt_ot_has(gdef, 0, minor >= 3 ? 18 : minor == 2 ? 14 : 12)) return MT_OK;
    uint8_t *bytes = mt_arena_new(arena, gdef.length, 1);
    if (!bytes) return MT_NO_MEMORY;
    memcpy(bytes, gdef.bytes, gdef.length);
    bytes[3] = minor >= 2 ? 2 : 0;
    memset(bytes + 6, 0, 4);
    *plain = (mt_bytes){bytes, gdef.length};
    return MT_OK;
}

/* ---- what comes out ------------------------------------------------------------------------------------ */

/* GDEF comes before GSUB, which names its sets. */
static mt_status take_table(hb_face_t *face, uint32_t tag, mt_bytes gdef, mt_arena *arena, mt_bytes *table) {
    hb_blob_t *blob = hb_face_reference_table(face, tag);
    unsigned length;
    const char *from = hb_blob_get_data(blob, &length);
    uint8_t *bytes = mt_arena_new(arena, (size_t)length + 1, 1);
    if (bytes && length) memcpy(bytes, from, length);
    hb_blob_destroy(blob);
    if (!bytes) return MT_NO_MEMORY;
    *table = (mt_bytes){bytes, length};
    if (tag == MT_TAG('G', 'D', 'E', 'F')) mt_tidy_classes(bytes, length);
    if (tag != MT_TAG('G', 'S', 'U', 'B') || length == 0) return MT_OK;
    mt_tidy_scripts(bytes, length);
    return mt_tidy_lookups(bytes, length, MT_EXTENSION_GSUB, gdef, arena);
}

/* Whether the subsetter keeps these glyphs and no other, in their order. */
static bool keeps_order(const hb_subset_plan_t *plan, const uint16_t *kept, int count) {
    const hb_map_t *numbers = hb_subset_plan_old_to_new_glyph_mapping(plan);
    if (hb_map_get_population(numbers) != (unsigned)count) return false;
    for (int i = 0; i < count; i++)
        if (hb_map_get(numbers, kept[i]) != (unsigned)i) return false;
    return true;
}

static mt_status subset(hb_face_t *face, const hb_subset_input_t *input, const uint16_t *kept, int count,
                        mt_arena *arena, mt_layout_tables *tables, bool *held) {
    hb_subset_plan_t *plan = hb_subset_plan_create_or_fail(face, input);
    if (!plan) return MT_NO_MEMORY;
    *held = keeps_order(plan, kept, count);
    hb_face_t *made = *held ? hb_subset_plan_execute_or_fail(plan) : NULL;
    mt_status status = MT_OK;
    if (made) {
        status = take_table(made, MT_TAG('G', 'D', 'E', 'F'), (mt_bytes){0}, arena, &tables->gdef);
        if (status == MT_OK)
            status = take_table(made, MT_TAG('G', 'S', 'U', 'B'), tables->gdef, arena, &tables->gsub);
        hb_face_destroy(made);
    }
    hb_subset_plan_destroy(plan);
    return status;
}

/* All features and all scripts; of glyphs those that are kept. *held tells whether no other glyphs came with them. */
static mt_status prune_face(hb_face_t *face, const uint16_t *kept, int count, mt_arena *arena,
                            mt_layout_tables *tables, bool *held) {
    hb_subset_input_t *input = hb_subset_input_create_or_fail();
    if (!input) return MT_NO_MEMORY;
    hb_set_t *features = hb_subset_input_set(input, HB_SUBSET_SETS_LAYOUT_FEATURE_TAG);
    hb_set_t *glyphs = hb_subset_input_glyph_set(input);
    hb_set_clear(features);
    hb_set_invert(features);
    for (int i = 0; i < count; i++) hb_set_add(glyphs, kept[i]);
    bool filled = hb_set_allocation_successful(features) && hb_set_allocation_successful(glyphs);
    mt_status status = filled ? subset(face, input, kept, count, arena, tables, held) : MT_NO_MEMORY;
    hb_subset_input_destroy(input);
    return status;
}

/* ---- the whole ----------------------------------------------------------------------------------------- */

/* The font's GSUB without what leads out of the kept glyphs. */
static mt_status cut_gsub(const mt_font *font, const uint16_t *kept, int count, mt_arena *arena,
                          mt_bytes *cut) {
    mt_gsub gsub;
    mt_status status = mt_gsub_open(font, arena, &gsub);
    if (status != MT_OK) return status;
    bool *is_kept = mt_arena_new(arena, (size_t)gsub.glyph_count + 1, sizeof *is_kept);
    if (!is_kept) return MT_NO_MEMORY;
    for (int i = 0; i < count; i++) is_kept[kept[i]] = true;
    return mt_gsub_cut(&gsub, is_kept, arena, cut);
}

static mt_status prune(int glyph_count, mt_bytes gsub, mt_bytes gdef, const uint16_t *kept, int count,
                       mt_arena *arena, mt_layout_tables *tables, bool *held) {
    mt_face_tables with = {.gsub = gsub, .gdef = gdef, .glyph_count = glyph_count};
    *held = true;
    if (!gsub.length && !gdef.length) return MT_OK;
    hb_face_t *face = mt_face_make(&with);
    if (!face) return MT_NO_MEMORY;
    mt_status status = prune_face(face, kept, count, arena, tables, held);
    hb_face_destroy(face);
    return status;
}

mt_status mt_gsub_subset(const mt_font *font, const uint16_t *kept, int count, mt_arena *arena,
                         mt_layout_tables *tables) {
    mt_bytes gsub, gdef;
    mt_layout_tables made = {0};
    bool held;
    mt_status status = cut_gsub(font, kept, count, arena, &gsub);
    if (status == MT_OK) status = mt_font_table(font, MT_TAG('G', 'D', 'E', 'F'), arena, &gdef);
    if (status == MT_OK) status = plain_gdef(gdef, arena, &gdef);
    if (status == MT_OK)
        status = prune(mt_font_glyph_count(font), gsub, gdef, kept, count, arena, &made, &held);
    if (status == MT_OK && !held)
        status = prune(mt_font_glyph_count(font), (mt_bytes){0}, gdef, kept, count, arena, &made, &held);
    if (status == MT_OK) *tables = made;
    return status;
}

/* ---- twins --------------------------------------------------------------------------------------------- */

/* GDEF with its GlyphClassDef written anew behind it, for the twins too; as it is where the offset would not do. */
static mt_status class_twins(mt_bytes *gdef, int count, const mt_twin *twins, int twin_count,
                             mt_arena *arena) {
    mt_bytes classes = mt_ot_follow(*gdef, 4);
    if (!classes.length || gdef->length > UINT16_MAX) return MT_OK;
    mt_table table = {0};
    mt_glyph_class *list = mt_arena_new(arena, (size_t)count + (size_t)twin_count, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    for (int i = 0; i < count + twin_count; i++) {
        unsigned like = i < count ? (unsigned)i : twins[i - count].like;
        list[i] = (mt_glyph_class){(uint16_t)i, (uint16_t)mt_class_find(classes, like)};
    }
    mt_table_bytes(&table, gdef->bytes, gdef->length);
    mt_table_classes(&table, list, count + twin_count);
    if (!table.failed) {
        table.bytes[4] = (uint8_t)(gdef->length >> 8);
        table.bytes[5] = (uint8_t)gdef->length;
    }
    return mt_table_keep(&table, arena, gdef);
}

static mt_status substitute_twins(mt_bytes *table, int count, const mt_twin *twins, int twin_count,
                                  mt_arena *arena) {
    mt_gsub gsub;
    int all = count + twin_count;
    mt_status status = mt_gsub_open_table(*table, all, arena, &gsub);
    if (status == MT_OK) status = mt_gsub_add_twins(&gsub, twins, twin_count, arena);
    bool *kept = status == MT_OK ? mt_arena_new(arena, (size_t)all, sizeof *kept) : NULL;
    if (!kept) return MT_NO_MEMORY;
    for (int i = 0; i < all; i++) kept[i] = true;
    return mt_gsub_cut(&gsub, kept, arena, table);
}

/* Everything is kept: the subsetter only packs the tables again. Without twins they stay where that does not go. */
mt_status mt_gsub_twins(mt_layout_tables *tables, int count, const mt_twin *twins, int twin_count,
                        mt_arena *arena) {
    mt_layout_tables made = *tables, packed = {0};
    int all = count + twin_count;
    bool held = false;
    if (twin_count == 0 || (!made.gsub.length && !made.gdef.length)) return MT_OK;
    uint16_t *kept = mt_arena_new(arena, (size_t)all, sizeof *kept);
    if (!kept) return MT_NO_MEMORY;
    for (int i = 0; i < all; i++) kept[i] = (uint16_t)i;
    mt_status status = made.gdef.length ? class_twins(&made.gdef, count, twins, twin_count, arena) : MT_OK;
    if (status == MT_OK && made.gsub.length)
        status = substitute_twins(&made.gsub, count, twins, twin_count, arena);
    if (status == MT_OK) status = prune(all, made.gsub, made.gdef, kept, all, arena, &packed, &held);
    bool whole = held && packed.gsub.length >= (tables->gsub.length > 0) &&
                 packed.gdef.length >= (tables->gdef.length > 0);
    if (status == MT_OK && whole) *tables = packed;
    return status;
}
