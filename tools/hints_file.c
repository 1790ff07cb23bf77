#include "hints_file.h"

#include "characters.h"
#include "hints/table.h"
#include "messages.h"
#include "work.h"

#include <errno.h>

#define RANGES_MOST 12 /* ranges in the line on characters left out */

/* The name of a glyph that stands on a line of the file; NULL where none does. */
static const char *name_on(const mt_hint_table *table, int line) {
    for (int i = table ? table->character_count : 0; table && i < table->count; i++)
        if (table->lines[i].name_line == line) return table->lines[i].name;
    return NULL;
}

int hints_fail(const cli_options *options, mt_status status, const mt_hint_error *error,
               const mt_hint_table *table) {
    if (status != MT_BAD_HINTS) return fail_status(options->hints_file, status);
    const char *name = name_on(table, error->line);
    if (name)
        return fail("%s:%d: %s has no glyph /%.255s", options->hints_file, error->line, options->fonts[0],
                    name);
    return fail("%s:%d: %s", options->hints_file, error->line, error->reason);
}

/* Those of the table that a font lacks. */
static mt_status subtract(const mt_hint_table *table, mt_font *const *fonts, int count, characters *lacking) {
    uint32_t code_point, found;
    mt_status status = MT_OK;
    for (uint32_t from = 0; status == MT_OK && mt_hint_table_next_char(table, from, &code_point);
         from = code_point + 1) {
        bool everywhere = true;
        for (int i = 0; i < count; i++)
            everywhere = everywhere && mt_font_next_char(fonts[i], code_point, &found) && found == code_point;
        if (!everywhere) status = characters_add(lacking, code_point);
    }
    return status;
}

static int say_lacking(const cli_options *options, const mt_hint_table *table, mt_font *const *fonts,
                       int count) {
    char ranges[512];
    characters lacking = {0};
    mt_status status = subtract(table, fonts, count, &lacking);
    if (status == MT_OK && lacking.count > 0) {
        characters_describe(&lacking, RANGES_MOST, ranges, sizeof ranges);
        say("%s: hints for %d character%s not in both fonts: %s", options->hints_file, lacking.count,
            lacking.count == 1 ? "" : "s", ranges);
    }
    characters_free(&lacking);
    return status == MT_OK ? DONE : fail_status(options->hints_file, status);
}

int hints_read(const cli_options *options, mt_font *const *fonts, int count, mt_hint_table **table) {
    mt_hint_error error;
    *table = NULL;
    if (!options->hints_file) return DONE;
    errno = 0;
    mt_status status = mt_hint_table_open(options->hints_file, table, &error);
    if (status != MT_OK) return hints_fail(options, status, &error, NULL);
    if (!options->verbose || count < 2) return DONE;
    int outcome = say_lacking(options, *table, fonts, count);
    if (outcome == DONE) return DONE;
    mt_hint_table_free(*table);
    *table = NULL;
    return outcome;
}
