/* What unhinted outlines ask of a rasterizer: 'gasp', and 'prep', the program that runs once for a size. */
#include "write/tables.h"

/* At every size: on the grid and smoothed, and so in both directions. */
void mt_write_gasp(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    enum { GRIDFIT = 1, DOGRAY = 2, SYMMETRIC_GRIDFIT = 4, SYMMETRIC_SMOOTHING = 8, EVERY_SIZE = 0xFFFF };
    (void)data, (void)summary;
    mt_table_16(table, 1); /* version */
    mt_table_16(table, 1); /* numRanges */
    mt_table_16(table, EVERY_SIZE);
    mt_table_16(table, GRIDFIT | DOGRAY | SYMMETRIC_GRIDFIT | SYMMETRIC_SMOOTHING);
}

/* Dropouts, places where a stroke falls between two rows of pixels, are filled at every size and whatever the
 * transformation (SCANCTRL 511), by smart dropout control (SCANTYPE 4). */
void mt_write_prep(const mt_font_data *data, const mt_summary *summary, mt_table *table) {
    enum { PUSHW_1 = 0xB8, SCANCTRL = 0x85, PUSHB_1 = 0xB0, SCANTYPE = 0x8D };
    static const uint8_t program[] = {PUSHW_1, 511 >> 8, 511 & 0xFF, SCANCTRL, PUSHB_1, 4, SCANTYPE};
    (void)data, (void)summary;
    mt_table_bytes(table, program, sizeof program);
}
