#include "base/base64.h"
#include "base/html.h"
#include "specimen/specimen.h"
#include "support/allocation.h"
#include "support/check.h"
#include "support/fixture.h"
#include "support/fonts.h"
#include "support/sample.h"

#include <string.h>
#include <unistd.h>

/* Each test leaves the directory empty. */
static int tear_down(void **state) {
    (void)state;
    assert_int_equal(rmdir(directory), 0);
    mt_arena_release(&arena);
    return 0;
}

/* ---- parts of a page ------------------------------------------------------------------------------------- */

static void assert_text(mt_buffer *text, const char *wanted) {
    assert_int_equal(text->length, strlen(wanted));
    assert_memory_equal(text->bytes, wanted, text->length);
    mt_buffer_free(text);
}

/* RFC 4648, section 10. */
static void base64_is_that_of_the_rfc(void **state) {
    (void)state;
    static const char *const pairs[][2] = {
        {"f", "Zg=="},         {"fo", "Zm8="},         {"foo", "Zm9v"},         {"foob", "Zm9vYg=="},
        {"fooba", "Zm9vYmE="}, {"foobar", "Zm9vYmFy"}, {"\xff\xfe\xfd", "//79"}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        mt_buffer text = {0};
        mt_assert_ok(mt_base64_add(&text, (const uint8_t *)pairs[i][0], strlen(pairs[i][0])));
        assert_text(&text, pairs[i][1]);
    }
}

/* More than is encoded at a time. */
static void long_base64_goes_on(void **state) {
    (void)state;
    enum { LENGTH = 5000 };
    uint8_t zeros[LENGTH] = {0};
    mt_buffer text = {0};
    mt_assert_ok(mt_base64_add(&text, zeros, LENGTH));
    assert_int_equal(text.length, (LENGTH + 2) / 3 * 4);
    for (size_t i = 0; i < text.length; i++) assert_int_equal(text.bytes[i], i + 1 < text.length ? 'A' : '=');
    mt_buffer_free(&text);
}

static void text_in_a_page_is_escaped(void **state) {
    (void)state;
    static const char *const pairs[][2] = {{"a<b>&\"'", "a&lt;b&gt;&amp;&quot;&#39;"},
                                           {"形", "形"},
                                           {"\x01\x7f", "\xef\xbf\xbd\xef\xbf\xbd"},
                                           {"\xff", "\xef\xbf\xbd"}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        mt_buffer text = {0};
        mt_assert_ok(mt_html_text(&text, pairs[i][0]));
        assert_text(&text, pairs[i][1]);
    }
}

static void pages_are_known_by_their_extension(void **state) {
    (void)state;
    assert_true(mt_specimen_is_page("a.b/x.html"));
    assert_true(mt_specimen_is_page("X.HTML"));
    assert_false(mt_specimen_is_page("x.html.gz"));
    assert_false(mt_specimen_is_page("html"));
}

/* ---- want of memory -------------------------------------------------------------------------------------- */

static const uint32_t letters[] = {'g'};

static mt_status save(mt_font *const *fonts, const mt_params *params, const char *path) {
    mt_variable *variable;
    mt_status status = mt_variable_new(fonts, 2, params, &variable);
    if (status != MT_OK) return status;
    const mt_specimen_request request = {.variable = variable, .text = "g"};
    status = mt_variable_set_chars(variable, letters, 1);
    if (status == MT_OK) status = mt_specimen_save(&request, path);
    mt_variable_free(variable);
    return status;
}

/* With request number `first` failing. */
static mt_status save_failing(long first, const char *path) {
    mt_params params = mt_params_default();
    params.threads = 1;
    mt_font *fonts[2];
    mt_allocation_watch();
    mt_assert_ok(mt_font_open(MT_TEST_SANS, &fonts[0]));
    mt_assert_ok(mt_font_open(MT_TEST_SERIF, &fonts[1]));
    mt_allocation_fail(first, false);
    mt_status status = save(fonts, &params, path);
    mt_allocation_succeed();
    for (int i = 0; i < 2; i++) mt_font_close(fonts[i]);
    long live = mt_allocation_live();
    mt_allocation_unwatch();
    assert_int_equal(live, 0);
    return status;
}

/* Every third request fails in turn: the whole is long. */
static void survives_want_of_memory(void **state) {
    (void)state;
    const char *path = mt_sample_path(&arena, directory, "x.html");
    mt_status status = MT_NO_MEMORY;
    mt_font_close(mt_test_font(MT_TEST_SANS));
    mt_font_close(mt_test_font(MT_TEST_SERIF));
    for (long first = 0; status != MT_OK; first += 3) {
        status = save_failing(first, path);
        assert_true(status == MT_OK || status == MT_NO_MEMORY);
        assert_int_equal(access(path, F_OK) == 0, status == MT_OK);
    }
    assert_int_equal(unlink(path), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(base64_is_that_of_the_rfc), cmocka_unit_test(long_base64_goes_on),
        cmocka_unit_test(text_in_a_page_is_escaped), cmocka_unit_test(pages_are_known_by_their_extension),
        cmocka_unit_test(survives_want_of_memory),
    };
    return cmocka_run_group_tests(tests, mt_test_set_up, tear_down);
}
