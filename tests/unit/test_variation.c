/* What is written of a font that varies, as FreeType reads it. */
#include <math.h>
#include <string.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_MULTIPLE_MASTERS_H

#include "sfnt/axis.h"
#include "support/check.h"
#include "support/random.h"
#include "support/sample.h"
#include "write/extent.h"
#include "write/write.h"

enum { PLACES_MAX = 5, GLYPHS = 5 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static void *room(size_t count, size_t size) {
    void *made = mt_arena_new(&arena, count, size);
    assert_non_null(made);
    return made;
}

/* A glyph of many points, so that their numbers and the counts of runs need words. */
static mt_glyf large_glyph(mt_random *random, int count) {
    mt_glyf glyph = {.advance = 900, .contour_count = 1, .ends = room(1, sizeof(int))};
    glyph.points = room((size_t)count, sizeof *glyph.points);
    glyph.ends[0] = count - 1;
    for (int i = 0; i < count; i++)
        glyph.points[i] = (mt_glyf_point){(int16_t)mt_random_between(random, -900, 900),
                                          (int16_t)mt_random_between(random, -900, 900), i % 3 != 1};
    return glyph;
}

/* Moves of all sizes. */
static int16_t random_move(mt_random *random) {
    int range = mt_random_one_in(random, 3) ? 0 : mt_random_one_in(random, 2) ? 100 : 3000;
    return (int16_t)mt_random_between(random, -range, range);
}

static int point_count(const mt_glyf *glyph) {
    return mt_glyf_point_count(glyph) + glyph->reference_count + MT_PHANTOM_POINTS;
}

/* Where the points are as the font has them; the phantom points of a glyph without height. */
static mt_font_point *own_points(const mt_glyf *glyph) {
    int count = point_count(glyph);
    mt_font_point *own = room((size_t)count, sizeof *own);
    for (int i = 0; i < mt_glyf_point_count(glyph); i++)
        own[i] = (mt_font_point){glyph->points[i].x, glyph->points[i].y};
    own[count - 3].x = (int16_t)glyph->advance;
    return own;
}

/* Some points move, and at some places none. */
static mt_glyph_path random_path(mt_random *random, const mt_glyf *glyph) {
    int points = mt_glyf_point_count(glyph);
    int count = mt_random_between(random, 1, PLACES_MAX), *places = room((size_t)count, sizeof(int));
    mt_font_point **at = room((size_t)count, sizeof *at);
    for (int i = 0; i < count; i++) {
        places[i] = MT_PLACE_ONE * (i + 1) / count;
        if (i + 1 < count && mt_random_one_in(random, 2)) places[i]++; /* no other glyph has it */
        at[i] = own_points(glyph);
        bool still = mt_random_one_in(random, 5);
        for (int k = 0; k < points && !still; k++) {
            at[i][k].x = (int16_t)(at[i][k].x + random_move(random));
            at[i][k].y = (int16_t)(at[i][k].y + random_move(random));
        }
    }
    return (mt_glyph_path){count, places, at};
}

/* Where a point is at a place: `share` of the way from the place before to the next one. */
static void check_points(FT_Face face, const mt_glyf *glyph, const mt_glyph_path *path, int i, double share) {
    for (int k = 0; k < mt_glyf_point_count(glyph); k++) {
        mt_font_point own = {glyph->points[k].x, glyph->points[k].y};
        mt_font_point before = i ? path->at[i - 1][k] : own, after = path->at[i][k];
        double x = before.x + share * (after.x - before.x), y = before.y + share * (after.y - before.y);
        assert_true(fabs((double)face->glyph->outline.points[k].x - x) <= 0.75);
        assert_true(fabs((double)face->glyph->outline.points[k].y - y) <= 0.75);
    }
}

static void check_glyph(FT_Face face, int glyph, const mt_font_data *data) {
    const mt_glyph_path *path = &data->variation->paths[glyph];
    for (int i = 0; i < path->place_count; i++)
        for (int half = 0; half < 2; half++) {
            int from = i ? path->places[i - 1] : 0;
            double share = half ? 0.5 : 1, place = from + share * (path->places[i] - from);
            FT_Fixed value = lround(place * MT_AXIS_END * 65536 / MT_PLACE_ONE);
            assert_int_equal(FT_Set_Var_Design_Coordinates(face, 1, &value), 0);
            assert_int_equal(FT_Load_Glyph(face, (FT_UInt)glyph, FT_LOAD_NO_SCALE), 0);
            check_points(face, &data->glyphs[glyph], path, i, share);
        }
}

static void check_font(const mt_font_data *data) {
    uint8_t *bytes;
    size_t length;
    FT_Library library;
    FT_Face face;
    mt_assert_ok(mt_font_write(data, &bytes, &length));
    assert_int_equal(FT_Init_FreeType(&library), 0);
    assert_int_equal(FT_New_Memory_Face(library, bytes, (FT_Long)length, 0, &face), 0);
    for (int i = 0; i < data->glyph_count; i++) check_glyph(face, i, data);
    FT_Done_FreeType(library);
    mt_bytes_free(bytes);
}

static void points_are_where_they_were_told_to_be(void **state) {
    (void)state;
    static const mt_named_place named[] = {{0, "First", false, 0, "First"},
                                           {100, "Last", false, 100, "Last"}};
    for (int n = 0; n < mt_test_cases(40); n++) {
        mt_random random = mt_random_case(n);
        mt_font_data data = mt_sample_font(&arena);
        mt_glyph_path *paths = room((size_t)data.glyph_count, sizeof *paths);
        data.glyphs[1] = large_glyph(&random, mt_random_between(&random, 3, 700));
        for (int i = 0; i < data.glyph_count; i++) paths[i] = random_path(&random, &data.glyphs[i]);
        mt_axis_data variation = {MT_AXIS_DEFAULT, "Morph", 2, named, paths, {0}, MT_SLOPE_UNTOLD};
        data.variation = &variation;
        check_font(&data);
        mt_arena_reset(&arena);
    }
}

/* Contours of which only the first and the last move: their points' numbers are far apart. */
static void points_far_apart_are_told(void **state) {
    (void)state;
    enum { CONTOURS = 300, POINTS = 3 * CONTOURS };
    static const mt_named_place named[] = {{0, "First", false, 0, "First"},
                                           {100, "Last", false, 100, "Last"}};
    static const int end[] = {MT_PLACE_ONE};
    mt_random random = mt_random_case(0);
    mt_font_data data = mt_sample_font(&arena);
    mt_glyf *glyph = &data.glyphs[1];
    *glyph = large_glyph(&random, POINTS);
    glyph->contour_count = CONTOURS;
    glyph->ends = room(CONTOURS, sizeof(int));
    for (int i = 0; i < CONTOURS; i++) glyph->ends[i] = 3 * i + 2;
    mt_glyph_path *paths = room((size_t)data.glyph_count, sizeof *paths);
    mt_font_point *at[] = {own_points(glyph)};
    for (int i = 0; i < POINTS; i++) {
        int from_end = i < 3 ? i : POINTS - 1 - i;
        if (from_end > 2) continue;
        at[0][i].x = (int16_t)(at[0][i].x + 100 * from_end + 50);
        at[0][i].y = (int16_t)(at[0][i].y - 20);
    }
    paths[1] = (mt_glyph_path){1, end, at};
    mt_axis_data variation = {MT_AXIS_DEFAULT, "Morph", 2, named, paths, {0}, MT_SLOPE_UNTOLD};
    data.variation = &variation;
    check_font(&data);
}

/* The flag stands at a glyph's first point alone. */
static void overlaps_are_flagged(void **state) {
    (void)state;
    uint8_t *bytes;
    size_t length, glyf_length;
    mt_font_data data = mt_sample_font(&arena);
    for (int overlaps = 0; overlaps < 2; overlaps++) {
        for (int i = 0; i < data.glyph_count; i++) data.glyphs[i].overlaps = i == 1 && overlaps;
        data.glyphs[0].contour_count = 0; /* glyph 1 comes first in the table */
        mt_assert_ok(mt_font_write(&data, &bytes, &length));
        const uint8_t *glyf = mt_sample_table(bytes, "glyf", &glyf_length);
        const uint8_t *flags = glyf + 10 + 2 * data.glyphs[1].contour_count + 2;
        assert_int_equal(flags[0] >> 6 & 1, overlaps);
        assert_int_equal(flags[1] >> 6 & 1, 0);
        mt_bytes_free(bytes);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_where_they_were_told_to_be),
        cmocka_unit_test(points_far_apart_are_told),
        cmocka_unit_test(overlaps_are_flagged),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
