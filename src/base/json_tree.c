#include "base/json_tree.h"

#include <string.h>

#include "base/real.h"
#include "base/utf.h"

enum { LEVELS_MAX = 64, MEMBERS_MAX = 256, NUMBER_ROOM = 128 };

typedef struct mt_json_reading {
    const char *at, *end;
    mt_arena *arena;
    int level;
} mt_json_reading;

static mt_status read_value(mt_json_reading *r, mt_json_value **value);

static void skip_blanks(mt_json_reading *r) {
    while (r->at < r->end && (*r->at == ' ' || *r->at == '\t' || *r->at == '\n' || *r->at == '\r')) r->at++;
}

static bool take(mt_json_reading *r, char c) {
    skip_blanks(r);
    bool there = r->at < r->end && *r->at == c;
    r->at += there;
    return there;
}

/* ---- strings ------------------------------------------------------------------------------------------- */

/* Four hexadecimal digits; -1 where there are none. */
static int read_unit(mt_json_reading *r) {
    int value = 0;
    if (r->end - r->at < 4) return -1;
    for (int i = 0; i < 4; i++) {
        static const char digits[] = "0123456789abcdef";
        char c = *r->at++;
        const char *digit = c ? strchr(digits, c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c) : NULL;
        if (!digit) return -1;
        value = value * 16 + (int)(digit - digits);
    }
    return value;
}

/* What stands behind a backslash, as UTF-8; a half of a pair that is alone becomes U+FFFD. 0 bytes where it is wrong. */
static int read_escape(mt_json_reading *r, char bytes[4]) {
    static const char from[] = "\"\\/bfnrt", to[] = "\"\\/\b\f\n\r\t";
    char c = r->at < r->end ? *r->at++ : '\0';
    const char *known = c ? strchr(from, c) : NULL;
    if (known) {
        bytes[0] = to[known - from];
        return 1;
    }
    int unit = c == 'u' ? read_unit(r) : -1;
    if (unit < 0) return 0;
    uint32_t code_point = (uint32_t)unit;
    bool first = unit >= 0xD800 && unit < 0xDC00;
    if (first && r->end - r->at >= 6 && r->at[0] == '\\' && r->at[1] == 'u') {
        r->at += 2;
        int second = read_unit(r);
        if (second < 0) return 0;
        bool whole = second >= 0xDC00 && second < 0xE000;
        code_point =
            whole ? 0x10000 + ((code_point - 0xD800) << 10) + (uint32_t)(second - 0xDC00) : MT_REPLACEMENT;
    } else if (unit >= 0xD800 && unit < 0xE000) {
        code_point = MT_REPLACEMENT;
    }
    return mt_utf8_put(code_point ? code_point : MT_REPLACEMENT, bytes);
}

/* From behind the quotation mark to behind the next. */
static mt_status read_string(mt_json_reading *r, const char **text) {
    const char *end = r->at;
    while (end < r->end && *end != '"') end += *end == '\\' && end + 1 < r->end ? 2 : 1;
    if (end >= r->end) return MT_BAD_PARAMETER;
    char *string = mt_arena_new(r->arena, (size_t)(end - r->at) + 1, 1), *to = string;
    if (!string) return MT_NO_MEMORY;
    while (r->at < end) {
        char c = *r->at++;
        if ((unsigned char)c < ' ') return MT_BAD_PARAMETER;
        int length = 1;
        if (c == '\\')
            length = read_escape(r, to);
        else
            *to = c;
        if (length == 0) return MT_BAD_PARAMETER;
        to += length;
    }
    if (!mt_utf8_is_valid(string, (size_t)(to - string))) return MT_BAD_PARAMETER;
    r->at = end + 1;
    *text = string;
    return MT_OK;
}

/* ---- values -------------------------------------------------------------------------------------------- */

static mt_status read_number(mt_json_reading *r, mt_json_value *value) {
    char text[NUMBER_ROOM];
    const char *at = text;
    size_t length = 0;
    while (r->at + length < r->end && strchr("+-.0123456789eE", r->at[length]) && r->at[length]) length++;
    if (length == 0 || length >= NUMBER_ROOM) return MT_BAD_PARAMETER;
    memcpy(text, r->at, length);
    text[length] = '\0';
    if (!mt_real_next(&at, &value->number) || *at != '\0') return MT_BAD_PARAMETER;
    value->kind = MT_JSON_NUMBER;
    r->at += length;
    return MT_OK;
}

static mt_status read_word(mt_json_reading *r, mt_json_value *value) {
    static const struct {
        const char *word;
        mt_json_kind kind;
    } words[] = {{"null", MT_JSON_NULL}, {"false", MT_JSON_FALSE}, {"true", MT_JSON_TRUE}};
    for (int i = 0; i < 3; i++) {
        size_t length = strlen(words[i].word);
        if ((size_t)(r->end - r->at) < length || memcmp(r->at, words[i].word, length) != 0) continue;
        value->kind = words[i].kind;
        r->at += length;
        return MT_OK;
    }
    return read_number(r, value);
}

static mt_status read_key(mt_json_reading *r, const char **key) {
    if (!take(r, '"')) return MT_BAD_PARAMETER;
    mt_status status = read_string(r, key);
    return status == MT_OK && !take(r, ':') ? MT_BAD_PARAMETER : status;
}

/* An array's items one by one, for mt_json_item. */
static mt_status list_items(mt_json_reading *r, mt_json_value *array) {
    array->items = mt_arena_new(r->arena, (size_t)array->count, sizeof(mt_json_value *));
    if (!array->items) return MT_NO_MEMORY;
    int i = 0;
    for (mt_json_value *item = array->first; item; item = item->next) array->items[i++] = item;
    return MT_OK;
}

/* An array or an object, from behind its first bracket to behind its last. */
static mt_status read_container(mt_json_reading *r, mt_json_value *value, char close) {
    bool is_object = close == '}';
    mt_json_value **next = &value->first;
    value->kind = is_object ? MT_JSON_OBJECT : MT_JSON_ARRAY;
    if (take(r, close)) return MT_OK;
    do {
        const char *key = NULL;
        if (is_object && value->count == MEMBERS_MAX) return MT_BAD_PARAMETER;
        mt_status status = is_object ? read_key(r, &key) : MT_OK;
        if (status == MT_OK) status = read_value(r, next);
        if (status != MT_OK) return status;
        (*next)->key = key;
        next = &(*next)->next;
        value->count++;
    } while (take(r, ','));
    if (!take(r, close)) return MT_BAD_PARAMETER;
    return is_object ? MT_OK : list_items(r, value);
}

static mt_status read_value(mt_json_reading *r, mt_json_value **value) {
    mt_json_value *made = mt_arena_new(r->arena, 1, sizeof *made);
    mt_status status;
    if (!made) return MT_NO_MEMORY;
    if (r->level == LEVELS_MAX) return MT_BAD_PARAMETER;
    r->level++;
    if (take(r, '{'))
        status = read_container(r, made, '}');
    else if (take(r, '['))
        status = read_container(r, made, ']');
    else if (take(r, '"'))
        status = read_string(r, &made->text), made->kind = MT_JSON_STRING;
    else
        status = read_word(r, made);
    r->level--;
    *value = made;
    return status;
}

mt_status mt_json_read(const char *text, size_t length, mt_arena *arena, mt_json_value **value) {
    mt_json_reading r = {text, text + length, arena, 0};
    mt_json_value *made;
    mt_status status = read_value(&r, &made);
    skip_blanks(&r);
    if (status == MT_OK && r.at < r.end) status = MT_BAD_PARAMETER;
    if (status == MT_OK) *value = made;
    return status;
}

/* ---- what is in it ------------------------------------------------------------------------------------- */

const mt_json_value *mt_json_member(const mt_json_value *object, const char *key) {
    if (!object || object->kind != MT_JSON_OBJECT) return NULL;
    for (const mt_json_value *member = object->first; member; member = member->next)
        if (strcmp(member->key, key) == 0) return member;
    return NULL;
}

int mt_json_count(const mt_json_value *object, const char *key) {
    const mt_json_value *array = mt_json_member(object, key);
    return array && array->kind == MT_JSON_ARRAY ? array->count : 0;
}

const mt_json_value *mt_json_item(const mt_json_value *object, const char *key, int index) {
    if (index < 0 || index >= mt_json_count(object, key)) return NULL;
    return mt_json_member(object, key)->items[index];
}

int mt_json_index(const mt_json_value *object, const char *key, int other) {
    const mt_json_value *member = mt_json_member(object, key);
    if (!member) return other;
    bool good = member->kind == MT_JSON_NUMBER && member->number >= 0 && member->number <= INT32_MAX &&
                member->number == (int)member->number;
    return good ? (int)member->number : -1;
}

bool mt_json_numbers(const mt_json_value *object, const char *key, int count, double *numbers) {
    if (mt_json_count(object, key) != count) return false;
    for (int i = 0; i < count; i++) {
        const mt_json_value *item = mt_json_item(object, key, i);
        if (item->kind != MT_JSON_NUMBER) return false;
        numbers[i] = item->number;
    }
    return true;
}
