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

/* Of each glyph of the first font that is named, its partner in the second; in the arena. */
static mt_status list_partners(mt_row *row, const mt_choice *choices, int count, mt_arena *arena,
                               uint32_t **partners) {
    mt_row_glyphs set;
    int all = mt_font_glyph_count(row->fonts[0]);
    uint32_t *list = mt_arena_new(arena, (size_t)all + 1, sizeof *list);
    uint32_t *glyphs = mt_arena_new(arena, (size_t)count + 1, sizeof *glyphs);
    if (!list || !glyphs) return MT_NO_MEMORY;
    const mt_charset_request request = {.set = MT_GLYPHS_FIRST,
                                        .pairs = &row->pairs,
                                        .glyphs = glyphs,
                                        .glyph_count = list_values(choices, count, true, glyphs)};
    mt_status status = mt_row_glyphs_make(row->fonts, 2, &request, arena, &set);
    if (status != MT_OK) return status;
    for (int i = 0; i < all; i++) list[i] = MT_NO_PARTNER;
    for (int i = 0; i < set.charset.primary_count; i++)
        list[set.charset.glyphs[i].a] = set.charset.glyphs[i].b;
    *partners = list;
    return MT_OK;
}

static bool any_named(const mt_choice *choices, int count) {
    for (int i = 0; i < count; i++)
        if (choices[i].name) return true;
    return false;
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
    if (status == MT_OK && two && any_named(choices, count))
        status = list_partners(row, choices, count, arena, &partners);
    for (int i = 0; i < count && status == MT_OK; i++) {
        const mt_choice *choice = &choices[i];
        uint32_t a = choice->glyph, b = MT_NO_PARTNER;
        if (!choice->name) a = mt_given_glyph(&row->pairs, row->fonts, 0, choice->code_point);
        if (two)
            b = partners && choice->name ? partners[a]
                                         : mt_given_glyph(&row->pairs, row->fonts, 1, choice->code_point);
        list[i] = (mt_choice_glyphs){a, b};
        if (!choice->name && (!a || !b)) status = MT_NO_GLYPH;
        if (!choice->name && (!a || !b)) *failed = i;
        if (two && choice->name && b == MT_NO_PARTNER) note_alone(row, choice);
    }
    if (status == MT_OK) *glyphs = list;
    return status;
}
