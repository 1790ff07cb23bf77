/* The inspection as a page, on which hints are made by pointing (pointing/pointing.h has what its script reads of a glyph). */
#include "base/page.h"
#include "pointing/idle_hints.h"
#include "picture/page.h"
#include "picture/view.h"
#include "pointing/pointing.h"

/* ---- glyphs -------------------------------------------------------------------------------------------- */

typedef struct mt_inspect_page {
    mt_row *row;
    mt_json json;
    int alone; /* glyphs without a partner, left out */
} mt_inspect_page;

/* An mt_view_taken. */
static mt_status take_view(const mt_view *view, int index, mt_arena *arena, void *user) {
    mt_inspect_page *page = user;
    char label[MT_CHOICE_LABEL_ROOM];
    bool *idle;
    (void)index;
    page->alone += !view->paired;
    if (!view->paired) return MT_OK;
    mt_choice_label(view->choice, label);
    mt_status status =
        mt_pair_find_idle_hints(page->row, 0, view->glyphs.a, view->glyphs.b, &view->pair, arena, &idle);
    if (status != MT_OK) return status;
    uint32_t code_point = view->choice->name ? 0 : view->choice->code_point;
    mt_pointed_glyph glyph = {label, code_point, view->glyphs.a, view->glyphs.b, &view->pair, idle};
    return mt_pointing_add_glyph(&page->json, page->row, &glyph, arena);
}

/* ---- the page ------------------------------------------------------------------------------------------ */

/* An mt_page_fill. */
static mt_status fill(mt_page_slot slot, const void *user, mt_buffer *text) {
    const mt_inspect_page *page = user;
    return slot == MT_SLOT_TITLE ? mt_pointing_add_title(text, page->row)
                                 : mt_page_add_json(text, &page->json.text);
}

mt_status mt_inspect_page_make(mt_row *row, const mt_inspection *what, uint8_t **bytes, size_t *length,
                               int *failed) {
    mt_inspect_page page = {.row = row};
    mt_json *json = &page.json;
    mt_buffer text;
    mt_json_object(json, NULL);
    mt_pointing_add_names(json, "names", row);
    mt_json_array(json, "glyphs");
    mt_status status = mt_views_make(row, what, take_view, &page, failed);
    mt_json_array_end(json);
    mt_json_object_end(json);
    if (status == MT_OK) status = json->status;
    if (status == MT_OK && page.alone == what->count) status = MT_NOTHING_SHARED;
    if (status == MT_OK) status = mt_page_make(mt_inspect_page_parts, fill, &page, &text);
    mt_buffer_free(&json->text);
    if (status != MT_OK) return status;
    *bytes = text.bytes;
    *length = text.length;
    return MT_OK;
}

/* ---- hints without effect ------------------------------------------------------------------------------- */

typedef struct mt_idle_search {
    mt_row *row;
    mt_idle_hint_noted call;
    void *user;
} mt_idle_search;

/* An mt_view_taken. */
static mt_status tell_idle(const mt_view *view, int index, mt_arena *arena, void *user) {
    const mt_idle_search *search = user;
    mt_row *row = search->row;
    bool *idle;
    if (!view->paired) return MT_OK;
    mt_hints hints = mt_hint_index_find(row->hints[0], view->glyphs.a, view->glyphs.b);
    mt_status status =
        mt_pair_find_idle_hints(row, 0, view->glyphs.a, view->glyphs.b, &view->pair, arena, &idle);
    for (int i = 0; status == MT_OK && i < hints.count; i++)
        if (idle[i]) search->call(index, mt_hint_index_line(row->hints[0], &hints.hints[i]), search->user);
    return status;
}

mt_status mt_inspect_idle_hints(mt_row *row, const mt_inspection *what, mt_idle_hint_noted call, void *user,
                                int *failed) {
    mt_idle_search search = {row, call, user};
    return mt_views_make(row, what, tell_idle, &search, failed);
}
