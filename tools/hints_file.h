/* The file of --hints, what it says of the two fonts, and what is wrong with it. */
#pragma once

#include "options.h"

/* Reads the file into a table for mt_hint_table_free; NULL where none is given. With --verbose, says which of
 * its characters not all of the `count` fonts have. DONE or, said, COULD_NOT. */
int hints_read(const cli_options *options, mt_font *const *fonts, int count, mt_hint_table **table);

/* Says why the file's hints cannot be used, on MT_BAD_HINTS with its line and with the name of a glyph that the first font has not,
 * and gives COULD_NOT. The table is NULL where there is none. */
int hints_fail(const cli_options *options, mt_status status, const mt_hint_error *error,
               const mt_hint_table *table);
