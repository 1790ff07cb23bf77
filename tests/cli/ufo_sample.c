/* For test_ufo.py:
 *
 *     ufo-sample OUT.ufo     a UFO of the sample font, with references, vertical metrics and kerning
 *     ufo-sample             the file names of the glyph names on stdin, a line each */
#include "save/ufo.h"
#include "save/ufo_parts.h"
#include "support/check.h"
#include "support/sample.h"

#include <stdio.h>
#include <string.h>

/* The sample font with a sixth glyph, made of A and o. */
static mt_font_data with_composite(mt_arena *arena) {
    static mt_glyf_reference references[] = {{.glyph = 1}, {.glyph = 2, .dx = 30, .dy = -20}};
    static mt_char_variation variants[] = {
        {0xFE00, 'A', 5, false}, {0xFE00, 'o', 2, true}, {0xE0100, 'o', 5, false}};
    mt_font_data data = mt_sample_font(arena);
    mt_glyf *glyphs = mt_arena_new(arena, 6, sizeof *glyphs);
    assert_non_null(glyphs);
    memcpy(glyphs, data.glyphs, 5 * sizeof *glyphs);
    glyphs[5] = (mt_glyf){.advance = 640, .reference_count = 2, .references = references};
    for (int i = 0; i < 6; i++) {
        glyphs[i].height = (uint16_t)(1000 + i);
        glyphs[i].origin = (int16_t)(880 - i);
    }
    data.glyphs = glyphs;
    data.glyph_count = 6;
    data.metrics.vertical = true;
    data.metrics.vhea_ascender = 500;
    data.metrics.vhea_descender = -500;
    data.metrics.family_class = 0x0805;
    data.metrics.italic_angle = -9.5;
    data.variants = variants;
    data.variant_count = 3;
    data.copyright = "© & é < 形\1";
    data.designer = "D";
    data.trademark = "T";
    return data;
}

/* A against the group of o and é, that group against A, é against o as glyphs; a group without glyphs. */
static const uint16_t rounds[] = {2, 3}, triangle[] = {1};
static const mt_kerning_group left[] = {{1, triangle}, {2, rounds}}, right[] = {{0, NULL}, {2, rounds}};
static const mt_kerning_pair pairs[] = {
    {.left = 1, .right = 1, .value = 7},
    {.left = 0, .right = 1, .value = -80},
    {.left_is_glyph = true, .left = 3, .right_is_glyph = true, .right = 2, .value = 11},
    {.left = 1, .right_is_glyph = true, .right = 1, .value = -40},
    {.left = 0, .right = 0, .value = 99},
};
static const mt_kerning kerning = {2, 2, left, right, sizeof pairs / sizeof *pairs, pairs};

static void write_sample(const char *path) {
    mt_arena arena = {0};
    mt_folder folder;
    mt_font_data data = with_composite(&arena);
    int unsaid = 0;
    data.kerning = &kerning;
    data.curves = MT_CURVES_QUADRATIC;
    mt_assert_ok(mt_folder_begin(path, &folder));
    mt_assert_ok(mt_ufo_write(&data, &folder, &unsaid));
    assert_int_equal(unsaid, 0);
    mt_assert_ok(mt_folder_place(&folder, MT_UFO_MARK));
    mt_folder_free(&folder);
    mt_arena_release(&arena);
}

static void print_file_names(void) {
    enum { NAMES_MAX = 4096, NAME_ROOM = 1024 };
    static char lines[NAMES_MAX][NAME_ROOM];
    static const char *names[NAMES_MAX];
    const char **files;
    mt_arena arena = {0};
    int count = 0;
    while (count < NAMES_MAX && fgets(lines[count], NAME_ROOM, stdin)) {
        lines[count][strcspn(lines[count], "\n")] = '\0';
        names[count] = lines[count];
        count++;
    }
    mt_assert_ok(mt_ufo_file_names(names, count, &arena, &files));
    for (int i = 0; i < count; i++) puts(files[i]);
    mt_arena_release(&arena);
}

int main(int argc, char **argv) {
    if (argc > 1)
        write_sample(argv[1]);
    else
        print_file_names();
    return 0;
}
