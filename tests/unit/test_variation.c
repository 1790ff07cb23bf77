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

/* Moves of all sizes, and runs of points that stay. */
static mt_move random_move(mt_random *random) {
    int range = mt_random_one_in(random, 3) ? 0 : mt_random_one_in(random, 2) ? 100 : 3000;
    return (mt_move){(int16_t)mt_random_between(random, -range, range),
                     (int16_t)mt_random_between(random, -range, range)};
}

static mt_glyph_moves random_moves(mt_random *random, const mt_glyf *glyph) {
    int points = mt_glyf_point_count(glyph) + glyph->reference_count + MT_PHANTOM_POINTS;
    int count = mt_random_between(random, 1, PLACES_MAX), *places = room((size_t)count, sizeof(int));
    mt_move **moves = room((size_t)count, sizeof *moves);
    for (int i = 0; i < count; i++) {
        places[i] = MT_PLACE_ONE * (i + 1) / count;
        if (i + 1 < count && mt_random_one_in(random, 2)) places[i]++; /* no other glyph has it */
        moves[i] = room((size_t)points, sizeof(mt_move));
        bool still = mt_random_one_in(random, 5);
        for (int k = 0; k < points - MT_PHANTOM_POINTS && !still; k++) moves[i][k] = random_move(random);
    }
    return (mt_glyph_moves){count, places, moves};
}

/* Where a point is at a place: `share` of the way from the place before to the next one. */
static void check_points(FT_Face face, const mt_glyf *glyph, const mt_glyph_moves *moves, int i,
                         double share) {
    static const mt_move still = {0, 0};
    for (int k = 0; k < mt_glyf_point_count(glyph); k++) {
        mt_move before = i ? moves->moves[i - 1][k] : still, after = moves->moves[i][k];
        double x = glyph->points[k].x + before.x + share * (after.x - before.x);
        double y = glyph->points[k].y + before.y + share * (after.y - before.y);
        assert_true(fabs((double)face->glyph->outline.points[k].x - x) <= 0.75);
        assert_true(fabs((double)face->glyph->outline.points[k].y - y) <= 0.75);
    }
}

static void check_glyph(FT_Face face, int glyph, const mt_font_data *data) {
    const mt_glyph_moves *moves = &data->variation->moves[glyph];
    for (int i = 0; i < moves->place_count; i++)
        for (int half = 0; half < 2; half++) {
            int from = i ? moves->places[i - 1] : 0;
            double share = half ? 0.5 : 1, place = from + share * (moves->places[i] - from);
            FT_Fixed value = lround(place * MT_AXIS_END * 65536 / MT_PLACE_ONE);
            assert_int_equal(FT_Set_Var_Design_Coordinates(face, 1, &value), 0);
            assert_int_equal(FT_Load_Glyph(face, (FT_UInt)glyph, FT_LOAD_NO_SCALE), 0);
            check_points(face, &data->glyphs[glyph], moves, i, share);
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
    static const mt_named_place named[] = {{0, "First"}, {100, "Last"}};
    for (int n = 0; n < mt_test_cases(40); n++) {
        mt_random random = mt_random_case(n);
        mt_font_data data = mt_sample_font(&arena);
        mt_glyph_moves *moves = room((size_t)data.glyph_count, sizeof *moves);
        data.glyphs[1] = large_glyph(&random, mt_random_between(&random, 3, 700));
        for (int i = 0; i < data.glyph_count; i++) moves[i] = random_moves(&random, &data.glyphs[i]);
        mt_axis_data variation = {MT_AXIS_TAG, MT_AXIS_NAME, 0, MT_AXIS_END, 2, named, moves, {0}};
        data.variation = &variation;
        check_font(&data);
        mt_arena_reset(&arena);
    }
}

/* Contours of which only the first and the last move: their points' numbers are far apart. */
static void points_far_apart_are_told(void **state) {
    (void)state;
    enum { CONTOURS = 300, POINTS = 3 * CONTOURS };
    static const mt_named_place named[] = {{0, "First"}, {100, "Last"}};
    static const int end[] = {MT_PLACE_ONE};
    mt_random random = mt_random_case(0);
    mt_font_data data = mt_sample_font(&arena);
    mt_glyf *glyph = &data.glyphs[1];
    *glyph = large_glyph(&random, POINTS);
    glyph->contour_count = CONTOURS;
    glyph->ends = room(CONTOURS, sizeof(int));
    for (int i = 0; i < CONTOURS; i++) glyph->ends[i] = 3 * i + 2;
    mt_glyph_moves *moves = room((size_t)data.glyph_count, sizeof *moves);
    mt_move *row = room(POINTS + MT_PHANTOM_POINTS, sizeof *row);
    for (int i = 0; i < 3; i++) row[i] = row[POINTS - 1 - i] = (mt_move){(int16_t)(100 * i + 50), -20};
    mt_move *rows[] = {row};
    moves[1] = (mt_glyph_moves){1, end, rows};
    mt_axis_data variation = {MT_AXIS_TAG, MT_AXIS_NAME, 0, MT_AXIS_END, 2, named, moves, {0}};
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
