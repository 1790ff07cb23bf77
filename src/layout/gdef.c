#include "layout/gdef.h"

#include "layout/lookup_builder.h"
#include "layout/ot.h"

enum { HEADER = 18, OFFSETS = 5 }; /* bytes; 16-bit offsets from byte 4 on, the last since version 1.2 */

/* What the 16-bit offsets lead to lies behind the header, which grows. */
static mt_status write_header(mt_bytes plain, size_t plain_header, mt_table *table) {
    mt_table_32(table, 0x00010003);
    for (size_t i = 0; i < OFFSETS; i++) {
        size_t at = 4 + 2 * i, offset = at < plain_header ? mt_ot_u16(plain, at) : 0;
        if (offset) offset += HEADER - plain_header;
        if (offset > UINT16_MAX) return MT_TOO_LARGE;
        mt_table_16(table, (int)offset);
    }
    return MT_OK;
}

mt_status mt_gdef_vary(mt_bytes plain, const mt_var_store *store, mt_arena *arena, mt_bytes *gdef) {
    size_t header = mt_ot_u16(plain, 2) >= 2 ? 14 : 12;
    size_t rest = plain.length > header ? plain.length - header : 0;
    mt_table table = {0};
    if (store->rows.count == 0) {
        *gdef = plain;
        return MT_OK;
    }
    if (rest > INT32_MAX) return MT_TOO_LARGE;
    mt_status status = write_header(plain, header, &table);
    mt_table_32(&table, (uint32_t)(HEADER + rest));
    if (rest) mt_table_bytes(&table, plain.bytes + header, rest);
    if (status == MT_OK) status = mt_var_store_write(store, &table);
    if (status == MT_OK) status = mt_table_keep(&table, arena, gdef);
    mt_table_free(&table);
    return status;
}
