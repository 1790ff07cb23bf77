#include "kerning/writer.h"

void mt_pair_write_header(mt_table *table, int format, size_t coverage, mt_value_format values) {
    mt_table_16(table, format);
    mt_table_16(table, (int)coverage);
    mt_table_16(table, mt_value_format_field(values, 0));
    mt_table_16(table, mt_value_format_field(values, MT_VALUE_PARTS));
}
