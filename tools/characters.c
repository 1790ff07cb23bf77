#include "characters.h"

#include "base/memory.h"
#include "base/utf.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CODE_POINTS 0x110000

bool characters_have(const characters *set, uint32_t code_point) {
    return set->seen && code_point < CODE_POINTS && (set->seen[code_point / 8] >> code_point % 8 & 1);
}

static mt_status make_room(characters *set) {
    if (!set->seen) set->seen = mt_new(CODE_POINTS / 8, 1);
    if (!set->seen) return MT_NO_MEMORY;
    if (set->count < set->room) return MT_OK;
    int room = set->room ? 2 * set->room : 256;
    uint32_t *list = mt_grow(set->list, (size_t)room, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    set->list = list;
    set->room = room;
    return MT_OK;
}

mt_status characters_add(characters *set, uint32_t code_point) {
    if (characters_have(set, code_point)) return MT_OK;
    if (code_point >= CODE_POINTS) return MT_BAD_PARAMETER;
    mt_status status = make_room(set);
    if (status != MT_OK) return status;
    set->list[set->count++] = code_point;
    set->seen[code_point / 8] |= (uint8_t)(1 << code_point % 8);
    return MT_OK;
}

void characters_free(characters *set) {
    mt_free(set->list);
    mt_free(set->seen);
    *set = (characters){0};
}

mt_status characters_add_text(characters *set, const char *utf8) {
    uint32_t code_point;
    while (*utf8) {
        if (!mt_utf8_next(&utf8, &code_point)) return MT_BAD_PARAMETER;
        mt_status status = code_point == '\n' ? MT_OK : characters_add(set, code_point);
        if (status != MT_OK) return status;
    }
    return MT_OK;
}

mt_status characters_add_font(characters *set, const mt_font *font) {
    uint32_t code_point;
    mt_status status = MT_OK;
    for (uint32_t from = 0; status == MT_OK && mt_font_next_char(font, from, &code_point);
         from = code_point + 1)
        status = characters_add(set, code_point);
    return status;
}

static int compare(const void *a, const void *b) {
    uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* The index after the run of consecutive code points that starts at `from`. */
static int run_end(const characters *set, int from) {
    int end = from + 1;
    while (end < set->count && set->list[end] == set->list[end - 1] + 1) end++;
    return end;
}

static int count_runs(const characters *set, int from) {
    int runs = 0;
    for (; from < set->count; from = run_end(set, from)) runs++;
    return runs;
}

void characters_describe(characters *set, int most, char *text, size_t room) {
    size_t used = 0;
    int from = 0;
    if (set->count > 0) qsort(set->list, (size_t)set->count, sizeof *set->list, compare);
    text[0] = '\0';
    for (int runs = 0; from < set->count && runs < most && used + 64 < room; runs++) {
        int end = run_end(set, from);
        used += (size_t)snprintf(text + used, room - used, "%sU+%04lX", runs ? ", " : "",
                                 (unsigned long)set->list[from]);
        if (end > from + 1)
            used += (size_t)snprintf(text + used, room - used, "-%04lX", (unsigned long)set->list[end - 1]);
        from = end;
    }
    int left = count_runs(set, from);
    if (left > 0) snprintf(text + used, room - used, " and %d more range%s", left, left == 1 ? "" : "s");
}
