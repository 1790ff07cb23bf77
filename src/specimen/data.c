/* What the specimen's script reads: JSON, in which no markup can be. */
#include "base/json.h"
#include "base/page.h"
#include "base/utf.h"
#include "source/font.h"
#include "specimen/specimen.h"

#include <hb.h>
#include <string.h>

/* ---- names --------------------------------------------------------------------------------------------- */

static void add_text(mt_json *json, const char *key, const char *text) {
    if (text) mt_json_text(json, key, text);
}

static void add_tag(mt_json *json, const char *key, uint32_t tag) {
    char text[5] = "";
    hb_tag_to_string(tag, text);
    mt_json_text(json, key, text);
}

/* Without the directory, which is nobody's business once the page is on the web. */
static const char *file_name(const mt_font *font) {
    const char *slash = strrchr(mt_font_spec(font), '/');
    return slash ? slash + 1 : mt_font_spec(font);
}

static void add_source(mt_json *json, const mt_font *font) {
    mt_names names;
    mt_font_names(font, &names);
    mt_json_object(json, NULL);
    mt_json_text(json, "family", mt_font_family(font));
    mt_json_text(json, "style", mt_font_style(font));
    mt_json_text(json, "file", file_name(font));
    add_text(json, "version", names.version);
    add_text(json, "designer", names.designer);
    add_text(json, "copyright", names.copyright);
    add_text(json, "trademark", names.trademark);
    add_text(json, "license", names.license);
    add_text(json, "license_url", names.license_url);
    mt_json_object_end(json);
}

static void add_heading(mt_json *json, const mt_specimen *specimen) {
    const mt_row *row = &specimen->request->variable->row;
    mt_json_text(json, "program", "Morphotype " MORPHOTYPE_VERSION);
    mt_json_text(json, "family", specimen->font.family);
    mt_json_text(json, "method", row->params.method == MT_METHOD_JOINT ? "joint" : "paper");
    mt_json_int(json, "bytes", (int64_t)specimen->packed_length);
    add_text(json, "text", specimen->request->text);
    mt_json_array(json, "sources");
    for (int i = 0; i < row->font_count; i++) add_source(json, row->fonts[i]);
    mt_json_array_end(json);
    mt_json_one_line(json);
    mt_json_array(json, "features");
    for (int i = 0; i < specimen->font.feature_count; i++) add_tag(json, NULL, specimen->font.features[i]);
    mt_json_array_end(json);
}

/* ---- characters ---------------------------------------------------------------------------------------- */

/* Those of the font's characters that `wanted` lets through, as one text. */
static void add_characters(mt_json *json, const char *key, const mt_specimen *specimen,
                           bool (*wanted)(const mt_specimen *specimen, int index, int than), int than) {
    mt_buffer text = {0};
    char bytes[4];
    mt_status status = MT_OK;
    for (int i = 0; i < specimen->font.char_count && status == MT_OK; i++)
        if (wanted(specimen, i, than))
            status = mt_buffer_add(&text, bytes, (size_t)mt_utf8_put(specimen->font.chars[i], bytes));
    if (status == MT_OK) status = mt_buffer_add(&text, "", 1);
    if (status == MT_OK)
        mt_json_text(json, key, (const char *)text.bytes);
    else
        json->status = status;
    mt_buffer_free(&text);
}

static bool has_script_of(const mt_specimen *specimen, int index, int than) {
    return specimen->font.scripts[index] == specimen->font.scripts[than];
}

static bool has_new_script(const mt_specimen *specimen, int index) {
    for (int i = 0; i < index; i++)
        if (has_script_of(specimen, i, index)) return false;
    return true;
}

/* One group for each script, in the order of their first characters. */
static void add_groups(mt_json *json, const mt_specimen *specimen) {
    mt_json_array(json, "groups");
    for (int i = 0; i < specimen->font.char_count; i++) {
        if (!has_new_script(specimen, i)) continue;
        mt_json_object(json, NULL);
        add_tag(json, "script", specimen->font.scripts[i]);
        add_characters(json, "characters", specimen, has_script_of, i);
        mt_json_object_end(json);
    }
    mt_json_array_end(json);
}

/* Not all fonts have the character, so that its glyph stays as it is. */
static bool is_still(const mt_specimen *specimen, int index, int than) {
    const mt_row *row = &specimen->request->variable->row;
    (void)than;
    for (int i = 0; i < row->font_count; i++)
        if (mt_given_glyph(&row->pairs, row->fonts, i, specimen->font.chars[index]) == 0) return true;
    return false;
}

/* ---- flags --------------------------------------------------------------------------------------------- */

static void add_reasons(mt_json *json, int step, const mt_report_glyph *glyph) {
    char reason[MT_REPORT_REASON_ROOM];
    for (unsigned flag = 1; flag <= MT_FLAG_ALL; flag <<= 1) {
        if (!(glyph->flags & flag)) continue;
        mt_report_reason(glyph, (mt_report_flag)flag, reason);
        mt_json_object(json, NULL);
        mt_json_int(json, "step", step);
        mt_json_text(json, "reason", reason);
        mt_json_object_end(json);
    }
}

/* The figures of a character's glyph on a step. */
static const mt_report_glyph *figures_of(const mt_specimen *specimen, int step, int index) {
    return &specimen->figures.steps[step][specimen->font.glyphs[index]];
}

static bool is_flagged(const mt_specimen *specimen, int index) {
    for (int i = 0; i < specimen->figures.step_count; i++)
        if (figures_of(specimen, i, index)->flags) return true;
    return false;
}

static void add_flagged_one(mt_json *json, const mt_specimen *specimen, int index) {
    char character[5] = "";
    mt_utf8_put(specimen->font.chars[index], character);
    mt_json_one_line(json);
    mt_json_object(json, NULL);
    mt_json_text(json, "character", character);
    mt_json_array(json, "reasons");
    for (int i = 0; i < specimen->figures.step_count; i++)
        add_reasons(json, i, figures_of(specimen, i, index));
    mt_json_array_end(json);
    mt_json_object_end(json);
}

static void add_flagged(mt_json *json, const mt_specimen *specimen) {
    mt_json_array(json, "flagged");
    for (int i = 0; i < specimen->font.char_count; i++)
        if (is_flagged(specimen, i)) add_flagged_one(json, specimen, i);
    mt_json_array_end(json);
}

/* ---- the data ------------------------------------------------------------------------------------------ */

mt_status mt_specimen_data(const mt_specimen *specimen, mt_buffer *text) {
    mt_json json = {0};
    mt_json_object(&json, NULL);
    add_heading(&json, specimen);
    add_groups(&json, specimen);
    add_flagged(&json, specimen);
    add_characters(&json, "still", specimen, is_still, 0);
    mt_json_object_end(&json);
    mt_status status = json.status == MT_OK ? mt_page_add_json(text, &json.text) : json.status;
    mt_buffer_free(&json.text);
    return status;
}
