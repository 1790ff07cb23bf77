/* Pair adjustment of fonts made for the test: many classes, several subtables, one font that kerns. */
#include "sfnt/sfnt.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/sample.h"

#include <time.h>

enum {
    FIRST = 0xE000,
    X_ADVANCE = 4,
    DEFAULT = MT_TAG('D', 'F', 'L', 'T'),
    KERN = MT_TAG('k', 'e', 'r', 'n')
};

static uint32_t next_random(uint32_t *state) {
    *state = *state * 1664525u + 1013904223u;
    return *state >> 8;
}

/* ---- GPOS of class matrices ---------------------------------------------------------------------------- */

/* A PairPosFormat2 of random values: glyphs 1 … count in `classes` × `classes` random classes on both sides, on the right
 * only glyphs of `from` ≤ glyph % 2 ≤ `to`; the others are in class 0 there. */
static mt_bytes random_matrix(uint32_t seed, int count, int classes, int from, int to) {
    mt_table table = {0}, tables[3] = {{0}};
    uint16_t *covered = mt_test_new((size_t)count, sizeof *covered);
    mt_glyph_class *left = mt_test_new((size_t)count, sizeof *left);
    mt_glyph_class *right = mt_test_new((size_t)count, sizeof *right);
    for (int i = 0; i < count; i++) {
        uint16_t glyph = (uint16_t)(i + 1);
        bool listed = glyph % 2 >= from && glyph % 2 <= to;
        covered[i] = glyph;
        left[i] = (mt_glyph_class){glyph, (uint16_t)(next_random(&seed) % (uint32_t)classes)};
        right[i] = (mt_glyph_class){
            glyph, (uint16_t)(listed ? 1 + next_random(&seed) % (uint32_t)(classes - 1) : 0)};
    }
    mt_table_coverage(&tables[0], covered, count);
    mt_table_classes(&tables[1], left, count);
    mt_table_classes(&tables[2], right, count);
    size_t at = 16 + 2 * (size_t)(classes * classes);
    const int head[] = {2,
                        (int)at,
                        X_ADVANCE,
                        0,
                        (int)(at + tables[0].length),
                        (int)(at + tables[0].length + tables[1].length),
                        classes,
                        classes};
    for (int i = 0; i < 8; i++) mt_table_16(&table, head[i]);
    for (int i = 0; i < classes * classes; i++)
        mt_table_16(&table, next_random(&seed) % 4 ? 0 : (int)(next_random(&seed) % 200) - 100);
    for (int i = 0; i < 3; i++) {
        mt_table_bytes(&table, tables[i].bytes, tables[i].length);
        mt_table_free(&tables[i]);
    }
    free(covered);
    free(left);
    free(right);
    mt_bytes bytes;
    mt_assert_ok(mt_table_keep(&table, &arena, &bytes));
    return bytes;
}

static mt_test_end blank_end(const char *name, int units, int count, uint32_t tag, mt_bytes table) {
    char *path = mt_sample_path(&arena, directory, name);
    mt_test_save_blank(path, units, FIRST, count, tag, table, &arena);
    return mt_test_open_end(path, path, 0);
}

static mt_test_end gpos_end(const char *name, int units, int count, const mt_bytes *subtables, int n) {
    return blank_end(name, units, count, MT_TAG('G', 'P', 'O', 'S'),
                     mt_test_one_lookup(DEFAULT, KERN, 2, subtables, n, &arena));
}

static void compare_random_pairs(mt_test_place *place, int count, int pairs) {
    uint32_t seed = 7;
    for (int i = 0; i < pairs; i++) {
        uint32_t text[] = {FIRST + next_random(&seed) % (uint32_t)count,
                           FIRST + next_random(&seed) % (uint32_t)count};
        mt_test_compare(place, text, 2);
    }
}

static void check_place(mt_test_place place, int count, int pairs, int least_kerned) {
    compare_random_pairs(&place, count, pairs);
    print_message("t %g: %d of %d pairs kerned, at most %.3g units a glyph off; GPOS of %zu bytes\n", place.t,
                  place.kerned, pairs, place.worst, place.gpos_length);
    assert_true(place.kerned >= least_kerned);
    mt_test_place_close(&place);
}

static void check(mt_test_end a, mt_test_end b, int count, int pairs, int least_kerned) {
    mt_test_blend blend = mt_test_blend_of(a, b, &arena);
    for (int i = 0; i <= 4; i++) {
        check_place(mt_test_place_at(&blend, i / 4.0), count, pairs, least_kerned);
        check_place(mt_test_varying_place_at(&blend, i / 4.0), count, pairs, least_kerned);
    }
    mt_test_blend_close(&blend);
}

/* ---- tests --------------------------------------------------------------------------------------------- */

/* Class 0 on the right is a class: a lookup's second subtable has nothing to say where the first covers the left glyph. */
static void the_first_subtable_applies(void **state) {
    (void)state;
    mt_bytes in_a[] = {random_matrix(1, 60, 8, 1, 1), random_matrix(2, 60, 7, 0, 1)};
    mt_bytes in_b[] = {random_matrix(3, 60, 9, 0, 1), random_matrix(4, 60, 5, 0, 1)};
    check(gpos_end("a.ttf", 1000, 60, in_a, 2), gpos_end("b.ttf", 2048, 60, in_b, 2), 60, 3000, 100);
}

/* Random classes, so that nearly every glyph is a class of its own: for 600 glyphs a matrix of 600 kilobytes in many
 * subtables; for 3,000 each font's matrix by itself. */
static void check_many_classes(int count, int classes) {
    mt_bytes in_a = random_matrix(5, count, classes, 0, 1), in_b = random_matrix(6, count, classes, 0, 1);
    mt_test_end a = gpos_end("a.ttf", 1000, count, &in_a, 1), b = gpos_end("b.ttf", 1000, count, &in_b, 1);
    check(a, b, count, 10000, 500);
}

static void many_classes(void **state) {
    (void)state;
    clock_t start = clock();
    check_many_classes(600, 40);
    check_many_classes(3000, 100);
    assert_true(clock() - start < 20 * CLOCKS_PER_SEC);
}

/* Only B kerns; only A does. */
static void one_of_them_kerns(void **state) {
    (void)state;
    mt_bytes matrix = random_matrix(8, 40, 6, 0, 1);
    mt_bytes none = {0};
    for (int first = 0; first < 2; first++) {
        mt_test_end kerns = gpos_end("kerns.ttf", 1000, 40, &matrix, 1);
        mt_test_end plain = blank_end("plain.ttf", 2000, 40, 0, none);
        mt_test_blend blend = mt_test_blend_of(first ? kerns : plain, first ? plain : kerns, &arena);
        mt_test_place place = mt_test_place_at(&blend, 0.5);
        compare_random_pairs(&place, 40, 1000);
        assert_true(place.kerned > 100);
        mt_test_place_close(&place);
        mt_test_blend_close(&blend);
    }
}

/* A has a system that other text is not set by; so B's is added. */
static void a_script_of_the_first_font_alone(void **state) {
    (void)state;
    mt_bytes in_a = random_matrix(9, 40, 6, 0, 1), in_b = random_matrix(10, 40, 6, 0, 1);
    mt_bytes math = mt_test_one_lookup(MT_TAG('m', 'a', 't', 'h'), KERN, 2, &in_a, 1, &arena);
    mt_test_end a = blank_end("a.ttf", 1000, 40, MT_TAG('G', 'P', 'O', 'S'), math);
    mt_test_blend blend = mt_test_blend_of(a, gpos_end("b.ttf", 1000, 40, &in_b, 1), &arena);
    mt_test_place place = mt_test_place_at(&blend, 0.5);
    compare_random_pairs(&place, 40, 1000);
    assert_true(place.kerned > 100);
    mt_test_place_close(&place);
    mt_test_blend_close(&blend);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_first_subtable_applies),
        cmocka_unit_test(many_classes),
        cmocka_unit_test(one_of_them_kerns),
        cmocka_unit_test(a_script_of_the_first_font_alone),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, mt_test_tear_down);
}
