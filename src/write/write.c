/* A font from plain data: each table made by hand, HarfBuzz's face builder for the container and its
 * checksums. */
#include "write/write.h"

#include "write/tables.h"

#include <hb.h>
#include <string.h>

#include "base/memory.h"

/* glyf comes first: it fills in the offsets that head and loca need. */
static const struct {
    hb_tag_t tag;
    mt_write_table write;
} writers[] = {
    {HB_TAG('g', 'l', 'y', 'f'), mt_write_glyf}, {HB_TAG('l', 'o', 'c', 'a'), mt_write_loca},
    {HB_TAG('h', 'm', 't', 'x'), mt_write_hmtx}, {HB_TAG('h', 'h', 'e', 'a'), mt_write_hhea},
    {HB_TAG('c', 'm', 'a', 'p'), mt_write_cmap}, {HB_TAG('h', 'e', 'a', 'd'), mt_write_head},
    {HB_TAG('m', 'a', 'x', 'p'), mt_write_maxp}, {HB_TAG('O', 'S', '/', '2'), mt_write_os2},
    {HB_TAG('p', 'o', 's', 't'), mt_write_post}, {HB_TAG('n', 'a', 'm', 'e'), mt_write_name},
    {HB_TAG('g', 'a', 's', 'p'), mt_write_gasp}, {HB_TAG('p', 'r', 'e', 'p'), mt_write_prep},
    {HB_TAG('f', 'v', 'a', 'r'), mt_write_fvar}, {HB_TAG('S', 'T', 'A', 'T'), mt_write_stat},
    {HB_TAG('v', 'm', 't', 'x'), mt_write_vmtx}, {HB_TAG('v', 'h', 'e', 'a'), mt_write_vhea},
    {HB_TAG('a', 'v', 'a', 'r'), mt_write_avar},
};

enum { TABLE_COUNT = sizeof writers / sizeof *writers };

/* Beyond this HarfBuzz would count bytes in too few bits. */
#define FONT_BYTES_MAX ((size_t)1 << 31)

static mt_status write_tables(const mt_font_data *data, mt_summary *summary, mt_table *tables) {
    size_t length = 0;
    for (int i = 0; i < TABLE_COUNT; i++) {
        writers[i].write(data, summary, &tables[i]);
        if (tables[i].failed) return MT_NO_MEMORY;
        length += tables[i].length;
        if (length > FONT_BYTES_MAX) return MT_TOO_LARGE;
    }
    return MT_OK;
}

/* ---- the container ------------------------------------------------------------------------------------- */

/* A table that was left empty is none of this font's. */
static bool add_table(hb_face_t *builder, hb_tag_t tag, mt_bytes table) {
    if (table.length == 0) return true;
    hb_blob_t *blob = hb_blob_create_or_fail((const char *)table.bytes, (unsigned)table.length,
                                             HB_MEMORY_MODE_READONLY, NULL, NULL);
    bool added = blob && hb_face_builder_add_table(builder, tag, blob);
    hb_blob_destroy(blob);
    return added;
}

static mt_status copy_blob(hb_blob_t *blob, uint8_t **bytes, size_t *length) {
    unsigned size;
    const char *from = hb_blob_get_data(blob, &size);
    if (size == 0) return MT_NO_MEMORY; /* what HarfBuzz gives when it has none */
    uint8_t *copy = mt_new(size, 1);
    if (!copy) return MT_NO_MEMORY;
    *bytes = memcpy(copy, from, size);
    *length = size;
    return MT_OK;
}

static mt_status assemble(const mt_font_data *data, const mt_table *tables, const mt_table *gvar,
                          uint8_t **bytes, size_t *length) {
    hb_face_t *builder = hb_face_builder_create();
    bool added = add_table(builder, HB_TAG('g', 'v', 'a', 'r'), (mt_bytes){gvar->bytes, gvar->length});
    for (int i = 0; i < TABLE_COUNT && added; i++)
        added = add_table(builder, writers[i].tag, (mt_bytes){tables[i].bytes, tables[i].length});
    for (int i = 0; i < data->extra_count && added; i++)
        added = add_table(builder, data->extras[i].tag, data->extras[i].data);
    mt_status status = MT_NO_MEMORY;
    if (added) {
        hb_blob_t *blob = hb_face_reference_blob(builder);
        status = copy_blob(blob, bytes, length);
        hb_blob_destroy(blob);
    }
    hb_face_destroy(builder);
    return status;
}

/* ---- the whole ----------------------------------------------------------------------------------------- */

static mt_status begin_summary(const mt_font_data *data, mt_summary *summary) {
    size_t glyphs = (size_t)data->glyph_count;
    summary->offsets = mt_new(glyphs + 1, sizeof *summary->offsets);
    summary->extents = mt_new(glyphs, sizeof *summary->extents);
    if (!summary->offsets || !summary->extents) return MT_NO_MEMORY;
    mt_status status = mt_extents_fill(data->glyphs, data->glyph_count, summary->extents);
    if (status == MT_OK) mt_summarise(data, summary);
    return status;
}

mt_status mt_font_write(const mt_font_data *data, uint8_t **bytes, size_t *length) {
    mt_table tables[TABLE_COUNT] = {0}, gvar = {0};
    mt_summary summary = {0};
    mt_status status = mt_font_data_check(data);
    if (status != MT_OK) return status;
    status = begin_summary(data, &summary);
    if (status == MT_OK) status = write_tables(data, &summary, tables);
    if (status == MT_OK) status = mt_write_gvar(data, &gvar);
    if (status == MT_OK) status = assemble(data, tables, &gvar, bytes, length);
    mt_table_free(&gvar);
    for (int i = 0; i < TABLE_COUNT; i++) mt_table_free(&tables[i]);
    mt_free(summary.offsets);
    mt_free(summary.extents);
    return status;
}

void mt_bytes_free(uint8_t *bytes) {
    mt_free(bytes);
}
