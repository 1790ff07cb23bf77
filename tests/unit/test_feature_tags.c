/* The features that text has without asking for them, against the lookups of HarfBuzz's own shaping plans. */
#include "layout/feature_tags.h"
#include "sfnt/layout_face.h"
#include "support/check.h"
#include "support/gsub.h"

#include <hb-ot.h>
#include <string.h>

static const char *const tags[] = {
    "aalt", "abvf", "abvm", "abvs", "afrc", "akhn", "blwf", "blwm", "blws", "c2pc", "c2sc", "calt",
    "case", "ccmp", "cfar", "cjct", "clig", "cpct", "cpsp", "cswh", "cv01", "cv99", "dlig", "dnom",
    "expt", "falt", "fin2", "fin3", "fina", "frac", "fwid", "half", "haln", "hist", "hkna", "hlig",
    "hngl", "hojo", "hwid", "init", "isol", "ital", "jalt", "jp78", "jp83", "jp90", "jp04", "ljmo",
    "lnum", "locl", "ltra", "ltrm", "med2", "medi", "mgrk", "mset", "nalt", "nlck", "nukt", "numr",
    "onum", "ordn", "ornm", "pcap", "pkna", "pnum", "pref", "pres", "pstf", "psts", "pwid", "qwid",
    "rand", "rclt", "rkrf", "rlig", "rphf", "rtla", "rtlm", "ruby", "rvrn", "salt", "sinf", "smcp",
    "smpl", "ss01", "ss20", "stch", "subs", "sups", "swsh", "titl", "tjmo", "tnam", "tnum", "trad",
    "twid", "unic", "vatu", "vert", "vjmo", "vrt2", "vrtr", "zero", "XYZ1",
};
enum { COUNT = sizeof tags / sizeof *tags };

static mt_arena arena;

static int tear_down(void **state) {
    (void)state;
    mt_arena_release(&arena);
    return 0;
}

static uint32_t tag_of(const char *text) {
    return MT_TAG((uint32_t)text[0], (uint32_t)text[1], (uint32_t)text[2], (uint32_t)text[3]);
}

/* A table with one lookup for each tag, number i for tags[i], in the script. */
static mt_bytes table_of(const char *script) {
    mt_test_lookup lookups[COUNT];
    for (int i = 0; i < COUNT; i++) lookups[i] = (mt_test_lookup){tags[i], NULL, 1, "1 2"};
    mt_bytes table = mt_test_gsub(lookups, COUNT, false, &arena);
    assert_memory_equal(table.bytes + 12, "latn", 4); /* the first script record's */
    memcpy((uint8_t *)table.bytes + 12, script, 4);
    return table;
}

/* Marks the features whose lookups HarfBuzz's plan for the script has. */
static void mark_planned(const char *tag, hb_script_t script, hb_direction_t direction, bool *planned) {
    mt_face_tables tables = {.gsub = table_of(tag), .glyph_count = 3};
    hb_face_t *face = mt_face_make(&tables);
    hb_segment_properties_t text = {
        .direction = direction, .script = script, .language = HB_LANGUAGE_INVALID};
    assert_non_null(face);
    hb_shape_plan_t *plan = hb_shape_plan_create(face, &text, NULL, 0, (const char *const[]){"ot", NULL});
    hb_set_t *lookups = hb_set_create();
    hb_ot_shape_plan_collect_lookups(plan, HB_OT_TAG_GSUB, lookups);
    for (int i = 0; i < COUNT; i++) planned[i] |= hb_set_has(lookups, (hb_codepoint_t)i);
    hb_set_destroy(lookups);
    hb_shape_plan_destroy(plan);
    hb_face_destroy(face);
}

static void as_harfbuzz_plans(void **state) {
    (void)state;
    static const struct {
        const char *tag;
        hb_script_t script;
    } scripts[] = {
        {"latn", HB_SCRIPT_LATIN},      {"arab", HB_SCRIPT_ARABIC},    {"syrc", HB_SCRIPT_SYRIAC},
        {"hang", HB_SCRIPT_HANGUL},     {"hebr", HB_SCRIPT_HEBREW},    {"dev2", HB_SCRIPT_DEVANAGARI},
        {"deva", HB_SCRIPT_DEVANAGARI}, {"mlm2", HB_SCRIPT_MALAYALAM}, {"khmr", HB_SCRIPT_KHMER},
        {"mym2", HB_SCRIPT_MYANMAR},    {"thai", HB_SCRIPT_THAI},      {"tibt", HB_SCRIPT_TIBETAN},
        {"bali", HB_SCRIPT_BALINESE},   {"mong", HB_SCRIPT_MONGOLIAN}, {"kana", HB_SCRIPT_KATAKANA},
    };
    bool planned[COUNT] = {false};
    for (size_t i = 0; i < sizeof scripts / sizeof *scripts; i++) {
        mark_planned(scripts[i].tag, scripts[i].script, HB_DIRECTION_LTR, planned);
        mark_planned(scripts[i].tag, scripts[i].script, HB_DIRECTION_RTL, planned);
        mark_planned(scripts[i].tag, scripts[i].script, HB_DIRECTION_TTB, planned);
    }
    for (int i = 0; i < COUNT; i++)
        if (mt_feature_is_automatic(tag_of(tags[i]), true) != planned[i])
            fail_msg("%s: HarfBuzz %s", tags[i], planned[i] ? "applies it" : "does not apply it");
}

/* Around a fraction slash alone. */
static void fractions(void **state) {
    (void)state;
    assert_false(mt_feature_is_automatic(tag_of("frac"), false));
    assert_false(mt_feature_is_automatic(tag_of("numr"), false));
    assert_false(mt_feature_is_automatic(tag_of("dnom"), false));
    assert_true(mt_feature_is_automatic(tag_of("liga"), false));
    assert_false(mt_feature_is_automatic(0, true));
}

static void formulas(void **state) {
    (void)state;
    assert_true(mt_feature_is_automatic(tag_of("ssty"), false));
    assert_true(mt_feature_is_automatic(tag_of("dtls"), false));
    assert_true(mt_feature_is_automatic(tag_of("flac"), false));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_harfbuzz_plans),
        cmocka_unit_test(fractions),
        cmocka_unit_test(formulas),
    };
    return cmocka_run_group_tests(tests, NULL, tear_down);
}
