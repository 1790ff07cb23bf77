#include "blend/choice.h"

#include <stdio.h>

#include "glyphset/charset.h"

void mt_choice_label(const mt_choice *choice, char label[MT_CHOICE_LABEL_ROOM]) {
    if (choice->name)
        snprintf(label, MT_CHOICE_LABEL_ROOM, "/%s", choice->name);
    else
        snprintf(label, MT_CHOICE_LABEL_ROOM, "U+%04lX", (unsigned long)choice->code_point);
}

/* The code points of characters, or the numbers of named glyphs; how many. */
static int list_values(const mt_choice *choices, int count, bool named, uint32_t *values) {
    int listed = 0;
    for (int i = 0; i < count; i++)
        if ((choices[i].name != NULL) == named)
            values[listed++] = named ? choices[i].glyph : choices[i].code_point;
    return listed;
}

mt_status mt_row_choose(mt_row *row, const mt_choice *choices, int count) {
    uint32_t *values = mt_new((size_t)count + 1, sizeof *values);
    if (!values) return MT_NO_MEMORY;
    mt_status status = mt_row_set_chars(row, values, list_values(choices, count, false, values));
    if (status == MT_OK)
        status = mt_row_set_glyph_numbers(row, values, list_values(choices, count, true, values));
    mt_free(values);
    return status;
}

/* ---- glyphs of two fonts --------------------------------------------------------------------------------- */

/* Of each choice by name, in their order, its partner in the second font, in the arena; NULL where there is none by name. */
static mt_status list_partners(mt_row *row, const mt_choice *choices, int count, mt_arena *arena,
                               uint32_t **in_second) {
    uint32_t *partners[2] = {NULL, NULL}, *glyphs = mt_arena_new(arena, (size_t)count + 1, sizeof *glyphs);
    if (!glyphs) return MT_NO_MEMORY;
    int named = list_values(choices, count, true, glyphs);
    mt_status status =
        named ? mt_row_partners(row->fonts, 2, &row->pairs, glyphs, named, arena, partners) : MT_OK;
    *in_second = partners[1];
    return status;
}

static void note_alone(mt_row *row, const mt_choice *choice) {
    const mt_glyph_note note = {
        .is_form = true, .glyph = choice->glyph, .name = choice->name, .font = -1, .why = MT_NO_GLYPH};
    if (row->kept) row->kept(&note, row->kept_user);
}

mt_status mt_choices_pair(mt_row *row, const mt_choice *choices, int count, mt_arena *arena,
                          mt_choice_glyphs **glyphs, int *failed) {
    bool two = row->font_count > 1;
    uint32_t *partners = NULL;
    mt_choice_glyphs *list = mt_arena_new(arena, (size_t)count + 1, sizeof *list);
    mt_status status = list ? MT_OK : MT_NO_MEMORY;
    if (status == MT_OK && two) status = list_partners(row, choices, count, arena, &partners);
    for (int i = 0; i < count && status == MT_OK; i++) {
        const mt_choice *choice = &choices[i];
        uint32_t a = choice->glyph, b = MT_NO_PARTNER;
        if (!choice->name) a = mt_given_glyph(&row->pairs, row->fonts, 0, choice->code_point);
        if (two)
            b = choice->name ? *partners++ : mt_given_glyph(&row->pairs, row->fonts, 1, choice->code_point);
        list[i] = (mt_choice_glyphs){a, b};
        if (!choice->name && (!a || !b)) status = MT_NO_GLYPH;
        if (!choice->name && (!a || !b)) *failed = i;
        if (two && choice->name && b == MT_NO_PARTNER) note_alone(row, choice);
    }
    if (status == MT_OK) *glyphs = list;
    return status;
}
