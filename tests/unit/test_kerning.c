/* The kerning of blends: HarfBuzz's advances of the blend are the mix of the two fonts' own. */
#include "support/blending.h"
#include "support/check.h"
#include "support/fonts.h"

#define INTER "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf"
#define NIMBUS "/usr/share/fonts/opentype/urw-base35/NimbusSans-Regular.otf"
#define PALATINO "/usr/share/fonts/opentype/urw-base35/P052-Roman.otf"

enum { LETTERS = 200, WORDS = 1000, WORD_MAX = 12 };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

/* ---- texts --------------------------------------------------------------------------------------------- */

typedef struct mt_letters {
    uint32_t list[LETTERS];
    int count;
} mt_letters;

/* Latin, Greek and Cyrillic that both fonts have, as far as there are so many of each. */
static mt_letters choose_letters(const mt_test_blend *blend) {
    static const uint32_t ranges[][2] = {
        {0x21, 0x7E}, {0xC0, 0xFF}, {0x2018, 0x201E}, {0x386, 0x3CE}, {0x410, 0x45F}};
    static const int most[] = {75, 20, 7, 49, 49};
    mt_letters letters = {0};
    for (int r = 0; r < 5; r++) {
        int taken = 0;
        for (uint32_t c = ranges[r][0]; c <= ranges[r][1] && taken < most[r]; c++) {
            if (!mt_font_glyph(blend->ends[0].font, c) || !mt_font_glyph(blend->ends[1].font, c)) continue;
            letters.list[letters.count++] = c;
            taken++;
        }
    }
    return letters;
}

static void compare_pairs(mt_test_place *place, const mt_letters *letters) {
    for (int i = 0; i < letters->count; i++)
        for (int k = 0; k < letters->count; k++) {
            uint32_t text[] = {letters->list[i], letters->list[k]};
            mt_test_compare(place, text, 2);
        }
}

/* Words of three to twelve letters, by a generator that is always the same. */
static void compare_words(mt_test_place *place, const mt_letters *letters) {
    uint32_t state = 20240501, text[WORD_MAX];
    for (int w = 0; w < WORDS; w++) {
        state = state * 1664525u + 1013904223u;
        int length = 3 + (int)((state >> 16) % (WORD_MAX - 2));
        for (int i = 0; i < length; i++) {
            state = state * 1664525u + 1013904223u;
            text[i] = letters->list[(state >> 8) % (uint32_t)letters->count];
        }
        mt_test_compare(place, text, length);
    }
}

static void check(mt_test_end a, mt_test_end b, int least_kerned) {
    static const double places[] = {0.25, 0.5};
    mt_test_blend blend = mt_test_blend_of(a, b, &arena);
    mt_letters letters = choose_letters(&blend);
    assert_in_range(letters.count, 120, LETTERS);
    for (int i = 0; i < 2; i++) {
        mt_test_place place = mt_test_place_at(&blend, places[i]);
        compare_pairs(&place, &letters);
        int pairs = place.kerned;
        compare_words(&place, &letters);
        print_message(
            "t %g: %d letters, %d pairs kerned, at most %.3g units a glyph off; GPOS of %zu bytes\n", place.t,
            letters.count, pairs, place.worst, place.gpos_length);
        assert_true(pairs >= least_kerned);
        mt_test_place_close(&place);
    }
    mt_test_blend_close(&blend);
}

/* ---- fonts --------------------------------------------------------------------------------------------- */

static mt_test_end plain(const char *path) {
    return mt_test_open_end(path, path, 0);
}

static void classes_with_classes(void **state) {
    (void)state;
    check(plain(MT_TEST_SANS), plain(MT_TEST_SERIF), 400);
}

static void lists_with_lists(void **state) {
    (void)state;
    check(plain(NIMBUS), plain(PALATINO), 1000);
}

static void varying_with_classes(void **state) {
    (void)state;
    check(mt_test_open_end(INTER, INTER "@wght=300", 300), plain(MT_TEST_SERIF), 1000);
    check(mt_test_open_end(INTER, INTER "@wght=850", 850), plain(MT_TEST_SERIF), 1000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(classes_with_classes),
        cmocka_unit_test(lists_with_lists),
        cmocka_unit_test(varying_with_classes),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
