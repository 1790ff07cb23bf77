/* Subtables of GPOS that vary, larger than any font's, and GDEF with their store: as the readers of layout/ have them at
 * places of the axis. */
#include <hb-ot.h>
#include <math.h>
#include <string.h>

#include "anchors/write.h"
#include "anchors/write_cursive.h"
#include "anchors/write_marks.h"
#include "gpos/singles.h"
#include "kerning/write.h"
#include "layout/gdef.h"
#include "layout/lookup_groups.h"
#include "layout/open.h"
#include "sfnt/sfnt.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/gpos.h"
#include "support/random.h"

enum { STOPS = 3 };

static const mt_at stops[STOPS] = {{0, 0}, {1, 1}, {2, 2}};

static mt_arena arena;
static mt_var_store store;

static int set_up(void **state) {
    (void)state;
    const mt_stops even = mt_stops_even(STOPS);
    store = mt_var_store_make(&even);
    return 0;
}

static int tear_down(void **state) {
    (void)state;
    mt_var_store_free(&store);
    mt_arena_release(&arena);
    return 0;
}

static mt_places all_stops(void) {
    return (mt_places){STOPS, STOPS, stops, NULL, &store};
}

static void *new_list(int count, size_t size) {
    void *list = mt_arena_new(&arena, (size_t)count, size);
    assert_non_null(list);
    return list;
}

/* What GDEF's store adds at a place, 0 … 1. */
static mt_gdef_deltas at_place(double place) {
    mt_gdef_deltas variations;
    mt_bytes gdef, none = {0};
    int32_t normalized = (int32_t)lround(place * 0x10000);
    mt_assert_ok(mt_gdef_vary(none, &store, &arena, &gdef));
    mt_assert_ok(mt_gdef_deltas_open(gdef, &normalized, 1, &arena, &variations));
    return variations;
}

/* Between three values. */
static double between(const int32_t *values, double place) {
    int stop = place < 0.5 ? 0 : 1;
    return values[stop] + (2 * place - stop) * (values[stop + 1] - values[stop]);
}

static void assert_value(double got, double wanted) {
    if (!(fabs(got - wanted) <= 1e-6)) fail_msg("%g, not %g", got, wanted);
}

static mt_layout layout_of(int type, const mt_bytes *subtables, int count) {
    mt_layout layout;
    mt_bytes gpos = mt_test_one_lookup(MT_TAG('D', 'F', 'L', 'T'), MT_TAG('k', 'e', 'r', 'n'), type,
                                       subtables, count, &arena);
    mt_assert_ok(mt_layout_open(gpos, MT_EXTENSION_GPOS, &arena, &layout));
    assert_int_equal(layout.lookup_count, 1);
    return layout;
}

/* ---- pairs --------------------------------------------------------------------------------------------- */

enum { GLYPHS = 40000, ROWS = 160, COLUMNS = 190, LISTED = 30000, WIDTH = 2 * STOPS };

/* The left glyph's advance, and the right glyph's placement; some are the same at all stops. */
static void random_values(mt_random *random, int32_t *values) {
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < STOPS; i++) {
            bool same = i && mt_random_one_in(random, 3);
            values[k * STOPS + i] = same ? values[k * STOPS] : mt_random_between(random, -150, 150);
        }
}

/* Row and column 0 are 0; glyph g is in row g % ROWS and in column g % COLUMNS. */
static void fill_matrix(mt_mixed_pairs *mixed, mt_random *random) {
    mixed->row_count = ROWS;
    mixed->column_count = COLUMNS;
    mixed->cells = new_list(ROWS * COLUMNS * WIDTH, sizeof *mixed->cells);
    for (int i = COLUMNS; i < ROWS * COLUMNS; i++)
        if (i % COLUMNS) random_values(random, mixed->cells + i * WIDTH);
    for (int g = 0; g < GLYPHS; g++) {
        mixed->row_of[g] = (uint16_t)(g % ROWS);
        mixed->column_of[g] = (uint16_t)(g % COLUMNS);
    }
}

/* Glyph 7 has 20000 pairs, more than go into a set; others have 100 each, the even ones the same. */
static void fill_list(mt_mixed_pairs *mixed, mt_random *random) {
    mixed->listed = new_list(LISTED, sizeof *mixed->listed);
    mixed->listed_values = new_list(LISTED * WIDTH, sizeof *mixed->listed_values);
    for (int i = 0; i < LISTED; i++) {
        int32_t *values = mixed->listed_values + i * WIDTH;
        bool long_one = i < 20000;
        int other = (i - 20000) / 100;
        mixed->listed[i].left = (uint16_t)(long_one ? 7 : 100 + other);
        mixed->listed[i].right = (uint16_t)(long_one ? 2 * i : 3 * (i % 100));
        if (!long_one && other && other % 2 == 0)
            memcpy(values, mixed->listed_values + (20000 + i % 100) * WIDTH, WIDTH * sizeof *values);
        else
            random_values(random, values);
    }
    mixed->listed_count = LISTED;
}

static mt_mixed_pairs new_pairs(void) {
    static const uint8_t parts[] = {MT_VALUE_X_ADVANCE, MT_VALUE_PARTS};
    mt_mixed_pairs mixed = {.glyph_count = GLYPHS,
                            .values = {2, STOPS, parts},
                            .row_count = 1,
                            .column_count = 1,
                            .row_of = new_list(GLYPHS, sizeof *mixed.row_of),
                            .column_of = new_list(GLYPHS, sizeof *mixed.column_of),
                            .cells = new_list(WIDTH, sizeof *mixed.cells)};
    return mixed;
}

static mt_pair_source read_pairs(const mt_mixed_pairs *mixed, const mt_gdef_deltas *variations, int *count) {
    static const int lookup = 0;
    mt_bytes *subtables;
    mt_pair_source source;
    mt_assert_ok(mt_pairs_write(mixed, &store, &arena, &subtables, count));
    mt_layout layout = layout_of(MT_LOOKUP_PAIR, subtables, *count);
    mt_assert_ok(mt_pair_source_gpos(&layout, &lookup, 1, variations, 1, &arena, &source));
    assert_int_equal(source.count, *count);
    return source;
}

static void assert_pair(const mt_pair_source *source, uint32_t left, uint32_t right, const int32_t *wanted,
                        double place) {
    int32_t rows[64], columns[64];
    double values[MT_PAIR_PARTS];
    assert_true(source->count <= 64);
    for (int i = 0; i < source->count; i++) {
        rows[i] = mt_pair_row(&source->subtables[i], left);
        columns[i] = mt_pair_column(&source->subtables[i], right);
    }
    mt_pair_value(source, &(mt_pair){rows, columns, left, right}, values);
    assert_value(values[MT_VALUE_X_ADVANCE], between(wanted, place));
    assert_value(values[MT_VALUE_PARTS], between(wanted + STOPS, place));
}

static void matrices_are_split(void **state) {
    (void)state;
    mt_random random = mt_random_case(0);
    mt_mixed_pairs mixed = new_pairs();
    mt_gdef_deltas variations;
    int count;
    fill_matrix(&mixed, &random);
    mt_pair_source source = read_pairs(&mixed, &variations, &count);
    assert_true(count > 2);
    for (double place = 0; place <= 1; place += 0.125) {
        variations = at_place(place);
        for (int i = 0; i < 3000; i++) {
            int left = mt_random_between(&random, 0, GLYPHS - 1);
            int right = mt_random_between(&random, 0, GLYPHS - 1);
            assert_pair(&source, (uint32_t)left, (uint32_t)right,
                        mt_mixed_cell(&mixed, left % ROWS, right % COLUMNS), place);
        }
    }
}

static void lists_are_split(void **state) {
    (void)state;
    static const int32_t none[WIDTH] = {0};
    mt_random random = mt_random_case(0);
    mt_mixed_pairs mixed = new_pairs();
    mt_gdef_deltas variations;
    int count;
    fill_list(&mixed, &random);
    mt_pair_source source = read_pairs(&mixed, &variations, &count);
    assert_true(count > 4);
    for (double place = 0; place <= 1; place += 0.25) {
        variations = at_place(place);
        for (int i = 0; i < LISTED; i += 7) {
            mt_listed_pair pair = mixed.listed[i];
            assert_pair(&source, pair.left, pair.right, mt_mixed_listed(&mixed, i), place);
        }
        assert_pair(&source, 7, 1, none, place);
        assert_pair(&source, 6, 0, none, place);
    }
}

/* Where values vary in one part alone, and not by default, the others take no room. */
static void formats_are_what_is_needed(void **state) {
    (void)state;
    mt_mixed_pairs mixed = new_pairs();
    mt_gdef_deltas variations;
    int count;
    mt_listed_pair listed[] = {{1, 2}, {1, 3}};
    int32_t values[] = {0, 5, 9, 0, 0, 0, 0, -3, 0, 0, 0, 0};
    mixed.listed = listed;
    mixed.listed_count = 2;
    mixed.listed_values = values;
    mt_pair_source source = read_pairs(&mixed, &variations, &count);
    assert_int_equal(count, 1);
    assert_int_equal(source.subtables[0].formats[0], 1 << (MT_VALUE_PARTS + MT_VALUE_X_ADVANCE));
    assert_int_equal(source.subtables[0].formats[1], 0);
    variations = at_place(1);
    assert_pair(&source, 1, 2, values, 1);
}

/* ---- single adjustments -------------------------------------------------------------------------------- */

static mt_single random_single(mt_random *random, int glyph) {
    mt_single single = {(uint16_t)(3 * glyph), new_list(STOPS, sizeof *single.in_fonts)};
    for (int i = 0; i < STOPS; i++)
        for (int k = 0; k < MT_VALUE_PARTS; k++)
            single.in_fonts[i][k] = glyph % 3 == 0 ? 10 * i + k : mt_random_between(random, -500, 500);
    return single;
}

static void single_adjustments_vary(void **state) {
    (void)state;
    enum { COUNT = 6000 };
    static const int lookup = 0;
    mt_random random = mt_random_case(0);
    mt_places places = all_stops();
    mt_singles singles = {COUNT, new_list(COUNT, sizeof *singles.list)}, read;
    mt_bytes *subtables;
    int count;
    for (int i = 0; i < COUNT; i++) singles.list[i] = random_single(&random, i);
    mt_assert_ok(mt_singles_write(&singles, &places, &arena, &subtables, &count));
    assert_true(count > 3);
    mt_layout layout = layout_of(MT_LOOKUP_SINGLE, subtables, count);
    uint32_t *own = new_list(3 * COUNT, sizeof *own);
    for (int i = 0; i < 3 * COUNT; i++) own[i] = (uint32_t)i;
    mt_font_glyphs glyphs = {1, 3 * COUNT, {own}};
    for (double place = 0; place <= 1; place += 0.25) {
        mt_gdef_deltas variations = at_place(place);
        mt_single_source source = {&layout, &variations, 1, 1, &lookup};
        mt_assert_ok(mt_singles_prepare(&source, MT_NO_CALLER, &glyphs, &arena, &read));
        assert_int_equal(read.count, COUNT);
        for (int i = 0; i < COUNT; i++)
            for (int k = 0; k < MT_VALUE_PARTS; k++) {
                int32_t values[STOPS];
                for (int s = 0; s < STOPS; s++) values[s] = (int32_t)singles.list[i].in_fonts[s][k];
                assert_int_equal(read.list[i].glyph, singles.list[i].glyph);
                assert_value(read.list[i].in_fonts[0][k], between(values, place));
            }
    }
}

/* ---- anchors ------------------------------------------------------------------------------------------- */

/* Every fourth stays where it is; the others go ways of their own. */
static mt_anchor anchor_at(int x, int y) {
    mt_anchor anchor = {new_list(STOPS, sizeof *anchor.in_fonts)};
    for (int i = 0; i < STOPS; i++)
        anchor.in_fonts[i] =
            (mt_anchor_point){x + (x % 4 ? i * (31 * x % 2003) : 0), y - (x % 4 ? i * (17 * x % 3001) : 0)};
    return anchor;
}

static void assert_point(mt_anchor_point got, mt_anchor anchor, double place) {
    int32_t x[STOPS], y[STOPS];
    for (int i = 0; i < STOPS; i++) {
        x[i] = (int32_t)anchor.in_fonts[i].x;
        y[i] = (int32_t)anchor.in_fonts[i].y;
    }
    assert_value(got.x, between(x, place));
    assert_value(got.y, between(y, place));
}

enum { MARKS = 3100, BASES = 9000, FIRST_BASE = 14000 };

static mt_attachment many_marks_and_bases(bool ligatures) {
    mt_attachment all = {MARKS, 0, new_list(MARKS, sizeof *all.marks), new_list(BASES, sizeof *all.bases)};
    for (int i = 0; i < MARKS; i++) all.marks[i] = (mt_anchored){(uint16_t)(2 * i), 0, 1, anchor_at(i, -i)};
    for (int i = 0; i < BASES; i++) {
        mt_anchored base = {(uint16_t)(FIRST_BASE + i), 0, 1, anchor_at(3 * i / 2, i % 1000)};
        if (ligatures) base.glyph = (uint16_t)(FIRST_BASE + i / 2);
        if (ligatures) base.component = (uint16_t)(i % 2), base.component_count = 2;
        all.bases[all.base_count++] = base;
    }
    return all;
}

/* As engines do, in the first subtable that has both. */
static bool find_pair(const mt_subtables *subtables, int type, const mt_gdef_deltas *variations,
                      const mt_anchored *mark, const mt_anchored *base, mt_anchor_point points[2]) {
    for (int i = 0; i < subtables->count; i++) {
        mt_attachment_table table;
        int mark_class;
        assert_true(mt_attachment_open(subtables->list[i], type, &table));
        int at = mt_coverage_find(table.mark_coverage, mark->glyph);
        int under = mt_coverage_find(table.base_coverage, base->glyph);
        if (at < 0 || under < 0) continue;
        return mt_attachment_mark(&table, at, variations, &mark_class, &points[0]) &&
               mt_attachment_base(&table, under, base->component, mark_class, variations, &points[1]);
    }
    return false;
}

static void check_attachments(int type) {
    mt_attachment all = many_marks_and_bases(type == MT_MARK_TO_LIGATURE);
    mt_places places = all_stops();
    mt_subtables subtables = {0};
    mt_assert_ok(mt_attachment_write(&all, type, &places, &arena, &subtables));
    assert_true(subtables.count > 4);
    for (double place = 0; place <= 1; place += 0.25) {
        mt_gdef_deltas variations = at_place(place);
        for (int i = 0; i < BASES; i++) {
            mt_anchor_point points[2];
            const mt_anchored *mark = &all.marks[i * 7 % MARKS], *base = &all.bases[i];
            assert_true(find_pair(&subtables, type, &variations, mark, base, points));
            assert_point(points[0], mark->at, place);
            assert_point(points[1], base->at, place);
        }
    }
}

static void marks_vary(void **state) {
    (void)state;
    check_attachments(MT_MARK_TO_BASE);
}

static void ligatures_vary(void **state) {
    (void)state;
    check_attachments(MT_MARK_TO_LIGATURE);
}

static void cursive_anchors_vary(void **state) {
    (void)state;
    enum { COUNT = 2600 };
    mt_cursive cursive = {COUNT, new_list(COUNT, sizeof *cursive.glyphs)};
    mt_places places = all_stops();
    mt_subtables subtables = {0};
    for (int i = 0; i < COUNT; i++)
        cursive.glyphs[i] =
            (mt_cursive_glyph){(uint16_t)(3 * i), {true, true}, {anchor_at(i, 0), anchor_at(-i, 500)}};
    mt_assert_ok(mt_cursive_write(&cursive, &places, &arena, &subtables));
    mt_gdef_deltas variations = at_place(0.75);
    for (int i = 0; i < COUNT; i++) {
        const mt_cursive_glyph *from = &cursive.glyphs[i], *to = &cursive.glyphs[i * 7919 % COUNT];
        mt_anchor_point exit, entry;
        bool found = false;
        for (int k = 0; k < subtables.count && !found; k++) {
            mt_bytes table = subtables.list[k], coverage = mt_cursive_coverage(table);
            found =
                mt_cursive_anchor(table, mt_coverage_find(coverage, from->glyph), 1, &variations, &exit) &&
                mt_cursive_anchor(table, mt_coverage_find(coverage, to->glyph), 0, &variations, &entry);
        }
        assert_true(found);
        assert_point(exit, from->at[1], 0.75);
        assert_point(entry, to->at[0], 0.75);
    }
}

/* ---- GDEF ---------------------------------------------------------------------------------------------- */

/* Version 1.0 with classes, or 1.2 with a mark glyph set of glyph 5 too. */
static mt_bytes plain_gdef(bool with_set) {
    static const uint16_t classes[] = {0, 1, 2, 3, 3, 3};
    static const uint16_t set_glyph = 5;
    mt_table table = {0};
    mt_bytes gdef, list = mt_test_gdef(classes, 6, &arena);
    if (!with_set) return list;
    mt_table_32(&table, 0x00010002);
    mt_table_16(&table, 14);
    mt_table_zeros(&table, 6);
    mt_table_16(&table, 14 + (int)list.length - 12);
    mt_table_bytes(&table, list.bytes + 12, list.length - 12);
    mt_table_16(&table, 1); /* MarkGlyphSets format, count, offset */
    mt_table_16(&table, 1);
    mt_table_32(&table, 8);
    mt_table_coverage(&table, &set_glyph, 1);
    mt_assert_ok(mt_table_keep(&table, &arena, &gdef));
    return gdef;
}

static void assert_classes(mt_bytes gdef) {
    for (uint32_t i = 0; i < 6; i++) assert_int_equal(mt_class_find(mt_ot_follow(gdef, 4), i), i < 4 ? i : 3);
}

static void gdef_takes_the_store(void **state) {
    (void)state;
    mt_gdef_deltas variations;
    uint32_t index;
    int32_t normalized = 0x8000;
    mt_assert_ok(mt_var_store_add(&store, (int32_t[]){0, 77, 100}, &index));
    const uint8_t device[] = {0, 0, 0, 0, 0x80, 0};
    for (int k = 0; k < 2; k++) {
        mt_bytes plain = plain_gdef(k), gdef;
        mt_assert_ok(mt_gdef_vary(plain, &store, &arena, &gdef));
        assert_int_equal(mt_ot_u32(gdef, 0), 0x00010003);
        assert_classes(gdef);
        mt_bytes sets = mt_ot_follow(gdef, 12);
        assert_int_equal(sets.length > 0, k);
        if (k) assert_int_equal(mt_coverage_find(mt_ot_follow32(sets, 4), 5), 0);
        mt_assert_ok(mt_gdef_deltas_open(gdef, &normalized, 1, &arena, &variations));
        assert_value(mt_gdef_delta(&variations, (mt_bytes){device, sizeof device}), 77);
    }
}

static void gdef_stays_without_a_store(void **state) {
    (void)state;
    mt_bytes plain = plain_gdef(true), gdef, none = {0};
    mt_assert_ok(mt_gdef_vary(plain, &store, &arena, &gdef));
    assert_ptr_equal(gdef.bytes, plain.bytes);
    assert_int_equal(gdef.length, plain.length);
    mt_assert_ok(mt_gdef_vary(none, &store, &arena, &gdef));
    assert_int_equal(gdef.length, 0);
}

/* What lies at the end of what 16 bits can tell would be moved past it. */
static void gdef_may_be_too_large(void **state) {
    (void)state;
    uint32_t index;
    uint8_t *bytes = new_list(0x10010, 1);
    mt_bytes gdef;
    bytes[1] = 1;
    bytes[4] = bytes[5] = 0xFF;
    mt_assert_ok(mt_var_store_add(&store, (int32_t[]){0, 1, 2}, &index));
    assert_int_equal(mt_gdef_vary((mt_bytes){bytes, 0x10010}, &store, &arena, &gdef), MT_TOO_LARGE);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(matrices_are_split, set_up, tear_down),
        cmocka_unit_test_setup_teardown(lists_are_split, set_up, tear_down),
        cmocka_unit_test_setup_teardown(formats_are_what_is_needed, set_up, tear_down),
        cmocka_unit_test_setup_teardown(single_adjustments_vary, set_up, tear_down),
        cmocka_unit_test_setup_teardown(marks_vary, set_up, tear_down),
        cmocka_unit_test_setup_teardown(ligatures_vary, set_up, tear_down),
        cmocka_unit_test_setup_teardown(cursive_anchors_vary, set_up, tear_down),
        cmocka_unit_test_setup_teardown(gdef_takes_the_store, set_up, tear_down),
        cmocka_unit_test_setup_teardown(gdef_stays_without_a_store, set_up, tear_down),
        cmocka_unit_test_setup_teardown(gdef_may_be_too_large, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
