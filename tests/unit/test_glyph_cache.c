/* Prepared glyphs as bytes, what they are found by, and the files that they are kept in. */
#include "base/tree.h"
#include "cache/cache.h"
#include "cache/store.h"
#include "morph/between/instance.h"
#include "morph/prepare.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/fonts.h"
#include "support/random.h"
#include "support/sample.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- digests ------------------------------------------------------------------------------------------------- */

static void assert_digest(const char *text, int times, const char *expected) {
    char hexadecimal[2 * MT_DIGEST_BYTES + 1];
    mt_hashing hashing = mt_hashing_begin();
    for (int i = 0; i < times; i++) mt_hashing_add(&hashing, text, strlen(text));
    mt_digest digest = mt_hashing_end(&hashing);
    for (int i = 0; i < MT_DIGEST_BYTES; i++) sprintf(hexadecimal + 2 * i, "%02x", digest.bytes[i]);
    assert_string_equal(hexadecimal, expected);
}

/* The examples of FIPS 180-2, appendix B, and of nothing. */
static void digests_are_the_standard_s(void **state) {
    (void)state;
    assert_digest("", 1, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    assert_digest("abc", 1, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    assert_digest("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq", 1,
                  "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    assert_digest("a", 1000000, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

/* ---- glyphs as bytes ----------------------------------------------------------------------------------------- */

static mt_prepared prepare(uint32_t code_point, const mt_params *params) {
    mt_font *fonts[2] = {mt_test_font(MT_TEST_SANS), mt_test_font(MT_TEST_SERIF)};
    mt_prepared made = {.at_fault = -1};
    mt_assert_ok(mt_test_glyph_shape(fonts[0], code_point, params->tolerance, &arena, &made.a));
    mt_assert_ok(mt_test_glyph_shape(fonts[1], code_point, params->tolerance, &arena, &made.b));
    made.status = mt_morph_prepare(&made.a, &made.b, NULL, params, &arena, &made.morph);
    for (int i = 0; i < 2; i++) mt_font_close(fonts[i]);
    return made;
}

static void assert_same_outline(const mt_morph *p, const mt_morph *q, const mt_params *params) {
    mt_outline of_p, of_q;
    mt_assert_ok(mt_morph_outline(p, mt_weights_at(0.3), params, &arena, &of_p));
    mt_assert_ok(mt_morph_outline(q, mt_weights_at(0.3), params, &arena, &of_q));
    assert_int_equal(of_p.count, of_q.count);
    for (int i = 0; i < of_p.count; i++) {
        assert_int_equal(of_p.contours[i].count, of_q.contours[i].count);
        for (int k = 0; k < of_p.contours[i].count; k++)
            assert_true(mt_point_equal(of_p.contours[i].segments[k].end, of_q.contours[i].segments[k].end));
    }
}

/* Letters with cuts, holes and links, a blank, and one that failed, by both methods. */
static void what_is_unpacked_is_what_was_packed(void **state) {
    (void)state;
    mt_params params = mt_params_default();
    for (int k = 0; k < 2 * mt_test_latin_count; k++) {
        mt_buffer bytes = {0}, again = {0};
        mt_prepared unpacked;
        params.method = k % 2 ? MT_METHOD_PAPER : MT_METHOD_JOINT;
        mt_prepared made = prepare(mt_test_latin[k / 2], &params);
        mt_assert_ok(mt_prepared_pack(&made, &bytes));
        mt_assert_ok(mt_prepared_unpack(bytes.bytes, bytes.length, &arena, &unpacked));
        mt_assert_ok(mt_prepared_pack(&unpacked, &again));
        assert_int_equal(bytes.length, again.length);
        assert_memory_equal(bytes.bytes, again.bytes, bytes.length);
        assert_int_equal(made.status, unpacked.status);
        if (made.status == MT_OK) assert_same_outline(&made.morph, &unpacked.morph, &params);
        mt_buffer_free(&bytes);
        mt_buffer_free(&again);
        mt_arena_reset(&arena);
    }
}

static void failures_are_kept_too(void **state) {
    (void)state;
    mt_buffer bytes = {0};
    mt_prepared made = {.status = MT_TOO_LARGE, .at_fault = 1}, unpacked;
    mt_assert_ok(mt_prepared_pack(&made, &bytes));
    mt_assert_ok(mt_prepared_unpack(bytes.bytes, bytes.length, &arena, &unpacked));
    assert_int_equal(unpacked.status, MT_TOO_LARGE);
    assert_int_equal(unpacked.at_fault, 1);
    mt_buffer_free(&bytes);
    made.status = MT_STOPPED;
    assert_false(mt_prepared_is_lasting(&made));
    made.status = MT_NO_MEMORY;
    assert_false(mt_prepared_is_lasting(&made));
    mt_assert_ok(mt_prepared_pack(&made, &bytes));
    assert_int_equal(mt_prepared_unpack(bytes.bytes, bytes.length, &arena, &unpacked), MT_BAD_GEOMETRY);
    mt_buffer_free(&bytes);
}

/* Cut short at each byte, it is refused; with a byte changed, refused or valid. */
static void damage_is_seen(void **state) {
    (void)state;
    mt_params params = mt_params_default();
    mt_buffer bytes = {0};
    mt_prepared made = prepare('B', &params), unpacked;
    mt_random random = mt_random_case(0);
    mt_assert_ok(mt_prepared_pack(&made, &bytes));
    for (size_t i = 0; i < bytes.length; i++) {
        mt_arena_place before = mt_arena_mark(&arena);
        assert_int_equal(mt_prepared_unpack(bytes.bytes, i, &arena, &unpacked), MT_BAD_GEOMETRY);
        uint8_t was = bytes.bytes[i];
        bytes.bytes[i] ^= (uint8_t)mt_random_between(&random, 1, 255);
        if (mt_prepared_unpack(bytes.bytes, bytes.length, &arena, &unpacked) == MT_OK)
            assert_true(unpacked.status != MT_OK || mt_morph_is_valid(&unpacked.morph));
        bytes.bytes[i] = was;
        mt_arena_rewind(&arena, before);
    }
    mt_buffer_free(&bytes);
}

/* ---- keys ---------------------------------------------------------------------------------------------------- */

static bool same_key(const mt_digest *p, const mt_digest *q) {
    return memcmp(p->bytes, q->bytes, MT_DIGEST_BYTES) == 0;
}

static mt_digest key_of(const mt_outline outlines[2], const mt_hints *hints, const mt_params *params) {
    mt_digest key;
    mt_assert_ok(mt_cache_key(outlines, hints, params, &key));
    return key;
}

/* Each parameter by itself, both outlines swapped or one point moved, and hints. */
static void all_that_matters_is_in_the_key(void **state) {
    (void)state;
    mt_segment segments[] = {{1, {{0}}, {10, 0}}, {2, {{10, 10}}, {0, 10}}, {1, {{0}}, {0, 0}}};
    mt_contour contour = {3, segments}, none = {0};
    mt_outline outlines[] = {{1, &contour}, {0, &none}}, swapped[] = {{0, &none}, {1, &contour}};
    mt_hint hint = {MT_HINT_POINT, {1, 2}, {3, 4}};
    mt_hints hints = {1, &hint};
    const mt_params usual = mt_params_default();
    mt_params changed[12];
    for (size_t i = 0; i < 12; i++) changed[i] = usual;
    changed[0].method = MT_METHOD_PAPER, changed[1].tolerance *= 2, changed[2].fit *= 2;
    changed[3].weights[0] += 0.1, changed[4].weights[2] += 0.1, changed[5].rounds++;
    changed[6].threshold += 0.1, changed[7].one_scale = true, changed[8].rotation = MT_ROTATION_FOUND;
    changed[9].degrees++, changed[10].lean++, changed[11].effort *= 2;
    mt_digest key = key_of(outlines, NULL, &usual), other = key_of(swapped, NULL, &usual);
    assert_false(same_key(&key, &other));
    for (size_t i = 0; i < 12; i++) {
        other = key_of(outlines, NULL, &changed[i]);
        assert_false(same_key(&key, &other));
    }
    mt_digest hinted = key_of(outlines, &hints, &usual);
    assert_false(same_key(&key, &hinted));
    hint.b.y++;
    other = key_of(outlines, &hints, &usual);
    assert_false(same_key(&hinted, &other));
    segments[1].control[0].x++;
    other = key_of(outlines, NULL, &usual);
    assert_false(same_key(&key, &other));
    segments[1].control[0].x--;
    changed[0] = usual;
    changed[0].threads = 7;
    other = key_of(outlines, NULL, &changed[0]);
    assert_true(same_key(&key, &other));
}

/* ---- files --------------------------------------------------------------------------------------------------- */

static mt_digest numbered_key(int number) {
    mt_digest key = {{0x3f, (uint8_t)(number >> 8), (uint8_t)number}};
    return key;
}

static char *file_of(int number) {
    char name[128];
    snprintf(name, sizeof name, "cache/3f/%04x%058d", (unsigned)number, 0);
    return mt_sample_path(&arena, directory, name);
}

static mt_store *open_store(uint64_t most) {
    mt_store *store;
    mt_assert_ok(mt_store_open(mt_sample_path(&arena, directory, "cache"), most, &store));
    return store;
}

static bool is_kept(mt_store *store, int number, const uint8_t *expected, size_t expected_length) {
    mt_digest key = numbered_key(number);
    const uint8_t *bytes;
    size_t length;
    if (!mt_store_read(store, &key, &arena, &bytes, &length)) return false;
    assert_int_equal(length, expected_length);
    assert_memory_equal(bytes, expected, length);
    return true;
}

static void an_entry_is_found_unless_it_is_damaged(void **state) {
    (void)state;
    static const uint8_t content[] = "what was prepared";
    mt_store *store = open_store(1 << 24);
    mt_digest key = numbered_key(1);
    size_t length;
    assert_false(is_kept(store, 1, content, sizeof content));
    assert_true(mt_store_write(store, &key, content, sizeof content));
    assert_true(is_kept(store, 1, content, sizeof content));
    uint8_t *entry = mt_sample_load(&arena, file_of(1), &length);
    mt_sample_save(file_of(2), entry, length); /* in another's place */
    assert_false(is_kept(store, 2, content, sizeof content));
    for (size_t i = 0; i < length; i++) {
        entry[i] ^= 1;
        mt_sample_save(file_of(1), entry, length);
        entry[i] ^= 1;
        assert_false(is_kept(store, 1, content, sizeof content));
        mt_sample_save(file_of(1), entry, i); /* torn */
        assert_false(is_kept(store, 1, content, sizeof content));
    }
    assert_true(mt_store_write(store, &key, content, sizeof content));
    assert_true(is_kept(store, 1, content, sizeof content));
    mt_store_close(store);
}

/* A folder of 16 blocks: it never has more than an eighth over that, and what was used last is there. */
static void the_oldest_go(void **state) {
    (void)state;
    enum { BLOCK = 4096, BLOCKS = 16, WRITTEN = 100 };
    static const uint8_t content[BLOCK / 2];
    mt_store *store = open_store((uint64_t)256 * BLOCKS * BLOCK);
    for (int i = 0; i < WRITTEN; i++) {
        int there = 0;
        mt_digest key = numbered_key(i);
        assert_true(mt_store_write(store, &key, content, sizeof content));
        if (i > 0) assert_true(is_kept(store, 0, content, sizeof content)); /* used again and again */
        for (int k = 0; k <= i; k++) there += access(file_of(k), F_OK) == 0;
        assert_true(there <= BLOCKS + BLOCKS / 8);
        assert_true(there >= (i < BLOCKS ? i + 1 : BLOCKS / 2));
        assert_int_equal(access(file_of(i), F_OK), 0);
    }
    assert_false(is_kept(store, 1, content, sizeof content));
    mt_store_close(store);
}

static void a_place_that_cannot_be_is_refused(void **state) {
    (void)state;
    mt_cache *cache;
    mt_sample_save(mt_sample_path(&arena, directory, "file"), "x", 1);
    const char *file = mt_sample_path(&arena, directory, "file"),
               *nowhere = mt_sample_path(&arena, directory, "nowhere/cache");
    assert_int_equal(mt_cache_open(file, 0, &cache), MT_CANNOT_WRITE);
    assert_int_equal(mt_cache_open(nowhere, 0, &cache), MT_CANNOT_WRITE);
    assert_int_equal(mt_cache_open(mt_sample_path(&arena, directory, "small"), 1, &cache), MT_BAD_PARAMETER);
}

static int tear_down(void **state) {
    mt_tree_remove(mt_sample_path(&arena, directory, "cache"));
    return mt_test_tear_down(state);
}

int main(void) {
    const struct CMUnitTest pure[] = {
        cmocka_unit_test(digests_are_the_standard_s),
        cmocka_unit_test(what_is_unpacked_is_what_was_packed),
        cmocka_unit_test(failures_are_kept_too),
        cmocka_unit_test(damage_is_seen),
        cmocka_unit_test(all_that_matters_is_in_the_key),
    };
    const struct CMUnitTest files[] = {
        cmocka_unit_test_setup_teardown(an_entry_is_found_unless_it_is_damaged, mt_test_set_up, tear_down),
        cmocka_unit_test_setup_teardown(the_oldest_go, mt_test_set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_place_that_cannot_be_is_refused, mt_test_set_up, tear_down),
    };
    int failed = cmocka_run_group_tests(pure, NULL, NULL);
    mt_arena_release(&arena);
    return failed + cmocka_run_group_tests(files, NULL, NULL);
}
