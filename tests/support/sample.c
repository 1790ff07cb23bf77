#include "support/sample.h"

#include "sfnt/sfnt.h"
#include "support/check.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* ---- the font ------------------------------------------------------------------------------------------ */

mt_glyf mt_sample_glyph(mt_arena *arena, const int16_t (*points)[2], int count, bool on, uint16_t advance) {
    mt_glyf glyph = {.advance = advance, .contour_count = 1};
    glyph.ends = mt_arena_new(arena, 1, sizeof *glyph.ends);
    glyph.points = mt_arena_new(arena, (size_t)count, sizeof *glyph.points);
    assert_true(glyph.ends && glyph.points);
    glyph.ends[0] = count - 1;
    for (int i = 0; i < count; i++) glyph.points[i] = (mt_glyf_point){points[i][0], points[i][1], on};
    return glyph;
}

static mt_glyf two_squares(mt_arena *arena) {
    static const int16_t points[][2] = {{0, 0},     {100, 0},   {100, 100}, {0, 100},
                                        {300, 400}, {700, 400}, {700, 800}, {300, 800}};
    mt_glyf glyph = mt_sample_glyph(arena, points, 8, true, 800);
    glyph.contour_count = 2;
    glyph.ends = mt_arena_new(arena, 2, sizeof *glyph.ends);
    assert_non_null(glyph.ends);
    glyph.ends[0] = 3;
    glyph.ends[1] = 7;
    return glyph;
}

static const mt_metrics metrics = {
    .hhea_ascender = 900,
    .hhea_descender = -250,
    .hhea_line_gap = 40,
    .typo_ascender = 750,
    .typo_descender = -250,
    .typo_line_gap = 200,
    .win_ascent = 950,
    .win_descent = 260,
    .x_height = 512,
    .cap_height = 701,
    .underline_position = -75,
    .underline_thickness = 51,
    .strikeout_position = 260,
    .strikeout_size = 49,
    .subscript_size = {650, 600},
    .subscript_offset = {1, 75},
    .superscript_size = {640, 610},
    .superscript_offset = {-2, 350},
    .weight_class = 350,
    .width_class = 4,
    .caret_offset = 3,
    .vhea_ascender = 500,
    .vhea_descender = -500,
    .family_class = 0x0501,
    .panose = {2, 3, 4, 5, 6, 7, 8, 9, 10, 11},
    .use_typo_metrics = true,
};

mt_font_data mt_sample_font(mt_arena *arena) {
    static const int16_t triangle[][2] = {{10, 0}, {610, 0}, {310, 700}},
                         circle[][2] = {{500, 0}, {500, 501}, {-7, 501}, {-7, 0}};
    static const mt_char chars[] = {{'A', 1}, {'o', 2}, {0xE9, 3}, {0x1F600, 4}};
    mt_font_data data = {
        .units = 1000,
        .glyph_count = 5,
        .char_count = 4,
        .metrics = metrics,
        .created = 3000000000,
        .modified = 3900000000,
        .embedding = 4,
        .family = "Sample 形 𝔘",
        .style = "Half Way",
        .unique_id = "sample;1",
        .version = "Version 1.250",
        .copyright = "© é",
        .license = "MIT",
        .license_url = "https://example.org/",
        .description = "A sample",
        .designer = "É. Signer",
        .trademark = "Sample is no trademark",
    };
    data.glyphs = mt_arena_new(arena, 5, sizeof *data.glyphs);
    data.chars = mt_arena_new(arena, 4, sizeof *data.chars);
    assert_true(data.glyphs && data.chars);
    data.glyphs[0].advance = data.glyphs[4].advance = 500;
    data.glyphs[1] = mt_sample_glyph(arena, triangle, 3, true, 620);
    data.glyphs[2] = mt_sample_glyph(arena, circle, 4, false, 493);
    data.glyphs[3] = two_squares(arena);
    memcpy(data.chars, chars, sizeof chars);
    return data;
}

/* ---- files --------------------------------------------------------------------------------------------- */

char *mt_sample_path(mt_arena *arena, const char *directory, const char *name) {
    size_t size = strlen(directory) + strlen(name) + 2;
    char *path = mt_arena_new(arena, size, 1);
    assert_non_null(path);
    snprintf(path, size, "%s/%s", directory, name);
    return path;
}

char *mt_sample_directory(mt_arena *arena) {
    const char *where = getenv("TMPDIR");
    char *path = mt_sample_path(arena, where ? where : "/tmp", "morphotype-test-XXXXXX");
    assert_non_null(mkdtemp(path));
    return path;
}

int mt_sample_count(const char *directory) {
    int count = 0;
    DIR *entries = opendir(directory);
    assert_non_null(entries);
    while (readdir(entries)) count++;
    closedir(entries);
    return count - 2; /* . and .. */
}

void mt_sample_remove(const char *directory) {
    mt_arena arena = {0};
    DIR *entries = opendir(directory);
    assert_non_null(entries);
    for (struct dirent *entry; (entry = readdir(entries));)
        if (strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0)
            assert_int_equal(remove(mt_sample_path(&arena, directory, entry->d_name)), 0);
    closedir(entries);
    assert_int_equal(rmdir(directory), 0);
    mt_arena_release(&arena);
}

void mt_sample_save(const char *path, const void *bytes, size_t length) {
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
}

uint8_t *mt_sample_load(mt_arena *arena, const char *path, size_t *length) {
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_int_equal(fseek(file, 0, SEEK_END), 0);
    *length = (size_t)ftell(file);
    rewind(file);
    uint8_t *bytes = mt_arena_new(arena, *length, 1);
    assert_non_null(bytes);
    assert_int_equal(fread(bytes, 1, *length, file), *length);
    fclose(file);
    return bytes;
}

/* ---- tables -------------------------------------------------------------------------------------------- */

const uint8_t *mt_sample_table(const uint8_t *bytes, const char *tag, size_t *length) {
    for (unsigned i = 0; i < mt_read_u16(bytes + 4); i++) {
        const uint8_t *entry = bytes + 12 + 16 * i;
        if (memcmp(entry, tag, 4) != 0) continue;
        if (length) *length = mt_read_u32(entry + 12);
        return bytes + mt_read_u32(entry + 8);
    }
    return NULL;
}
