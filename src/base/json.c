#include "base/json.h"

#include "base/decimal.h"
#include "base/real.h"
#include "base/utf.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static void add(mt_json *json, const char *text) {
    if (json->status == MT_OK) json->status = mt_buffer_add(&json->text, text, strlen(text));
}

static void new_line(mt_json *json) {
    add(json, "\n");
    for (int i = 0; i < json->depth; i++) add(json, "  ");
}

static bool on_one_line(const mt_json *json) {
    return json->line_depth > 0 && json->depth >= json->line_depth;
}

static void add_character(mt_json *json, uint32_t code_point) {
    char text[8];
    if (code_point == '"' || code_point == '\\')
        snprintf(text, sizeof text, "\\%c", (char)code_point);
    else if (code_point < ' ')
        snprintf(text, sizeof text, "\\u%04x", (unsigned)code_point);
    else
        text[mt_utf8_put(code_point, text)] = '\0';
    add(json, text);
}

static void add_string(mt_json *json, const char *utf8) {
    add(json, "\"");
    while (*utf8) {
        uint32_t code_point = MT_REPLACEMENT;
        if (!mt_utf8_next(&utf8, &code_point)) utf8++;
        add_character(json, code_point);
    }
    add(json, "\"");
}

/* What stands before a value: a comma after the one before it, a new line, its name. */
static void begin_value(mt_json *json, const char *key) {
    if (json->depth > 0 && !json->first) add(json, on_one_line(json) ? ", " : ",");
    if (json->depth > 0 && !on_one_line(json)) new_line(json);
    if (key) {
        add_string(json, key);
        add(json, ": ");
    }
    json->first = false;
}

static void begin_container(mt_json *json, const char *key, const char *bracket) {
    begin_value(json, key);
    add(json, bracket);
    json->depth++;
    json->first = true;
}

static void end_container(mt_json *json, const char *bracket) {
    bool breaks = !json->first && !on_one_line(json);
    json->depth--;
    if (breaks) new_line(json);
    if (json->depth < json->line_depth) json->line_depth = 0;
    add(json, bracket);
    if (json->depth == 0) add(json, "\n");
    json->first = false;
}

void mt_json_object(mt_json *json, const char *key) {
    begin_container(json, key, "{");
}

void mt_json_object_end(mt_json *json) {
    end_container(json, "}");
}

void mt_json_array(mt_json *json, const char *key) {
    begin_container(json, key, "[");
}

void mt_json_array_end(mt_json *json) {
    end_container(json, "]");
}

void mt_json_one_line(mt_json *json) {
    if (json->line_depth == 0) json->line_depth = json->depth + 1;
}

void mt_json_text(mt_json *json, const char *key, const char *utf8) {
    begin_value(json, key);
    add_string(json, utf8);
}

void mt_json_bool(mt_json *json, const char *key, bool value) {
    begin_value(json, key);
    add(json, value ? "true" : "false");
}

void mt_json_int(mt_json *json, const char *key, int64_t value) {
    char text[24];
    snprintf(text, sizeof text, "%" PRId64, value);
    begin_value(json, key);
    add(json, text);
}

void mt_json_real(mt_json *json, const char *key, double value, int digits) {
    char text[MT_REAL_ROOM];
    mt_real_write(value, digits, text);
    begin_value(json, key);
    add(json, text);
}

void mt_json_number(mt_json *json, const char *key, double value) {
    char text[MT_DECIMAL_ROOM];
    mt_decimal_write(value, 9, text);
    begin_value(json, key);
    add(json, text);
}
