/* The container of WOFF2 (W3C, "WOFF File Format 2.0", sections 4 and 5), compressed by Google's Brotli. */
#include "save/woff2_plain.h"

#include <brotli/encode.h>

#include "base/memory.h"
#include "sfnt/sfnt.h"
#include "sfnt/table.h"

enum { SFNT_HEADER = 12, SFNT_RECORD = 16, WOFF2_HEADER = 48 };

static size_t round_up(size_t length) {
    return (length + 3) & ~(size_t)3;
}

/* ---- what the font holds ------------------------------------------------------------------------------- */

static int table_count(const uint8_t *font) {
    return (int)mt_read_u16(font + 4);
}

static const uint8_t *record_of(const uint8_t *font, int i) {
    return font + SFNT_HEADER + (size_t)i * SFNT_RECORD;
}

static uint32_t length_of(const uint8_t *record) {
    return mt_read_u32(record + 12);
}

/* All tables one after another, in the order of their records. */
static void join_tables(const uint8_t *font, mt_table *joined) {
    for (int i = 0; i < table_count(font); i++) {
        const uint8_t *record = record_of(font, i);
        mt_table_bytes(joined, font + mt_read_u32(record + 8), length_of(record));
    }
}

/* The size of the font, each table padded. */
static size_t sfnt_size(const uint8_t *font) {
    size_t size = SFNT_HEADER + (size_t)table_count(font) * SFNT_RECORD;
    for (int i = 0; i < table_count(font); i++) size += round_up(length_of(record_of(font, i)));
    return size;
}

/* ---- what is written ----------------------------------------------------------------------------------- */

/* UIntBase128: seven bits a byte, the highest first; all but the last have the top bit set. */
static void write_base128(uint32_t value, mt_table *table) {
    int more = 0;
    while (more < 4 && value >> 7 * (more + 1)) more++;
    for (; more >= 0; more--) mt_table_u8(table, (value >> 7 * more & 0x7F) | (more ? 0x80 : 0));
}

/* Each by its tag in full. Of 'glyf' and 'loca', version 3 of the transformation is none; of others, version 0. */
static void write_directory(const uint8_t *font, mt_table *table) {
    enum { TAG_FOLLOWS = 63, NOT_TRANSFORMED = 3 << 6 };
    for (int i = 0; i < table_count(font); i++) {
        const uint8_t *record = record_of(font, i);
        uint32_t tag = mt_read_u32(record);
        bool outlines = tag == MT_TAG('g', 'l', 'y', 'f') || tag == MT_TAG('l', 'o', 'c', 'a');
        mt_table_u8(table, TAG_FOLLOWS | (outlines ? NOT_TRANSFORMED : 0));
        mt_table_32(table, tag);
        write_base128(length_of(record), table);
    }
}

static void write_whole(const uint8_t *font, const uint8_t *stream, size_t stream_length, mt_table *table) {
    mt_table directory = {0};
    write_directory(font, &directory);
    size_t length = round_up(WOFF2_HEADER + directory.length + stream_length);
    mt_table_32(table, MT_TAG('w', 'O', 'F', '2'));
    mt_table_bytes(table, font, 4); /* the flavor */
    mt_table_32(table, (uint32_t)length);
    mt_table_16(table, table_count(font));
    mt_table_16(table, 0); /* reserved */
    mt_table_32(table, (uint32_t)sfnt_size(font));
    mt_table_32(table, (uint32_t)stream_length);
    mt_table_32(table, 0x00010000); /* the version of the font's data, as libwoff2 has it */
    mt_table_zeros(table, 20);      /* neither metadata nor private data */
    mt_table_bytes(table, directory.bytes, directory.length);
    mt_table_bytes(table, stream, stream_length);
    mt_table_zeros(table, (int)(length - WOFF2_HEADER - directory.length - stream_length));
    table->failed = table->failed || directory.failed;
    mt_table_free(&directory);
}

static mt_status compress(const mt_table *joined, uint8_t **stream, size_t *length) {
    *length = BrotliEncoderMaxCompressedSize(joined->length);
    *stream = *length ? mt_new(*length, 1) : NULL;
    if (!*stream) return MT_NO_MEMORY;
    bool done = BrotliEncoderCompress(BROTLI_MAX_QUALITY, BROTLI_DEFAULT_WINDOW, BROTLI_MODE_FONT,
                                      joined->length, joined->bytes, length, *stream);
    return done ? MT_OK : MT_NO_MEMORY;
}

mt_status mt_woff2_pack_plain(const uint8_t *font, size_t length, uint8_t **bytes, size_t *packed) {
    mt_table joined = {0}, table = {0};
    uint8_t *stream = NULL;
    size_t stream_length = 0;
    if (length > INT32_MAX) return MT_TOO_LARGE;
    join_tables(font, &joined);
    mt_status status = joined.failed ? MT_NO_MEMORY : compress(&joined, &stream, &stream_length);
    if (status == MT_OK) write_whole(font, stream, stream_length, &table);
    if (status == MT_OK && table.failed) status = MT_NO_MEMORY;
    mt_table_free(&joined);
    mt_free(stream);
    if (status != MT_OK) {
        mt_table_free(&table);
        return status;
    }
    *bytes = table.bytes;
    *packed = table.length;
    return MT_OK;
}
