/* JSON (RFC 8259), written. Commas and indentation come by themselves; numbers look the same in every locale. */
#pragma once

#include "base/buffer.h"

typedef struct mt_json {
    mt_buffer text;
    mt_status status; /* MT_OK or MT_NO_MEMORY; once it is not MT_OK nothing more is written */
    int depth;
    int line_depth; /* containers at this depth and below stand on one line; 0: none do */
    bool first;     /* the innermost container is empty so far */
} mt_json;          /* all zero is an empty text */

/* `key` is the member's name inside an object, and NULL inside an array and at the top. */
void mt_json_object(mt_json *json, const char *key);
void mt_json_object_end(mt_json *json);
void mt_json_array(mt_json *json, const char *key);
void mt_json_array_end(mt_json *json);
/* The container that starts next goes on one line, with all that is in it. */
void mt_json_one_line(mt_json *json);

void mt_json_text(mt_json *json, const char *key,
                  const char *utf8); /* bytes that are no UTF-8 become U+FFFD */
void mt_json_bool(mt_json *json, const char *key, bool value);
void mt_json_int(mt_json *json, const char *key, int64_t value);
void mt_json_real(mt_json *json, const char *key, double value, int digits); /* as mt_real_write */
void mt_json_number(mt_json *json, const char *key, double value); /* to 9 decimals; |value| under 10^9 */
