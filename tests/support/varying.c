#include "support/varying.h"

#include <math.h>

#include "layout/gdef.h"
#include "layout/lookup_builder.h"
#include "sfnt/sfnt.h"
#include "support/check.h"

mt_bytes mt_test_fvar(mt_arena *arena) {
    enum { HEADER = 16, AXIS_SIZE = 20, INSTANCE_SIZE = 8, NAME = 256 };
    mt_table table = {0};
    mt_bytes fvar;
    mt_table_32(&table, 0x00010000);
    mt_table_16(&table, HEADER);
    mt_table_16(&table, 2); /* reserved */
    mt_table_16(&table, 1);
    mt_table_16(&table, AXIS_SIZE);
    mt_table_16(&table, 0);
    mt_table_16(&table, INSTANCE_SIZE);
    mt_table_32(&table, MT_TAG('M', 'O', 'R', 'F'));
    mt_table_fixed(&table, 0);
    mt_table_fixed(&table, 0);
    mt_table_fixed(&table, 100);
    mt_table_16(&table, 0); /* flags */
    mt_table_16(&table, NAME);
    mt_assert_ok(mt_table_keep(&table, arena, &fvar));
    return fvar;
}

mt_status mt_test_write_varying(const mt_positions *positions, int font_count, mt_bytes plain,
                                mt_arena *arena, mt_bytes *gpos, mt_bytes *gdef) {
    const mt_stops stops = mt_stops_even(font_count);
    mt_var_store store = mt_var_store_make(&stops);
    mt_status status = mt_positions_write_varying(positions, &store, arena, gpos);
    if (status == MT_OK) status = mt_gdef_vary(plain, &store, arena, gdef);
    mt_var_store_free(&store);
    return status;
}

mt_bytes mt_test_gvar(int glyph_count, mt_arena *arena) {
    enum { HEADER = 20 };
    mt_table table = {0};
    mt_bytes gvar;
    uint32_t end = HEADER + 2 * ((uint32_t)glyph_count + 1);
    mt_table_32(&table, 0x00010000);
    mt_table_16(&table, 1);
    mt_table_16(&table, 0); /* shared tuples */
    mt_table_32(&table, end);
    mt_table_16(&table, glyph_count);
    mt_table_16(&table, 0); /* flags: offsets of 16 bits */
    mt_table_32(&table, end);
    mt_table_zeros(&table, 2 * (glyph_count + 1));
    mt_assert_ok(mt_table_keep(&table, arena, &gvar));
    return gvar;
}

void mt_test_place_on_axis(hb_font_t *font, double place) {
    int normalized = (int)lround(place * 0x4000);
    hb_font_set_var_coords_normalized(font, &normalized, 1);
}
