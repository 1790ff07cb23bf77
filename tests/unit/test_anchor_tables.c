/* Anchors without any real font: subtables written and read back, small fonts blended, malformed tables. */
#include "anchors/anchors.h"
#include "anchors/write.h"
#include "anchors/write_cursive.h"
#include "anchors/write_marks.h"
#include "gpos/gpos.h"
#include "layout/open.h"
#include "sfnt/sfnt.h"
#include "support/allocation.h"
#include "support/blending.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/fonts.h"
#include "support/random.h"
#include "support/sample.h"
#include "write/write.h"

#include <string.h>

static const mt_gdef_deltas still = {0};

static mt_anchor anchor_of(mt_anchor_point in_a, mt_anchor_point in_b) {
    mt_anchor anchor = {mt_arena_new(&arena, 2, sizeof *anchor.in_fonts)};
    assert_non_null(anchor.in_fonts);
    anchor.in_fonts[0] = in_a;
    anchor.in_fonts[1] = in_b;
    return anchor;
}

static mt_anchor anchor_at(double x, double y) {
    return anchor_of((mt_anchor_point){x, y}, (mt_anchor_point){x + 100, y - 60});
}

/* One place between two fonts. */
static mt_places at(const mt_at *place) {
    return (mt_places){2, 1, place, NULL, NULL};
}

static mt_font_glyphs glyphs_of(const mt_charset *charset, mt_arena *of) {
    mt_font_glyphs glyphs;
    mt_assert_ok(mt_test_font_glyphs(charset, 2, of, &glyphs));
    return glyphs;
}

static mt_anchored *new_anchored(int count) {
    mt_anchored *anchored = mt_arena_new(&arena, (size_t)count, sizeof *anchored);
    assert_non_null(anchored);
    return anchored;
}

/* ---- subtables ----------------------------------------------------------------------------------------- */

/* The anchors of a mark and a base's component, of the first subtable that has both: as engines find them. */
static bool find_pair(const mt_subtables *subtables, int type, uint32_t mark, uint32_t base, int component,
                      mt_anchor_point *on_mark, mt_anchor_point *on_base) {
    for (int i = 0; i < subtables->count; i++) {
        mt_attachment_table table;
        int mark_class;
        assert_true(mt_attachment_open(subtables->list[i], type, &table));
        int at = mt_coverage_find(table.mark_coverage, mark);
        int under = mt_coverage_find(table.base_coverage, base);
        if (at < 0 || under < 0) continue;
        assert_true(mt_attachment_mark(&table, at, &still, &mark_class, on_mark));
        bool found = mt_attachment_base(&table, under, component, mark_class, &still, on_base);
        assert_true(found || type == MT_MARK_TO_LIGATURE); /* Uniscribe goes no further */
        if (found) return true;
    }
    return false;
}

enum { MARK_COUNT = 6500, BASE_COUNT = 20000, FIRST_BASE = 14000 };

static mt_attachment many_marks_and_bases(void) {
    mt_attachment all = {MARK_COUNT, BASE_COUNT, new_anchored(MARK_COUNT), new_anchored(BASE_COUNT)};
    for (int i = 0; i < MARK_COUNT; i++)
        all.marks[i] = (mt_anchored){(uint16_t)(2 * i), 0, 1, anchor_at(i, -i)};
    for (int i = 0; i < BASE_COUNT; i++)
        all.bases[i] = (mt_anchored){(uint16_t)(FIRST_BASE + i), 0, 1, anchor_at(3 * i / 2, i % 1000)};
    return all;
}

static void large_lookups_are_split(void **state) {
    (void)state;
    mt_attachment all = many_marks_and_bases();
    mt_places half = at(&(mt_at){0.5, 0.5});
    mt_subtables subtables = {0};
    mt_assert_ok(mt_attachment_write(&all, MT_MARK_TO_BASE, &half, &arena, &subtables));
    assert_true(subtables.count > 2);
    for (int i = 0; i < BASE_COUNT; i++) {
        mt_anchor_point mark, base;
        int m = i * 7 % MARK_COUNT;
        assert_true(find_pair(&subtables, MT_MARK_TO_BASE, (uint32_t)(2 * m), (uint32_t)(FIRST_BASE + i), 0,
                              &mark, &base));
        assert_true(mark.x == m + 50 && mark.y == -m - 30);
        assert_true(base.x == 3 * i / 2 + 50 && base.y == i % 1000 - 30);
        assert_false(find_pair(&subtables, MT_MARK_TO_BASE, (uint32_t)(2 * m + 1), (uint32_t)(FIRST_BASE + i),
                               0, &mark, &base));
    }
}

enum { LIGATURE_COUNT = 5000 };

/* Every third component has no anchor. */
static bool component_has(int ligature, int component) {
    return (ligature + component) % 3 != 0;
}

static void ligatures_keep_their_components(void **state) {
    (void)state;
    mt_attachment all = {1, 0, new_anchored(1), new_anchored(4 * LIGATURE_COUNT)};
    mt_places end = at(&(mt_at){1, 1});
    all.marks[0] = (mt_anchored){1, 0, 1, anchor_at(0, 0)};
    for (int i = 0; i < LIGATURE_COUNT; i++)
        for (int c = 0, components = 2 + i % 3; c < components; c++)
            if (component_has(i, c))
                all.bases[all.base_count++] = (mt_anchored){(uint16_t)(10 + i), (uint16_t)c,
                                                            (uint16_t)components, anchor_at(i, 200 * c)};
    mt_subtables subtables = {0};
    mt_assert_ok(mt_attachment_write(&all, MT_MARK_TO_LIGATURE, &end, &arena, &subtables));
    assert_true(subtables.count > 1);
    for (int i = 0; i < LIGATURE_COUNT; i++)
        for (int c = 0; c < 5; c++) {
            mt_anchor_point mark, base;
            bool found = find_pair(&subtables, MT_MARK_TO_LIGATURE, 1, (uint32_t)(10 + i), c, &mark, &base);
            assert_int_equal(found, c < 2 + i % 3 && component_has(i, c));
            if (found) assert_true(base.x == i + 100 && base.y == 200 * c - 60);
        }
}

/* Whether a line goes on from one glyph to another, as an engine finds it, and where. */
static bool find_joint(const mt_subtables *subtables, uint32_t from, uint32_t to, mt_anchor_point *exit,
                       mt_anchor_point *entry) {
    for (int i = 0; i < subtables->count; i++) {
        mt_bytes table = subtables->list[i], coverage = mt_cursive_coverage(table);
        if (mt_cursive_anchor(table, mt_coverage_find(coverage, from), 1, &still, exit) &&
            mt_cursive_anchor(table, mt_coverage_find(coverage, to), 0, &still, entry))
            return true;
    }
    return false;
}

static void many_cursive_glyphs_still_join(void **state) {
    (void)state;
    enum { COUNT = 6000 };
    mt_cursive cursive = {COUNT, mt_arena_new(&arena, COUNT, sizeof(mt_cursive_glyph))};
    assert_non_null(cursive.glyphs);
    mt_places start = at(&(mt_at){0, 0});
    for (int i = 0; i < COUNT; i++)
        cursive.glyphs[i] = (mt_cursive_glyph){
            (uint16_t)(3 * i), {i % 5 != 0, i % 7 != 0}, {anchor_at(i, 0), anchor_at(-i, 500)}};
    mt_subtables subtables = {0};
    mt_assert_ok(mt_cursive_write(&cursive, &start, &arena, &subtables));
    for (int i = 0; i < 20 * COUNT; i++) {
        int from = i % COUNT, to = (int)((int64_t)i * 7919 % COUNT);
        mt_anchor_point exit, entry;
        bool found = find_joint(&subtables, (uint32_t)(3 * from), (uint32_t)(3 * to), &exit, &entry);
        assert_int_equal(found, from % 7 != 0 && to % 5 != 0);
        if (found) assert_true(exit.x == -from && exit.y == 500 && entry.x == to && entry.y == 0);
    }
}

/* ---- small fonts --------------------------------------------------------------------------------------- */

/* A font of the sample's glyphs, the second a triangle in the given box, with these lookups. */
typedef struct mt_small {
    mt_font *font;
    mt_layout layout;
} mt_small;

static mt_small open_small(const char *name, const int16_t (*triangle)[2], const mt_lookup_builders *made) {
    mt_small small;
    uint8_t *bytes;
    size_t length;
    mt_bytes gpos;
    mt_shared_system system = {.script = MT_TAG('D', 'F', 'L', 'T')};
    mt_systems systems = {1, &system};
    mt_font_data data = mt_sample_font(&arena);
    data.glyphs[1] = mt_sample_glyph(&arena, triangle, 3, true, 700);
    mt_assert_ok(mt_gpos_write(&systems, made, &arena, &gpos));
    data.extras[data.extra_count++] = (mt_extra_table){MT_TAG('G', 'P', 'O', 'S'), gpos};
    mt_assert_ok(mt_font_write(&data, &bytes, &length));
    const char *path = mt_sample_path(&arena, directory, name);
    mt_sample_save(path, bytes, length);
    mt_bytes_free(bytes);
    mt_assert_ok(mt_font_open(path, &small.font));
    mt_assert_ok(mt_font_table(small.font, MT_TAG('G', 'P', 'O', 'S'), &arena, &gpos));
    mt_assert_ok(mt_layout_open(gpos, MT_EXTENSION_GPOS, &arena, &small.layout));
    return small;
}

static const int16_t wide[][2] = {{0, 0}, {600, 0}, {300, 700}}, high[][2] = {{100, 0}, {400, 0}, {250, 900}};

static mt_anchored fixed(int glyph, int component, int components, double x, double y) {
    return (mt_anchored){(uint16_t)glyph, (uint16_t)component, (uint16_t)components,
                         anchor_of((mt_anchor_point){x, y}, (mt_anchor_point){x, y})};
}

static void add_lookup(mt_lookup_builders *made, int type, const mt_attachment *attachment,
                       const mt_cursive *cursive) {
    static const mt_member member = {0, MT_TAG('m', 'a', 'r', 'k')};
    mt_places start = at(&(mt_at){0, 0});
    mt_subtables subtables = {0};
    if (attachment) mt_assert_ok(mt_attachment_write(attachment, type, &start, &arena, &subtables));
    if (cursive) mt_assert_ok(mt_cursive_write(cursive, &start, &arena, &subtables));
    mt_lookup_builder lookup = {.order = made->count,
                                .type = type,
                                .mark_set = -1,
                                .member_count = 1,
                                .members = &member,
                                .subtable_count = subtables.count,
                                .subtables = subtables.list};
    mt_assert_ok(mt_lookup_builders_add(made, &lookup, &arena));
}

static mt_anchors blend_small(const mt_small *a, const mt_small *b, const mt_charset *charset) {
    mt_systems systems;
    mt_anchors anchors;
    mt_anchor_source sources[] = {{a->font, &a->layout, &still}, {b->font, &b->layout, &still}};
    mt_font_glyphs glyphs = glyphs_of(charset, &arena);
    mt_assert_ok(mt_systems_make((const mt_layout *[]){&a->layout, &b->layout}, 2, &arena, &systems));
    mt_assert_ok(mt_anchors_prepare(sources, &systems, NULL, 0, &glyphs, 1000, &arena, &anchors));
    mt_font_close(a->font);
    mt_font_close(b->font);
    return anchors;
}

static void assert_anchored(const mt_anchored *got, int glyph, double ax, double ay, double bx, double by) {
    const mt_anchor_point *ends = got->at.in_fonts;
    assert_int_equal(got->glyph, glyph);
    if (ends[0].x != ax || ends[0].y != ay || ends[1].x != bx || ends[1].y != by)
        fail_msg("(%g, %g) to (%g, %g)", ends[0].x, ends[0].y, ends[1].x, ends[1].y);
}

static void the_rest_is_as_in_a_and_moves_with_the_outline(void **state) {
    (void)state;
    mt_anchored mark = fixed(3, 0, 1, 50, 0), bases[] = {fixed(1, 0, 1, 300, 750), fixed(2, 0, 1, 250, 500)};
    mt_anchored mark_b = fixed(3, 0, 1, 80, 10), base_b = fixed(2, 0, 1, 200, 600);
    mt_attachment in_a = {1, 2, &mark, bases}, in_b = {1, 1, &mark_b, &base_b};
    mt_lookup_builders made_a = {0}, made_b = {0};
    add_lookup(&made_a, MT_MARK_TO_BASE, &in_a, NULL);
    add_lookup(&made_b, MT_MARK_TO_BASE, &in_b, NULL);
    mt_small a = open_small("a.ttf", wide, &made_a), b = open_small("b.ttf", high, &made_b);
    mt_pairing glyphs[] = {{0, 0, 0, false},
                           {'A', 1, 1, true},
                           {'o', 2, 2, true},
                           {0xE9, 3, 3, true},
                           {'x', 1, MT_NO_PARTNER, true}};
    mt_charset charset = {.glyph_count = 5, .glyphs = glyphs};
    mt_anchors anchors = blend_small(&a, &b, &charset);
    assert_int_equal(anchors.count, 1);
    assert_int_equal(anchors.lookups[0].attachment_count, 2);
    const mt_attachment *both = &anchors.lookups[0].attachments[0], *rest = both + 1;
    assert_int_equal(both->mark_count, 1);
    assert_int_equal(both->base_count, 1);
    assert_anchored(&both->marks[0], 3, 50, 0, 80, 10);
    assert_anchored(&both->bases[0], 2, 250, 500, 200, 600);
    assert_int_equal(rest->base_count, 2);
    assert_anchored(&rest->marks[0], 3, 50, 0, 50, 0);
    assert_anchored(&rest->bases[0], 1, 300, 750, 250, 950); /* over the top by 50 in both */
    assert_anchored(&rest->bases[1], 4, 300, 750, 300, 750);
}

static void glyphs_that_share_one_of_a_have_their_own(void **state) {
    (void)state;
    mt_anchored mark = fixed(3, 0, 1, 0, 0), base = fixed(1, 0, 1, 10, 20);
    mt_anchored bases_b[] = {fixed(1, 0, 1, 30, 40), fixed(2, 0, 1, 50, 60)};
    mt_attachment in_a = {1, 1, &mark, &base}, in_b = {1, 2, &mark, bases_b};
    mt_lookup_builders made_a = {0}, made_b = {0};
    add_lookup(&made_a, MT_MARK_TO_MARK, &in_a, NULL);
    add_lookup(&made_b, MT_MARK_TO_MARK, &in_b, NULL);
    mt_small a = open_small("a.ttf", wide, &made_a), b = open_small("b.ttf", high, &made_b);
    mt_pairing glyphs[] = {{0, 0, 0, false}, {'A', 1, 1, true}, {0xE9, 3, 3, true}, {'B', 1, 2, true}};
    mt_charset charset = {.glyph_count = 4, .glyphs = glyphs};
    mt_anchors anchors = blend_small(&a, &b, &charset);
    const mt_attachment *both = anchors.lookups[0].attachments;
    assert_int_equal(anchors.lookups[0].attachment_count, 1);
    assert_int_equal(both->base_count, 2);
    assert_anchored(&both->bases[0], 1, 10, 20, 30, 40);
    assert_anchored(&both->bases[1], 3, 10, 20, 50, 60);
}

/* As in HarfBuzz: a lookup attaches anew what one before it attached, its first subtable that applies does. */
static void the_last_lookup_of_b_decides(void **state) {
    (void)state;
    mt_anchored mark = fixed(3, 0, 1, 0, 0), other = fixed(1, 0, 1, 30, 40);
    mt_anchored bases[] = {fixed(1, 0, 1, 10, 20), fixed(2, 0, 1, 5, 6)};
    mt_attachment in_a = {1, 2, &mark, bases}, first = {1, 1, &mark, bases}, last = {1, 1, &mark, &other};
    mt_lookup_builders made_a = {0}, made_b = {0};
    add_lookup(&made_a, MT_MARK_TO_BASE, &in_a, NULL);
    add_lookup(&made_b, MT_MARK_TO_BASE, &first, NULL);
    add_lookup(&made_b, MT_MARK_TO_BASE, &last, NULL);
    mt_small a = open_small("a.ttf", wide, &made_a), b = open_small("b.ttf", high, &made_b);
    mt_pairing glyphs[] = {{0, 0, 0, false}, {'A', 1, 1, true}, {'o', 2, 2, true}, {0xE9, 3, 3, true}};
    mt_charset charset = {.glyph_count = 4, .glyphs = glyphs};
    mt_anchors anchors = blend_small(&a, &b, &charset);
    assert_int_equal(anchors.lookups[0].attachment_count, 2); /* of both, and the rest */
    assert_anchored(anchors.lookups[0].attachments[0].bases, 1, 10, 20, 30, 40);
}

static void ligatures_go_by_their_components(void **state) {
    (void)state;
    mt_anchored mark = fixed(3, 0, 1, 0, 0);
    mt_anchored bases_a[] = {fixed(1, 0, 2, 100, 700), fixed(1, 1, 2, 500, 700), fixed(2, 0, 2, 1, 2)};
    mt_anchored bases_b[] = {fixed(1, 1, 2, 400, 600), fixed(2, 0, 3, 3, 4)};
    mt_attachment in_a = {1, 3, &mark, bases_a}, in_b = {1, 2, &mark, bases_b};
    mt_lookup_builders made_a = {0}, made_b = {0};
    add_lookup(&made_a, MT_MARK_TO_LIGATURE, &in_a, NULL);
    add_lookup(&made_b, MT_MARK_TO_LIGATURE, &in_b, NULL);
    mt_small a = open_small("a.ttf", wide, &made_a), b = open_small("b.ttf", wide, &made_b);
    mt_pairing glyphs[] = {{0, 0, 0, false}, {'A', 1, 1, true}, {'o', 2, 2, true}, {0xE9, 3, 3, true}};
    mt_charset charset = {.glyph_count = 4, .glyphs = glyphs};
    mt_anchors anchors = blend_small(&a, &b, &charset);
    assert_int_equal(anchors.lookups[0].attachment_count, 2);
    const mt_attachment *both = anchors.lookups[0].attachments, *rest = both + 1;
    assert_int_equal(both->base_count, 1);
    assert_int_equal(both->bases[0].component, 1);
    assert_anchored(&both->bases[0], 1, 500, 700, 400, 600);
    assert_int_equal(rest->base_count, 2);
    assert_anchored(&rest->bases[0], 1, 100, 700, 100, 700);
    assert_anchored(&rest->bases[1], 2, 1, 2, 1, 2);
}

static void cursive_anchors_are_mixed_each(void **state) {
    (void)state;
    mt_cursive_glyph in_a[] = {{1, {true, true}, {fixed(0, 0, 1, 600, 0).at, fixed(0, 0, 1, 0, 350).at}}};
    mt_cursive_glyph in_b[] = {{1, {true, false}, {fixed(0, 0, 1, 500, 10).at}}};
    mt_cursive cursive_a = {1, in_a}, cursive_b = {1, in_b};
    mt_lookup_builders made_a = {0}, made_b = {0};
    add_lookup(&made_a, MT_CURSIVE, NULL, &cursive_a);
    add_lookup(&made_b, MT_CURSIVE, NULL, &cursive_b);
    mt_small a = open_small("a.ttf", wide, &made_a), b = open_small("b.ttf", high, &made_b);
    mt_pairing glyphs[] = {{0, 0, 0, false}, {'A', 1, 1, true}};
    mt_charset charset = {.glyph_count = 2, .glyphs = glyphs};
    mt_anchors anchors = blend_small(&a, &b, &charset);
    assert_int_equal(anchors.lookups[0].cursive_count, 1);
    const mt_cursive_glyph *glyph = anchors.lookups[0].cursives[0].glyphs;
    assert_true(glyph->has[0] && glyph->has[1]);
    assert_true(glyph->at[0].in_fonts[1].x == 500 && glyph->at[0].in_fonts[1].y == 10);
    assert_true(glyph->at[1].in_fonts[1].x == 100 && glyph->at[1].in_fonts[1].y == 450);
}

/* ---- memory -------------------------------------------------------------------------------------------- */

/* Opens two small fonts, and blends and writes their anchors while allocation number `failing` fails. */
static mt_status blend_without(long failing, const char *paths[2]) {
    mt_arena scratch = {0};
    mt_font *fonts[2];
    mt_layout layouts[2];
    mt_systems systems;
    mt_anchors anchors;
    mt_lookup_builders made = {0};
    mt_pairing glyphs[] = {{0, 0, 0, false}, {'A', 1, 1, true}, {'o', 2, 2, true}, {0xE9, 3, 3, true}};
    mt_charset charset = {.glyph_count = 4, .glyphs = glyphs};
    for (int i = 0; i < 2; i++) {
        mt_bytes gpos;
        mt_assert_ok(mt_font_open(paths[i], &fonts[i]));
        mt_assert_ok(mt_font_table(fonts[i], MT_TAG('G', 'P', 'O', 'S'), &scratch, &gpos));
        mt_assert_ok(mt_layout_open(gpos, MT_EXTENSION_GPOS, &scratch, &layouts[i]));
    }
    mt_font_glyphs in_fonts = glyphs_of(&charset, &scratch);
    mt_assert_ok(mt_systems_make((const mt_layout *[]){&layouts[0], &layouts[1]}, 2, &scratch, &systems));
    mt_anchor_source sources[] = {{fonts[0], &layouts[0], &still}, {fonts[1], &layouts[1], &still}};
    mt_places half = at(&(mt_at){0.5, 0.5});
    mt_arena kept = {0};
    mt_allocation_fail(failing, false);
    mt_status status = mt_anchors_prepare(sources, &systems, NULL, 0, &in_fonts, 1000, &kept, &anchors);
    if (status == MT_OK) status = mt_anchors_write(&anchors, &half, &kept, &made);
    mt_allocation_succeed();
    for (int i = 0; i < 2; i++) mt_font_close(fonts[i]);
    mt_arena_release(&kept);
    mt_arena_release(&scratch);
    return status;
}

static void any_allocation_may_fail(void **state) {
    (void)state;
    mt_anchored mark = fixed(3, 0, 1, 50, 0), bases[] = {fixed(1, 0, 1, 300, 750), fixed(2, 0, 1, 250, 500)};
    mt_attachment in_a = {1, 2, &mark, bases}, in_b = {1, 1, &mark, bases + 1};
    mt_lookup_builders made_a = {0}, made_b = {0};
    add_lookup(&made_a, MT_MARK_TO_BASE, &in_a, NULL);
    add_lookup(&made_b, MT_MARK_TO_BASE, &in_b, NULL);
    mt_font_close(open_small("a.ttf", wide, &made_a).font);
    mt_font_close(open_small("b.ttf", high, &made_b).font);
    const char *paths[] = {mt_sample_path(&arena, directory, "a.ttf"),
                           mt_sample_path(&arena, directory, "b.ttf")};
    mt_status status = MT_NO_MEMORY;
    long failing = 0;
    for (; status == MT_NO_MEMORY; failing++) {
        mt_allocation_watch();
        status = blend_without(failing, paths);
        assert_int_equal(mt_allocation_live(), 0);
        mt_allocation_unwatch();
    }
    mt_assert_ok(status);
    assert_true(failing > 5);
}

/* ---- malformed tables ---------------------------------------------------------------------------------- */

static const uint32_t sample_text[] =
    U"aeouAEOUinαεАЕбوسلم\u0300\u0301\u0302\u0303\u0308\u0323\u064B\u064E\u0651";
static const int sample_length = sizeof sample_text / sizeof *sample_text - 1;

/* Blends a GPOS table with another, both of which may be anything, and writes what comes of it. */
static void blend_tables(mt_font *font, const mt_charset *charset, mt_bytes one, mt_bytes other) {
    mt_arena scratch = {0};
    mt_layout a, b;
    mt_systems systems;
    mt_anchors anchors;
    mt_lookup_builders made = {0};
    mt_assert_ok(mt_layout_open(one, MT_EXTENSION_GPOS, &scratch, &a));
    mt_assert_ok(mt_layout_open(other, MT_EXTENSION_GPOS, &scratch, &b));
    mt_assert_ok(mt_systems_make((const mt_layout *[]){&a, &b}, 2, &scratch, &systems));
    mt_anchor_source sources[] = {{font, &a, &still}, {font, &b, &still}};
    mt_font_glyphs glyphs = glyphs_of(charset, &scratch);
    mt_places half = at(&(mt_at){0.5, 0.5});
    mt_assert_ok(mt_anchors_prepare(sources, &systems, NULL, 0, &glyphs, 2048, &scratch, &anchors));
    mt_assert_ok(mt_anchors_write(&anchors, &half, &scratch, &made));
    mt_arena_release(&scratch);
}

/* A copy of its own, so that a reader past the end is found out, with some bytes changed, most of them near
 * the start. */
static mt_bytes spoilt(mt_bytes table, mt_random *random) {
    int length =
        mt_random_one_in(random, 4) ? mt_random_between(random, 1, (int)table.length) : (int)table.length;
    uint8_t *bytes = mt_test_new((size_t)length, 1);
    memcpy(bytes, table.bytes, (size_t)length);
    for (int i = mt_random_between(random, 0, 60); i > 0; i--) {
        int reach = mt_random_one_in(random, 2) && length > 3000 ? 3000 : length;
        bytes[mt_random_between(random, 0, reach - 1)] = (uint8_t)mt_random_between(random, 0, 255);
    }
    return (mt_bytes){bytes, (size_t)length};
}

static void malformed_tables_do_no_harm(void **state) {
    (void)state;
    mt_font *font = mt_test_font(MT_TEST_SANS);
    mt_bytes table;
    mt_charset charset;
    mt_assert_ok(mt_font_table(font, MT_TAG('G', 'P', 'O', 'S'), &arena, &table));
    mt_assert_ok(mt_charset_make(
        font, font, &(mt_charset_request){.wanted = sample_text, .count = sample_length}, &arena, &charset));
    for (int i = mt_test_cases(200); i > 0; i--) {
        mt_random random = mt_random_case(i);
        mt_bytes bad = spoilt(table, &random);
        blend_tables(font, &charset, bad, table);
        blend_tables(font, &charset, table, bad);
        free((void *)bad.bytes);
    }
    mt_font_close(font);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(large_lookups_are_split, mt_test_set_up, mt_test_tear_down),
        cmocka_unit_test_setup_teardown(ligatures_keep_their_components, mt_test_set_up, mt_test_tear_down),
        cmocka_unit_test_setup_teardown(many_cursive_glyphs_still_join, mt_test_set_up, mt_test_tear_down),
        cmocka_unit_test_setup_teardown(the_rest_is_as_in_a_and_moves_with_the_outline, mt_test_set_up,
                                        mt_test_tear_down),
        cmocka_unit_test_setup_teardown(glyphs_that_share_one_of_a_have_their_own, mt_test_set_up,
                                        mt_test_tear_down),
        cmocka_unit_test_setup_teardown(the_last_lookup_of_b_decides, mt_test_set_up, mt_test_tear_down),
        cmocka_unit_test_setup_teardown(ligatures_go_by_their_components, mt_test_set_up, mt_test_tear_down),
        cmocka_unit_test_setup_teardown(cursive_anchors_are_mixed_each, mt_test_set_up, mt_test_tear_down),
        cmocka_unit_test_setup_teardown(any_allocation_may_fail, mt_test_set_up, mt_test_tear_down),
        cmocka_unit_test_setup_teardown(malformed_tables_do_no_harm, mt_test_set_up, mt_test_tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
