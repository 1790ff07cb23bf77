#include "support/gsub.h"

#include <string.h>

#include "layout/lookup_builder.h"
#include "sfnt/sfnt.h"
#include "sfnt/table.h"
#include "support/check.h"
#include "support/sample.h"
#include "write/write.h"

enum { NUMBERS_MAX = 16, RULES_MAX = 32, EXTENSION = 7 };

typedef struct rule {
    int count, numbers[NUMBERS_MAX];
} rule;

static int read_rules(const char *text, rule *rules) {
    int count = 0;
    for (const char *at = text; *at; count++) {
        assert_true(count < RULES_MAX);
        rules[count].count = 0;
        for (; *at && *at != ','; at += *at == ' ') {
            char *end;
            rules[count].numbers[rules[count].count++] = (int)strtol(at, &end, 10);
            assert_true(end > at);
            at = end;
        }
        at += *at == ',';
    }
    return count;
}

/* ---- subtables ----------------------------------------------------------------------------------------- */

static void put_coverage(mt_table *table, const rule *rules, int count, int which) {
    mt_table_16(table, 1);
    mt_table_16(table, count);
    for (int i = 0; i < count; i++) mt_table_16(table, rules[i].numbers[which]);
}

static void put_single(mt_table *table, const rule *rules, int count) {
    mt_table_16(table, 2);
    mt_table_16(table, 6 + 2 * count);
    mt_table_16(table, count);
    for (int i = 0; i < count; i++) mt_table_16(table, rules[i].numbers[1]);
    put_coverage(table, rules, count, 0);
}

/* Rows, alternates, and sets of one ligature each. */
static void put_sets(mt_table *table, int type, const rule *rules, int count) {
    int length = 6 + 2 * count, extra = type == 4 ? 2 : 0;
    mt_table_16(table, 1);
    mt_table_16(table, 6 + 2 * count);
    mt_table_16(table, count);
    length += 4 + 2 * count;
    for (int i = 0; i < count; length += 2 * (rules[i++].count + extra)) mt_table_16(table, length);
    put_coverage(table, rules, count, 0);
    for (int i = 0; i < count; i++) {
        int last = rules[i].count - 1;
        if (type == 4) {
            mt_table_16(table, 1);
            mt_table_16(table, 4);
            mt_table_16(table, rules[i].numbers[last]);
        }
        mt_table_16(table, last);
        for (int k = 1; k < last + (type != 4); k++) mt_table_16(table, rules[i].numbers[k]);
    }
}

/* Format 3 of a chained context, or a reverse one, of one rule: coverages of one glyph. */
static void put_context(mt_table *table, int type, const rule *only) {
    bool reverse = type == 8;
    int at = reverse ? 16 : 20;
    mt_table_16(table, reverse ? 1 : 3);
    if (reverse) mt_table_16(table, at);
    mt_table_16(table, 1);
    mt_table_16(table, at + 6);
    if (!reverse) {
        mt_table_16(table, 1);
        mt_table_16(table, at);
    }
    mt_table_16(table, 1);
    mt_table_16(table, at + 12);
    mt_table_16(table, 1);
    if (!reverse) mt_table_16(table, 0);
    mt_table_16(table, only->numbers[3]);
    put_coverage(table, only, 1, 1);
    put_coverage(table, only, 1, 0);
    put_coverage(table, only, 1, 2);
}

static void put_subtable(mt_table *table, const mt_test_lookup *lookup) {
    rule rules[RULES_MAX];
    int count = read_rules(lookup->what, rules);
    if (lookup->type == 1) put_single(table, rules, count);
    if (lookup->type >= 2 && lookup->type <= 4) put_sets(table, lookup->type, rules, count);
    if (lookup->type == 6 || lookup->type == 8) put_context(table, lookup->type, rules);
}

/* ---- the table ----------------------------------------------------------------------------------------- */

/* A lookup of one subtable. */
static void put_lookup(mt_table *table, const mt_test_lookup *lookup, bool extended) {
    mt_table_16(table, extended ? EXTENSION : lookup->type);
    mt_table_16(table, 0);
    mt_table_16(table, 1);
    mt_table_16(table, 8);
    if (extended) {
        mt_table_16(table, 1);
        mt_table_16(table, lookup->type);
        mt_table_32(table, 8);
    }
    put_subtable(table, lookup);
}

static bool is_of(const mt_test_lookup *lookup, const char *language) {
    if (!lookup->language || !language) return lookup->language == language;
    return strcmp(lookup->language, language) == 0;
}

/* The features of a language: each lookup is a feature of its own. */
static void put_system(mt_table *table, const mt_test_lookup *lookups, int count, const char *language) {
    int features = 0;
    for (int i = 0; i < count; i++) features += is_of(&lookups[i], language);
    mt_table_16(table, 0);
    mt_table_16(table, 0xFFFF);
    mt_table_16(table, features);
    for (int i = 0; i < count; i++)
        if (is_of(&lookups[i], language)) mt_table_16(table, i);
}

/* latn with its default language, and TRK. */
static void put_scripts(mt_table *table, const mt_test_lookup *lookups, int count) {
    mt_table system = {0};
    put_system(&system, lookups, count, NULL);
    mt_table_16(table, 1);
    mt_table_bytes(table, "latn", 4);
    mt_table_16(table, 8);
    mt_table_16(table, 10);
    mt_table_16(table, 1);
    mt_table_bytes(table, "TRK ", 4);
    mt_table_16(table, 10 + (int)system.length);
    mt_table_bytes(table, system.bytes, system.length);
    mt_table_free(&system);
    put_system(table, lookups, count, "TRK ");
}

static void put_features(mt_table *table, const mt_test_lookup *lookups, int count) {
    mt_table_16(table, count);
    for (int i = 0; i < count; i++) {
        mt_table_bytes(table, lookups[i].feature, 4);
        mt_table_16(table, 2 + 6 * count + 6 * i);
    }
    for (int i = 0; i < count; i++) {
        bool applies = strcmp(lookups[i].feature, "    ") != 0;
        mt_table_16(table, 0);
        mt_table_16(table, applies);
        mt_table_16(table, i);
    }
}

mt_bytes mt_test_gsub(const mt_test_lookup *lookups, int count, bool extended, mt_arena *arena) {
    mt_table table = {0}, scripts = {0}, features = {0}, bodies = {0};
    mt_bytes bytes;
    put_scripts(&scripts, lookups, count);
    put_features(&features, lookups, count);
    mt_table_32(&table, 0x00010000);
    mt_table_16(&table, 10);
    mt_table_16(&table, 10 + (int)scripts.length);
    mt_table_16(&table, 10 + (int)(scripts.length + features.length));
    mt_table_bytes(&table, scripts.bytes, scripts.length);
    mt_table_bytes(&table, features.bytes, features.length);
    mt_table_16(&table, count);
    for (int i = 0; i < count; i++) {
        mt_table_16(&table, 2 + 2 * count + (int)bodies.length);
        put_lookup(&bodies, &lookups[i], extended);
    }
    mt_table_bytes(&table, bodies.bytes, bodies.length);
    mt_table_free(&scripts);
    mt_table_free(&features);
    mt_table_free(&bodies);
    mt_assert_ok(mt_table_keep(&table, arena, &bytes));
    return bytes;
}

/* ---- fonts --------------------------------------------------------------------------------------------- */

static int by_code_point(const void *p, const void *q) {
    return (int)((const mt_char *)p)->code_point - (int)((const mt_char *)q)->code_point;
}

mt_font *mt_test_gsub_font(const char *path, int glyph_count, const char *chars, const char **names,
                           mt_bytes gsub, mt_arena *arena) {
    mt_font_data data = mt_sample_font(arena);
    data.glyph_count = glyph_count;
    data.glyph_names = names;
    data.char_count = (int)strlen(chars);
    data.chars = mt_arena_new(arena, (size_t)data.char_count + 1, sizeof *data.chars);
    data.glyphs = mt_arena_new(arena, (size_t)glyph_count, sizeof *data.glyphs);
    assert_true(data.chars && data.glyphs);
    for (int i = 0; i < data.char_count; i++)
        data.chars[i] = (mt_char){(unsigned char)chars[i], (uint16_t)(i + 1)};
    qsort(data.chars, (size_t)data.char_count, sizeof *data.chars, by_code_point);
    for (int i = 0; i < glyph_count; i++) {
        int16_t side = (int16_t)(100 + 5 * (i % 100));
        const int16_t square[][2] = {{0, 0}, {0, side}, {side, side}, {side, 0}};
        data.glyphs[i] = mt_sample_glyph(arena, square, 4, true, (uint16_t)(side + 10));
    }
    if (gsub.length) data.extras[data.extra_count++] = (mt_extra_table){MT_TAG('G', 'S', 'U', 'B'), gsub};
    uint8_t *bytes;
    size_t length;
    mt_font *font;
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    mt_sample_save(path, bytes, length);
    mt_bytes_free(bytes);
    mt_assert_ok(mt_font_open(path, &font));
    return font;
}
