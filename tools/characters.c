#include "characters.h"

#include "base/memory.h"
#include "geometry/limits.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CODE_POINTS 0x110000

bool characters_have(const characters *set, uint32_t code_point) {
    return set->seen && code_point < CODE_POINTS && (set->seen[code_point / 8] >> code_point % 8 & 1);
}

/* ---- rows ----------------------------------------------------------------------------------------------- */

mt_status choices_add(choices *row, const mt_choice *choice) {
    mt_choice *list = mt_grow_list(row->list, row->count, &row->room, sizeof *list);
    if (!list) return MT_NO_MEMORY;
    row->list = list;
    char *name = choice->name ? mt_copy_text(choice->name) : NULL;
    if (choice->name && !name) return MT_NO_MEMORY;
    list[row->count++] = (mt_choice){choice->code_point, name, choice->glyph};
    return MT_OK;
}

void choices_free(choices *row) {
    for (int i = 0; i < row->count; i++) mt_free((void *)(uintptr_t)row->list[i].name);
    mt_free(row->list);
    *row = (choices){0};
}

/* ---- sets ----------------------------------------------------------------------------------------------- */

/* Adds a value under `values` to a list, and its bit to those that were seen, unless it has it. *added: it had not. */
static mt_status add_value(uint32_t value, size_t values, uint32_t **list, int *count, int *room,
                           uint8_t **seen, bool *added) {
    if (!*seen) *seen = mt_new(values / 8 + 1, 1);
    if (!*seen) return MT_NO_MEMORY;
    *added = !((*seen)[value / 8] >> value % 8 & 1);
    if (!*added) return MT_OK;
    uint32_t *grown = mt_grow_list(*list, *count, room, sizeof *grown);
    if (!grown) return MT_NO_MEMORY;
    *list = grown;
    (*list)[(*count)++] = value;
    (*seen)[value / 8] |= (uint8_t)(1 << value % 8);
    return MT_OK;
}

mt_status characters_add_choice(characters *set, const mt_choice *choice) {
    bool added;
    uint32_t value = choice->name ? choice->glyph : choice->code_point;
    size_t values = choice->name ? MT_GLYPHS_MAX : CODE_POINTS;
    if (value >= values) return MT_BAD_PARAMETER;
    mt_status status =
        choice->name ? add_value(value, values, &set->glyphs, &set->glyph_count, &set->glyph_room,
                                 &set->seen_glyphs, &added)
                     : add_value(value, values, &set->list, &set->count, &set->room, &set->seen, &added);
    return status == MT_OK && added ? choices_add(&set->order, choice) : status;
}

mt_status characters_add(characters *set, uint32_t code_point) {
    return characters_add_choice(set, &(mt_choice){.code_point = code_point});
}

void characters_free(characters *set) {
    mt_free(set->list);
    mt_free(set->seen);
    mt_free(set->glyphs);
    mt_free(set->seen_glyphs);
    choices_free(&set->order);
    *set = (characters){0};
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
