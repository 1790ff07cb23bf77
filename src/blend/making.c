/* The glyph set, composites and layout of a row's new font; then every glyph of it, by the workers, to the sinks. */
#include "blend/making.h"

#include <string.h>

#include "base/memory.h"
#include "glyphset/new_names.h"
#include "sfnt/sfnt.h"
#include "write/extent.h"

/* ---- what is told of glyphs ------------------------------------------------------------------------------ */

/* What is to be told of a glyph. A name made of its number in the new font would be no help. */
static mt_glyph_note note_of(const mt_making *making, int glyph, int font, mt_status why) {
    mt_pairing pairing = making->set.charset.glyphs[glyph];
    const char *name = making->glyph_names ? making->glyph_names[glyph] : NULL;
    return (mt_glyph_note){.code_point = pairing.code_point,
                           .is_form = !pairing.mapped,
                           .glyph = pairing.a,
                           .name = name && strncmp(name, "glyph", 5) != 0 ? name : NULL,
                           .font = font,
                           .why = why};
}

void mt_making_report(mt_making *making, int glyph, int font, mt_status why) {
    const mt_glyph_note note = note_of(making, glyph, font, why);
    if (glyph != 0) mt_row_report(making->row, &note);
}

void mt_task_report(const mt_glyph_task *task, mt_status why) {
    int font = task->pair.at_fault < 0 ? -1 : task->step + task->pair.at_fault;
    mt_making_report(task->making, task->glyph, font, why);
}

void mt_task_report_held(const mt_glyph_task *task, mt_at at, mt_at asked) {
    mt_glyph_note note = note_of(task->making, task->glyph, -1, MT_TOO_LARGE);
    note.t = at.x, note.up = at.y, note.asked = asked.x, note.asked_up = asked.y;
    if (task->glyph != 0) mt_row_report_held(task->making->row, &note);
}

static void report_cut_short(const mt_glyph_task *task) {
    const mt_glyph_note note = note_of(task->making, task->glyph, -1, MT_TOO_COSTLY);
    if (task->glyph != 0) mt_row_report_cut_short(task->making->row, &note);
}

/* Before the first glyph is made: nobody else calls the caller yet. */
static void note_unblended(const mt_making *making) {
    const mt_row *row = making->row;
    for (int i = 1; i < making->glyph_count && row->kept; i++) {
        if (making->set.charset.glyphs[i].b != MT_NO_PARTNER) continue;
        const mt_glyph_note note = note_of(making, i, -1, MT_NO_GLYPH);
        row->kept(&note, row->kept_user);
    }
}

/* The tags of the features, each of four characters, with ", " between them. */
static mt_status note_left_out(const mt_making *making) {
    const mt_row *row = making->row;
    const mt_charset *charset = &making->set.charset;
    if (!row->left_out || charset->left_count == 0) return MT_OK;
    char *text = mt_new((size_t)charset->left_tag_count + 1, 6), *end = text;
    if (!text) return MT_NO_MEMORY;
    for (int i = 0; i < charset->left_tag_count; i++) {
        if (i) *end++ = ',', *end++ = ' ';
        for (int shift = 24; shift >= 0; shift -= 8) *end++ = (char)(charset->left_tags[i] >> shift & 0xFF);
    }
    row->left_out(charset->left_count, text, row->left_out_user);
    mt_free(text);
    return MT_OK;
}

/* ---- what there is to make ----------------------------------------------------------------------------- */

mt_status mt_making_begin(mt_making *making, mt_row *row, const mt_charset_request *request) {
    making->row = row;
    making->step_count = row->font_count - 1;
    making->units = mt_row_units(row);
    mt_status status = mt_row_verdict(row, MT_OK);
    if (status != MT_OK) return status;
    status = mt_row_glyphs_make(row->fonts, row->font_count, request, &making->arena, &making->set);
    if (status == MT_OK) making->glyph_count = making->set.charset.glyph_count;
    return mt_row_verdict(row, status);
}

/* The glyphs by depth, in their order otherwise. */
static mt_status order_glyphs(mt_making *making) {
    int ordered = 0;
    making->order = mt_arena_new(&making->arena, (size_t)making->glyph_count, sizeof *making->order);
    if (!making->order) return MT_NO_MEMORY;
    for (int depth = 0; depth <= MT_GLYF_DEPTH_MAX; depth++)
        for (int i = 0; i < making->glyph_count; i++)
            if (making->composites[i].depth == depth) making->order[ordered++] = i;
    return MT_OK;
}

static mt_status list_origins(mt_making *making) {
    const mt_pairing *glyphs = making->set.charset.glyphs;
    making->origins = mt_arena_new(&making->arena, (size_t)making->glyph_count, sizeof *making->origins);
    if (!making->origins) return MT_NO_MEMORY;
    for (int i = 0; i < making->glyph_count; i++)
        making->origins[i] = (mt_origin){glyphs[i].a, glyphs[i].code_point};
    return MT_OK;
}

static mt_status take_layout(mt_making *making) {
    const mt_charset *charset = &making->set.charset;
    const mt_row *row = making->row;
    mt_arena *arena = &making->arena;
    uint16_t *kept = mt_arena_new(arena, (size_t)charset->primary_count, sizeof *kept);
    if (!kept) return MT_NO_MEMORY;
    for (int i = 0; i < charset->primary_count; i++) kept[i] = (uint16_t)charset->glyphs[i].a;
    mt_status status = mt_gsub_subset(row->fonts[0], kept, charset->primary_count, arena, &making->layout);
    if (status == MT_OK) status = mt_charset_twins(charset, arena, &making->layout);
    if (status == MT_OK) status = mt_glyph_names_make(row->fonts[0], charset, arena, &making->glyph_names);
    if (status != MT_OK) return status;
    status = mt_positions_prepare(row->fonts, &making->set.fonts, making->units, arena, &making->positions);
    if (status != MT_OK) return status;
    return mt_math_prepare(row->fonts, &making->set.fonts, making->units, arena, &making->math);
}

mt_status mt_making_begin_font(mt_making *making, mt_row *row) {
    mt_charset_request request = mt_row_request(row);
    request.varies = making->varies;
    mt_status status = mt_making_begin(making, row, &request);
    if (status != MT_OK) return status;
    row->unblended = making->set.charset.unblended_count;
    row->prepared = row->proved = 0;
    status = mt_composites_find(row, &making->set.fonts, &making->arena, &making->composites);
    status = mt_row_verdict(row, status);
    if (status == MT_OK) status = order_glyphs(making);
    if (status == MT_OK) status = list_origins(making);
    if (status == MT_OK) status = mt_row_verdict(row, take_layout(making));
    if (status == MT_OK) note_unblended(making);
    return status == MT_OK ? note_left_out(making) : status;
}

void mt_making_end(mt_making *making) {
    mt_thread_arenas_release(&making->kept);
    mt_arena_release(&making->arena);
}

/* ---- one glyph ----------------------------------------------------------------------------------------- */

/* But for .notdef, which nobody asks for. */
static void count_proof(mt_row *row, const mt_morph *morph) {
    pthread_mutex_lock(&row->lock);
    row->prepared++;
    row->proved += morph->proved;
    pthread_mutex_unlock(&row->lock);
}

static mt_status take(mt_glyph_task *task, const bool *wanted) {
    const mt_making *making = task->making;
    mt_status status = MT_OK, prepared = mt_pair_prepare(making->row, task->step, task->a, task->b,
                                                         task->scratch, &task->pair);
    if (prepared == MT_NO_MEMORY || prepared == MT_STOPPED) return prepared;
    if (prepared == MT_OK && task->glyph != 0 && task->b != MT_NO_PARTNER)
        count_proof(making->row, &task->pair.morph);
    if (prepared == MT_OK && task->pair.morph.cut_short) report_cut_short(task);
    for (int i = 0; i < making->sink_count && status == MT_OK; i++) {
        mt_pair_allow(making->row, task->scratch);
        if (wanted[i]) status = making->sinks[i].take(task, prepared, making->sinks[i].user);
    }
    return status;
}

/* A task: the glyphs of the first step, then those of the second, and so on. */
static mt_status make_glyph(int index, mt_arena *scratch, mt_arena *kept, void *user) {
    mt_making *making = user;
    const mt_font_glyphs *fonts = &making->set.fonts;
    int turn = making->first + index % making->batch, step = index / making->batch;
    int glyph = making->order ? making->order[turn] : turn;
    bool wanted[MT_SINKS_MAX] = {false}, any = false;
    mt_glyph_task task = {.making = making,
                          .step = step,
                          .glyph = glyph,
                          .a = fonts->of[step][glyph],
                          .b = fonts->of[step + 1][glyph],
                          .scratch = scratch,
                          .kept = kept};
    if (step > 0 && task.b == MT_NO_PARTNER) return MT_OK;
    mt_status status = mt_pair_read_rooms(making->row, step, task.a, task.b, &task.pair);
    for (int i = 0; i < making->sink_count && status == MT_OK; i++) {
        status = making->sinks[i].begin(&task, making->sinks[i].user, &wanted[i]);
        any = any || wanted[i];
    }
    if (status == MT_OK && any) status = take(&task, wanted);
    return mt_row_verdict(making->row, status);
}

/* ---- all of them --------------------------------------------------------------------------------------- */

/* How many glyphs from the first one on are of the same depth. */
static int batch_from(const mt_making *making, int first) {
    int end = first + 1;
    if (!making->order) return making->glyph_count;
    while (end < making->glyph_count &&
           making->composites[making->order[end]].depth == making->composites[making->order[first]].depth)
        end++;
    return end - first;
}

static mt_status run_batch(mt_making *making) {
    mt_row_progress progress = {making->row, making->step_count * making->first,
                                making->step_count * making->glyph_count};
    mt_work work = {.count = making->step_count * making->batch,
                    .task = make_glyph,
                    .user = making,
                    .kept = &making->kept,
                    .threads = making->row->params.threads,
                    .progress = mt_row_pass_progress,
                    .progress_user = &progress};
    return mt_work_run(&work);
}

mt_status mt_making_run(mt_making *making) {
    mt_status status = MT_OK;
    for (int i = 0; i < making->sink_count && status == MT_OK; i++)
        status = making->sinks[i].start(making, making->sinks[i].user);
    for (making->first = 0; making->first < making->glyph_count && status == MT_OK;
         making->first += making->batch) {
        making->batch = batch_from(making, making->first);
        status = run_batch(making);
    }
    return status;
}

/* ---- as data ------------------------------------------------------------------------------------------- */

void mt_add_extra(mt_font_data *data, uint32_t tag, mt_bytes table) {
    if (table.length) data->extras[data->extra_count++] = (mt_extra_table){tag, table};
}

mt_font_data mt_making_font(const mt_making *making, mt_glyf *glyphs) {
    const mt_charset *charset = &making->set.charset;
    mt_font_data data = {.units = making->units,
                         .curves = making->row->curves,
                         .glyph_count = charset->glyph_count,
                         .glyphs = glyphs,
                         .origins = making->origins,
                         .char_count = charset->char_count,
                         .chars = charset->chars,
                         .variant_count = charset->variant_count,
                         .variants = charset->variants,
                         .glyph_names = making->glyph_names};
    mt_add_extra(&data, MT_TAG('G', 'S', 'U', 'B'), making->layout.gsub);
    return data;
}
