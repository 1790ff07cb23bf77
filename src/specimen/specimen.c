/* The variable font made, with its figures; the page put together of its parts; the file. */
#include "specimen/specimen.h"

#include "base/base64.h"
#include "base/file.h"
#include "base/html.h"
#include "blend/variable.h"
#include "save/save.h"
#include "specimen/page.h"
#include "write/write.h"

#include <errno.h>
#include <string.h>
#include <strings.h>

/* ---- the page ------------------------------------------------------------------------------------------ */

static mt_status add(mt_buffer *text, const char *markup) {
    return mt_buffer_add(text, markup, strlen(markup));
}

static mt_status add_title(const mt_specimen *specimen, mt_buffer *text) {
    mt_status status = mt_html_text(text, specimen->font.family);
    return status == MT_OK ? add(text, ": a specimen") : status;
}

static mt_status add_font(const mt_specimen *specimen, mt_buffer *text) {
    mt_status status = add(text, "data:font/woff2;base64,");
    return status == MT_OK ? mt_base64_add(text, specimen->packed, specimen->packed_length) : status;
}

/* An mt_page_fill. */
static mt_status fill(mt_page_slot slot, const void *user, mt_buffer *text) {
    const mt_specimen *specimen = user;
    switch (slot) {
    case MT_SLOT_TITLE: return add_title(specimen, text);
    case MT_SLOT_DATA: return mt_specimen_data(specimen, text);
    case MT_SLOT_FONT: return add_font(specimen, text);
    default: return MT_OK;
    }
}

mt_status mt_specimen_html(const mt_specimen *specimen, mt_buffer *text) {
    return mt_page_make(mt_specimen_page, fill, specimen, text);
}

/* ---- making -------------------------------------------------------------------------------------------- */

/* What a specimen keeps until its page is written; all zero at first. */
typedef struct mt_specimen_state {
    mt_specimen specimen;
    mt_arena arena;
    uint8_t *font, *packed;
    size_t font_length;
} mt_specimen_state;

/* An mt_font_ready. */
static mt_status keep_font(const mt_font_data *data, int index, void *user) {
    mt_specimen_state *making = user;
    mt_specimen *specimen = &making->specimen;
    (void)index;
    mt_status status = mt_font_write(data, &making->font, &making->font_length);
    if (status == MT_OK)
        status =
            mt_font_pack(data, making->font, making->font_length, &making->packed, &specimen->packed_length);
    if (status == MT_OK) specimen->packed = making->packed;
    return status;
}

/* The glyphs are judged as they are made. */
static mt_status make_font(mt_specimen_state *making) {
    const mt_specimen_request *request = making->specimen.request;
    making->specimen.figures.mapped_only = true;
    mt_sink judge = mt_report_sink(&making->specimen.figures);
    mt_status status = mt_variable_make(request->variable, &judge, keep_font, making);
    if (status == MT_OK && request->made) status = request->made(request->user);
    if (status != MT_OK) return status;
    return mt_specimen_font_read(making->font, making->font_length, &making->arena, &making->specimen.font);
}

/* Hands the font over, with the page that shows it. */
static mt_status hand_over(mt_specimen_state *making, mt_specimen_made *made) {
    mt_specimen_made all = {.font = making->font,
                            .font_length = making->font_length,
                            .packed = making->packed,
                            .packed_length = making->specimen.packed_length};
    mt_status status = mt_specimen_html(&making->specimen, &all.page);
    if (status != MT_OK) return status;
    making->font = making->packed = NULL;
    *made = all;
    return MT_OK;
}

mt_status mt_specimen_make(const mt_specimen_request *request, mt_specimen_made *made) {
    mt_specimen_state making = {.specimen = {.request = request}};
    mt_status status = make_font(&making);
    if (status == MT_OK) status = hand_over(&making, made);
    mt_report_figures_free(&making.specimen.figures);
    mt_bytes_free(making.packed);
    mt_bytes_free(making.font);
    mt_arena_release(&making.arena);
    return status;
}

void mt_specimen_made_free(mt_specimen_made *made) {
    mt_bytes_free(made->font);
    mt_bytes_free(made->packed);
    mt_buffer_free(&made->page);
    *made = (mt_specimen_made){0};
}

/* ---- the file ------------------------------------------------------------------------------------------ */

bool mt_specimen_is_page(const char *path) {
    const char *dot = strrchr(path, '.');
    return dot && strcasecmp(dot, ".html") == 0;
}

mt_status mt_specimen_save(const mt_specimen_request *request, const char *path) {
    mt_specimen_made made;
    mt_status status = mt_specimen_make(request, &made);
    if (status != MT_OK) return status;
    status = mt_file_write(path, made.page.bytes, made.page.length);
    int why = errno;
    mt_specimen_made_free(&made);
    errno = why;
    return status;
}
