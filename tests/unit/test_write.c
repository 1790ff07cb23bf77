#include "geometry/limits.h"
#include "sfnt/sfnt.h"
#include "sfnt/table.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/random.h"
#include "support/sample.h"
#include "write/extent.h"
#include "write/max_context.h"
#include "write/write.h"

#include <limits.h>
#include <math.h>
#include <string.h>

static uint8_t *write_font(const mt_font_data *data, size_t *length) {
    uint8_t *bytes;
    mt_assert_ok(mt_font_write(data, &bytes, length));
    return bytes;
}

/* Writes the font and opens what was written. */
static mt_font *reopen(const mt_font_data *data) {
    size_t length;
    mt_font *font;
    uint8_t *bytes = write_font(data, &length);
    const char *path = mt_sample_path(&arena, directory, "reopened.ttf");
    mt_sample_save(path, bytes, length);
    mt_bytes_free(bytes);
    mt_assert_ok(mt_font_open(path, &font));
    return font;
}

static void assert_refused(const mt_font_data *data, mt_status status) {
    uint8_t *bytes = NULL;
    size_t length = 77;
    assert_int_equal(mt_font_write(data, &bytes, &length), status);
    assert_null(bytes);
    assert_int_equal(length, 77);
}

static int16_t read_i16(const uint8_t *bytes) {
    return (int16_t)mt_read_u16(bytes);
}

/* ---- the container ------------------------------------------------------------------------------------- */

static uint32_t checksum(const uint8_t *bytes, size_t length) {
    uint32_t sum = 0;
    for (size_t i = 0; i < length; i++) sum += (uint32_t)bytes[i] << (24 - 8 * (i % 4));
    return sum;
}

static void checksums_are_right(void **state) {
    (void)state;
    size_t length;
    mt_font_data data = mt_sample_font(&arena);
    uint8_t *bytes = write_font(&data, &length);
    assert_int_equal(checksum(bytes, length), 0xB1B0AFBA);
    assert_int_equal(mt_read_u16(bytes + 4), 12);
    for (unsigned i = 0; i < 12; i++) {
        const uint8_t *entry = bytes + 12 + 16 * i;
        uint32_t sum = checksum(bytes + mt_read_u32(entry + 8), mt_read_u32(entry + 12));
        if (memcmp(entry, "head", 4) == 0)
            sum -= mt_read_u32(bytes + mt_read_u32(entry + 8) + 8); /* its adjustment */
        assert_int_equal(sum, mt_read_u32(entry + 4));
        if (i) assert_true(memcmp(entry - 16, entry, 4) < 0);
    }
    mt_bytes_free(bytes);
}

static void same_input_same_bytes(void **state) {
    (void)state;
    size_t first_length, second_length;
    mt_font_data data = mt_sample_font(&arena);
    uint8_t *first = write_font(&data, &first_length), *second = write_font(&data, &second_length);
    assert_int_equal(first_length, second_length);
    assert_memory_equal(first, second, first_length);
    mt_bytes_free(first);
    mt_bytes_free(second);
}

/* ---- outlines ------------------------------------------------------------------------------------------ */

/* A glyph with differences of every size that glyf tells apart, and runs of equal flags longer than a repeat
 * counts. */
static mt_glyf random_glyph(mt_random *random) {
    static const int16_t reaches[] = {0, 1, 255, 256, 3000, 16000};
    int count = mt_random_between(random, 1, mt_random_one_in(random, 4) ? 1200 : 40);
    mt_glyf glyph = {.advance = (uint16_t)mt_random_between(random, 0, UINT16_MAX)};
    glyph.points = mt_arena_new(&arena, (size_t)count, sizeof *glyph.points);
    glyph.ends = mt_arena_new(&arena, (size_t)count, sizeof *glyph.ends);
    assert_true(glyph.points && glyph.ends);
    int reach = reaches[mt_random_between(random, 0, 5)];
    for (int i = 0; i < count; i++) {
        if (mt_random_one_in(random, 30)) reach = reaches[mt_random_between(random, 0, 5)];
        glyph.points[i].x = (int16_t)mt_random_between(random, -reach, reach);
        glyph.points[i].y = (int16_t)mt_random_between(random, -reach, reach);
        glyph.points[i].on = mt_random_one_in(random, 2);
        if (i == count - 1 || mt_random_one_in(random, 10)) glyph.ends[glyph.contour_count++] = i;
    }
    return glyph;
}

/* Reads 'glyf' as the specification has it, apart from the code that wrote it, and compares. */
static void assert_reads_back(const uint8_t *bytes, size_t length, const mt_glyf *glyph) {
    int count = glyph->ends[glyph->contour_count - 1] + 1, x = 0, y = 0;
    const uint8_t *at = bytes + 10;
    assert_int_equal(read_i16(bytes), glyph->contour_count);
    for (int i = 0; i < glyph->contour_count; i++, at += 2) assert_int_equal(mt_read_u16(at), glyph->ends[i]);
    assert_int_equal(mt_read_u16(at), 0);
    at += 2;
    uint8_t *flags = mt_test_new((size_t)count, 1);
    for (int i = 0; i < count;) {
        int times = *at & 8 ? at[1] + 1 : 1;
        assert_true(i + times <= count && !(*at & 0xC0));
        memset(flags + i, *at, (size_t)times);
        at += *at & 8 ? 2 : 1;
        i += times;
    }
    for (int i = 0; i < count; i++) {
        if (flags[i] & 2)
            x += flags[i] & 16 ? *at : -*at;
        else if (!(flags[i] & 16))
            x += read_i16(at);
        at += flags[i] & 2 ? 1 : flags[i] & 16 ? 0 : 2;
        assert_int_equal(x, glyph->points[i].x);
        assert_int_equal(flags[i] & 1, glyph->points[i].on);
        assert_true(read_i16(bytes + 2) <= x && x <= read_i16(bytes + 6));
    }
    for (int i = 0; i < count; i++) {
        if (flags[i] & 4)
            y += flags[i] & 32 ? *at : -*at;
        else if (!(flags[i] & 32))
            y += read_i16(at);
        at += flags[i] & 4 ? 1 : flags[i] & 32 ? 0 : 2;
        assert_int_equal(y, glyph->points[i].y);
        assert_true(read_i16(bytes + 4) <= y && y <= read_i16(bytes + 8));
    }
    free(flags);
    assert_in_range(length - (size_t)(at - bytes), 0, 1);
}

static void outlines_read_back(void **state) {
    (void)state;
    enum { GLYPHS = 60 };
    mt_font_data data = mt_sample_font(&arena);
    for (int number = 0; number < mt_test_cases(5); number++) {
        mt_random random = mt_random_case(number);
        size_t length;
        data.glyphs = mt_arena_new(&arena, GLYPHS, sizeof *data.glyphs);
        assert_non_null(data.glyphs);
        data.glyph_count = GLYPHS;
        for (int i = 0; i < GLYPHS; i++) data.glyphs[i] = random_glyph(&random);
        uint8_t *bytes = write_font(&data, &length);
        const uint8_t *glyf = mt_sample_table(bytes, "glyf", NULL),
                      *loca = mt_sample_table(bytes, "loca", NULL);
        bool is_long = mt_read_u16(mt_sample_table(bytes, "head", NULL) + 50);
        for (int i = 0; i < GLYPHS; i++) {
            size_t start = is_long ? mt_read_u32(loca + 4 * i) : 2 * mt_read_u16(loca + 2 * i);
            size_t end = is_long ? mt_read_u32(loca + 4 * i + 4) : 2 * mt_read_u16(loca + 2 * i + 2);
            assert_reads_back(glyf + start, end - start, &data.glyphs[i]);
        }
        mt_bytes_free(bytes);
    }
}

static void offsets_grow_long(void **state) {
    (void)state;
    mt_random random = mt_random_case(0);
    mt_font_data data = mt_sample_font(&arena);
    const int count = 3000;
    data.glyphs = mt_arena_new(&arena, (size_t)count, sizeof *data.glyphs);
    assert_non_null(data.glyphs);
    for (int i = 0; i < count; i++) data.glyphs[i] = random_glyph(&random);
    for (data.glyph_count = 5; data.glyph_count <= count; data.glyph_count += count - 5) {
        size_t length, glyf, loca;
        uint8_t *bytes = write_font(&data, &length);
        mt_sample_table(bytes, "glyf", &glyf);
        mt_sample_table(bytes, "loca", &loca);
        bool is_long = mt_read_u16(mt_sample_table(bytes, "head", NULL) + 50);
        assert_int_equal(is_long, data.glyph_count == count);
        assert_int_equal(is_long, glyf > 0x1FFFE);
        assert_int_equal(loca, (is_long ? 4 : 2) * (size_t)(data.glyph_count + 1));
        mt_bytes_free(bytes);
    }
}

/* Glyph 4 becomes A with the two squares high above it, and glyph 0 that one moved. */
static mt_font_data with_references(void) {
    static const mt_glyf_reference parts[] = {{1, 0, 0, true}, {3, -20, 900, false}},
                                   moved[] = {{4, 300, -7, false}};
    mt_font_data data = mt_sample_font(&arena);
    mt_glyf *nested = &data.glyphs[0], *composite = &data.glyphs[4];
    nested->reference_count = 1;
    nested->references = mt_arena_new(&arena, 1, sizeof parts[0]);
    composite->reference_count = 2;
    composite->references = mt_arena_new(&arena, 2, sizeof parts[0]);
    assert_true(nested->references && composite->references);
    memcpy(nested->references, moved, sizeof moved);
    memcpy(composite->references, parts, sizeof parts);
    composite->advance = data.glyphs[1].advance;
    return data;
}

static void references_read_back(void **state) {
    (void)state;
    size_t length;
    mt_font_data data = with_references();
    mt_outline part, whole;
    mt_references references;
    double advance;
    mt_font *font = reopen(&data);
    mt_assert_ok(mt_font_references(font, 4, &arena, &references));
    assert_int_equal(references.count, 2);
    assert_int_equal(references.list[0].glyph, 1);
    assert_int_equal(references.list[1].glyph, 3);
    assert_int_equal(references.list[1].dx, -20);
    assert_int_equal(references.list[1].dy, 900);
    mt_assert_ok(mt_font_references(font, 0, &arena, &references));
    assert_true(references.count == 1 && references.list[0].glyph == 4 && references.list[0].dx == 300);
    mt_assert_ok(mt_font_references(font, 3, &arena, &references));
    assert_int_equal(references.count, 0);
    mt_assert_ok(mt_font_outline(font, 1, &arena, &part, &advance));
    mt_assert_ok(mt_font_outline(font, 0, &arena, &whole, &advance));
    assert_int_equal(whole.count, 3);
    for (int i = 0; i < part.contours[0].count; i++) {
        mt_point p = part.contours[0].segments[i].end, q = whole.contours[0].segments[i].end;
        assert_true(q.x - p.x == 300 * 256 && q.y - p.y == -7 * 256);
    }
    mt_font_close(font);
    uint8_t *bytes = write_font(&data, &length);
    const uint8_t *maxp = mt_sample_table(bytes, "maxp", NULL), *head = mt_sample_table(bytes, "head", NULL);
    static const int counts[] = {8, 2, 11, 3}; /* points and contours, of a glyph and of a composite */
    for (int i = 0; i < 4; i++) assert_int_equal(mt_read_u16(maxp + 6 + 2 * i), counts[i]);
    assert_int_equal(mt_read_u16(maxp + 28), 2); /* references */
    assert_int_equal(mt_read_u16(maxp + 30), 2); /* depth */
    assert_int_equal(read_i16(head + 42), 1700); /* yMax: the squares' */
    mt_bytes_free(bytes);
}

static void bad_references(void **state) {
    (void)state;
    mt_font_data data = with_references();
    data.glyphs[4].references[1].glyph = 5; /* there is none */
    assert_refused(&data, MT_BAD_PARAMETER);
    data.glyphs[4].references[1].glyph = 0; /* in a circle */
    assert_refused(&data, MT_BAD_PARAMETER);
    data.glyphs[4].references[1].glyph = 4;
    assert_refused(&data, MT_BAD_PARAMETER);
    data = with_references();
    data.glyphs[3].reference_count = 1;
    data.glyphs[3].references = data.glyphs[4].references;
    assert_refused(&data, MT_BAD_PARAMETER); /* contours and references */
    data = with_references();
    data.glyphs[4].references[1].dy = 32000; /* 800 high */
    assert_refused(&data, MT_TOO_LARGE);
}

/* Each glyph refers to the one before: as many deep as are let pass, and one more. */
static void references_are_only_so_deep(void **state) {
    (void)state;
    enum { COUNT = MT_GLYF_DEPTH_MAX + 3 };
    mt_font_data data = mt_sample_font(&arena);
    size_t length;
    data.glyphs = mt_arena_new(&arena, COUNT, sizeof *data.glyphs);
    mt_glyf_reference *references = mt_arena_new(&arena, COUNT, sizeof *references);
    assert_true(data.glyphs && references);
    data.glyphs[1] = mt_sample_font(&arena).glyphs[1];
    for (int i = 2; i < COUNT; i++) {
        references[i] = (mt_glyf_reference){(uint16_t)(i - 1), 1, 0, false};
        data.glyphs[i].references = &references[i];
        data.glyphs[i].reference_count = 1;
    }
    data.glyph_count = COUNT - 1;
    mt_bytes_free(write_font(&data, &length));
    data.glyph_count = COUNT;
    assert_refused(&data, MT_BAD_PARAMETER);
}

static void nothing_drawn(void **state) {
    (void)state;
    size_t length, glyf;
    mt_font_data data = mt_sample_font(&arena);
    data.glyph_count = 1;
    data.char_count = 0;
    uint8_t *bytes = write_font(&data, &length);
    assert_non_null(mt_sample_table(bytes, "glyf", &glyf));
    assert_int_equal(glyf, 1);
    assert_int_equal(mt_read_u16(mt_sample_table(bytes, "maxp", NULL) + 4), 1);
    mt_bytes_free(bytes);
}

/* ---- metrics ------------------------------------------------------------------------------------------- */

static void trailing_advances_are_shared(void **state) {
    (void)state;
    size_t length, hmtx;
    mt_font_data data = mt_sample_font(&arena);
    data.glyphs[2].advance = data.glyphs[3].advance = data.glyphs[4].advance = 700;
    uint8_t *bytes = write_font(&data, &length);
    const uint8_t *metrics = mt_sample_table(bytes, "hmtx", &hmtx),
                  *hhea = mt_sample_table(bytes, "hhea", NULL);
    assert_int_equal(mt_read_u16(hhea + 34), 3);
    assert_int_equal(hmtx, 4 * 3 + 2 * 2);
    assert_int_equal(mt_read_u16(metrics + 8), 700);
    assert_int_equal(read_i16(metrics + 10), -7); /* o's left side bearing */
    assert_int_equal(mt_read_u16(hhea + 10), 700);
    assert_int_equal(read_i16(hhea + 12), -7);
    assert_int_equal(read_i16(hhea + 14), 0); /* é: 700 - 700 */
    assert_int_equal(read_i16(hhea + 16), 700);
    mt_bytes_free(bytes);
}

/* Heights that repeat are stored once; the top side bearing is what the top is under the origin. */
static void vertical_metrics(void **state) {
    (void)state;
    size_t length, vmtx;
    mt_vertical vertical;
    mt_font_data data = mt_sample_font(&arena);
    data.metrics.vertical = true;
    data.metrics.vhea_ascender = 480;
    data.metrics.vhea_line_gap = 33;
    for (int i = 0; i < 5; i++) {
        data.glyphs[i].height = i < 2 ? 900 : 1000;
        data.glyphs[i].origin = 880;
    }
    data.glyphs[2].origin = 400;
    uint8_t *bytes = write_font(&data, &length);
    const uint8_t *heights = mt_sample_table(bytes, "vmtx", &vmtx),
                  *vhea = mt_sample_table(bytes, "vhea", NULL);
    assert_int_equal(mt_read_u16(vhea + 34), 3);
    assert_int_equal(vmtx, 4 * 3 + 2 * 2);
    assert_int_equal(mt_read_u16(heights + 4), 900);
    assert_int_equal(read_i16(heights + 6), 880 - 700);  /* A */
    assert_int_equal(read_i16(heights + 10), 400 - 501); /* o */
    assert_int_equal(read_i16(heights + 12), 880 - 800); /* é */
    assert_int_equal(read_i16(vhea + 4), 480);
    assert_int_equal(read_i16(vhea + 6), -500);
    assert_int_equal(read_i16(vhea + 8), 33);
    assert_int_equal(mt_read_u16(vhea + 10), 1000);
    assert_int_equal(read_i16(vhea + 12), -101);            /* the least top side bearing */
    assert_int_equal(read_i16(vhea + 14), 900 - 180 - 700); /* the least at the bottom: A's */
    assert_int_equal(read_i16(vhea + 16), 880);             /* the farthest reach: A's and é's */
    mt_bytes_free(bytes);
    mt_font *font = reopen(&data);
    for (uint32_t i = 0; i < 5; i++) {
        mt_assert_ok(mt_font_vertical(font, i, &vertical));
        assert_float_equal(vertical.advance, 256.0 * data.glyphs[i].height, 0);
        assert_float_equal(vertical.origin, 256.0 * data.glyphs[i].origin, 0);
    }
    mt_font_close(font);
}

static void no_vertical_metrics(void **state) {
    (void)state;
    size_t length;
    mt_vertical vertical;
    mt_font_data data = mt_sample_font(&arena);
    uint8_t *bytes = write_font(&data, &length);
    assert_true(!mt_sample_table(bytes, "vhea", NULL) && !mt_sample_table(bytes, "vmtx", NULL));
    mt_bytes_free(bytes);
    mt_font *font = reopen(&data);
    mt_assert_ok(mt_font_vertical(font, 1, &vertical));
    assert_float_equal(vertical.advance, 256.0 * (750 + 250), 0); /* the typographic lines' */
    assert_float_equal(vertical.origin, 256.0 * 750, 0);
    mt_font_close(font);
}

static void smooth_at_every_size(void **state) {
    (void)state;
    size_t length, gasp, prep;
    static const uint8_t range[] = {0, 1, 0, 1, 0xFF, 0xFF, 0, 15},
                         program[] = {0xB8, 1, 0xFF, 0x85, 0xB0, 4, 0x8D};
    mt_font_data data = mt_sample_font(&arena);
    uint8_t *bytes = write_font(&data, &length);
    const uint8_t *ranges = mt_sample_table(bytes, "gasp", &gasp),
                  *run = mt_sample_table(bytes, "prep", &prep);
    assert_true(gasp == sizeof range && prep == sizeof program);
    assert_memory_equal(ranges, range, gasp);
    assert_memory_equal(run, program, prep);
    assert_int_equal(mt_read_u16(mt_sample_table(bytes, "maxp", NULL) + 24), 1); /* maxStackElements */
    mt_bytes_free(bytes);
}

/* A monospaced font says so in PANOSE too, where its family knows the proportion. */
static void panose_tells_monospaced(void **state) {
    (void)state;
    static const uint8_t families[][3] = {
        {0, 2, 9}, {2, 2, 9}, {3, 3, 5}}; /* given; and then, with the proportion */
    for (int i = 0; i < 3; i++) {
        size_t length;
        mt_font_data data = mt_sample_font(&arena);
        data.metrics.monospaced = true;
        data.metrics.panose[0] = families[i][0];
        uint8_t *bytes = write_font(&data, &length);
        const uint8_t *panose = mt_sample_table(bytes, "OS/2", NULL) + 32;
        assert_int_equal(panose[0], families[i][1]);
        assert_int_equal(panose[3], families[i][2]);
        mt_bytes_free(bytes);
    }
}

/* A GSUB of one lookup of one subtable. */
static mt_bytes one_lookup(uint16_t type, const uint16_t *subtable, int count) {
    uint16_t words[64] = {1, 0,    0, 0, 10, 1,
                          4, type, 0, 1, 8}; /* the list at 10, its lookup at 14, the subtable at 22 */
    uint8_t *bytes = mt_arena_new(&arena, 200, 1);
    assert_non_null(bytes);
    memcpy(words + 11, subtable, (size_t)count * sizeof *subtable);
    for (int i = 0; i < 11 + count; i++) {
        bytes[2 * i] = (uint8_t)(words[i] >> 8);
        bytes[2 * i + 1] = (uint8_t)words[i];
    }
    return (mt_bytes){bytes, (size_t)(22 + 2 * count)};
}

static void contexts_are_measured(void **state) {
    (void)state;
    static const uint16_t ligature[] = {1, 0, 1, 8, 2, 6, 10, 99, 3, 99, 2}, context[] = {3, 4, 0},
                          chain[] = {3, 2, 0, 0, 1, 0, 2, 0, 0, 0},
                          chain_rule[] = {1, 0, 1, 8, 1, 4, 1, 9, 3, 8, 8, 4, 7, 7, 7, 7, 0},
                          reverse[] = {1, 0, 1, 0, 5, 0, 0, 0, 0, 0, 0},
                          extension[] = {1, 6, 0, 8, 3, 0, 7, 0};
    const struct {
        unsigned type;
        const uint16_t *subtable;
        int count, most;
    } cases[] = {{1, context, 1, 1},     {4, ligature, 11, 3}, {5, context, 3, 4},   {6, chain, 10, 3},
                 {6, chain_rule, 17, 7}, {8, reverse, 11, 6},  {7, extension, 8, 7}, {99, context, 3, 0}};
    for (int i = 0; i < 8; i++) {
        mt_bytes table = one_lookup((uint16_t)cases[i].type, cases[i].subtable, cases[i].count);
        assert_int_equal(mt_max_context(table, true), cases[i].most);
        for (; table.length > 0; table.length--) assert_in_range(mt_max_context(table, true), 0, 99);
    }
    static const uint16_t pair[] = {1};
    assert_int_equal(mt_max_context(one_lookup(2, pair, 1), false), 2);
    assert_int_equal(mt_max_context(one_lookup(2, pair, 1), true), 1);
    size_t length;
    mt_font_data data = mt_sample_font(&arena);
    data.extra_count = 1;
    data.extras[0] = (mt_extra_table){MT_TAG('G', 'S', 'U', 'B'), one_lookup(4, ligature, 11)};
    uint8_t *bytes = write_font(&data, &length);
    assert_int_equal(mt_read_u16(mt_sample_table(bytes, "OS/2", NULL) + 94), 3);
    mt_bytes_free(bytes);
}

static void figures_are_kept_in_range(void **state) {
    (void)state;
    size_t length;
    mt_font_data data = mt_sample_font(&arena);
    data.metrics.typo_ascender = 1e9;
    data.metrics.typo_descender = -1e300;
    data.metrics.typo_line_gap = NAN;
    data.metrics.win_ascent = -5;
    data.metrics.win_descent = 99.5;
    uint8_t *bytes = write_font(&data, &length);
    const uint8_t *os2 = mt_sample_table(bytes, "OS/2", NULL);
    assert_int_equal(read_i16(os2 + 68), INT16_MAX);
    assert_int_equal(read_i16(os2 + 70), INT16_MIN);
    assert_int_equal(read_i16(os2 + 72), 0);
    assert_int_equal(mt_read_u16(os2 + 74), 0);
    assert_int_equal(mt_read_u16(os2 + 76), 100);
    mt_bytes_free(bytes);
}

static void coverage_is_told(void **state) {
    (void)state;
    size_t length;
    mt_font_data data = mt_sample_font(&arena);
    static const mt_char chars[] = {{'A', 1},    {0x416, 1},  {0x4E00, 1},
                                    {0xAC00, 1}, {0xE000, 1}, {0x1F600, 4}};
    data.chars = (mt_char *)chars;
    data.char_count = 6;
    uint8_t *bytes = write_font(&data, &length);
    const uint8_t *os2 = mt_sample_table(bytes, "OS/2", NULL);
    assert_int_equal(mt_read_u32(os2 + 42), 1u << 0 | 1u << 9);
    assert_int_equal(mt_read_u32(os2 + 46),
                     1u << (56 - 32) | 1u << (57 - 32) | 1u << (59 - 32) | 1u << (60 - 32));
    assert_int_equal(mt_read_u32(os2 + 50) | mt_read_u32(os2 + 54), 0);
    assert_int_equal(mt_read_u16(os2 + 64), 'A');
    assert_int_equal(mt_read_u16(os2 + 66), 0xFFFF);
    mt_bytes_free(bytes);
}

/* ---- characters ---------------------------------------------------------------------------------------- */

/* `count` characters from `first`, `step` apart, all on glyph 1, then U+1F600. */
static void map_many(mt_font_data *data, uint32_t first, uint32_t step, int count) {
    data->chars = mt_arena_new(&arena, (size_t)count + 1, sizeof *data->chars);
    assert_non_null(data->chars);
    for (int i = 0; i < count; i++) data->chars[i] = (mt_char){first + step * (uint32_t)i, 1};
    data->chars[count] = (mt_char){0x1F600, 4};
    data->char_count = count + 1;
}

static void assert_maps(const mt_font_data *data) {
    mt_font *font = reopen(data);
    uint32_t from = 0, found;
    for (int i = 0; i < data->char_count; i++, from = found + 1) {
        assert_true(mt_font_next_char(font, from, &found));
        assert_int_equal(found, data->chars[i].code_point);
        assert_int_equal(mt_font_glyph(font, found), data->chars[i].glyph);
    }
    assert_false(mt_font_next_char(font, from, &found));
    mt_font_close(font);
}

static unsigned count_encodings(const mt_font_data *data) {
    size_t length;
    uint8_t *bytes = write_font(data, &length);
    unsigned count = mt_read_u16(mt_sample_table(bytes, "cmap", NULL) + 2);
    mt_bytes_free(bytes);
    return count;
}

static void characters_in_the_bmp(void **state) {
    (void)state;
    mt_font_data data = mt_sample_font(&arena);
    data.char_count = 3;
    assert_int_equal(count_encodings(&data), 2);
    assert_maps(&data);
    map_many(&data, 1, 3, 8188);
    data.char_count = 8188; /* as many segments as format 4 holds */
    assert_int_equal(count_encodings(&data), 2);
    assert_maps(&data);
}

static void characters_beyond_format_4(void **state) {
    (void)state;
    mt_font_data data = mt_sample_font(&arena);
    assert_int_equal(count_encodings(&data), 4);
    assert_maps(&data);
    map_many(&data, 1, 3, 8189);
    data.char_count = 8189;
    assert_int_equal(count_encodings(&data), 4);
    assert_maps(&data);
    map_many(&data, 0xE000, 1, 0x2000); /* up to U+FFFF */
    data.char_count = 0x2000;
    assert_int_equal(count_encodings(&data), 4);
    assert_maps(&data);
    map_many(&data, 0, 2, 25000);
    assert_maps(&data);
}

/* ---- names --------------------------------------------------------------------------------------------- */

/* The name's text, each UTF-16 unit beyond ASCII as '?'; NULL when there is none. */
static const char *find_name(const uint8_t *bytes, int id) {
    static char text[256];
    const uint8_t *name = mt_sample_table(bytes, "name", NULL);
    for (unsigned i = 0; i < mt_read_u16(name + 2); i++) {
        const uint8_t *record = name + 6 + 12 * i;
        if ((int)mt_read_u16(record + 6) != id) continue;
        const uint8_t *units = name + mt_read_u16(name + 4) + mt_read_u16(record + 10);
        unsigned count = mt_read_u16(record + 8) / 2;
        for (unsigned u = 0; u < count; u++) text[u] = units[2 * u] ? '?' : (char)units[2 * u + 1];
        text[count] = '\0';
        return text;
    }
    return NULL;
}

/* `own` is what old applications take to the family's name; of a split style the true one stands in names 16 and 17. */
static void assert_style(const char *style, double weight, double angle, const char *linked, const char *own,
                         bool split) {
    size_t length;
    mt_font_data data = mt_sample_font(&arena);
    data.family = "Fam";
    data.style = style;
    data.metrics.weight_class = weight;
    data.metrics.italic_angle = angle;
    data.metrics.use_typo_metrics = false;
    uint8_t *bytes = write_font(&data, &length);
    bool bold = strstr(linked, "Bold") != NULL, italic = strstr(linked, "Italic") != NULL;
    assert_string_equal(find_name(bytes, 2), linked);
    assert_int_equal(find_name(bytes, 17) != NULL, split);
    assert_int_equal(find_name(bytes, 16) != NULL, split);
    if (split) assert_string_equal(find_name(bytes, 17), style);
    assert_string_equal(find_name(bytes, 1) + strlen("Fam"), own);
    assert_int_equal(mt_read_u16(mt_sample_table(bytes, "head", NULL) + 44),
                     (bold ? 1 : 0) + (italic ? 2 : 0));
    int selection = (bold ? 32 : 0) + (italic ? 1 : 0);
    assert_int_equal(mt_read_u16(mt_sample_table(bytes, "OS/2", NULL) + 62), selection ? selection : 64);
    mt_bytes_free(bytes);
}

static void styles_are_linked(void **state) {
    (void)state;
    assert_style("Regular", 400, 0, "Regular", "", false);
    assert_style("Bold", 700, 0, "Bold", "", false);
    assert_style("Italic", 400, -12, "Italic", "", false);
    assert_style("Bold Italic", 700, -12, "Bold Italic", "", false);
    assert_style("Half Way", 550, 0, "Regular", " Half Way", true);
    assert_style("Half Way", 550, -4, "Italic", " Half Way", true);
    assert_style("Half Way", 900, 0, "Bold", " Half Way", true);
}

/* What the name says counts for more than the figures. */
static void styles_are_named(void **state) {
    (void)state;
    assert_style("Black", 900, 0, "Regular", " Black", true);
    assert_style("Regular", 900, -1, "Regular", "", false);
    assert_style("Bold", 550, 0, "Bold", "", false);
    assert_style("Light", 700, 0, "Regular", " Light", true);
    assert_style("SemiBold Italic", 600, -12, "Italic", " SemiBold", true);
    assert_style("Semi Bold Italic", 600, -12, "Italic", " Semi Bold", true);
    assert_style("Condensed Bold", 700, 0, "Bold", " Condensed", true);
    assert_style("Extra Condensed Bold Oblique", 700, 0, "Bold Italic", " Extra Condensed", true);
    assert_style("Book", 400, 0, "Regular", "", true);
    assert_style("Oblique", 400, 0, "Italic", "", true);
    assert_style("Italic Display", 400, 0, "Italic", " Italic Display", true);
}

static void assert_postscript(const char *family, const char *style, const char *name) {
    size_t length;
    mt_font_data data = mt_sample_font(&arena);
    data.family = family;
    data.style = style;
    uint8_t *bytes = write_font(&data, &length);
    assert_string_equal(find_name(bytes, 6), name);
    mt_bytes_free(bytes);
}

static void postscript_names(void **state) {
    (void)state;
    assert_postscript("My Font", "Semi Bold", "MyFont-SemiBold");
    assert_postscript("A-B (c) [d] {e} <f> g/h%", "1/2", "ABcdefgh-12");
    assert_postscript("文泉 𝔘", "粗", "u6587u6CC9u1D518-u7C97");
    assert_postscript("Café Øre Ångström ŁÓDŹ Straße", "Émigré", "CafeOreAngstromLODZStrasse-Emigre");
    assert_postscript("Cafe\u0301 Ấn", "İı", "CafeAn-Ii");
    assert_postscript("Юность Щит Ёж", "Жирный", "YunostShchitEzh-Zhirnyj");
    assert_postscript("Αθήνα Ψ", "Ή", "AthinaPs-I");
    assert_postscript("ÆŒÞ × ﷽", "ẞ", "AeOeThu00D7uFDFD-ss");
    assert_postscript("1234567890123456789012345678901234567890",
                      "abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz",
                      "1234567890123456789012345678901-abcdefghijklmnopqrstuvwxyzabcde");
    assert_postscript("123456789012345678901234567890123456789012345678901234567890形", "xx",
                      "123456789012345678901234567890123456789012345678901234567890-xx");
}

static void names_that_are_missing(void **state) {
    (void)state;
    size_t length;
    mt_font_data data = mt_sample_font(&arena);
    data.version = data.copyright = data.license = data.license_url = data.description = NULL;
    uint8_t *bytes = write_font(&data, &length);
    static const int absent[] = {0, 5, 10, 13, 14};
    for (int i = 0; i < 5; i++) assert_null(find_name(bytes, absent[i]));
    assert_string_equal(find_name(bytes, 3), "sample;1");
    assert_int_equal(mt_read_u32(mt_sample_table(bytes, "head", NULL) + 4), 0x00010000);
    mt_bytes_free(bytes);
}

/* ---- what is refused ----------------------------------------------------------------------------------- */

static void bad_numbers(void **state) {
    (void)state;
    static const int units[] = {15, 16385, 0, -1};
    for (int i = 0; i < 4; i++) {
        mt_font_data data = mt_sample_font(&arena);
        data.units = units[i];
        assert_refused(&data, MT_BAD_PARAMETER);
    }
    mt_font_data data = mt_sample_font(&arena);
    data.glyph_count = 0;
    assert_refused(&data, MT_BAD_PARAMETER);
    data.glyph_count = MT_GLYPHS_MAX + 1;
    assert_refused(&data, MT_TOO_LARGE);
}

static void bad_contours(void **state) {
    (void)state;
    mt_font_data data = mt_sample_font(&arena);
    data.glyphs[3].ends[1] = 3; /* an empty contour */
    assert_refused(&data, MT_BAD_PARAMETER);
    data.glyphs[3].ends[0] = -1;
    assert_refused(&data, MT_BAD_PARAMETER);
    data.glyphs[3].ends[0] = INT_MAX;
    assert_refused(&data, MT_TOO_LARGE);
    data.glyphs[3].contour_count = MT_GLYF_CONTOURS_MAX + 1;
    assert_refused(&data, MT_TOO_LARGE);
    data.glyphs[3].contour_count = -1;
    assert_refused(&data, MT_BAD_PARAMETER);
    data.glyphs[3].contour_count = 0;
    data.glyphs[1].points[0].x = -20000;
    data.glyphs[1].points[1].x = 20000; /* 40 000 apart */
    assert_refused(&data, MT_TOO_LARGE);
}

static void bad_characters(void **state) {
    (void)state;
    static const mt_char bad[] = {{'B', 1}, {'A', 1}, {0xD800, 1}, {0xDFFF, 1}, {0x110000, 1}, {'C', 5}};
    for (int i = 0; i < 6; i++) {
        mt_font_data data = mt_sample_font(&arena);
        data.chars[0] = (mt_char){'B', 1};
        data.chars[1] = bad[i];
        data.char_count = 2;
        assert_refused(&data, MT_BAD_PARAMETER);
    }
}

static void bad_names(void **state) {
    (void)state;
    static const char *const texts[] = {"",          "\xFF",         "\xC0\x80",
                                        "a\xE5\xBD", "\xED\xA0\x80", "\xF4\x90\x80\x80"};
    for (int i = 0; i < 6; i++) {
        mt_font_data data = mt_sample_font(&arena);
        data.style = texts[i];
        assert_refused(&data, MT_BAD_PARAMETER);
    }
    mt_font_data data = mt_sample_font(&arena);
    data.family = NULL;
    assert_refused(&data, MT_BAD_PARAMETER);
    data = mt_sample_font(&arena);
    char *text = mt_arena_new(&arena, 40001, 1);
    assert_non_null(text);
    memset(text, 'x', 40000);
    data.license = text;
    assert_refused(&data, MT_TOO_LARGE);
    text[31000] = '\0';
    size_t length;
    mt_bytes_free(write_font(&data, &length));
}

/* ---- memory -------------------------------------------------------------------------------------------- */

static void tables_stay_failed(void **state) {
    (void)state;
    mt_table table = {0};
    mt_table_16(&table, 0x1234);
    mt_allocation_watch();
    mt_allocation_fail(0, true);
    mt_table_zeros(&table, 1000);
    mt_allocation_unwatch();
    size_t length = table.length;
    mt_table_16(&table, 1);
    assert_true(table.failed && table.length == length && length >= 2);
    assert_int_equal(mt_read_u16(table.bytes), 0x1234);
    mt_table_free(&table);
}

static void every_allocation_may_fail(void **state) {
    (void)state;
    mt_font_data data = mt_sample_font(&arena);
    long failed = 0;
    for (mt_status status = MT_NO_MEMORY; status != MT_OK; failed++) {
        uint8_t *bytes = NULL;
        size_t length;
        mt_allocation_watch();
        mt_allocation_fail(failed, false);
        status = mt_font_write(&data, &bytes, &length);
        assert_int_equal(status, bytes ? MT_OK : MT_NO_MEMORY);
        mt_bytes_free(bytes);
        long live = mt_allocation_live();
        mt_allocation_unwatch();
        assert_int_equal(live, 0);
    }
    assert_true(failed > 10); /* each of the tables asked for some */
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(checksums_are_right),
        cmocka_unit_test(same_input_same_bytes),
        cmocka_unit_test(outlines_read_back),
        cmocka_unit_test(offsets_grow_long),
        cmocka_unit_test(references_read_back),
        cmocka_unit_test(bad_references),
        cmocka_unit_test(references_are_only_so_deep),
        cmocka_unit_test(nothing_drawn),
        cmocka_unit_test(trailing_advances_are_shared),
        cmocka_unit_test(vertical_metrics),
        cmocka_unit_test(no_vertical_metrics),
        cmocka_unit_test(smooth_at_every_size),
        cmocka_unit_test(panose_tells_monospaced),
        cmocka_unit_test(contexts_are_measured),
        cmocka_unit_test(figures_are_kept_in_range),
        cmocka_unit_test(coverage_is_told),
        cmocka_unit_test(characters_in_the_bmp),
        cmocka_unit_test(characters_beyond_format_4),
        cmocka_unit_test(styles_are_linked),
        cmocka_unit_test(styles_are_named),
        cmocka_unit_test(postscript_names),
        cmocka_unit_test(names_that_are_missing),
        cmocka_unit_test(bad_numbers),
        cmocka_unit_test(bad_contours),
        cmocka_unit_test(bad_characters),
        cmocka_unit_test(bad_names),
        cmocka_unit_test(tables_stay_failed),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
