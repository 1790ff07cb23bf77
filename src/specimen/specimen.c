#include "specimen/specimen.h"

#include "base/base64.h"
#include "base/file.h"
#include "base/html.h"
#include "save/save.h"
#include "specimen/page.h"
#include "write/write.h"

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

static mt_status add_data(const mt_specimen *specimen, mt_buffer *text) {
    mt_buffer data;
    mt_status status = mt_specimen_data(specimen, &data);
    if (status != MT_OK) return status;
    status = mt_buffer_add(text, data.bytes, data.length);
    mt_buffer_free(&data);
    return status;
}

static mt_status add_font(const mt_specimen *specimen, mt_buffer *text) {
    mt_status status = add(text, "data:font/woff2;base64,");
    return status == MT_OK ? mt_base64_add(text, specimen->packed, specimen->packed_length) : status;
}

static mt_status fill(mt_specimen_slot slot, const mt_specimen *specimen, mt_buffer *text) {
    switch (slot) {
    case MT_SLOT_VERSION: return add(text, MORPHOTYPE_VERSION);
    case MT_SLOT_TITLE: return add_title(specimen, text);
    case MT_SLOT_DATA: return add_data(specimen, text);
    case MT_SLOT_FONT: return add_font(specimen, text);
    default: return MT_OK;
    }
}

mt_status mt_specimen_html(const mt_specimen *specimen, mt_buffer *text) {
    mt_buffer made = {0};
    mt_status status = MT_OK;
    bool last = false;
    for (const mt_specimen_part *part = mt_specimen_parts; !last && status == MT_OK; part++) {
        status = mt_buffer_add(&made, part->markup, part->length);
        if (status == MT_OK) status = fill(part->slot, specimen, &made);
        last = part->slot == MT_SLOT_END;
    }
    if (status == MT_OK)
        *text = made;
    else
        mt_buffer_free(&made);
    return status;
}

/* ---- progress ------------------------------------------------------------------------------------------ */

/* The font is one stage, and each report another; all count as much. */
typedef struct mt_stages {
    const mt_specimen_request *request;
    int stage;
} mt_stages;

enum { SHARES = 1000 }; /* of a stage */

/* An mt_progress. */
static void show_progress(int done, int all, void *user) {
    const mt_stages *stages = user;
    const mt_specimen_request *request = stages->request;
    int share = all > 0 ? (int)((int64_t)SHARES * done / all) : SHARES;
    if (request->progress)
        request->progress(SHARES * stages->stage + share, SHARES * request->font_count,
                          request->progress_user);
}

/* ---- making -------------------------------------------------------------------------------------------- */

/* What a specimen keeps until its page is written; all zero at first. */
typedef struct mt_specimen_state {
    mt_specimen specimen;
    mt_stages stages;
    mt_arena arena;
    uint8_t *font, *packed;
    size_t font_length;
    mt_report *reports; /* of each two neighbours */
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

static mt_status make_font(mt_specimen_state *making) {
    const mt_specimen_request *request = making->specimen.request;
    mt_variable_on_progress(request->variable, show_progress, &making->stages);
    mt_status status = mt_variable_make(request->variable, keep_font, making);
    mt_variable_on_progress(request->variable, NULL, NULL);
    if (status == MT_OK && request->made) status = request->made(request->user);
    if (status != MT_OK) return status;
    return mt_specimen_font_read(making->font, making->font_length, &making->arena, &making->specimen.font);
}

/* The characters that the font has: of three fonts and more, two neighbours may share others. */
static mt_status judge_step(mt_specimen_state *making, int step) {
    const mt_specimen_request *request = making->specimen.request;
    mt_report_request wanted = {.a = request->fonts[step],
                                .b = request->fonts[step + 1],
                                .params = request->params,
                                .hints = mt_variable_hints(request->variable, step),
                                .code_points = making->specimen.font.chars,
                                .count = making->specimen.font.char_count,
                                .progress = show_progress,
                                .user = &making->stages};
    making->stages.stage = 1 + step;
    mt_status status = mt_report_make(&wanted, &making->reports[step]);
    if (status != MT_OK) return status;
    return mt_specimen_flags_make(&making->reports[step], &making->arena, &making->specimen.flags[step]);
}

static mt_status judge(mt_specimen_state *making) {
    int count = making->specimen.request->font_count - 1;
    making->reports = mt_new((size_t)count, sizeof *making->reports);
    making->specimen.flags = mt_arena_new(&making->arena, (size_t)count, sizeof *making->specimen.flags);
    if (!making->reports || !making->specimen.flags) return MT_NO_MEMORY;
    mt_status status = MT_OK;
    for (int i = 0; i < count && status == MT_OK; i++) status = judge_step(making, i);
    return status;
}

static void end(mt_specimen_state *making) {
    for (int i = 0; making->reports && i + 1 < making->specimen.request->font_count; i++)
        mt_report_free(&making->reports[i]);
    mt_free(making->reports);
    mt_bytes_free(making->packed);
    mt_bytes_free(making->font);
    mt_arena_release(&making->arena);
}

/* ---- the file ------------------------------------------------------------------------------------------ */

bool mt_specimen_is_page(const char *path) {
    const char *dot = strrchr(path, '.');
    return dot && strcasecmp(dot, ".html") == 0;
}

static mt_status write_page(const mt_specimen *specimen, const char *path) {
    mt_buffer text;
    mt_status status = mt_specimen_html(specimen, &text);
    if (status != MT_OK) return status;
    status = mt_file_write(path, text.bytes, text.length);
    mt_buffer_free(&text);
    return status;
}

mt_status mt_specimen_save(const mt_specimen_request *request, const char *path) {
    mt_specimen_state making = {.specimen = {.request = request}, .stages = {.request = request}};
    mt_status status = make_font(&making);
    if (status == MT_OK) status = judge(&making);
    if (status == MT_OK) status = write_page(&making.specimen, path);
    end(&making);
    return status;
}
