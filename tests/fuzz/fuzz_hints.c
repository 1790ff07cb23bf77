/* A text of hints to a table, and to hints for the glyphs of two fonts. */
#include "fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t length) {
    static mt_blend *blend; /* stays open */
    mt_hint_table *table;
    mt_hint_error error = {0};
    mt_params params = mt_params_default();
    if (!blend)
        fuzz_require(
            mt_blend_new(fuzz_own_font("PaperA.ttf"), fuzz_own_font("PaperB.ttf"), &params, &blend) == MT_OK);
    mt_status status = mt_hint_table_read((const char *)bytes, length, &table, &error);
    fuzz_require(status == MT_OK || (status == MT_BAD_HINTS && error.line > 0) || status == MT_TOO_LARGE);
    if (status != MT_OK) return 0;
    uint32_t code_point = 0;
    while (mt_hint_table_next_char(table, code_point, &code_point)) code_point++;
    (void)mt_blend_set_hints(blend, table, &error);
    mt_hint_table_free(table);
    return 0;
}
