/* Writing a TrueType font from plain data. */
#pragma once

#include "write/font_data.h"

/* Writes glyf, loca, hmtx, cmap (formats 4 and 12), head, hhea, maxp, OS/2, post, name, gasp, prep, with vertical metrics
 * vhea and vmtx, of a font that varies fvar, gvar and STAT, and the extra tables, into bytes for mt_bytes_free. MT_NO_MEMORY, MT_TOO_LARGE, MT_BAD_PARAMETER. */
mt_status mt_font_write(const mt_font_data *data, uint8_t **bytes, size_t *length);
