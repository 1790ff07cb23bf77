/* Which glyphs are paired, and which are kept. */
#include "glyphset/charset.h"
#include "source/glyph_names.h"

#include <math.h>
#include <string.h>
#include <time.h>

#include "geometry/limits.h"
#include "glyphset/new_names.h"
#include "gsub/subset.h"
#include "layout/lookup_builder.h"
#include "sfnt/table.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/gsub.h"
#include "support/sample.h"
#include "write/write.h"

/* Two fonts of 40 glyphs. A has abcdef as the glyphs 1 … 6, B has fedcba. */
typedef struct pair {
    mt_font *a, *b;
} pair;

enum { GLYPHS = 40 };

static mt_font *open_font(const char *name, const char *chars, const mt_test_lookup *lookups, int count,
                          const char **names) {
    mt_bytes gsub = count ? mt_test_gsub(lookups, count, false, &arena) : (mt_bytes){0};
    return mt_test_gsub_font(mt_sample_path(&arena, directory, name), GLYPHS, chars, names, gsub, &arena);
}

static mt_charset make(pair fonts, const char *wanted, mt_glyph_set set) {
    uint32_t codes[16];
    mt_charset charset;
    mt_charset_request request = {
        .wanted = codes, .count = (int)strlen(wanted), .set = set, .alternates = true};
    for (int i = 0; i < request.count; i++) codes[i] = (unsigned char)wanted[i];
    mt_assert_ok(mt_charset_make(fonts.a, fonts.b, &request, &arena, &charset));
    mt_font_close(fonts.a);
    mt_font_close(fonts.b);
    return charset;
}

/* `wanted` are A's glyphs and their partners in A's order, .notdef left out; -1 for none. */
static void assert_pairs(const mt_charset *charset, const int (*wanted)[2], int count) {
    assert_int_equal(charset->glyphs[0].a, 0);
    assert_int_equal(charset->glyphs[0].b, 0);
    for (int i = 0; i < count && i + 1 < charset->primary_count; i++) {
        assert_int_equal(charset->glyphs[i + 1].a, wanted[i][0]);
        assert_int_equal((int32_t)charset->glyphs[i + 1].b, wanted[i][1]);
    }
    assert_int_equal(charset->primary_count, count + 1);
}

/* ---- pairs --------------------------------------------------------------------------------------------- */

static void by_characters_alone(void **state) {
    (void)state;
    pair fonts = {open_font("a.ttf", "abcg", NULL, 0, NULL), open_font("b.ttf", "xcba", NULL, 0, NULL)};
    mt_charset charset = make(fonts, "", MT_GLYPHS_BOTH);
    static const int wanted[][2] = {{1, 4}, {2, 3}, {3, 2}};
    assert_pairs(&charset, wanted, 3);
    assert_int_equal(charset.glyph_count, 4);
    assert_int_equal(charset.char_count, 3);
    for (int i = 0; i < 3; i++) {
        assert_int_equal(charset.chars[i].code_point, 'a' + i);
        assert_int_equal(charset.chars[i].glyph, i + 1);
        assert_int_equal(charset.glyphs[i + 1].code_point, 'a' + i);
        assert_true(charset.glyphs[i + 1].mapped);
    }
}

/* One feature leads to the next: from a by 'smcp' to 11 and from there by 'salt' to 13; in B from 6 to 21 to 23. */
static void by_features(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {{"smcp", NULL, 1, "1 11,2 12"},
                                          {"salt", NULL, 1, "11 13"},
                                          {"liga", NULL, 4, "1 2 3 14"},
                                          {"ccmp", NULL, 2, "3 15 16"},
                                          {"ss01", NULL, 3, "1 17 18"}};
    static const mt_test_lookup in_b[] = {{"salt", NULL, 3, "21 23 24"},
                                          {"smcp", NULL, 1, "6 21"},
                                          {"liga", NULL, 4, "6 5 4 25,6 4 5 26"},
                                          {"ccmp", NULL, 2, "4 27 28"},
                                          {"ss01", NULL, 3, "6 29"}};
    pair fonts = {open_font("a.ttf", "abcdef", in_a, 5, NULL), open_font("b.ttf", "fedcba", in_b, 5, NULL)};
    mt_charset charset = make(fonts, "abc", MT_GLYPHS_BOTH);
    static const int wanted[][2] = {{1, 6},   {2, 5},   {3, 4},   {11, 21}, {12, -1}, {13, 23},
                                    {14, 25}, {15, 27}, {16, 28}, {17, 29}, {18, -1}};
    assert_pairs(&charset, wanted, 11);
    assert_int_equal(charset.glyphs[4].code_point, 'a'); /* a form of it */
    assert_false(charset.glyphs[4].mapped);
}

/* The same glyph leads elsewhere in another language: a system that both fonts have comes before any. */
static void by_languages(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {{"locl", NULL, 1, "1 11"}, {"locl", "TRK ", 1, "1 12"}};
    static const mt_test_lookup in_b[] = {{"locl", "TRK ", 1, "6 21"}, {"locl", NULL, 1, "6 22"}};
    pair fonts = {open_font("a.ttf", "abcdef", in_a, 2, NULL), open_font("b.ttf", "fedcba", in_b, 2, NULL)};
    mt_charset charset = make(fonts, "a", MT_GLYPHS_BOTH);
    static const int wanted[][2] = {{1, 6}, {11, 22}, {12, 21}};
    assert_pairs(&charset, wanted, 3);
}

/* Through a context, and in systems of different languages. */
static void by_contexts(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {{"calt", "ROM ", 6, "1 2 3 1"}, {"    ", NULL, 1, "2 11"}};
    static const mt_test_lookup in_b[] = {{"    ", "TRK ", 1, "5 21"}, {"calt", "TRK ", 6, "4 5 6 0"}};
    pair fonts = {open_font("a.ttf", "abcdef", in_a, 2, NULL), open_font("b.ttf", "fedcba", in_b, 2, NULL)};
    mt_charset charset = make(fonts, "abc", MT_GLYPHS_BOTH);
    static const int wanted[][2] = {{1, 6}, {2, 5}, {3, 4}, {11, 21}};
    assert_pairs(&charset, wanted, 4);
}

/* The same text leads to glyphs that one font makes by 'ccmp' in one step and the other in two, by other features and other
 * types of lookups; and to a character's own glyph in A where B replaces it, or takes it
 * apart. */
static void by_texts(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {
        {"liga", NULL, 4, "1 2 11"}, {"calt", NULL, 6, "3 4 5 2"}, {"    ", NULL, 2, "4 12 13"}};
    static const mt_test_lookup in_b[] = {{"ccmp", NULL, 2, "6 21 22"},
                                          {"rlig", NULL, 4, "21 22 5 23"},
                                          {"calt", NULL, 6, "4 3 2 4"},
                                          {"rclt", NULL, 1, "1 26"},
                                          {"    ", NULL, 2, "3 24 25"}};
    pair fonts = {open_font("a.ttf", "abcdef", in_a, 3, NULL), open_font("b.ttf", "fedcba", in_b, 5, NULL)};
    mt_charset charset = make(fonts, "", MT_GLYPHS_BOTH);
    static const int wanted[][2] = {
        {1, MT_COMPOSED_FIRST}, {2, 5}, {3, 4}, {4, 3}, {5, 2}, {6, 26}, {11, 23}, {12, 24}, {13, 25}};
    assert_pairs(&charset, wanted, 9);
    assert_int_equal(charset.unblended_count, 0);
}

/* A ligature of A's goes with what B draws of its letters, each in its place; a glyph that B draws by one glyph all the same with
 * that one. */
static void by_what_several_draw(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {{"liga", NULL, 4, "1 2 11,3 4 12"}, {"ccmp", NULL, 2, "5 13 14"}};
    static const mt_test_lookup in_b[] = {{"liga", NULL, 4, "4 3 21"}};
    pair fonts = {open_font("a.ttf", "abcdef", in_a, 2, NULL), open_font("b.ttf", "fedcba", in_b, 1, NULL)};
    mt_charset charset;
    mt_charset_request request = {.set = MT_GLYPHS_BOTH};
    mt_assert_ok(mt_charset_make(fonts.a, fonts.b, &request, &arena, &charset));
    static const int wanted[][2] = {
        {1, 6},   {2, 5},   {3, 4},  {4, 3}, {5, 2}, {6, 1}, {11, MT_COMPOSED_FIRST},
        {12, 21}, {13, -1}, {14, -1}};
    assert_pairs(&charset, wanted, 10);
    const mt_composed *composed = mt_font_composed(fonts.b, charset.glyphs[7].b);
    double first, second, both;
    mt_assert_ok(mt_font_advance(fonts.b, 6, &first));
    mt_assert_ok(mt_font_advance(fonts.b, 5, &second));
    mt_assert_ok(mt_font_advance(fonts.b, charset.glyphs[7].b, &both));
    assert_true(fabs(both - first - second) < 0.5);
    assert_int_equal(composed->parts.count, 2);
    assert_int_equal(composed->like, 6);
    assert_int_equal(composed->parts.list[0].glyph, 6);
    assert_int_equal(composed->parts.list[0].dx, 0);
    assert_int_equal(composed->parts.list[1].glyph, 5);
    assert_true(fabs(composed->parts.list[1].dx * (double)MT_EM / mt_font_units_per_em(fonts.b) - first) <
                0.5);
    mt_outline outline, one;
    mt_assert_ok(mt_font_outline(fonts.b, charset.glyphs[7].b, &arena, &outline, &both));
    mt_assert_ok(mt_font_outline(fonts.b, 5, &arena, &one, &second));
    assert_int_equal(outline.count, 2);
    assert_true(fabs(outline.contours[1].segments[0].end.x - one.contours[0].segments[0].end.x - first) <= 1);
    assert_int_equal(outline.contours[1].segments[0].end.y, one.contours[0].segments[0].end.y);
    mt_font_close(fonts.a);
    mt_font_close(fonts.b);
}

/* 'aalt' numbers its alternates in each font in its own way: they are no pairs, and it alone keeps no glyph. */
static void not_by_numbers(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {
        {"aalt", NULL, 3, "1 11 12"}, {"aalt", NULL, 1, "2 13"}, {"salt", NULL, 3, "3 14 15"}};
    static const mt_test_lookup in_b[] = {
        {"aalt", NULL, 3, "6 21 22"}, {"aalt", NULL, 1, "5 23"}, {"salt", NULL, 3, "4 24 25"}};
    pair fonts = {open_font("a.ttf", "abcdef", in_a, 3, NULL), open_font("b.ttf", "fedcba", in_b, 3, NULL)};
    mt_charset charset = make(fonts, "abc", MT_GLYPHS_BOTH);
    static const int wanted[][2] = {{1, 6}, {2, 5}, {3, 4}, {14, 24}, {15, -1}};
    assert_pairs(&charset, wanted, 5);
}

static const char **name_all(int glyph, const char *name, int other, const char *other_name) {
    static const char *const plain[] = {"glyph00", "gid1", "cid0002"};
    const char **names = mt_arena_new(&arena, GLYPHS, sizeof *names);
    assert_non_null(names);
    for (int i = 0; i < GLYPHS; i++) names[i] = plain[i % 3];
    names[0] = ".notdef";
    names[glyph] = name;
    names[other] = other_name;
    return names;
}

/* Names that tell a number pair nothing, nor does a name of a glyph that has a partner. */
static void by_names(void **state) {
    (void)state;
    pair fonts = {open_font("a.ttf", "ab", NULL, 0, name_all(20, "Omega.alt", 30, "b")),
                  open_font("b.ttf", "ab", NULL, 0, name_all(9, "Omega.alt", 2, "b"))};
    mt_charset charset = make(fonts, "", MT_GLYPHS_BOTH);
    static const int wanted[][2] = {{1, 1}, {2, 2}, {20, 9}};
    assert_pairs(&charset, wanted, 3);
}

/* ---- what is kept -------------------------------------------------------------------------------------- */

static void all_of_the_first(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {{"smcp", NULL, 1, "1 11,2 12"}};
    pair fonts = {open_font("a.ttf", "abg", in_a, 1, NULL), open_font("b.ttf", "ab", NULL, 0, NULL)};
    mt_charset charset = make(fonts, "", MT_GLYPHS_FIRST);
    assert_int_equal(charset.glyph_count, GLYPHS);
    assert_int_equal(charset.unblended_count, GLYPHS - 3);
    assert_int_equal(charset.char_count, 3);
    assert_int_equal(charset.chars[2].glyph, 3);
    assert_int_equal(charset.glyphs[3].b, MT_NO_PARTNER);
}

static void wanted_of_the_first(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {{"smcp", NULL, 1, "1 11,2 12"}, {"liga", NULL, 4, "1 2 13"}};
    pair fonts = {open_font("a.ttf", "abg", in_a, 2, NULL), open_font("b.ttf", "ab", NULL, 0, NULL)};
    mt_charset charset = make(fonts, "ga", MT_GLYPHS_FIRST);
    static const int wanted[][2] = {{1, 1}, {3, -1}, {11, -1}};
    assert_pairs(&charset, wanted, 3);
    assert_int_equal(charset.unblended_count, 2);
}

/* What a person has paired comes first: the characters of A that lead there are characters of both. */
static void as_given(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {{"smcp", NULL, 1, "1 11,2 12"}};
    static const mt_test_lookup in_b[] = {{"smcp", NULL, 1, "3 21,1 22"}};
    pair fonts = {open_font("a.ttf", "abc", in_a, 1, NULL), open_font("b.ttf", "abx", in_b, 1, NULL)};
    static const uint32_t rows[] = {30, 31, 3,
                                    1,  1,  3}; /* c with a, a with x; two that no character leads to */
    mt_given_pairs given;
    mt_charset charset;
    mt_assert_ok(mt_given_pairs_make(rows, 3, (mt_font *[]){fonts.a, fonts.b}, 2, &given));
    assert_int_equal(mt_given_partner(&given, 3, 1), 1);
    assert_int_equal(mt_given_partner(&given, 2, 1), 0);
    assert_int_equal(mt_given_partner(NULL, 3, 1), 0);
    assert_int_equal(mt_given_glyph(&given, (mt_font *[]){fonts.a, fonts.b}, 1, 'a'), 3);
    assert_int_equal(mt_given_glyph(&given, (mt_font *[]){fonts.a, fonts.b}, 1, 'b'), 2);
    mt_charset_request request = {.pairs = &given};
    mt_assert_ok(mt_charset_make(fonts.a, fonts.b, &request, &arena, &charset));
    static const int wanted[][2] = {{1, 3}, {2, 2}, {3, 1}, {11, 21}, {12, -1}, {30, 31}};
    assert_pairs(&charset, wanted, 6);
    assert_int_equal(charset.char_count, 3);
    assert_int_equal(charset.glyph_count, charset.primary_count);
    assert_int_equal(charset.glyphs[4].code_point, 'a'); /* a form of it */
    mt_given_pairs_free(&given);
    mt_font_close(fonts.a);
    mt_font_close(fonts.b);
}

static void bad_pairs(void **state) {
    (void)state;
    pair fonts = {open_font("a.ttf", "abc", NULL, 0, NULL), open_font("b.ttf", "abx", NULL, 0, NULL)};
    static const uint32_t rows[][4] = {
        {1, 2, 1, 3}, {0, 1, 2, 1}, {1, 0, 2, 1}, {GLYPHS, 1, 2, 1}, {1, GLYPHS, 2, 1}};
    mt_given_pairs given = {.count = -1};
    for (int i = 0; i < 5; i++)
        assert_int_equal(mt_given_pairs_make(rows[i], 2, (mt_font *[]){fonts.a, fonts.b}, 2, &given),
                         MT_BAD_PARAMETER);
    assert_int_equal(given.count, -1);
    mt_font_close(fonts.a);
    mt_font_close(fonts.b);
}

/* All names count, those that tell a number too. */
static void glyphs_by_name(void **state) {
    (void)state;
    mt_font *named = open_font("a.ttf", "ab", NULL, 0, name_all(20, "home", 30, "house")),
            *nameless = open_font("b.ttf", "ab", NULL, 0, NULL);
    mt_name_index index;
    mt_assert_ok(mt_name_index_make(named, &arena, &index));
    assert_int_equal(mt_name_index_find(&index, "home"), 20);
    assert_int_equal(mt_name_index_find(&index, "house"), 30);
    assert_int_equal(mt_name_index_find(&index, "gid1"), 1);
    assert_int_equal(mt_name_index_find(&index, "hom"), 0);
    assert_int_equal(mt_name_index_find(&index, ""), 0);
    mt_assert_ok(mt_name_index_make(nameless, &arena, &index));
    assert_int_equal(index.count, 0);
    assert_int_equal(mt_name_index_find(&index, "home"), 0);
    mt_font_close(named);
    mt_font_close(nameless);
}

/* Of wanted characters: what shaping makes by itself, from the start and in steps, and what a language requires; but nothing that
 * text has to ask for, nor what becomes of that. */
static void without_alternates(void **state) {
    (void)state;
    static const mt_test_lookup in_a[] = {
        {"smcp", NULL, 1, "1 11,2 12"}, {"liga", NULL, 4, "1 2 13,2 3 14"}, {"calt", NULL, 1, "11 16,13 15"},
        {"ss01", NULL, 6, "1 2 1 4"},   {"    ", NULL, 1, "2 17"},          {"salt", NULL, 3, "3 18 19"}};
    uint32_t codes[] = {'a', 'b'};
    for (int alternates = 0; alternates < 2; alternates++) {
        mt_charset_request request = {.wanted = codes, .count = 2, .alternates = alternates};
        mt_charset charset;
        pair fonts = {open_font("a.ttf", "abcdef", in_a, 6, NULL),
                      open_font("b.ttf", "abcdef", NULL, 0, NULL)};
        mt_assert_ok(mt_charset_make(fonts.a, fonts.b, &request, &arena, &charset));
        mt_font_close(fonts.a);
        mt_font_close(fonts.b);
        static const int by_itself[][2] = {{1, 1}, {2, 2}, {13, -1}, {15, MT_COMPOSED_FIRST}};
        static const int all[][2] = {{1, 1},   {2, 2},  {11, -1}, {12, -1}, {13, -1}, {15, MT_COMPOSED_FIRST},
                                     {16, -1}, {17, -1}};
        assert_pairs(&charset, alternates ? all : by_itself, alternates ? 8 : 4);
        assert_int_equal(charset.left_count, alternates ? 0 : 4);
        assert_int_equal(charset.left_tag_count, alternates ? 0 : 2);
        for (int i = 0; i < charset.left_tag_count; i++)
            assert_int_equal(charset.left_tags[i],
                             i ? MT_TAG('s', 's', '0', '1') : MT_TAG('s', 'm', 'c', 'p'));
    }
}

/* A has one glyph for two characters, B has two: the second pair comes last, and the wanted character's comes first. */
static void further_pairs(void **state) {
    (void)state;
    for (int i = 0; i < 2; i++) {
        uint32_t codes[] = {'b'};
        mt_char chars[] = {{'a', 1}, {'b', 1}, {'c', 2}};
        mt_font_data data = mt_sample_font(&arena);
        data.char_count = 3;
        data.chars = chars;
        uint8_t *bytes;
        size_t length;
        const char *path = mt_sample_path(&arena, directory, "one.ttf");
        mt_assert_ok(mt_font_write(&data, &bytes, &length));
        mt_sample_save(path, bytes, length);
        mt_bytes_free(bytes);
        pair fonts = {.b = open_font("b.ttf", "abc", NULL, 0, NULL)};
        mt_assert_ok(mt_font_open(path, &fonts.a));
        mt_charset_request request = {.wanted = codes, .count = i};
        mt_charset charset;
        mt_assert_ok(mt_charset_make(fonts.a, fonts.b, &request, &arena, &charset));
        mt_font_close(fonts.a);
        mt_font_close(fonts.b);
        static const int all[][2] = {{1, 1}, {2, 3}}, one[][2] = {{1, 2}};
        assert_pairs(&charset, i ? one : all, i ? 1 : 2);
        assert_int_equal(charset.glyph_count, i ? 2 : 4);
        if (i) continue;
        assert_int_equal(charset.glyphs[3].a, 1);
        assert_int_equal(charset.glyphs[3].b, 2);
        assert_int_equal(charset.chars[1].glyph, 3);
    }
}

/* ---- names of the new glyphs --------------------------------------------------------------------------- */

static void names_are_safe_and_single(void **state) {
    (void)state;
    const char **names = name_all(1, "a(b", 2, "twice"), **made;
    names[3] = "twice";
    names[4] = "uni0061";
    names[5] = "ka-deva";
    names[6] = "50%";
    mt_charset charset;
    pair fonts = {open_font("a.ttf", "abcdef", NULL, 0, names), open_font("b.ttf", "abcdef", NULL, 0, NULL)};
    mt_charset_request request = {.set = MT_GLYPHS_BOTH};
    mt_assert_ok(mt_charset_make(fonts.a, fonts.b, &request, &arena, &charset));
    mt_assert_ok(mt_glyph_names_make(fonts.a, &charset, &arena, &made));
    static const char *const wanted[] = {".notdef", "glyph00001", "twice",  "uni0063",
                                         "uni0061", "ka-deva",    "uni0066"};
    for (int i = 0; i < 7; i++) assert_string_equal(made[i], wanted[i]);
    mt_assert_ok(mt_glyph_names_make(fonts.b, &charset, &arena, &made));
    assert_null(made);
    mt_font_close(fonts.a);
    mt_font_close(fonts.b);
}

/* ---- limits -------------------------------------------------------------------------------------------- */

static const mt_test_lookup every_type[] = {{"calt", NULL, 6, "1 2 3 5"},   {"ccmp", NULL, 2, "3 15 16"},
                                            {"liga", NULL, 4, "1 2 3 14"},  {"salt", NULL, 3, "11 13 17"},
                                            {"smcp", NULL, 1, "1 11,2 12"}, {"    ", NULL, 1, "2 18"}};
enum { TYPES = sizeof every_type / sizeof *every_type };

static mt_status make_all(mt_font *a, mt_font *b, mt_arena *own) {
    mt_charset charset;
    mt_charset_request request = {.set = MT_GLYPHS_BOTH};
    mt_layout_tables tables;
    const char **names;
    mt_status status = mt_charset_make(a, b, &request, own, &charset);
    if (status != MT_OK) return status;
    uint16_t *kept = mt_arena_new(own, (size_t)charset.primary_count, sizeof *kept);
    if (!kept) return MT_NO_MEMORY;
    for (int i = 0; i < charset.primary_count; i++) kept[i] = (uint16_t)charset.glyphs[i].a;
    status = mt_gsub_subset(a, kept, charset.primary_count, own, &tables);
    return status == MT_OK ? mt_glyph_names_make(a, &charset, own, &names) : status;
}

/* Every request for memory failed in turn, in an arena whose first block is full to some point. */
static void without_memory(void **state) {
    (void)state;
    const char *path = mt_sample_path(&arena, directory, "every.ttf");
    mt_bytes gsub = mt_test_gsub(every_type, TYPES, false, &arena);
    mt_font_close(mt_test_gsub_font(path, GLYPHS, "abcdef", name_all(20, "x", 30, "y"), gsub, &arena));
    int failures = 0;
    for (size_t filled = 0; filled < 1 << 16; filled += filled ? 1040 : 16) {
        bool failed = true;
        for (long first = 0; failed; first++) {
            mt_arena own = {0};
            mt_font *a, *b;
            mt_allocation_watch();
            mt_assert_ok(mt_font_open(path, &a));
            mt_assert_ok(mt_font_open(path, &b));
            assert_true(!filled || mt_arena_new(&own, filled, 1));
            long before = mt_allocation_requests();
            mt_allocation_fail(first, true);
            mt_status status = make_all(a, b, &own);
            failed = mt_allocation_requests() - before > first;
            mt_allocation_succeed();
            assert_int_equal(status, failed ? MT_NO_MEMORY : MT_OK);
            mt_arena_release(&own);
            mt_font_close(a);
            mt_font_close(b);
            assert_int_equal(mt_allocation_live(), 0);
            mt_allocation_unwatch();
            failures += failed;
        }
    }
    assert_true(failures > 100);
}

/* Thousands of lookups that are one and the same, of thousands of subtables that are one and the same, which has a
 * long coverage of one glyph: reading it over and over would take long. */
static void costs_are_bounded(void **state) {
    (void)state;
    enum { LOOKUPS = 4000, SUBTABLES = 10000, RANGES = 7000 };
    mt_table table = {0};
    static const uint8_t head[] = {0,    1,    0,   0,   0,   10,  0, 30, 0, 44, /* header */
                                   0,    1,    'l', 'a', 't', 'n', 0, 8,  0, 4,  0, 0, 0, 0,
                                   0xFF, 0xFF,         /* scripts */
                                   0,    1,    0,   0, /* a feature */
                                   0,    1,    's', 'm', 'c', 'p', 0, 8,  0, 0,  0, 1, 0, 0};
    mt_bytes gsub;
    mt_table_bytes(&table, head, sizeof head);
    mt_table_16(&table, LOOKUPS);
    for (int i = 0; i < LOOKUPS; i++) mt_table_16(&table, 2 + 2 * LOOKUPS);
    mt_table_16(&table, 1);
    mt_table_16(&table, 0);
    mt_table_16(&table, SUBTABLES);
    for (int i = 0; i < SUBTABLES; i++) mt_table_16(&table, 6 + 2 * SUBTABLES);
    mt_table_16(&table, 2);
    mt_table_16(&table, 8);
    mt_table_16(&table, 1);
    mt_table_16(&table, 2);
    mt_table_16(&table, 2);
    mt_table_16(&table, RANGES);
    for (int i = 0; i < RANGES; i++) mt_table_zeros(&table, 6);
    mt_assert_ok(mt_table_keep(&table, &arena, &gsub));
    const char *path = mt_sample_path(&arena, directory, "long.ttf");
    mt_font *a = mt_test_gsub_font(path, GLYPHS, "abcdef", NULL, gsub, &arena), *b;
    mt_assert_ok(mt_font_open(path, &b));
    clock_t start = clock();
    mt_assert_ok(make_all(a, b, &arena));
    assert_true(clock() - start < 60 * CLOCKS_PER_SEC);
    mt_font_close(a);
    mt_font_close(b);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_characters_alone),
        cmocka_unit_test(by_features),
        cmocka_unit_test(by_languages),
        cmocka_unit_test(by_contexts),
        cmocka_unit_test(by_texts),
        cmocka_unit_test(by_what_several_draw),
        cmocka_unit_test(not_by_numbers),
        cmocka_unit_test(by_names),
        cmocka_unit_test(all_of_the_first),
        cmocka_unit_test(wanted_of_the_first),
        cmocka_unit_test(as_given),
        cmocka_unit_test(bad_pairs),
        cmocka_unit_test(glyphs_by_name),
        cmocka_unit_test(without_alternates),
        cmocka_unit_test(further_pairs),
        cmocka_unit_test(names_are_safe_and_single),
        cmocka_unit_test(without_memory),
        cmocka_unit_test(costs_are_bounded),
    };
    return cmocka_run_group_tests_name("match", tests, mt_test_set_up, mt_test_tear_down);
}
