/* The metrics beside a Type 1 font (Adobe's AFM, Windows' PFM): its kerning, which is not in the font. They are read through
 * FreeType, and the pairs are given as a 'kern' table. */
#include "source/handle.h"

#include <stdio.h>
#include <string.h>

#include FT_FONT_FORMATS_H

#include "base/file.h"
#include "sfnt/table.h"

/* The largest file of metrics that is read, a hundred times that of a large font; and how many glyphs are looked at, ten
 * times as many as a large one has. */
enum { METRICS_FILE_MAX = 1 << 24, METRICS_GLYPHS_MAX = 8192 };

/* ---- reading ------------------------------------------------------------------------------------------- */

static bool is_type1(FT_Face face) {
    const char *format = FT_Get_Font_Format(face);
    return format && strcmp(format, "Type 1") == 0;
}

/* Reads the file of that extension, if there is one, into font->metrics_bytes. MT_NO_FILE, MT_TOO_LARGE, MT_NO_MEMORY. */
static mt_status load(mt_font *font, const char *extension) {
    const char *path = font->spec.path, *name = strrchr(path, '/'), *dot = strrchr(name ? name : path, '.');
    size_t stem = dot ? (size_t)(dot - path) : strlen(path), room = stem + strlen(extension) + 1;
    mt_free(font->metrics_path);
    mt_free(font->metrics_bytes);
    font->metrics_bytes = NULL;
    font->metrics_path = mt_new(room, 1);
    if (!font->metrics_path) return MT_NO_MEMORY;
    snprintf(font->metrics_path, room, "%.*s%s", (int)stem, path, extension);
    return mt_file_read(font->metrics_path, METRICS_FILE_MAX, &font->metrics_bytes, &font->metrics_length);
}

static bool attach(mt_font *font) {
    FT_Open_Args arguments = {.flags = FT_OPEN_MEMORY,
                              .memory_base = font->metrics_bytes,
                              .memory_size = (FT_Long)font->metrics_length};
    return FT_Attach_Stream(font->face, &arguments) == 0;
}

mt_status mt_font_attach_metrics(mt_font *font) {
    static const char *const extensions[] = {".afm", ".AFM", ".pfm", ".PFM"};
    if (font->in_memory || !is_type1(font->face)) return MT_OK;
    for (int i = 0; i < 4; i++) {
        mt_status status = load(font, extensions[i]);
        if (status == MT_NO_MEMORY) return status;
        if (status == MT_NO_FILE) continue;
        font->metrics_unread = status != MT_OK || !attach(font);
        return MT_OK;
    }
    return MT_OK;
}

const char *mt_font_unread_metrics(const mt_font *font) {
    return font->metrics_unread ? font->metrics_path : NULL;
}

/* ---- 'kern' -------------------------------------------------------------------------------------------- */

/* A table of version 0 in the making: as many subtables of format 0 as their 16-bit lengths ask for. */
enum { PAIRS_MAX = 10000, SUBTABLES_MAX = 1024, HORIZONTAL = 1 };

typedef struct mt_kern_writer {
    mt_table subtables, pairs;
    int subtable_count, pair_count; /* pairs: of the subtable at work */
} mt_kern_writer;

static void end_subtable(mt_kern_writer *writer) {
    if (writer->pair_count == 0) return;
    mt_table_16(&writer->subtables, 0); /* version */
    mt_table_16(&writer->subtables, 14 + 6 * writer->pair_count);
    mt_table_16(&writer->subtables, HORIZONTAL);
    mt_table_16(&writer->subtables, writer->pair_count);
    mt_table_zeros(&writer->subtables, 6); /* for a binary search, which the reader does without */
    mt_table_bytes(&writer->subtables, writer->pairs.bytes, writer->pairs.length);
    writer->subtables.failed |= writer->pairs.failed;
    writer->subtable_count++;
    mt_table_free(&writer->pairs);
    writer->pair_count = 0;
}

static void add_pair(mt_kern_writer *writer, FT_Face face, int left, int right) {
    FT_Vector kerning;
    if (writer->subtable_count == SUBTABLES_MAX) return;
    if (FT_Get_Kerning(face, (FT_UInt)left, (FT_UInt)right, FT_KERNING_UNSCALED, &kerning) != 0) return;
    if (kerning.x == 0 || kerning.x < INT16_MIN || kerning.x > INT16_MAX) return;
    mt_table_16(&writer->pairs, left);
    mt_table_16(&writer->pairs, right);
    mt_table_16(&writer->pairs, (int)kerning.x);
    if (++writer->pair_count == PAIRS_MAX) end_subtable(writer);
}

static mt_status write_kern(FT_Face face, mt_arena *arena, mt_bytes *kern) {
    mt_kern_writer writer = {0};
    mt_table table = {0};
    int count = face->num_glyphs < METRICS_GLYPHS_MAX ? (int)face->num_glyphs : METRICS_GLYPHS_MAX;
    for (int left = 0; left < count; left++)
        for (int right = 0; right < count; right++) add_pair(&writer, face, left, right);
    end_subtable(&writer);
    mt_table_16(&table, 0); /* version */
    mt_table_16(&table, writer.subtable_count);
    mt_table_bytes(&table, writer.subtables.bytes, writer.subtables.length);
    bool failed = table.failed || writer.subtables.failed;
    uint8_t *bytes = failed ? NULL : mt_arena_new(arena, table.length, 1);
    if (bytes) memcpy(bytes, table.bytes, table.length);
    *kern = (mt_bytes){bytes, bytes ? table.length : 0};
    mt_table_free(&writer.subtables);
    mt_table_free(&table);
    return bytes ? MT_OK : MT_NO_MEMORY;
}

mt_status mt_font_kern(const mt_font *font, mt_arena *arena, mt_bytes *kern) {
    bool attached = font->face && !font->without_layout && is_type1(font->face) && FT_HAS_KERNING(font->face);
    if (attached) return write_kern(font->face, arena, kern);
    return mt_font_table(font, MT_TAG('k', 'e', 'r', 'n'), arena, kern);
}
