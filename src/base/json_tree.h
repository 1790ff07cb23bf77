/* JSON (RFC 8259), read from untrusted bytes into a tree. At most 64 levels, and 256 members in an object,
 * which are looked for one by one. */
#pragma once

#include "base/memory.h"
#include "morphotype.h"

typedef enum mt_json_kind {
    MT_JSON_NULL,
    MT_JSON_FALSE,
    MT_JSON_TRUE,
    MT_JSON_NUMBER,
    MT_JSON_STRING,
    MT_JSON_ARRAY,
    MT_JSON_OBJECT,
} mt_json_kind;

typedef struct mt_json_value {
    mt_json_kind kind;
    int count;        /* of the items or members */
    double number;    /* of a number */
    const char *text; /* of a string: NUL-terminated UTF-8 */
    const char *key;  /* in an object */
    struct mt_json_value *first, *next;
    struct mt_json_value **items; /* of an array: all, by their places */
} mt_json_value;

/* The value that the whole text is, in the arena. MT_BAD_PARAMETER for what is no JSON, MT_NO_MEMORY. */
mt_status mt_json_read(const char *text, size_t length, mt_arena *arena, mt_json_value **value);

/* The object's first member of that name; NULL for none, or where `object` is no object or NULL. */
const mt_json_value *mt_json_member(const mt_json_value *object, const char *key);
/* The item at that place of an array that is a member; NULL for none. */
const mt_json_value *mt_json_item(const mt_json_value *object, const char *key, int index);
/* How many items an array that is a member has; 0 for none. */
int mt_json_count(const mt_json_value *object, const char *key);
/* A member that is a whole number from 0 to 2^31 - 1; `other` where there is none, and -1 where it is something else. */
int mt_json_index(const mt_json_value *object, const char *key, int other);
/* Fills in `count` numbers of an array that is a member; false where there is no such array. */
bool mt_json_numbers(const mt_json_value *object, const char *key, int count, double *numbers);
